package io.github.circles2d.tools;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.Session;
import java.nio.FloatBuffer;
import java.util.Locale;

/** The outcome of compiling a tiny kernel for a device, running it and comparing what it computed with Java. */
final class DeviceCheck {
    private static final int COUNT = 10_000;

    /** The largest relative error of a device that may round each of the three operations as it likes. */
    private static final float TOLERANCE = 1e-5f;

    private final boolean works;
    private final String finding;

    private DeviceCheck(boolean works, String finding) {
        this.works = works;
        this.finding = finding;
    }

    boolean works() {
        return works;
    }

    /** What was found, one line for people. */
    String finding() {
        return finding;
    }

    static DeviceCheck of(Device device) {
        float[] in = new float[COUNT];
        for (int i = 0; i < COUNT; i++) {
            in[i] = i * 0.37f;
        }
        float[] out = new float[COUNT];
        long start = System.nanoTime();
        try (Session session = Session.open(device)) {
            String[] options =
                    device.correctlyRounded() ? new String[] {"-cl-fp32-correctly-rounded-divide-sqrt"} : new String[0];
            DeviceBuffer input = session.allocate("in", (long) Float.BYTES * COUNT);
            DeviceBuffer output = session.allocate("out", (long) Float.BYTES * COUNT);
            input.write(FloatBuffer.wrap(in));
            session.build(KernelSource.of("tools/DeviceCheck.cl"), options)
                    .kernel("device_check")
                    .arg(0, input)
                    .arg(1, output)
                    .arg(2, COUNT)
                    .run(COUNT);
            output.read(FloatBuffer.wrap(out));
        } catch (OpenClException e) {
            return new DeviceCheck(false, "does not work: " + explain(e.getMessage()));
        }
        return judge(in, out, (System.nanoTime() - start) / 1_000_000);
    }

    /** Adds what is known of a failure to the driver's own words. */
    static String explain(String message) {
        if (message.contains("unknown target CPU")) {
            return "this POCL is older than the processor: the compiler in it does not know it. Use a newer POCL (that of"
                    + " Ubuntu 24.04 or Debian 12, or later). " + message.trim();
        }
        return message.trim();
    }

    /** Compares with the same formula in Java, whose operations are rounded correctly. */
    static DeviceCheck judge(float[] in, float[] out, long millis) {
        int otherBits = 0;
        for (int i = 0; i < in.length; i++) {
            float quotient = (float) Math.sqrt(in[i]) / (i + 1);
            float product = in[i] * 0.1f;
            float expected = quotient - product;
            float scale = Math.max(Math.abs(quotient), Math.abs(product));
            if (!(Math.abs(out[i] - expected) <= TOLERANCE * scale)) {
                return new DeviceCheck(
                        false,
                        String.format(
                                Locale.ROOT,
                                "does not work: a kernel computed %s where %s is right (element %d)",
                                out[i],
                                expected,
                                i));
            }
            if (Float.floatToIntBits(out[i]) != Float.floatToIntBits(expected)) {
                otherBits++;
            }
        }
        String rounding = otherBits == 0
                ? "to the same bits as Java"
                : String.format(
                        Locale.ROOT, "but %d of %d results differ from Java in the last bits", otherBits, in.length);
        return new DeviceCheck(
                true,
                String.format(
                        Locale.ROOT, "works: compiled and ran a kernel in %d ms, results right %s", millis, rounding));
    }
}
