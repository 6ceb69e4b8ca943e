package io.github.circles2d.opencl;

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
