package io.github.circles2d.tools;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What is missing on a machine for OpenCL, as far as its files show, and how to install it. */
final class Prescription {
    private static final String DEFAULT_VENDORS = "/etc/OpenCL/vendors";

    private static final List<String> LIBRARY_FOLDERS = List.of(
            "usr/lib/x86_64-linux-gnu",
            "usr/lib64",
            "usr/lib",
            "usr/local/lib",
            "lib/x86_64-linux-gnu",
            "lib64",
            "lib");

    private final String os;
    private final Path root;
    private final Path vendors;
    private final List<String> lines = new ArrayList<>();

    /**
     * Examines the files below {@code root}.
     *
     * @param os the property {@code os.name}
     * @param root the root of the file system
     * @param vendors the folder in which drivers are registered
     */
    Prescription(String os, Path root, Path vendors) {
        this.os = os.toLowerCase(Locale.ROOT);
        this.root = root;
        this.vendors = vendors;
    }

    static Prescription forThisMachine() {
        return new Prescription(System.getProperty("os.name", ""), Path.of("/"), vendors());
    }

    private static Path vendors() {
        String chosen = System.getenv("OCL_ICD_VENDORS");
        try {
            return Path.of(chosen == null || chosen.isEmpty() ? DEFAULT_VENDORS : chosen);
        } catch (InvalidPathException e) {
            return Path.of(DEFAULT_VENDORS); // the locale has no encoding for the name of the chosen one
        }
    }

    /** Returns what the files show, and how to install a driver. */
    List<String> forMissingDriver() {
        lines.clear();
        if (os.contains("mac")) {
            lines.add("OpenCL is a part of macOS; nothing has to be installed.");
        } else if (os.contains("windows")) {
            prescribeForWindows();
        } else {
            examineLinux();
            prescribeForLinux();
        }
        return List.copyOf(lines);
    }

    /** Returns what the files show, for a machine that has a driver; may be empty. */
    List<String> forFailingDevice() {
        lines.clear();
        if (!os.contains("mac") && !os.contains("windows")) {
            examineLinux();
        }
        return List.copyOf(lines);
    }

    private void prescribeForWindows() {
        lines.add(
                "GPU: install the current graphics driver of NVIDIA, AMD or Intel from its maker; OpenCL is a part of it.");
        lines.add("CPU: install Intel's CPU Runtime for OpenCL Applications; it works on AMD processors too.");
    }

    private void examineLinux() {
        if (findLibrary("libOpenCL.so.1") == null) {
            lines.add(
                    "There is no libOpenCL.so.1, the loader that finds drivers (package ocl-icd-libopencl1 or ocl-icd).");
        }
        if (Files.isRegularFile(vendors) && !vendors.toString().endsWith(".icd")) {
            return; // OCL_ICD_VENDORS may name the library of a driver
        }
        List<Path> registrations = registrations();
        if (registrations.isEmpty()) {
            lines.add("No driver is registered in " + vendors + ".");
        }
        boolean nvidiaRegistered = false;
        for (Path registration : registrations) {
            String library = firstLine(registration);
            nvidiaRegistered |= library.contains("libnvidia-opencl");
            if (!isThere(library)) {
                lines.add(registration + " names the driver '" + library
                        + "', which was not found: reinstall its package.");
            }
        }
        Path nvidia = findLibrary("libnvidia-opencl.so.1");
        if (nvidia != null && !nvidiaRegistered) {
            lines.add("NVIDIA's OpenCL library is there (" + nvidia + ") but not registered. As root:");
            lines.add("  mkdir -p /etc/OpenCL/vendors && echo libnvidia-opencl.so.1 > /etc/OpenCL/vendors/nvidia.icd");
        }
        if (isLockedOut()) {
            lines.add("This user may not use the GPU: sudo usermod -aG render,video $USER, then log in again.");
        }
    }

    private void prescribeForLinux() {
        lines.add("CPU:     Debian, Ubuntu: sudo apt-get install pocl-opencl-icd");
        lines.add("         Fedora: sudo dnf install pocl ocl-icd     Arch: sudo pacman -S pocl ocl-icd");
        lines.add("NVIDIA:  the proprietary driver with its OpenCL part (Debian: nvidia-opencl-icd, Fedora:");
        lines.add("         xorg-x11-drv-nvidia-cuda-libs, Arch: opencl-nvidia; on Ubuntu it is in the driver)");
        lines.add(
                "AMD:     rocm-opencl-icd or mesa-opencl-icd (Debian, Ubuntu), rocm-opencl (Fedora), rocm-opencl-runtime (Arch)");
        lines.add("Intel:   intel-opencl-icd (Debian, Ubuntu), intel-compute-runtime (Fedora, Arch)");
    }

    private List<Path> registrations() {
        if (!Files.isDirectory(vendors)) {
            return Files.isReadable(vendors) ? List.of(vendors) : List.of(); // OCL_ICD_VENDORS may name a single file
        }
        try (Stream<Path> files = Files.list(vendors)) {
            return files.filter(file -> file.toString().endsWith(".icd"))
                    .sorted()
                    .collect(Collectors.toList());
        } catch (IOException e) {
            return List.of();
        }
    }

    private static String firstLine(Path file) {
        try (Stream<String> content = Files.lines(file, StandardCharsets.ISO_8859_1)) {
            return content.findFirst().orElse("").trim();
        } catch (IOException e) {
            return "";
        }
    }

    private boolean isThere(String library) {
        try {
            return library.startsWith("/")
                    ? Files.exists(root.resolve(library.substring(1)))
                    : findLibrary(library) != null;
        } catch (InvalidPathException e) {
            return false;
        }
    }

    private Path findLibrary(String name) {
        for (String folder : LIBRARY_FOLDERS) {
            Path file = root.resolve(folder).resolve(name);
            if (Files.exists(file)) {
                return file;
            }
        }
        return null;
    }

    /** Render nodes of GPUs that this user may not open; on a machine without any there is nothing to open. */
    private boolean isLockedOut() {
        Path folder = root.resolve("dev/dri");
        if (!Files.isDirectory(folder)) {
            return false;
        }
        try (Stream<Path> nodes = Files.list(folder)) {
            return nodes.anyMatch(node -> node.getFileName().toString().startsWith("renderD")
                    && !(Files.isReadable(node) && Files.isWritable(node)));
        } catch (IOException e) {
            return false;
        }
    }
}
