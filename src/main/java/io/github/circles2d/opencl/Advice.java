package io.github.circles2d.opencl;

/** What to tell a user who lacks a driver; one wording for all messages. */
final class Advice {
    static final String INSTALL =
            "Install an OpenCL driver: on Debian and Ubuntu `apt-get install pocl-opencl-icd` (runs on any x86-64 CPU), on Fedora"
                    + " `dnf install pocl`, on Arch `pacman -S pocl`; for a GPU the vendor's driver with its OpenCL part. On Windows"
                    + " it comes with the graphics driver, on macOS with the system.";

    private Advice() {}
}
