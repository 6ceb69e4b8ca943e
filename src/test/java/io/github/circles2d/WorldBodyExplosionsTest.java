package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Explosions push bodies by the law of circles, at the nearest points of their outlines. */
class WorldBodyExplosionsTest {
    private static final float DT = 1 / 60f;
    private static final Outline BOX = Outline.box(2, 2);
    private static final float PI = (float) Math.PI;

    private static World.Builder builder() {
        return WorldScenes.jvm().bounds(0, 0, 40, 40).gravity(0, 0).threads(1);
    }

    @Test
    void theImpulseActsAtTheNearestPointOfTheOutline() {
        try (World world = builder().build()) {
            Bodies bodies = world.bodies();
            long body = bodies.add(BOX, 10, 10, 0, 2);
            assertThat(world.explode(7, 10, 2, 10, 0)).isOne();
            assertThat(bodies.vx(body)).isEqualTo(5);
            assertThat(bodies.vy(body)).isZero();
            assertThat(bodies.angularVelocity(body)).isZero();
            assertThat(world.explode(7, 10.5f, 2, 10, 0)).isOne();
            assertThat(bodies.vx(body)).isEqualTo(10);
            assertThat(bodies.angularVelocity(body)).isCloseTo(-5 / bodies.inertia(body), within(1e-5f));
            assertThat(world.explode(7, 10, 2, -20, 0)).as("it pulls").isOne();
            assertThat(bodies.vx(body)).isZero();
        }
    }

    @Test
    void theLawIsThatOfCircles() {
        Random random = new Random(4);
        Outline disc = Outline.of(Chain.from(1.5f, 0).arcTo(0, 0, 2 * PI).close());
        int pushed = 0;
        for (int k = 0; k < 300; k++) {
            try (World world = builder().build();
                    World other = builder().build()) {
                float x = 15 + 10 * random.nextFloat();
                float y = 15 + 10 * random.nextFloat();
                long body = world.bodies().add(disc, x, y, random.nextFloat(), 3);
                long circle = other.add(x, y, 1.5f, 3);
                float radius = 4 * random.nextFloat();
                float falloff = 4 * random.nextFloat();
                int count = other.explode(20, 20, radius, 30, falloff);
                assertThat(world.explode(20, 20, radius, 30, falloff)).isEqualTo(count);
                assertThat(world.bodies().vx(body)).isCloseTo(other.vx(circle), within(1e-3f));
                assertThat(world.bodies().vy(body)).isCloseTo(other.vy(circle), within(1e-3f));
                assertThat(world.bodies().angularVelocity(body)).isCloseTo(0, within(1e-3f));
                pushed += count;
            }
        }
        assertThat(pushed).isBetween(50, 290);
    }

    @Test
    void fromInsideItPushesOnThroughTheBody() {
        try (World world = builder().build()) {
            Bodies bodies = world.bodies();
            long body = bodies.add(BOX, 10, 10, 0, 2);
            assertThat(world.explode(9.25f, 10, 0, 10, 0)).isOne();
            assertThat(bodies.vx(body)).isEqualTo(5);
            assertThat(world.explode(10, 10, 5, 10, 0)).as("at the centroid").isZero();
            assertThat(bodies.vx(body)).isEqualTo(5);
            assertThat(world.explode(12, 12, 1, 10, 0)).as("beside the corner").isZero();
        }
    }

    @Test
    void masksCountAndCirclesAreCountedToo() {
        try (World world = builder().build()) {
            world.kind(3).setCategory(4);
            long circle = world.add(22, 20, 1, 1);
            long crate = world.bodies().add(BOX, 17, 20, 0, 1);
            long plank = world.bodies().add(Outline.box(6, 1), 20, 24, 0, 1, 3);
            assertThat(world.explode(20, 20, 9, 1, 0)).isEqualTo(3);
            assertThat(world.vx(circle)).isPositive();
            assertThat(world.bodies().vx(crate)).isNegative();
            assertThat(world.bodies().vy(plank)).isPositive();
            assertThat(world.explode(20, 20, 9, 1, 0, 4)).isOne();
            assertThat(world.bodies().vy(plank)).isEqualTo(2);
            assertThat(world.explode(20, 20, 9, 1, 0, 3)).isEqualTo(2);
            world.bodies().remove(plank);
            assertThat(world.explode(20, 20, 9, 1, 0)).isEqualTo(2);
        }
    }

