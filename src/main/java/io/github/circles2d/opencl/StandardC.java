package io.github.circles2d.opencl;

import org.bridj.BridJ;
import org.bridj.Pointer;
import org.bridj.ann.Library;
import org.bridj.ann.Ptr;

/** The functions of the C library that Java has no counterpart for. Name the library's file to BridJ before the first call. */
@Library(StandardC.LIBRARY)
final class StandardC {
    static final String LIBRARY = "c";

    static {
        BridJ.register();
    }

    private StandardC() {}

    /** Sets an environment variable of this process, replacing what it was. */
    static void setEnvironment(String name, String value) {
        setenv(Pointer.pointerToCString(name), Pointer.pointerToCString(value), 1);
    }

    /**
     * Makes a system call.
     *
     * @return what the C library returns: -1 if the call failed
     */
    static long systemCall(long number, long first, long second, long third, long fourth) {
        return syscall(number, first, second, third, fourth);
    }

    /** Sets an attribute of the calling thread; {@code linux/prctl.h} numbers them. */
    static void control(int attribute, long value) {
        prctl(attribute, value, 0, 0, 0);
    }

    private static native int setenv(Pointer<Byte> name, Pointer<Byte> value, int overwrite);

    // Both take a variable number of arguments in C. On the processors that BridJ supports, integers are passed alike.
    @Ptr
    private static native long syscall(
            @Ptr long number, @Ptr long first, @Ptr long second, @Ptr long third, @Ptr long fourth);

    private static native int prctl(int option, @Ptr long second, @Ptr long third, @Ptr long fourth, @Ptr long fifth);

    /**
     * Numbers of the kernel of Linux that depend on the processor.
     *
     * @param auditName what the kernel calls the processor in a filter of system calls
     * @param rtSigaction number of the system call that reads and sets a signal handler
     * @param seccomp number of the system call that installs a filter
     */
    record LinuxAbi(int auditName, int rtSigaction, int seccomp) {
        /** Those of this process; BridJ has native libraries for all but {@code aarch64}, for which users may build one. */
        static final LinuxAbi HERE =
                switch (System.getProperty("os.arch")) {
                    case "amd64" -> new LinuxAbi(0xc000003e, 13, 317);
                    case "aarch64" -> new LinuxAbi(0xc00000b7, 134, 277);
                    case "arm" -> new LinuxAbi(0x40000028, 174, 383);
                    default -> new LinuxAbi(0x40000003, 174, 354);
                };
    }
}
