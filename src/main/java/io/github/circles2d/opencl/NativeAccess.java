package io.github.circles2d.opencl;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.bridj.BridJ;
import org.bridj.Pointer;

/**
 * What must be settled before the first JavaCL class is touched, because a failure in there is sticky for the life of
 * the JVM: the processor is one that BridJ has a native library for, libOpenCL is the system's and not one that lies in
 * the current directory, kernels can be compiled through the home directory, and POCL leaves Java's signals alone.
 */
final class NativeAccess {
    private static final System.Logger LOG = System.getLogger(NativeAccess.class.getName());

    private NativeAccess() {}

    /** Prepares this JVM for JavaCL; throws what would otherwise be a linkage error later. */
    static void prepare() {
        requireSupportedPlatform();
        requireWritableHome();
        keepBridjQuiet();
        if (isLinux()) {
            keepSignalsOfJava();
            pinLibrary();
        }
    }

    private static boolean isLinux() {
        return osName().contains("linux");
    }

    private static String osName() {
        return System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
    }

    /** BridJ 0.7.0 carries natives for these pairs only; a user may bring another with -Dbridj.library. */
    private static void requireSupportedPlatform() {
        String arch = System.getProperty("os.arch", "").toLowerCase(Locale.ROOT);
        boolean x64 = arch.equals("amd64") || arch.equals("x86_64");
        boolean x86 = arch.matches("x86|i[3-6]86");
        boolean arm32 = arch.equals("arm");
        String os = osName();
        boolean supported = x64 && (os.contains("linux") || os.contains("windows") || os.contains("mac"))
                || x86 && (os.contains("linux") || os.contains("windows"))
                || arm32 && os.contains("linux");
        if (!supported && System.getProperty("bridj.library") == null && System.getenv("BRIDJ_LIBRARY") == null) {
            throw new OpenClUnavailableException(
                    "BridJ 0.7.0, through which Java reaches OpenCL, has no native library for "
                            + System.getProperty("os.name") + " on " + System.getProperty("os.arch")
                            + ". It has them for Linux (x86-64, x86, 32-bit Arm), Windows (x86-64, x86) and macOS (x86-64). Use a Java"
                            + " of one of these, or build BridJ's library yourself and name it with -Dbridj.library=FILE.");
        }
    }

    /** BridJ reports each symbol of OpenCL that a driver lacks, on standard error, unless told not to. */
    private static void keepBridjQuiet() {
        if (System.getProperty("bridj.quiet") == null) {
            System.setProperty("bridj.quiet", "true");
        }
    }

    /** JavaCL writes temporary include folders and its binary cache below ~/.javacl, and fails every build without. */
    private static void requireWritableHome() {
        Path folder = Path.of(System.getProperty("user.home", ""), ".javacl");
        try {
            Files.createDirectories(folder);
            Files.delete(Files.createTempFile(folder, "probe", null));
        } catch (IOException e) {
            throw new OpenClUnavailableException(
                    "kernels are compiled through the folder " + folder + ", which cannot be written (" + e
                            + "). Make it writable, or point -Duser.home at a folder that is.",
                    e);
        }
    }

    /**
     * POCL before 4.0 installs a process-wide SIGFPE handler that makes Java's {@code x / 0} return garbage instead of
     * throwing; this environment variable turns it off, and it is read when the driver is loaded.
     */
    private static void keepSignalsOfJava() {
        if (System.getenv("POCL_SIGFPE_HANDLER") != null) {
            return;
        }
        try {
            Optional<Path> libc = loadedLibrary("libc.so.6", "libc-");
            if (libc.isEmpty()) {
                LOG.log(Level.DEBUG, "no glibc found in this process: POCL_SIGFPE_HANDLER is left as it is");
                return;
            }
            BridJ.setNativeLibraryFile(StandardC.LIBRARY, libc.get().toFile());
            Pointer<Byte> name = Pointer.pointerToCString("POCL_SIGFPE_HANDLER");
            Pointer<Byte> value = Pointer.pointerToCString("0");
            StandardC.set(name, value);
        } catch (LinkageError | RuntimeException | IOException e) {
            LOG.log(Level.WARNING, "could not set POCL_SIGFPE_HANDLER=0; set it in the environment if POCL is used", e);
        }
    }

    /** Returns the file of a library that is already part of this process. */
    private static Optional<Path> loadedLibrary(String... prefixes) throws IOException {
        try (Stream<String> maps = Files.lines(Path.of("/proc/self/maps"))) {
            return maps.map(line -> line.substring(line.lastIndexOf(' ') + 1))
                    .filter(file -> file.startsWith("/"))
                    .map(Path::of)
                    .filter(file -> {
                        String base = file.getFileName().toString();
                        return Stream.of(prefixes).anyMatch(base::startsWith);
                    })
                    .findFirst();
        }
    }

    /** BridJ would look for libOpenCL in the current directory first: name the system's instead. */
    private static void pinLibrary() {
        boolean chosenByUser =
                System.getProperty("bridj.OpenCL.library") != null || System.getenv("BRIDJ_OPENCL_LIBRARY") != null;
        if (chosenByUser) {
            return;
        }
        for (Path folder : libraryFolders()) {
            for (String file : List.of("libOpenCL.so.1", "libOpenCL.so")) {
                Path library = folder.resolve(file);
                if (Files.isReadable(library)) {
                    BridJ.setNativeLibraryFile("OpenCL", library.toFile());
                    BridJ.setNativeLibraryFile("OpenCLProbe", library.toFile());
                    return;
                }
            }
        }
        throw new OpenClUnavailableException("there is no libOpenCL.so.1 on this machine. " + Advice.INSTALL);
    }

    private static List<Path> libraryFolders() {
        List<Path> folders = new ArrayList<>();
        String path = System.getenv("LD_LIBRARY_PATH");
        if (path != null) {
            Stream.of(path.split(":"))
                    .filter(folder -> folder.startsWith("/"))
                    .map(Path::of)
                    .forEach(folders::add);
        }
        String arch = System.getProperty("os.arch");
        String triplet = arch.equals("amd64") ? "x86_64" : arch.equals("arm") ? "arm" : "i386";
        String abi = triplet.equals("arm") ? "-linux-gnueabihf" : "-linux-gnu";
        Stream.of(
                        "/usr/lib/" + triplet + abi,
                        "/lib/" + triplet + abi,
                        "/usr/local/lib/" + triplet + abi,
                        "/usr/local/lib",
                        "/usr/lib64",
                        "/lib64",
                        "/usr/local/cuda/lib64",
                        "/opt/rocm/lib",
                        "/usr/lib",
                        "/lib")
                .map(Path::of)
                .forEach(folders::add);
        return folders;
    }
}
