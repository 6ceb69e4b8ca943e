package io.github.circles2d.opencl;

import org.bridj.BridJ;
import org.bridj.Pointer;
import org.bridj.ann.Library;

/** The one function of the C library that is needed: Java cannot change the environment of its own process. */
@Library(StandardC.LIBRARY)
final class StandardC {
    static final String LIBRARY = "c";

    static {
        BridJ.register();
    }

    private StandardC() {}

    /** Sets an environment variable of this process, replacing what it was. */
    static void set(Pointer<Byte> name, Pointer<Byte> value) {
        setenv(name, value, 1);
    }

    private static native int setenv(Pointer<Byte> name, Pointer<Byte> value, int overwrite);
}
