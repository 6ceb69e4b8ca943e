package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Circles that grow in a crowd as {@link World#grow} recommends hardly overlap others, and throw none. */
class WorldMergeTest {
    private static final int FRAMES = 3_000;

    /** The greatest overlap that is allowed, in radii of the circle that grows. */
    private static final float DEEPEST = 0.15f;

    /** The greatest speed of a circle that is thrown, in its radii a second. */
    private static final float FASTEST = 2;

    private static World.Builder recommended() {
        return WorldScenes.jvm().threads(1).subSteps(8).contactFrequency(134).greatestPushOutSpeed(2);
    }

    static float gap(float[] circles, int a, int b) {
        double dx = (double) circles[4 * a] - circles[4 * b];
        double dy = (double) circles[4 * a + 1] - circles[4 * b + 1];
        return (float) (Math.hypot(dx, dy) - circles[4 * a + 2] - circles[4 * b + 2]);
    }

    @Test
    void ballsThatGrowInAMergeGameHardlyOverlapOthers() {
        for (long seed = 1; seed <= 3; seed++) {
            try (MergeGame game = new MergeGame(recommended(), MergeGame.BY_GROWTH, seed)) {
                for (int frame = 0; frame < FRAMES; frame++) {
                    game.play();
                    assertThat(game.deepestOverlap(105))
                            .as("game %d, frame %d", seed, frame)
                            .isLessThan(DEEPEST);
                }
                assertThat(game.merges).isGreaterThan(50);
            }
        }
    }

    /** The bound above says something: newcomers of the whole size do not hold it, though overlaps are pushed out fast. */
    @Test
    void ballsThatComeWithTheirWholeSizeOverlapOthersDeeply() {
        try (MergeGame game = new MergeGame(recommended(), MergeGame.AT_ONCE, 1)) {
            int deep = 0;
            for (int frame = 0; frame < FRAMES; frame++) {
                game.play();
                deep += game.deepestOverlap(105) > DEEPEST ? 1 : 0;
            }
            assertThat(deep).isGreaterThan(20);
        }
    }

    @Test
    @Tag("long")
    void aCircleThatGrowsInACrowdAtRestThrowsNone() {
        Crowd byGrowth = new Crowd((world, handle, radius) -> world.grow(handle, radius, 45));
        Crowd atOnce = new Crowd(World::setRadius);
        for (long seed = 1; seed <= 4; seed++) {
            byGrowth.run(seed);
            atOnce.run(seed);
        }
        assertThat(byGrowth.deepest).isLessThan(DEEPEST);
        assertThat(byGrowth.fastest).isLessThan(FASTEST);
        assertThat(atOnce.deepest).isGreaterThan(DEEPEST);
        assertThat(atOnce.fastest).isGreaterThan(FASTEST);
    }

    /** Makes a circle larger. */
    private interface Enlarging {
        void enlarge(World world, long handle, float radius);
    }

    /** A crowd of the balls of a merge game, of which one after the other grows to the next size, and shrinks again. */
    private static final class Crowd {
        private static final int SIZE = 45;
        private static final int SHRINK_STEPS = 60;
        private static final int STEPS_OF_ONE = 120;

        /** A circle that touched the growing one so many steps ago may be thrown by it. */
        private static final int RECENT = 10;

        private final Enlarging enlarging;
        private Random random;
        private final long[] handles = new long[SIZE];
        private final int[] kind = new int[SIZE];
        private final int[] sinceTouch = new int[SIZE];
        private final float[] circles = new float[4 * SIZE];
        private final float[] velocities = new float[2 * SIZE];

        /** The deepest overlap with the circle that grows. */
        private float deepest;

        /** The greatest speed upwards of a circle in the air that touched it shortly before. */
        private float fastest;

        Crowd(Enlarging enlarging) {
            this.enlarging = enlarging;
        }

        void run(long seed) {
            random = new Random(seed);
            try (World world = recommended()
                    .bounds(0, 0, 10, 20)
                    .gravity(0, -30)
                    .restitution(0.2f)
                    .build()) {
                settle(world);
                int grown = -1;
                for (int step = 0; step < FRAMES; step++) {
                    if (step % STEPS_OF_ONE == 0) {
                        if (grown >= 0) {
                            world.grow(handles[grown], MergeGame.RADII[kind[grown]], SHRINK_STEPS);
                        }
                        grown = random.nextInt(SIZE);
                        enlarging.enlarge(world, handles[grown], MergeGame.RADII[kind[grown] + 1]);
                        Arrays.fill(sinceTouch, STEPS_OF_ONE);
                    }
                    world.step(1 / 60f);
                    world.readById(circles, null);
                    world.readVelocitiesById(velocities, null);
                    for (int id = 0; id < SIZE; id++) {
                        look(id, grown);
                    }
                }
            }
        }

        private void settle(World world) {
            for (int id = 0; id < SIZE; id++) {
                kind[id] = random.nextInt(7);
                float r = MergeGame.RADII[kind[id]];
                handles[id] = world.add(r + random.nextFloat() * (10 - 2 * r), 18.5f, r, r * r);
                world.step(1 / 60f, 40);
            }
            world.step(1 / 60f, 900);
        }

        private void look(int id, int grown) {
            float r = circles[4 * id + 2];
            float gap = Math.min(circles[4 * id + 1], Math.min(circles[4 * id], 10 - circles[4 * id])) - r;
            for (int other = 0; other < SIZE; other++) {
                gap = other == id ? gap : Math.min(gap, gap(circles, id, other));
            }
            if (id != grown) {
                float toGrown = gap(circles, id, grown);
                deepest = Math.max(deepest, -toGrown / circles[4 * grown + 2]);
                sinceTouch[id] = toGrown <= 0.01f * r ? 0 : sinceTouch[id] + 1;
            }
            if (gap > 0.02f * r && (id == grown || sinceTouch[id] <= RECENT)) {
                fastest = Math.max(fastest, velocities[2 * id + 1] / r);
            }
        }
    }
}
