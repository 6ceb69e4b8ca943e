package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.TestDevices;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Worlds at the ends of the ranges that they promise, where the cells on a circle's way are more than an int counts. */
class WorldRangesTest {
    private static final float STEP = 1 / 60f;
    private static final float GREATEST = 1e9f;
    private static final float STATIC = Float.POSITIVE_INFINITY;
    private static final int ALL = Events.BEGIN | Events.HIT | Events.END;
    private static final int SENSOR = 1;

    static Stream<World.Builder> backEnds() {
        return Stream.concat(Stream.of(WorldScenes.jvm()), devices());
    }

    static Stream<World.Builder> devices() {
        return TestDevices.all().stream().map(device -> World.builder().device(device));
    }

    @ParameterizedTest
    @MethodSource("backEnds")
    void aSensorThatTravelsToTheEndOfCoordinatesNoticesWhatIsInItsWay(World.Builder builder) {
        try (World world =
                builder.bounds(0, 0, 100, 100).edges(Edge.WALL, Edge.OPEN).build()) {
            List<String> expected = new ArrayList<>();
            for (int k = 1; k <= 20; k++) {
                expected.add("0 1 " + World.id(world.add(50, -1000 * k, 1e-4f, 1)) + " 40");
                world.add(48, -1000 * k, 1e-4f, 1);
            }
            long sensor = world.add(50, 10, 1, STATIC, 0, -GREATEST, SENSOR);
            world.kind(SENSOR).setSensor(true);
            world.terrain().addSegment(-90, 0, -80, 0, 0, 0); // all worlds here have it, so devices compile once
            world.report(ALL);
            world.step(1);
            assertThat(events(world)).containsExactlyInAnyOrderElementsOf(expected);
            assertThat(world.y(sensor)).isEqualTo(-GREATEST);
        }
    }

    @ParameterizedTest
    @MethodSource("backEnds")
    void aCircleThatIsTakenToTheEndOfCoordinatesIsNoticedByWhatIsInItsWay(World.Builder builder) {
        try (World world =
                builder.bounds(-50, -50, 50, 50).edges(Edge.OPEN, Edge.WALL).build()) {
            long gate = world.add(1000, 0, 30, STATIC, 0, 0, SENSOR);
            long speck = world.add(2000, 0.2f, 1e-4f, STATIC, 0, 0, SENSOR);
            long pushed = world.add(3, 0, 0.5f, 1);
            long pusher = world.add(0, 0, 1, STATIC);
            world.kind(SENSOR).setSensor(true);
            world.terrain().addSegment(0, 90, 0, 80, 0, 0);
            world.report(0, SENSOR, ALL);
            world.setPosition(pusher, GREATEST, 0);
            world.step(1);
            assertThat(world.x(pushed)).isGreaterThan(0.9f * GREATEST);
            assertThat(events(world))
                    .containsExactly(
                            "0 1 " + World.id(gate) + " " + World.id(pushed),
                            "0 1 " + World.id(speck) + " " + World.id(pushed));
        }
    }

    /** Circles of all sizes at all speeds, among them a body of terrain; compared after each step, also when the steps are made again. */
    @ParameterizedTest
    @MethodSource("devices")
    void fastestWorldsHaveTheSameBitsAndEvents(World.Builder device) {
        Edge[][] edges = {{Edge.WALL, Edge.OPEN}, {Edge.WRAP, Edge.WALL}, {Edge.OPEN, Edge.WALL}, {Edge.OPEN, Edge.WRAP}
        };
        for (Edge[] each : edges) {
            try (World one = settings(WorldScenes.jvm(), each).build();
                    World three = WorldScenes.onThreads(3, settings(WorldScenes.jvm(), each));
                    World onDevice = settings(device, each).build()) {
                List<World> worlds = List.of(one, three, onDevice);
                List<Rewind> rewinds = new ArrayList<>();
                for (World world : worlds) {
                    fill(world, new SplittableRandom(7));
                    rewinds.add(new Rewind(world, 1));
                }
                rewinds.forEach(rewind -> rewind.save(0));
                List<String> first = run(worlds);
                rewinds.forEach(rewind -> rewind.restore(0));
                assertThat(run(worlds)).isEqualTo(first);
            }
        }
    }

    private static World.Builder settings(World.Builder builder, Edge[] edges) {
        return builder.bounds(0, 0, 100, 100)
                .edges(edges[0], edges[1])
                .gravity(0, -1e6f)
                .restitution(0.5f);
    }

    private static void fill(World world, SplittableRandom random) {
        for (int i = 0; i < 300; i++) {
            float r = (float) (3 * StrictMath.pow(1000, -random.nextDouble()));
            float mass = i % 9 == 0 ? STATIC : 1;
            float fastest = i % 3 == 0 ? GREATEST : 6000;
            world.add(
                    100 * (float) random.nextDouble(),
                    100 * (float) random.nextDouble(),
                    r,
                    mass,
                    fastest * (float) random.nextDouble(-1, 1),
                    fastest * (float) random.nextDouble(-1, 1),
                    i % 4);
        }
        world.kind(SENSOR).setSensor(true);
        world.setResponse(0, 3, Response.SENSE);
        TerrainBody body = world.terrain().addBody(117, 48, 0);
        body.addChain(Chain.of(-20, -20, 20, -20, 20, 20, -20, 20).close());
        body.setVelocity(6.4e8f, -9e8f);
        body.setAngularVelocity(9);
        world.report(ALL);
    }

    /** Makes the same steps in all, and tells what comes of each. */
    private static List<String> run(List<World> worlds) {
        List<String> told = new ArrayList<>();
        for (float step : new float[] {STEP, STEP, 1, STEP, 1e-6f, 0.3f}) {
            String expected = null;
            for (World world : worlds) {
                world.step(step);
                ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
                world.snapshot(snapshot);
                List<String> events = events(world);
                assertThat(events).isNotEmpty();
                String now = Long.toHexString(world.hash()) + " " + Arrays.hashCode(snapshot.array()) + " " + events;
                expected = expected == null ? now : expected;
                assertThat(now)
                        .as("edges %s, %s, step %d", world.edgeX(), world.edgeY(), told.size())
                        .isEqualTo(expected);
            }
            told.add(expected);
        }
        return told;
    }

    /** Step, type and partners of each. */
    private static List<String> events(World world) {
        List<String> list = new ArrayList<>();
        Events events = world.events();
        for (int i = 0; i < events.size(); i++) {
            list.add(events.step(i) + " " + events.type(i) + " " + World.id(events.a(i)) + " " + World.id(events.b(i)));
        }
        return list;
    }
}
