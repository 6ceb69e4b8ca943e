package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A positive belt carries to the right of the normal, whatever has it. */
class BeltSignTest {
    private static final float STEP = 1 / 60f;
    private static final int STEPS = 6;
    private static final float PRESS = 20;
    private static final float R = 0.5f;
    private static final float GAP = 0.001f; // those that begin behind a one-way piece pass

    private static final int STILL = 0;
    private static final int BELT = 1;
    private static final int ONE_WAY = 2;

    /** Circles that do not turn, without and with a belt. */
    private static final int RIDER = 3;

    private static final int CRAWLER = 4;

    /** Ways out of a surface: of a floor, a ceiling, both walls, and slopes. */
    private static final float[][] NORMALS = {{0, 1}, {0, -1}, {1, 0}, {-1, 0}, {0.6f, 0.8f}, {-0.8f, -0.6f}};

    /** A surface through a place with a normal. */
    private interface Form {
        void add(World world, float x, float y, float nx, float ny, int kind);
    }

    private static final List<Form> FORMS = List.of(
            (w, x, y, nx, ny, kind) -> w.terrain().addSegment(x - 2 * ny, y + 2 * nx, x + 2 * ny, y - 2 * nx, 0, kind),
            (w, x, y, nx, ny, kind) -> w.terrain().addSegment(x + 2 * ny, y - 2 * nx, x - 2 * ny, y + 2 * nx, 0, kind),
            (w, x, y, nx, ny, kind) -> {
                float cx = x - 0.25f * nx;
                float cy = y - 0.25f * ny;
                w.terrain().addSegment(cx - 2 * ny, cy + 2 * nx, cx + 2 * ny, cy - 2 * nx, 0.25f, kind);
            },
            (w, x, y, nx, ny, kind) -> // circles are on its right
            w.terrain().addChain(Chain.of(x + 2 * ny, y - 2 * nx, x - 2 * ny, y + 2 * nx), kind, null),
            (w, x, y, nx, ny, kind) ->
                    w.terrain().addArc(x - 3 * nx, y - 3 * ny, 3, 0, 2 * (float) Math.PI, ArcSide.OUTER, kind),
            (w, x, y, nx, ny, kind) ->
                    w.terrain().addArc(x + 3 * nx, y + 3 * ny, 3, 0, 2 * (float) Math.PI, ArcSide.INNER, kind),
            (w, x, y, nx, ny, kind) -> w.terrain()
                    .addBody(x, y, (float) Math.atan2(-nx, ny)) // its y is the normal
                    .addSegment(-2, 0, 2, 0, 0, kind),
            (w, x, y, nx, ny, kind) -> w.terrain()
                    .addBody(x, y, (float) Math.atan2(-nx, ny))
                    .addArc(0, -3, 3, 0, 2 * (float) Math.PI, ArcSide.OUTER, kind),
            (w, x, y, nx, ny, kind) -> w.setKind(w.add(x - 3 * nx, y - 3 * ny, 3, Float.POSITIVE_INFINITY), kind));

    /** A world, and circles in it that something presses against a surface. */
    private static final class Riders {
        final World world;
        final float belt;
        final List<Long> handles = new ArrayList<>();
        final List<float[]> normals = new ArrayList<>();
        final List<Integer> kinds = new ArrayList<>();

        Riders(Backend backend, float belt, boolean byBuilder) {
            this.belt = belt;
            World.Builder builder =
                    World.builder().backend(backend).bounds(0, 0, 200, 200).friction(1);
            if (byBuilder) {
                for (Wall wall : Wall.values()) {
                    builder.wallSurface(wall, 1, 0, belt);
                }
            }
            world = builder.build();
            if (!byBuilder) {
                for (Wall wall : Wall.values()) {
                    world.setWallSurface(wall, 1, 0, belt);
                }
            }
            world.kind(BELT).setBeltSpeed(belt);
            world.kind(ONE_WAY).setBeltSpeed(belt).setOneWay(true);
            world.kind(RIDER).setInertia(Inertia.NONE);
            world.kind(CRAWLER).setInertia(Inertia.NONE).setBeltSpeed(belt);
            ride(100, 0, 0, 1, RIDER);
            ride(100, 200, 0, -1, RIDER);
            ride(0, 100, 1, 0, RIDER);
            ride(200, 100, -1, 0, RIDER);
            for (int form = 0; form < FORMS.size(); form++) {
                for (int k = 0; k < NORMALS.length; k++) {
                    float[] n = NORMALS[k];
                    float x = 15 + 20 * form;
                    float y = 15 + 20 * k;
                    FORMS.get(form).add(world, x, y, n[0], n[1], BELT);
                    ride(x, y, n[0], n[1], RIDER);
                }
            }
            for (int k = 0;
                    k < NORMALS.length;
                    k++) { // a segment in one direction, and a chain: circles are in front of both
                float[] n = NORMALS[k];
                FORMS.get(1).add(world, 15 + 20 * k, 135, n[0], n[1], ONE_WAY);
                ride(15 + 20 * k, 135, n[0], n[1], RIDER);
                FORMS.get(3).add(world, 15 + 20 * k, 155, n[0], n[1], ONE_WAY);
                ride(15 + 20 * k, 155, n[0], n[1], RIDER);
                FORMS.get(0).add(world, 15 + 20 * k, 175, n[0], n[1], STILL);
                ride(15 + 20 * k, 175, n[0], n[1], CRAWLER);
            }
        }

