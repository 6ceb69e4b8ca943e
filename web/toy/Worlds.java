import io.github.circles2d.Backend;
import io.github.circles2d.Edge;
import io.github.circles2d.Joint;
import io.github.circles2d.World;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Writes a world that no scene of the playground has: with an edge that wraps, an open one, sensors, ground that is passed from behind,
 * and a pin whose force has a limit. {@code java Worlds.java FOLDER} writes it as edges-30.circles2d, and as it is 60 steps later as edges-90.circles2d, and prints their hashes.
 */
final class Worlds {
    private static final float DT = 1 / 60f;

    public static void main(String[] arguments) throws IOException {
        World.Builder builder = World.builder().backend(Backend.JVM).bounds(-500, 200, 700, 260).gravity(0, -40);
        try (World world = builder.edges(Edge.WRAP, Edge.OPEN).friction(0.3f).build()) {
            world.kind(1).setSensor(true);
            world.kind(2).setOneWay(true);
            world.terrain().addSegment(-400, -100, 100, -180, 4, 0);
            world.terrain().addSegment(0, -100, 100, -80, 3, 2);
            for (int k = 0; k < 60; k++) {
                long circle = world.add(-480 + 19 * k, 300 + 31 * (k % 7), 5 + k % 4, 1 + k % 4, 8 * k - 200, 0);
                world.setKind(circle, k % 10 == 0 ? 1 : 0);
                if (k == 1) {
                    world.joints().add(circle, world.x(circle), world.y(circle), Joint.mouse(2, 1, 500));
                }
            }
            world.step(DT, 30);
            save(world, Path.of(arguments[0], "edges-30.circles2d"));
            world.step(DT, 60);
            save(world, Path.of(arguments[0], "edges-90.circles2d"));
        }
    }

    private static void save(World world, Path file) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(bytes);
        Files.write(file, bytes.array());
        System.out.println(String.format("%s: hash %016x", file, world.hash()));
    }
}
