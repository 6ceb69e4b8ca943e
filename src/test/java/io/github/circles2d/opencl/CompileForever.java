package io.github.circles2d.opencl;

/** Main class for {@link SignalsTest}: compiles again and again, or once and then waits, until a signal ends it. */
final class CompileForever {
    private CompileForever() {}

    public static void main(String[] arguments) throws InterruptedException {
        boolean once = arguments[0].equals("once");
        Runtime.getRuntime().addShutdownHook(new Thread(() -> System.out.println("shutdown hook ran")));
        for (int round = 0; ; round++) {
            try (Session session = Session.open(OpenCl.cpuDevice())) {
                session.build(KernelSource.ofText(
                        "k", "kernel void k" + round + "(global int *data) {\n    *data = 1;\n}\n"));
            }
            System.out.println("compiled " + round);
            if (once) {
                Thread.sleep(Long.MAX_VALUE);
            }
        }
    }
}
