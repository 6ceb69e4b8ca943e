package io.github.circles2d.opencl;

/**
 * There is no usable OpenCL device: no driver, no native library that can be loaded, no jars of JavaCL and BridJ, no device
 * of the kind asked for, no folder that kernels can be compiled through, or a POCL that lacks what it needs to work. The
 * message says what is missing and names the cure.
 */
public final class OpenClUnavailableException extends OpenClException {
    private static final long serialVersionUID = 1L;

    /** What to tell a user who lacks a driver. */
    private static final String ADVICE =
            "Install an OpenCL driver: on Debian and Ubuntu `apt-get install pocl-opencl-icd` (runs on any x86-64 CPU), on Fedora"
                    + " `dnf install pocl`, on Arch `pacman -S pocl`; for a GPU the vendor's driver with its OpenCL part. On Windows"
                    + " it comes with the graphics driver, on macOS with the system.";

    /** Whether no driver is installed. */
    private final boolean driverMissing;

    /**
     * Creates the exception of a cause that no driver cures.
     *
     * @param message what is missing, and the cure
     */
    public OpenClUnavailableException(String message) {
        this(message, null);
    }

    /**
     * Creates the exception of a cause that no driver cures, with the failure that it reports.
     *
     * @param message what is missing, and the cure
     * @param cause the failure below, may be null
     */
    public OpenClUnavailableException(String message, Throwable cause) {
        this(message, cause, false);
    }

    private OpenClUnavailableException(String message, Throwable cause, boolean driverMissing) {
        super(message, cause);
        this.driverMissing = driverMissing;
    }

    /** Returns the exception of a missing driver; the message ends with how to install one. */
    static OpenClUnavailableException withoutDriver(String what, Throwable cause) {
        return new OpenClUnavailableException(what + ". " + ADVICE, cause, true);
    }

    /** Returns an exception that says the same, for a further caller. */
    OpenClUnavailableException again() {
        return new OpenClUnavailableException(getMessage(), this, driverMissing);
    }

    /** {@return whether a driver is what is missing, so that installing one may be the cure} */
    public boolean isDriverMissing() {
        return driverMissing;
    }
}
