import io.github.circles2d.Backend;
import io.github.circles2d.Circles2D;
import io.github.circles2d.FixedStep;
import io.github.circles2d.World;
import io.github.circles2d.opencl.OpenClUnavailableException;

/** Run without the jars of JavaCL and BridJ: fails unless a World runs on the JVM, and OpenCL is refused by name. */
public class WithoutOpenCl {
    public static void main(String[] args) {
        // Room for so many circles that AUTO looks for a GPU, and for so few that it does not.
        for (int capacity : new int[] {10_000, 10}) {
            play(World.builder().capacity(capacity));
            play(World.builder().capacity(capacity).backend(Backend.AUTO));
            play(World.builder().capacity(capacity).backend(Backend.JVM));
        }
        refused(() -> World.builder().backend(Backend.OPENCL_CPU).build().close());
        refused(() -> World.builder().backend(Backend.OPENCL_GPU).build().close());
        refused(() -> new Circles2D(true).close());
        System.out.println("plays without OpenCL");
    }

    private static void play(World.Builder builder) {
        try (World world = builder.bounds(0, 0, 80, 100).gravity(0, -10).build()) {
            long ball = world.add(40, 90, 1, 2);
            FixedStep loop = new FixedStep(world, 1 / 60f);
            loop.advance(1 / 30f, null);
            float y = loop.positions(null).get(2 * World.id(ball) + 1);
            expect(y < 90 && y > world.y(ball), "the ball is at " + y);
            expect(world.stats().backend() == Backend.JVM, world.stats().toString());
        }
    }

    private static void refused(Runnable call) {
        try {
            call.run();
        } catch (OpenClUnavailableException e) {
            expect(e.getMessage().contains("com.nativelibs4java:javacl-core"), e.getMessage());
            return;
        }
        throw new AssertionError("something runs on OpenCL");
    }

    private static void expect(boolean condition, String message) {
        if (!condition) {
            throw new AssertionError(message);
        }
    }
}
