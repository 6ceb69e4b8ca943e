import io.github.circles2d.Backend;
import io.github.circles2d.Circles2D;
import io.github.circles2d.World;
import io.github.circles2d.opencl.OpenClUnavailableException;

/** Run without the jars of JavaCL and BridJ: fails unless a World runs on the JVM, and OpenCL is refused by name. */
public class WithoutOpenCl {
    public static void main(String[] args) {
        // Room for so many circles that AUTO looks for a GPU.
        try (World world = World.builder().bounds(0, 0, 80, 100).capacity(10_000).build()) {
            world.add(40, 90, 1, 2);
            world.step(1 / 60f);
            expect(world.stats().backend() == Backend.JVM, world.stats().toString());
        }
        try (Circles2D physics = new Circles2D(true)) {
            throw new AssertionError("Circles2D runs on " + physics.device());
        } catch (OpenClUnavailableException e) {
            expect(e.getMessage().contains("com.nativelibs4java:javacl-core"), e.getMessage());
        }
    }

    private static void expect(boolean condition, String message) {
        if (!condition) {
            throw new AssertionError(message);
        }
    }
}
