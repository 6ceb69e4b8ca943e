package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.reference.Event;
import io.github.circles2d.world.jvm.JvmPipeline;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Static circles that rest are left out of steps: which changes no bit of any state, event or answer. */
class WorldRestingTest {
    private static final float STATIC = Float.POSITIVE_INFINITY;
    private static final int GATE = 1;
    private static final int BELT = 2;

    /** Programs of calls and steps in two worlds, in one of which no circle rests. */
    @Test
    void aWorldInWhichStaticCirclesRestHasTheBitsOfOneInWhichNoneDoes() {
        for (int seed = 0; seed < TestScale.of(24, 60, 2000); seed++) {
            new Program(seed).run();
        }
    }

    /** Of two static circles that carry a circle from one time on, the one of the lower slot does, and slots have the order of buckets. */
    @Test
    void theSameStaticCircleCarriesAnotherAlong() {
        for (float y = 1000; y < 19_000; y += 250) {
            long[] hashes = new long[2];
            for (int k = 0; k < 2; k++) {
                JvmPipeline pipeline = new JvmPipeline(1, 1, 0, false);
                World.Builder builder =
                        WorldScenes.jvm().bounds(0, 0, 20_000, 20_000).subSteps(1);
                if (k == 0) {
                    pipeline.keepAwake();
                }
                try (World world = new World(builder, new BackendChoice(Backend.JVM, pipeline, "a test"))) {
                    for (int i = 0; i < 400; i++) {
                        world.add(300 + 20 * (i % 20), 300 + 20 * (i / 20), 408, STATIC);
                    }
                    world.add(10_000, y, 408, 1);
                    world.add(9640, y - 377, 408, STATIC, 7949, 0);
                    world.add(9640, y + 377, 408, STATIC, 6254, 2000);
                    world.step(1 / 60f);
                    hashes[k] = world.hash();
                }
            }
            assertThat(hashes[1]).as("y %s", y).isEqualTo(hashes[0]);
        }
    }

    private static final class Program {
        private final int seed;
        private final SplittableRandom random;
        private final World[] worlds = new World[2];
        private final float size;
        private final float least;
        private final float spread;
        private final float fastest;
        private final List<Long> handles = new ArrayList<>();
        private ByteBuffer snapshot;
        private List<Long> handlesOfSnapshot;

        Program(int seed) {
            this.seed = seed;
            random = new SplittableRandom(seed);
            size = new float[] {1f, 40f, 400f}[random.nextInt(3)];
            least = size / (30 + random.nextInt(200));
            spread = new float[] {0f, 1f, 4f, 6f}[random.nextInt(4)];
            fastest = size * (random.nextInt(3) == 0 ? 60f : 2f);
            Edge x = random.nextBoolean() ? Edge.WALL : Edge.values()[random.nextInt(3)];
            Edge y = random.nextBoolean() ? Edge.WALL : Edge.values()[random.nextInt(3)];
            float friction = random.nextInt(3) * 0.4f;
            float rolling = random.nextInt(2) * 0.1f;
            float restitution = random.nextInt(3) * 0.5f;
            float gravity = -random.nextInt(3) * size;
            int subSteps = 1 + random.nextInt(4);
            int threads = new int[] {1, 1, 2, 1, 1, 3}[seed % 6];
            for (int k = 0; k < worlds.length; k++) {
                JvmPipeline pipeline = new JvmPipeline(k == 0 ? 1 : threads, 1, 0, false);
                World.Builder builder = WorldScenes.jvm()
                        .bounds(0, 0, size, size)
                        .edges(x, y)
                        .gravity(0, gravity)
                        .friction(friction)
                        .rollingResistance(rolling)
                        .restitution(restitution)
                        .subSteps(subSteps);
                worlds[k] = new World(builder, new BackendChoice(Backend.JVM, pipeline, "a test"));
                if (k == 0) {
                    pipeline.keepAwake();
                }
                worlds[k].kind(GATE).setSensor(true).setSensesStatic(seed % 2 == 0);
                worlds[k].kind(BELT).setBeltSpeed(friction * size);
                worlds[k].report(Events.BEGIN | Events.HIT | Events.END);
            }
        }

        void run() {
            try {
                addMany(100 + random.nextInt(300), true);
                addMany(20 + random.nextInt(60), false);
                if (random.nextInt(3) == 0) {
                    for (World each : worlds) {
                        each.terrain().addSegment(0.3f * size, 0.2f * size, 0.7f * size, 0.25f * size);
                    }
                }
                for (int k = 0; k < 40; k++) {
                    call();
                    int steps = 1 + random.nextInt(3);
                    float dt = random.nextInt(4) == 0 ? 0.03f : 1 / 60f;
                    for (World each : worlds) {
                        each.step(dt, steps);
                    }
                    compare(k);
                }
            } finally {
                worlds[0].close();
                worlds[1].close();
            }
        }

        private float radius() {
            return Math.min(least * (float) StrictMath.pow(2, spread * random.nextDouble()), size / 12);
        }