        private void ride(float x, float y, float nx, float ny, int kind) {
            long circle = world.add(x + (R + GAP) * nx, y + (R + GAP) * ny, R, 1, 0, 0, kind);
            world.setForce(circle, -PRESS * nx, -PRESS * ny);
            handles.add(circle);
            normals.add(new float[] {nx, ny});
            kinds.add(kind);
        }

        void assertCarried() {
            for (int k = 0; k < handles.size(); k++) {
                float[] n = normals.get(k);
                float right = n[1] * world.vx(handles.get(k)) - n[0] * world.vy(handles.get(k));
                assertThat(right)
                        .as("number %d with the normal (%s, %s), of kind %d", k, n[0], n[1], kinds.get(k))
                        .isCloseTo(Math.signum(belt) * PRESS * STEPS * STEP, within(0.2f));
            }
            for (Wall wall : Wall.values()) {
                assertThat(world.wallBeltSpeed(wall)).isEqualTo(belt);
            }
            assertThat(world.kind(BELT).beltSpeed()).isEqualTo(belt);
        }
    }

    @OnEachBackend
    void aBeltCarriesToTheRightOfTheNormalWhateverHasIt(Backend backend) {
        for (float belt : new float[] {5, -5}) {
            Riders bySetters = new Riders(backend, belt, false);
            Riders byBuilder = new Riders(backend, belt, true);
            try (World world = bySetters.world;
                    World other = byBuilder.world) {
                world.step(STEP, STEPS);
                other.step(STEP, STEPS);
                bySetters.assertCarried();
                byBuilder.assertCarried();
                assertThat(other.hash()).isEqualTo(world.hash());
            }
        }
    }

    @OnEachBackend
    void snapshotsAndLogsKeepTheSign(Backend backend) throws IOException {
        Riders riders = new Riders(backend, 5, true);
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        try (World world = riders.world;
                World restored = World.builder().backend(backend).build();
                World repeated = World.builder().backend(backend).build()) {
            ByteBuffer snapshot = ByteBuffer.allocateDirect(world.snapshotBytes());
            world.snapshot(snapshot);
            try (Recording recording = new Recording(world, log, 1)) {
                for (Wall wall : Wall.values()) {
                    world.setWallSurface(wall, 1, 0, 7);
                }
                world.kind(BELT).setBeltSpeed(7);
                world.step(STEP, STEPS);
                assertThat(recording.steps()).isEqualTo(STEPS);
            }
            new Replay(new ByteArrayInputStream(log.toByteArray()), repeated).run();
            assertThat(repeated.hash()).isEqualTo(world.hash());
            assertBelts(repeated, 7);
            restored.restore(snapshot.flip());
            assertBelts(restored, 5);
        }
    }

    private static void assertBelts(World world, float speed) {
        for (Wall wall : Wall.values()) {
            assertThat(world.wallBeltSpeed(wall)).isEqualTo(speed);
        }
        assertThat(world.kind(BELT).beltSpeed()).isEqualTo(speed);
    }

    @Test
    void aRefusalNamesTheSpeedThatWasGiven() {
        try (World world = WorldScenes.jvm().build()) {
            for (float speed : new float[] {2e9f, -2e9f}) {
                assertIllegalArgument(
                        "belt speed is " + speed, () -> world.kind(0).setBeltSpeed(speed));
                for (Wall wall : Wall.values()) {
                    assertIllegalArgument("belt speed is " + speed, () -> world.setWallSurface(wall, 0, 0, speed));
                }
            }
            assertBelts(world, 0);
            world.kind(1).setBeltSpeed(0f);
            for (Wall wall : Wall.values()) {
                world.setWallSurface(wall, 0, 0, -0f);
                assertThat(Float.floatToRawIntBits(world.wallBeltSpeed(wall))).isZero();
            }
            assertThat(Float.floatToRawIntBits(world.kind(1).beltSpeed())).isZero();
        }
    }
}
