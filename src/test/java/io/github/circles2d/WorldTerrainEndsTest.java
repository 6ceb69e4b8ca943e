package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Circles go around the ends of pieces, beside them and behind them as if nothing were there; tips and bowls are as solid as all else. */
class WorldTerrainEndsTest {
    private static final float STEP = 1 / 60f;
    private static final float PI = (float) Math.PI;

    private static World world(double gravity) {
        return TerrainBall.builder(gravity, 0.6, 0).build();
    }

    /** A disc rolls off a line with a front, and falls beside it until it is below. */
    @ParameterizedTest
    @ValueSource(floats = {0.3f, 1, 3, 30})
    void whoRollsOffTheEndOfAChainFallsBelowIt(float speed) {
        try (TerrainBall ball =
                TerrainBall.at(-1, 0.5, TerrainBall.builder(10, 0.6, 0)).on(true, 0, 0, -20, 0)) {
            ball.world.terrain().addSegment(2.2f, 2, 2.2f, -20); // a wall that sends fast ones back below the line
            ball.step(30);
            ball.roll(speed);
            double last = ball.y();
            boolean below = false;
            for (int step = 0; step < 400; step++) {
                ball.step(1);
                below |= ball.y() < -0.5;
                assertThat(below && ball.y() > last + 1e-4)
                        .as("pulled up at %s", ball.y())
                        .isFalse();
                last = ball.y();
            }
            assertThat(below).isTrue();
        }
    }

    /** A disc rolls out of half a pipe over its lip, and falls outside. */
    @ParameterizedTest
    @ValueSource(floats = {6, 7, 9, 14})
    void whoLeavesAHalfPipeFallsOutside(float speed) {
        try (World world = world(10)) {
            world.terrain().addArc(0, 0, 1, PI, 2 * PI, ArcSide.INNER);
            long ball = world.add(0, -0.8f, 0.2f, 1, speed, 0);
            world.setAngularVelocity(ball, -speed / 0.2f);
            world.kind(0).setFriction(0);
            world.setForce(ball, 0.8f, 0);
            double lowest = 0;
            for (int step = 0; step < 240; step++) {
                world.step(STEP);
                lowest = Math.min(lowest, world.y(ball));
            }
            assertThat(lowest).isLessThan(-5);
            assertThat(Math.abs(world.vx(ball))).isLessThan(speed + 4);
        }
    }

    /** Circles that pass a segment, a line, an arc or a tip at a distance keep their velocity to the bit. */
    @ParameterizedTest
    @CsvSource({"0.1, 100", "0.02, 390", "0.1, 5", "0.5, 2"})
    @Tag("long")
    void whoMissesTerrainKeepsItsVelocity(float r, float speed) {
        SplittableRandom random = new SplittableRandom(3);
        for (int form = 0; form < 5; form++) {
            for (int k = 0; k < 200; k++) {
                double aim = 2 * Math.PI * random.nextDouble();
                double off = (k % 2 == 0 ? 1 : -1) * (1 + 1.5 * r + random.nextDouble() * r);
                float x = (float) (-5 * Math.cos(aim) - off * Math.sin(aim));
                float y = (float) (-5 * Math.sin(aim) + off * Math.cos(aim));
                float vx = (float) (speed * Math.cos(aim));
                float vy = (float) (speed * Math.sin(aim));
                try (World world = world(0)) {
                    build(world.terrain(), form); // within a radius of 1
                    long ball = world.add(x, y, r, 1, vx, vy);
                    world.step(STEP, (int) (12 / speed * 60) + 12);
                    assertThat(world.vx(ball)).as("form %d, shot %d", form, k).isEqualTo(vx);
                    assertThat(world.vy(ball)).as("form %d, shot %d", form, k).isEqualTo(vy);
                }
            }
        }
    }

