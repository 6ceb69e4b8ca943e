package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Bodies that sense, and bodies that are sensed. */
class WorldBodySensorTest {
    private static final int SENSOR = 3;
    private static final float DT = 1 / 60f;
    private static final Outline CRATE = Outline.box(1, 1);

    private static World world() {
        World world = WorldScenes.jvm().bounds(0, 0, 40, 40).threads(2).build();
        world.kind(SENSOR).setSensor(true);
        world.bodies().report(true);
        return world;
    }

    /** What a world has told since the last call, as words. */
    private static List<String> told(World world) {
        BodyEvents events = world.bodies().events();
        List<String> words = new ArrayList<>();
        for (int i = 0; i < events.size(); i++) {
            words.add((events.isBegin(i) ? "begin " : "end ") + events.partner(i));
            assertThat(events.impulse(i)).isZero();
        }
        return words;
    }

    @Test
    void aBodyIsASensorForOthers() {
        try (World world = world()) {
            Bodies bodies = world.bodies();
            long area = bodies.add(Outline.box(4, 4), 20, 20, 0.3f, 1, SENSOR);
            long crate = bodies.add(CRATE, 10, 20, 0, 1);
            bodies.setVelocity(crate, 10, 0);
            int begun = 0;
            for (int step = 1; step <= 120; step++) {
                world.step(DT);
                BodyEvents events = bodies.events();
                for (int i = 0; i < events.size(); i++) {
                    assertThat(events.partner(i)).isEqualTo(BodyEvents.Partner.BODY);
                    assertThat(events.body(i)).isEqualTo(area);
                    assertThat(events.other(i)).isEqualTo(crate);
                    assertThat(events.impulse(i)).isZero();
                    if (events.isBegin(i)) {
                        begun = step;
                        assertThat(events.speed(i)).isCloseTo(9.55f, within(0.02f)); // 10 cos 0.3
                        assertThat(events.normalX(i)).isCloseTo(-0.955f, within(0.01f));
                        assertThat(events.x(i)).isCloseTo(17.9f, within(0.2f));
                    } else {
                        assertThat(begun).isBetween(40, 46);
                        assertThat(step).isBetween(78, 86);
                        begun = -1;
                    }
                }
            }
            assertThat(begun).isEqualTo(-1);
            assertThat(bodies.vx(crate)).isEqualTo(10);
            assertThat(bodies.vx(area)).isZero();
            assertThat(bodies.x(crate)).isCloseTo(30, within(1e-4f));
        }
    }

    @Test
    void circlesAndBodiesSenseEachOther() {
        try (World world = world()) {
            Bodies bodies = world.bodies();
            bodies.add(Outline.capsule(2, 0.5f), 20, 20, 0, 1, SENSOR);
            bodies.add(CRATE, 5, 10, 0, 1);
            long ball = world.add(10, 20, 0.5f, 1, 300, 0); // passes the capsule within a step
            world.add(5, 10, 3, Float.POSITIVE_INFINITY, 0, 0, SENSOR); // the crate is wholly inside
            List<String> all = new ArrayList<>();
            for (int step = 0; step < 5; step++) {
                world.step(DT);
                all.addAll(told(world));
            }
            assertThat(all).containsExactly("begin CIRCLE", "begin CIRCLE", "end CIRCLE");
            assertThat(world.vx(ball)).isEqualTo(300);
        }
    }

    @Test
    void aSmallBodyInsideALargeOneIsSensed() {
        try (World world = world()) {
            Outline ring = Outline.of(Chain.from(4, 0)
                    .arcTo(0, 0, (float) Math.PI)
                    .arcTo(0, 0, (float) Math.PI)
                    .close());
            world.bodies().add(ring, 20, 20, 0, 1, SENSOR);
            long crate = world.bodies().add(Outline.box(0.2f, 0.2f), 22.7f, 22.7f, 0, 1);
            world.step(DT);
            assertThat(told(world)).containsExactly("begin BODY");
            world.step(DT, 10);
            assertThat(told(world)).isEmpty();
            long[] there = new long[2];
            assertThat(world.bodies().touching(crate, there)).isOne();
            assertThat(world.bodies().outline(there[0])).isEqualTo(ring);
            assertThat(world.bodies().touching(there[0], new long[0])).isOne();
            world.bodies().teleport(crate, 30, 30, 0);
            world.step(DT);
            assertThat(told(world)).containsExactly("end BODY");
            world.bodies().teleport(crate, 20, 20, 0);
            world.step(DT);
            assertThat(told(world)).containsExactly("begin BODY");
            world.bodies().remove(crate);
            assertThat(told(world)).containsExactly("end BODY");
        }
    }

    @Test
    void aPieceIsAGateForBodies() {
        try (World world = world()) {
            Bodies bodies = world.bodies();
            world.terrain().addSegment(20, 10, 20, 30, 0, SENSOR);
            Terrain terrain = world.terrain();
            terrain.addChain(Chain.of(30, 10, 30, 30), SENSOR, null); // its front is its right
            long crate = bodies.add(CRATE, 18, 20, 0.4f, 1);
            bodies.setVelocity(crate, 20, 0);
            List<String> there = new ArrayList<>();
            for (int step = 0; step < 60; step++) {
                world.step(DT);
                there.addAll(told(world));
            }
            assertThat(there).containsExactly("begin PIECE", "end PIECE"); // of the chain it comes from behind
            bodies.setVelocity(crate, -20, 0);
            List<String> back = new ArrayList<>();
            for (int step = 0; step < 60; step++) {
                world.step(DT);
                back.addAll(told(world));
            }
            assertThat(back).containsExactly("begin PIECE", "end PIECE", "begin PIECE", "end PIECE");
        }
    }

