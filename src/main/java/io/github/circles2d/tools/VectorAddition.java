package io.github.circles2d.tools;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.opencl.OpenClUnavailableException;
import io.github.circles2d.opencl.Program;
import io.github.circles2d.opencl.Session;
import java.nio.FloatBuffer;

/**
 * The smallest complete OpenCL program: adds two vectors. It shows the eight steps that every OpenCL host program takes,
 * as taught in S. Young, "Memory Organization and Buffer Construction for GPGPU for 2D Physics" (2014).
 */
public final class VectorAddition {
    private static final int LENGTH = 1024;

    private VectorAddition() {}

    /**
     * Adds the vectors (0, 1, .., 1023) and (0, 1, .., 1023) on the best device and prints the result.
     *
     * @param args none
     */
    public static void main(String[] args) {
        float[] a = new float[LENGTH];
        float[] b = new float[LENGTH];
        for (int i = 0; i < LENGTH; i++) {
            a[i] = i;
            b[i] = i;
        }
        try {
            // Step 1: find a device.
            Device device = OpenCl.bestDevice();

            float[] sum = add(device, a, b);
            System.out.println("on " + device);
            for (int i = 0; i < LENGTH; i++) {
                System.out.printf("%.0f + %.0f = %.0f%n", a[i], b[i], sum[i]);
            }
        } catch (OpenClUnavailableException e) {
            System.err.println(e.getMessage());
            System.exit(1);
        }
    }

    /**
     * Adds two vectors of the same length.
     *
     * @param device where to compute
     * @param a the one vector
     * @param b the other vector, as long as {@code a}
     * @return a new array of the sums
     * @throws IllegalArgumentException if the lengths differ
     */
    public static float[] add(Device device, float[] a, float[] b) {
        if (a.length != b.length) {
            throw new IllegalArgumentException(
                    "the vectors must be of one length, not " + a.length + " and " + b.length);
        }
        int n = a.length;
        long bytes = (long) n * Float.BYTES;
        float[] sum = new float[n];

        // Step 2: a context that holds what belongs together, and a queue for commands. Closing the session releases
        // all.
        try (Session session = Session.open(device)) {

            // Step 3: buffers in the memory of the device, and the data in them.
            DeviceBuffer bufferA = session.allocate("a", bytes);
            DeviceBuffer bufferB = session.allocate("b", bytes);
            DeviceBuffer bufferOut = session.allocate("out", bytes);
            bufferA.write(FloatBuffer.wrap(a));
            bufferB.write(FloatBuffer.wrap(b));

            // Step 4: a program, compiled for this device.
            Program program = session.build(KernelSource.of("tools/VectorAddition.cl"));

            // Step 5: a kernel of it.
            Kernel addFloats = program.kernel("add_floats");

            // Step 6: the kernel's arguments.
            addFloats.arg(0, bufferA).arg(1, bufferB).arg(2, bufferOut).arg(3, n);

            // Step 7: enqueue it: one work-item an element.
            addFloats.run(n);

            // Step 8: read the result back; this waits until it is there.
            bufferOut.read(FloatBuffer.wrap(sum));
        }
        return sum;
    }
}
