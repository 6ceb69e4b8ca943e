package io.github.circles2d.opencl;

/**
 * Main class for {@link SignalsTest}: compiles kernels while two threads run compiled loops and stack traces are asked for. Java
 * stops such threads by SIGSEGV, both at the same moment.
 */
final class SafepointProgram {
    private static volatile long result;

    private SafepointProgram() {}

    public static void main(String[] arguments) {
        int rounds = Integer.parseInt(arguments[0]);
        for (int i = 0; i < 2; i++) {
            Thread thread = new Thread(SafepointProgram::loop);
            thread.setDaemon(true);
            thread.start();
        }
        try (Session session = Session.open(OpenCl.cpuDevice())) {
            DeviceBuffer data = session.allocate("data", 1024);
            for (int round = 0; round < rounds; round++) {
                String name = "kernel" + round; // another one each time, so that no cache has it
                Program program = session.build(KernelSource.ofText(
                        name, "kernel void " + name + "(global int *data) {\n    data[get_global_id(0)] = 1;\n}\n"));
                program.kernel(name).arg(0, data).run(256);
                for (int k = 0; k < 10; k++) {
                    Thread.getAllStackTraces();
                }
                System.out.println("round " + round);
            }
        }
        System.out.println("survived");
    }

    private static void loop() {
        while (true) {
            long sum = 1;
            for (int i = 0; i < 1_000_000; i++) {
                sum = sum * 31 + i;
            }
            result = sum;
        }
    }
}
