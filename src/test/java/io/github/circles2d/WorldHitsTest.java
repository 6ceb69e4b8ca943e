package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A thousand collisions of two circles, at speeds from 1 to 100, head-on and oblique: each is one begin, one hit and one end. */
class WorldHitsTest {
    private static final int COLLISIONS = 1000;
    private static final float RADIUS = 0.5f;

    /** Circles that stick do not part by themselves: after so many steps one of them is removed. */
    private static final int STEPS = 40;

    private int begins;
    private int hits;
    private int ends;
    private float speed;
    private float impulseX;
    private float impulseY;

    @ParameterizedTest
    @ValueSource(floats = {0f, 0.5f, 1f})
    void eachIsOneBeginOneHitAndOneEnd(float restitution) {
        SplittableRandom random = new SplittableRandom(1);
        try (World world = WorldScenes.jvm()
                .bounds(-1000, -1000, 1000, 1000)
                .restitution(restitution)
                .build()) {
            world.report(Events.BEGIN | Events.HIT | Events.END | Events.WALL);
            for (int k = 0; k < COLLISIONS; k++) {
                double v = 1 + 99.0 * k / (COLLISIONS - 1);
                double angle = random.nextDouble() * 2 * Math.PI;
                double offset = (random.nextDouble() * 2 - 1) * 0.5 * RADIUS;
                double distance = 2.1 * RADIUS + v * (0.02 + 0.3 * random.nextDouble());
                double x = Math.cos(angle);
                double y = Math.sin(angle);
                float mass = 1 + (float) random.nextDouble();
                long target = world.add(0, 0, RADIUS, 1 + (float) random.nextDouble());
                long flying = world.add(
                        (float) (-x * distance - y * offset),
                        (float) (-y * distance + x * offset),
                        RADIUS,
                        mass,
                        (float) (x * v),
                        (float) (y * v));
                float beforeX = world.vx(flying);
                float beforeY = world.vy(flying);
                clear();
                for (int step = 0; step < STEPS; step++) {
                    world.step(1 / 60f);
                    take(world.events(), target, flying);
                }
                double px = mass * (world.vx(flying) - beforeX);
                double py = mass * (world.vy(flying) - beforeY);
                world.remove(flying);
                world.step(1 / 60f);
                take(world.events(), target, flying);
                world.remove(target);
                double expected = v * Math.sqrt(1 - offset * offset / (4 * RADIUS * RADIUS));
                String which = "collision " + k + " at speed " + v + ", offset " + offset;
                assertThat(new int[] {begins, hits, ends}).as(which).containsExactly(1, 1, 1);
                assertThat(speed / expected).as(which).isCloseTo(1, within(0.01));
                // Circles that stick turn round each other, and go on pushing.
                double error = Math.hypot(px - impulseX, py - impulseY) / Math.hypot(px, py);
                assertThat(error).as(which).isLessThan(restitution == 0 ? 0.02 : 1e-6);
            }
        }
    }

    private void clear() {
        begins = 0;
        hits = 0;
        ends = 0;
        impulseX = 0;
        impulseY = 0;
    }

    private void take(Events events, long a, long b) {
        for (int i = 0; i < events.size(); i++) {
            assertThat(events.a(i)).isEqualTo(a);
            assertThat(events.b(i)).isEqualTo(b);
            assertThat(events.side(i)).isNull();
            begins += events.type(i) == Events.BEGIN ? 1 : 0;
            ends += events.type(i) == Events.END ? 1 : 0;
            if (events.type(i) == Events.HIT) {
                hits++;
                speed = events.speed(i);
                impulseX += events.impulse(i) * events.normalX(i);
                impulseY += events.impulse(i) * events.normalY(i);
            }
        }
    }
}
