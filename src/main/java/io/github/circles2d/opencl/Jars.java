package io.github.circles2d.opencl;

import java.util.ArrayList;
import java.util.List;

/**
 * The jars through which Java reaches OpenCL. A program may leave them out of its class path, and has no OpenCL device
 * then.
 */
final class Jars {
    /** The Maven coordinates of a jar, and one of its classes. */
    private record Jar(String coordinates, String className) {}

    private static final List<Jar> ALL = List.of(
            new Jar("com.nativelibs4java:javacl-core", "com.nativelibs4java.opencl.JavaCL"),
            new Jar("com.nativelibs4java:opencl4java", "com.nativelibs4java.opencl.library.OpenCLLibrary"),
            new Jar("com.nativelibs4java:nativelibs4java-utils", "com.nativelibs4java.util.ValuedEnum"),
            new Jar("com.nativelibs4java:bridj", "org.bridj.BridJ"));

    private Jars() {}

    /** Throws if one of them is missing. No class is initialised, so no native library is loaded. */
    static void require() {
        List<String> missing = new ArrayList<>();
        Throwable cause = null;
        for (Jar jar : ALL) {
            try {
                Class.forName(jar.className, false, Jars.class.getClassLoader());
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
}