    private static void build(Terrain terrain, int form) {
        switch (form) {
            case 0 -> terrain.addSegment(-1, 0, 1, 0);
            case 1 -> terrain.addChain(Chain.of(1, 0, -1, 0));
            case 2 -> terrain.addArc(0, 0, 1, PI, 2 * PI, ArcSide.INNER);
            case 3 -> terrain.addArc(0, 0, 1, 0, PI, ArcSide.OUTER);
            default -> terrain.addChain(needle());
        }
    }

    /** A tip of 11 degrees at (1, 0); its front is outside. */
    private static Chain needle() {
        return Chain.of(1, 0, -0.9f, 0.2f, -0.9f, -0.2f).close();
    }

    /** The tip of a needle is an obstacle from all sides, and nobody who goes around it is pulled through. */
    @ParameterizedTest
    @CsvSource({"0.1, 100", "0.02, 390", "0.1, 3"})
    void nobodyPassesATip(float r, float speed) {
        SplittableRandom random = new SplittableRandom(5);
        for (int k = 0; k < 300; k++) {
            double from = (random.nextDouble() - 0.5) * Math.PI * 1.6;
            double off = (2 * random.nextDouble() - 1) * 0.9 * r;
            float vx = (float) (-speed * Math.cos(from));
            float vy = (float) (-speed * Math.sin(from));
            double way = 3 * r + speed * STEP * random.nextDouble();
            try (World world = world(0)) {
                world.terrain().addChain(needle());
                float x = (float) (1 + way * Math.cos(from) - off * Math.sin(from));
                float y = (float) (way * Math.sin(from) + off * Math.cos(from));
                long ball = world.add(x, y, r, 1, vx, vy);
                for (int step = 0; step < 20; step++) {
                    world.step(STEP);
                    assertThat(inNeedle(world.x(ball), world.y(ball)))
                            .as("shot %d", k)
                            .isFalse();
                }
                double speedNow = Math.hypot(world.vx(ball), world.vy(ball));
                assertThat(speedNow).as("shot %d", k).isLessThan(speed * 1.001);
                assertThat(world.vx(ball) == vx && world.vy(ball) == vy)
                        .as("shot %d passes, from %s, off %s", k, Math.toDegrees(from), off)
                        .isFalse();
            }
        }
    }

    private static boolean inNeedle(double x, double y) {
        return x > -0.9 && Math.abs(y) < 0.2 * (1 - x) / 1.9;
    }

    /** Bowls are as solid for who comes from far above, however fast, as for who is inside. */
    @ParameterizedTest
    @CsvSource({"0.02, 390", "0.05, 200", "0.1, 10"})
    void nobodyFallsThroughABowl(float r, float speed) {
        for (int k = 0; k < 100; k++) {
            try (World world = world(0)) {
                world.terrain().addArc(0, 0, 0.5f, PI, 2 * PI, ArcSide.INNER);
                long ball = world.add(-0.4f + 0.008f * k, 1 + 0.03f * k, r, 1, 0, -speed);
                for (int step = 0; step < 60; step++) {
                    world.step(STEP);
                    boolean through = world.y(ball) < 0 && Math.hypot(world.x(ball), world.y(ball)) > 0.5;
                    assertThat(through).as("shot %d", k).isFalse();
                }
            }
        }
    }

    /** A floor ends at a wall that is thinner than a disc; behind it the ground is lower. */
    @Test
    void aFloorIsNotFeltBehindAThinWall() {
        try (World world = world(10)) {
            world.terrain().addChain(Chain.of(5, -0.3f, 0.02f, -0.3f, 0.02f, 1, 0, 1, 0, 0, -5, 0));
            long ball = world.add(0.53f, 0.2f, 0.5f, 1, 0, 0);
            world.step(STEP, 60);
            assertThat(world.y(ball)).isCloseTo(0.2f, within(1e-3f));
            assertThat(world.x(ball)).isCloseTo(0.53f, within(0.01f));
        }
    }
}