        private float within(float edge) {
            return edge + (size - 2 * edge) * (float) random.nextDouble();
        }

        private float speed() {
            return fastest * (float) (random.nextDouble() - 0.5) * (random.nextInt(3) == 0 ? 1f : 0.1f);
        }

        private void addMany(int many, boolean isStatic) {
            boolean crowd = random.nextInt(8) == 0;
            float atX = within(0.3f * size);
            float atY = within(0.3f * size);
            for (int k = 0; k < many; k++) {
                float r = radius();
                float x =
                        crowd ? Math.min(atX + 3 * r * (float) random.nextDouble(), 0.9f * size) : within(0.1f * size);
                float y =
                        crowd ? Math.min(atY + 3 * r * (float) random.nextDouble(), 0.9f * size) : within(0.1f * size);
                int kind = random.nextInt(4) == 0 ? 1 + random.nextInt(2) : 0;
                float vx = isStatic ? 0 : speed();
                float vy = isStatic ? 0 : speed();
                long handle = 0;
                for (World each : worlds) {
                    handle = each.add(x, y, r, isStatic ? STATIC : 0.1f + k % 7, vx, vy, kind);
                }
                handles.add(handle);
            }
        }

        private void call() {
            for (int k = random.nextInt(6); k > 0 && !handles.isEmpty(); k--) {
                int at = random.nextInt(handles.size());
                long handle = handles.get(at);
                int what = random.nextInt(20);
                float a = within(0.1f * size);
                float b = within(0.1f * size);
                float c = speed();
                float d = speed();
                float r = radius();
                switch (what) {
                    case 0 -> handles.remove(at);
                    case 1 -> addMany(1 + random.nextInt(20), true);
                    case 2 -> addMany(1 + random.nextInt(3), false);
                    case 3 -> {
                        snapshot = ByteBuffer.allocate(worlds[1].snapshotBytes());
                        worlds[1].snapshot(snapshot);
                        snapshot.flip();
                        handlesOfSnapshot = new ArrayList<>(handles);
                    }
                    default -> {}
                }
                if (what == 4 && snapshot != null) {
                    for (World each : worlds) {
                        each.restore(snapshot.duplicate());
                    }
                    handles.clear();
                    handles.addAll(handlesOfSnapshot);
                    continue;
                }
                assertThat(isRefused(() -> call(worlds[1], what, handle, a, b, c, d, r, at)))
                        .isEqualTo(isRefused(() -> call(worlds[0], what, handle, a, b, c, d, r, at)));
            }
        }

        private static boolean isRefused(Runnable call) {
            try {
                call.run();
                return false;
            } catch (IllegalArgumentException refused) {
                return true;
            }
        }

        private void call(World world, int what, long handle, float a, float b, float c, float d, float r, int at) {
            switch (what) {
                case 0 -> world.remove(handle);
                case 5 -> world.setPosition(handle, a, b);
                case 6 -> world.teleport(handle, a, b);
                case 7 -> world.setVelocity(handle, c, d);
                case 8 -> world.setVelocity(handle, 0, 0);
                case 9 -> world.setVelocity(handle, 0, -0f);
                case 10 -> world.setMass(handle, STATIC);
                case 11 -> world.setMass(handle, 1);
                case 12 -> world.setRadius(handle, r);
                case 13 -> world.grow(handle, r, 3);
                case 14 -> world.setKind(handle, at % 3);
                case 15 -> world.setGroup(handle, at % 4);
                case 16 -> world.setBounds(0.01f * (at % 5) * size, 0, size, size);
                case 17 -> world.setFriction(handle, 0.3f);
                case 18 -> world.setAngularVelocity(handle, c);
                case 19 -> world.kind(BELT).setBeltSpeed(0.1f * c);
                default -> {}
            }
        }

        private void compare(int step) {
            String when = "program " + seed + " after step " + step;
            assertThat(worlds[1].hash()).as("hash of %s", when).isEqualTo(worlds[0].hash());
            assertThat(Event.of(worlds[1].events())).as("events of %s", when).isEqualTo(Event.of(worlds[0].events()));
            assertThat(worlds[1].stats().contacts())
                    .as("contacts of %s", when)
                    .isEqualTo(worlds[0].stats().contacts());
            assertThat(worlds[1].positions()).as("positions of %s", when).isEqualTo(worlds[0].positions());
            assertThat(snapshot(worlds[1])).as("snapshot of %s", when).isEqualTo(snapshot(worlds[0]));
            float x = within(0.1f * size);
            float y = within(0.1f * size);
            assertThat(near(worlds[1], x, y)).as("query in %s", when).isEqualTo(near(worlds[0], x, y));
        }

        private long[] near(World world, float x, float y) {
            long[] found = new long[64];
            int many = world.queries().overlapCircle(x, y, 0.1f * size, found);
            return Arrays.copyOf(found, Math.min(many, found.length));
        }
    }
}
