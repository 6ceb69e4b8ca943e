package io.github.circles2d.opencl;

import java.io.File;
import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.bridj.BridJ;

/**
 * What must be settled before the first JavaCL class is touched, because a failure in there is sticky for the life of
 * the JVM: no jar is missing, BridJ has a native library for the processor and can load it, libOpenCL is the system's and
 * not one that lies in the current directory, and POCL leaves Java's signals alone.
 */
final class NativeAccess {
    private static final System.Logger LOG = System.getLogger(NativeAccess.class.getName());

    /** A jar through which Java reaches OpenCL, which a program may leave out: its Maven coordinates, and one of its classes. */
    private record Jar(String coordinates, String className) {}

    private static final List<Jar> JARS = List.of(
            new Jar("com.nativelibs4java:javacl-core", "com.nativelibs4java.opencl.JavaCL"),
            new Jar("com.nativelibs4java:opencl4java", "com.nativelibs4java.opencl.library.OpenCLLibrary"),
            new Jar("com.nativelibs4java:nativelibs4java-utils", "com.nativelibs4java.util.ValuedEnum"),
            new Jar("com.nativelibs4java:bridj", "org.bridj.BridJ"));

    private NativeAccess() {}

    /** Prepares this JVM for JavaCL; throws what would otherwise be a linkage error later. */
    static void prepare() {
        requireSupportedPlatform();
        requireJars();
        keepBridjQuiet();
        BridjLibrary.load();
        if (isLinux()) {
            keepSignalsOfJava(LoadedLibraries.LIST);
            pinLibrary();
            PoclGate.examine(libraryFolders());
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
                            + " of one of these (on a Mac with Apple silicon it runs under Rosetta 2), or build BridJ's library"
                            + " yourself and name it with -Dbridj.library=FILE.");
        }
    }

    /** Throws if one of them is missing. No class is initialised, so no native library is loaded. */
    private static void requireJars() {
        List<String> missing = new ArrayList<>();
        Throwable cause = null;
        for (Jar jar : JARS) {
            try {
                Class.forName(jar.className, false, NativeAccess.class.getClassLoader());
            } catch (ClassNotFoundException | LinkageError e) {
                missing.add(jar.coordinates);
                cause = e;
            }
        }
        if (!missing.isEmpty()) {
            throw new OpenClUnavailableException(
                    "the class path lacks " + String.join(", ", missing) + ", through which Java reaches OpenCL. Add "
                            + (missing.size() == 1 ? "it" : "them")
                            + ", for example by depending on io.github.circles2d:circles2d without exclusions.",
                    cause);
        }
    }

    /** BridJ reports each symbol of OpenCL that a driver lacks, on standard error, unless told not to. */
    private static void keepBridjQuiet() {
        if (System.getProperty("bridj.quiet") == null) {
            System.setProperty("bridj.quiet", "true");
        }
    }

    /**
     * Drivers that take over signals break Java: see {@link DriverCalls}. POCL before 4.0 has a variable against one of them, read
     * when it is loaded: its SIGFPE handler makes Java's {@code x / 0} return garbage instead of throwing.
     */
    static void keepSignalsOfJava(File listOfLibraries) {
        try {
            LoadedLibraries libraries = new LoadedLibraries(listOfLibraries);
            File libc = libraries
                    .file("libc.so.6", "libc-", "ld-musl-")
                    .orElseThrow(() -> new IOException("the C library is not among the libraries of this process"));
            BridJ.setNativeLibraryFile(StandardC.LIBRARY, libc);
            if (System.getenv("POCL_SIGFPE_HANDLER") == null) {
                StandardC.setEnvironment("POCL_SIGFPE_HANDLER", "0");
            }
            DriverCalls.protectSignals(new SignalHandlers(libraries));
        } catch (LinkageError | RuntimeException | IOException e) {
            throw new OpenClUnavailableException(
                    "an OpenCL driver may take over the signals that Java works by, and they cannot be protected here: "
                            + e + ". The library reads " + listOfLibraries + " and calls the C library for that.",
                    e);
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
        throw OpenClUnavailableException.withoutDriver("there is no libOpenCL.so.1 on this machine", null);
    }

    private static List<Path> libraryFolders() {
        List<Path> folders = new ArrayList<>();
        String path = System.getenv("LD_LIBRARY_PATH");
        if (path != null) {
            for (String folder : path.split(":")) {
                addAbsolute(folder, folders);
            }
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

    private static void addAbsolute(String folder, List<Path> folders) {
        try {
            if (folder.startsWith("/")) {
                folders.add(Path.of(folder));
            }
        } catch (InvalidPathException e) {
            LOG.log(Level.DEBUG, "not a path in the encoding of this locale: {0}", folder);
        }
    }
}