    @Test
    void aGateOfALiftIsWhereTheLiftIs() {
        try (World world = world()) {
            TerrainBody lift = world.terrain().addBody(10, 10, 0);
            lift.addSegment(-2, 0, 2, 0, 0.1f, SENSOR);
            world.bodies().add(CRATE, 10, 20, 0, 1);
            lift.setVelocity(0, 30);
            int begun = 0;
            for (int step = 1; step < 40; step++) {
                world.step(DT);
                BodyEvents events = world.bodies().events();
                for (int i = 0; i < events.size(); i++) {
                    if (events.isBegin(i)) {
                        begun = step;
                        assertThat(events.speed(i)).isCloseTo(30, within(0.01f));
                        assertThat(events.normalY(i)).isCloseTo(-1, within(1e-5f));
                        assertThat(events.normalX(i)).isCloseTo(0, within(1e-5f));
                    } else {
                        assertThat(step).isBetween(begun + 2, begun + 4);
                        begun = -1;
                    }
                }
            }
            assertThat(begun).isEqualTo(-1);
        }
    }

    @Test
    void groupsAndMasksIgnore() {
        try (World world = world()) {
            long area = world.bodies().add(Outline.box(4, 4), 20, 20, 0, 1, SENSOR);
            long crate = world.bodies().add(CRATE, 20, 20, 0, 1);
            world.bodies().setGroup(area, 5);
            world.bodies().setGroup(crate, 5);
            world.step(DT);
            assertThat(told(world)).isEmpty();
            world.bodies().setGroup(crate, 0);
            world.kind(SENSOR).setMask(0);
            world.step(DT);
            assertThat(told(world)).isEmpty();
            world.kind(SENSOR).setMask(-1);
            world.step(DT);
            assertThat(told(world)).containsExactly("begin BODY");
            world.setResponse(0, SENSOR, Response.IGNORE);
            world.step(DT);
            assertThat(told(world)).containsExactly("end BODY");
        }
    }

    @Test
    void sleepersAreSensedAndSoIsWhatStays() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 40, 40)
                .gravity(0, -10)
                .sleep(true)
                .build()) {
            world.kind(SENSOR).setSensor(true);
            Bodies bodies = world.bodies();
            bodies.report(true);
            long crate = bodies.add(CRATE, 20, 0.5f, 0, 1);
            world.step(DT, 120);
            assertThat(bodies.isAwake(crate)).isFalse();
            bodies.events();
            long area = world.add(20, 1, 2, Float.POSITIVE_INFINITY, 0, 0, SENSOR);
            world.step(DT);
            assertThat(told(world)).containsExactly("begin CIRCLE");
            world.step(DT, 60);
            assertThat(told(world)).isEmpty();
            assertThat(bodies.isAwake(crate)).isFalse();
            world.teleport(area, 30, 1);
            world.step(DT);
            assertThat(told(world)).containsExactly("end CIRCLE");
            bodies.wake(crate);
            world.step(DT, 60);
            assertThat(told(world)).isEmpty(); // it stands on the floor all the time
        }
    }

    @Test
    void jointsDoNotHinderSensors() {
        try (World world = world()) {
            long area = world.bodies().add(Outline.box(4, 4), 20, 20, 0, 1, SENSOR);
            long crate = world.bodies().add(CRATE, 20, 20, 0, 1);
            world.joints().add(area, 0, 0, crate, 0, 0, Joint.pin());
            world.step(DT);
            assertThat(told(world)).containsExactly("begin BODY");
        }
    }

    @Test
    void sensorsSeeThroughSeams() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 40, 40)
                .edges(Edge.WRAP, Edge.WRAP)
                .build()) {
            world.kind(SENSOR).setSensor(true);
            world.bodies().report(true);
            world.bodies().add(Outline.box(4, 4), 39, 39, 0, 1, SENSOR);
            world.bodies().add(CRATE, 0.5f, 0.5f, 0, 1);
            world.add(0.2f, 39, 0.3f, 1);
            world.step(DT);
            assertThat(told(world)).containsExactly("begin BODY", "begin CIRCLE");
        }
    }

    @Test
    void snapshotsKnowWhatIsSensed() {
        try (World world = world();
                World other = world()) {
            world.bodies().add(Outline.box(4, 4), 20, 20, 0, 1, SENSOR);
            world.bodies().add(CRATE, 20, 20, 0, 1);
            world.add(21, 21, 0.3f, 1);
            world.step(DT);
            ByteBuffer snapshot = snapshot(world);
            other.restore(snapshot);
            other.step(DT);
            assertThat(told(other)).isEmpty();
            other.bodies().clear();
            assertThat(told(other)).containsExactly("end BODY", "end CIRCLE");
        }
    }

    @Test
    void sensorsChangeNoBit() {
        long[] hashes = new long[2];
        for (int round = 0; round < 2; round++) {
            try (World world = WorldScenes.jvm()
                    .bounds(0, 0, 20, 20)
                    .gravity(0, -10)
                    .friction(0.5f)
                    .sleep(true)
                    .build()) {
                world.kind(SENSOR).setSensor(true);
                world.bodies().report(round == 1);
                for (int k = 0; k < 30; k++) {
                    world.bodies().add(CRATE, 2 + 3 * (k % 6), 2 + 2 * (k / 6), 0.1f * k, 1, k % 5 == 0 ? SENSOR : 0);
                    world.add(3.5f + 3 * (k % 5), 3 + 2 * (k / 6), 0.4f, 1, 0, 0, k % 7 == 0 ? SENSOR : 0);
                }
                world.step(DT, 200);
                hashes[round] = world.hash();
            }
        }
        assertThat(hashes[0]).isEqualTo(hashes[1]);
    }
}