    @Test
    void terrainHidesBodiesWhoseNearestPointIsBehindIt() {
        try (World world = builder().build()) {
            Bodies bodies = world.bodies();
            long hidden = bodies.add(BOX, 20, 10, 0, 1);
            long seen = bodies.add(BOX, 14, 20, 0, 1);
            long ghost = bodies.add(BOX, 26, 10, 0, 1, 1);
            world.kind(1).setMask(0);
            world.terrain().addSegment(10, 15, 40, 15);
            assertThat(world.explodeInSight(20, 20, 30, 1, 0)).isEqualTo(2);
            assertThat(bodies.vy(hidden)).isZero();
            assertThat(bodies.vx(seen)).isEqualTo(-1);
            assertThat(bodies.vy(ghost)).as("the piece does not stop it").isNegative();
            assertThat(world.explodeInSight(20, 20, 30, 1, 0, 2)).isZero();
            assertThat(world.explode(20, 20, 30, 1, 0)).isEqualTo(3);
        }
    }

    @Test
    void acrossASeamTheyPushTheShortWay() {
        try (World world = builder().edges(Edge.WRAP, Edge.WALL).build()) {
            Bodies bodies = world.bodies();
            long body = bodies.add(Outline.box(6, 2), 39, 20, 0, 1);
            assertThat(world.explode(3, 20, 2, 1, 0)).as("its end is at 2").isOne();
            assertThat(bodies.vx(body)).isEqualTo(-1);
            assertThat(world.explode(1, 22, 2, 1, 0)).isOne();
            assertThat(bodies.vy(body)).isEqualTo(-1);
            assertThat(bodies.angularVelocity(body)).isCloseTo(-2 / bodies.inertia(body), within(1e-5f));
        }
    }

    @Test
    void farAwayItStaysInRange() {
        try (World world = builder().edges(Edge.OPEN, Edge.OPEN).build()) {
            Outline large = Outline.box(20, 20);
            long body = world.bodies().add(large, 1e9f, 1e9f, 0, 1);
            assertThat(world.explode(1e9f, 0, 1e10f, 7, 0)).isOne();
            assertThat(world.bodies().vy(body)).isEqualTo(7);
        }
    }

    @Test
    void valuesOutOfRangeChangeNothing() {
        try (World world = builder().build()) {
            world.bodies().add(BOX, 10, 10, 0, 2);
            long hash = world.hash();
            assertThatIllegalArgumentException().isThrownBy(() -> world.explode(9, 9, -1, 1, 0));
            assertThatIllegalArgumentException().isThrownBy(() -> world.explode(9, 9, 1, Float.NaN, 0));
            assertThat(world.hash()).isEqualTo(hash);
        }
    }

    @Test
    void aLogAndAnyThreadsHaveTheSameBits() throws IOException {
        long[] hashes = new long[3];
        for (int k = 0; k < hashes.length; k++) {
            ByteArrayOutputStream log = new ByteArrayOutputStream();
            try (World world = builder().threads(1 + k).build();
                    World second = builder().build()) {
                try (Recording recording = new Recording(world, log, 1)) {
                    for (int n = 0; n < 50; n++) {
                        world.bodies()
                                .add(n % 2 == 0 ? BOX : Outline.capsule(2, 0.5f), 3 + n % 8 * 4, 3 + n / 8 * 4, n, 1);
                        world.add(5 + n % 8 * 4, 3 + n / 8 * 4, 0.5f, 1);
                    }
                    for (int frame = 0; frame < 30; frame++) {
                        assertThat(world.explode(20, frame, 5, 8, 5)).isPositive();
                        world.step(DT);
                    }
                    assertThat(recording.hasFailed()).isFalse();
                }
                hashes[k] = world.hash();
                Replay replay = new Replay(new ByteArrayInputStream(log.toByteArray()), second).run();
                assertThat(replay.differs()).isFalse();
                assertThat(second.hash()).isEqualTo(hashes[k]);
            }
        }
        assertThat(hashes[1]).isEqualTo(hashes[0]);
        assertThat(hashes[2]).isEqualTo(hashes[0]);
    }
}
