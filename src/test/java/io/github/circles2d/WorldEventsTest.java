package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.reference.Event;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** When events come, and what they say. */
@Tag("each-jdk")
class WorldEventsTest {
    private static final int ALL = Events.BEGIN | Events.HIT | Events.END;
    private static final float DT = 1 / 60f;

    private final World world =
            WorldScenes.jvm().bounds(-50, -50, 50, 50).restitution(0.5f).build();

    @AfterEach
    void close() {
        world.close();
    }

    private List<String> events(World from) {
        List<String> list = new ArrayList<>();
        Events events = from.events();
        for (int i = 0; i < events.size(); i++) {
            String type = events.type(i) == Events.BEGIN ? "begin" : events.type(i) == Events.HIT ? "hit" : "end";
            String partner = events.side(i) == null
                    ? String.valueOf((int) events.b(i))
                    : events.side(i).toString();
            list.add(events.step(i) + " " + type + " " + (int) events.a(i) + " " + partner);
        }
        return list;
    }

    private List<String> events() {
        return events(world);
    }

    @Test
    void nothingIsReportedUntilItIsAskedFor() {
        world.add(0, 0, 1, 1);
        world.add(1.5f, 0, 1, 1);
        world.step(DT, 3);
        assertThat(events()).isEmpty();
        world.report(ALL);
        world.step(DT, 3);
        assertThat(events()).containsExactly("0 begin 0 1");
        world.report(0);
        world.step(DT, 3);
        assertThat(events()).isEmpty();
        assertThatIllegalArgumentException().isThrownBy(() -> world.report(16)).withMessageContaining("16");
        assertThatIllegalArgumentException().isThrownBy(() -> world.setHitSpeed(-1));
        assertThatIllegalArgumentException().isThrownBy(() -> world.setHitSpeed(Float.NaN));
    }

    /** A piston at speed 6 starts half a length away from a circle at rest, and stops after 20 steps. */
    @Test
    void aWallThatComesInHitsOnceWithItsOwnSpeed() {
        for (float restitution : new float[] {0f, 0.5f, 1f}) {
            try (World piston = WorldScenes.jvm()
                    .bounds(-50, -50, 50, 50)
                    .restitution(restitution)
                    .build()) {
                piston.report(ALL | Events.WALL);
                long circle = piston.add(-48.5f, 0, 1, 3);
                List<String> seen = new ArrayList<>();
                for (int k = 1; k <= 30; k++) {
                    piston.setBounds(-50 + 0.1f * Math.min(k, 20), -50, 50, 50);
                    piston.step(DT);
                    Events events = piston.events();
                    for (int i = 0; i < events.size(); i++) {
                        assertThat(events.side(i)).isEqualTo(Events.Side.LEFT);
                        seen.add(
                                events.type(i) == Events.BEGIN
                                        ? "begin"
                                        : events.type(i) == Events.HIT ? "hit" : "end");
                        if (events.type(i) == Events.HIT) {
                            assertThat(events.speed(i)).isCloseTo(6, within(0.06f));
                            assertThat(events.impulse(i)).isCloseTo(3 * 6 * (1 + restitution), within(0.5f));
                        }
                    }
                }
                assertThat(seen).as("restitution " + restitution).containsExactly("begin", "hit", "end");
                assertThat(piston.vx(circle)).isCloseTo(6 * (1 + restitution), within(0.2f));
            }
        }
    }

    @Test
    void circlesThatAreAddedWhileTheyTouchBegin() {
        world.report(ALL);
        world.add(0, 0, 1, 1);
        world.add(2, 0, 1, 1);
        world.add(0, 1.9999f, 1, 1);
        world.add(0, -1, 1, 1);
        world.step(DT);
        assertThat(events()).contains("0 begin 0 1", "0 begin 0 2", "0 begin 0 3");
    }

    @Test
    void anEventTellsTheOtherCircleOfOneOfItsOwn() {
        world.report(ALL | Events.WALL);
        long a = world.add(-49, 0, 1, 1);
        long b = world.add(-47, 0, 1, 1);
        long none = world.add(20, 0, 1, 1);
        world.step(DT);
        Events events = world.events();
        assertThat(events.side(1)).isEqualTo(Events.Side.LEFT);
        assertThat(events.other(0, a)).isEqualTo(b);
        assertThat(events.other(0, b)).isEqualTo(a);
        assertThat(events.other(1, a)).isZero();
        for (long wrong : new long[] {none, 0}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> events.other(0, wrong))
                    .withMessage("the circle with the handle " + wrong + " is not in the event 0, but must be " + a
                            + " or " + b);
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> events.other(1, wrong))
                    .withMessageEndingWith("but must be " + a);
        }
        assertThatExceptionOfType(IndexOutOfBoundsException.class)
                .isThrownBy(() -> events.other(events.size(), a))
                .withMessage("there is no event " + events.size() + " of " + events.size());
    }

    @Test
    void aRemovedCircleEndsUnderItsHandleAndItsSuccessorBegins() {
        world.report(Events.BEGIN | Events.END | Events.WALL);
        long a = world.add(-49, 0, 1, 1);
        long b = world.add(-47.1f, 0, 1, 1);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 1", "0 begin 0 LEFT");
        world.remove(b);
        world.remove(a);
        long c = world.add(-48.9f, 0, 1, 1);
        long d = world.add(-47, 0, 1, 1);
        assertThat((int) c).isEqualTo((int) a);
        assertThat(events()).isEmpty();
        world.step(DT);
        Events events = world.events();
        assertThat(events.type(0)).isEqualTo(Events.END);
        assertThat(new long[] {events.a(0), events.b(0)}).containsExactly(a, b);
        assertThat(events.type(1)).isEqualTo(Events.BEGIN);
        assertThat(new long[] {events.a(1), events.b(1)}).containsExactly(c, d);
        assertThat(events.type(2)).isEqualTo(Events.END);
        assertThat(new long[] {events.a(2), events.b(2)}).containsExactly(a, 0);
        assertThat(events.size()).isEqualTo(3);
    }

    @Test
    void theLastCirclesEndInAStepWithoutCircles() {
        world.report(ALL);
        long a = world.add(0, 0, 1, 1);
        long b = world.add(1.9f, 0, 1, 1);
        world.step(DT);
        world.events();
        world.remove(a);
        world.remove(b);
        world.step(DT, 2);
        assertThat(events()).containsExactly("0 end 0 1");
    }

    @Test
    void aCircleThatIsMovedAwayEnds() {
        world.report(ALL);
        world.add(0, 0, 1, 1);
        long b = world.add(1.9f, 0, 1, 1);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 1");
        world.setPosition(b, 20, 20);
        world.step(DT);
        assertThat(events()).containsExactly("0 end 0 1");
        world.setPosition(b, 1.9f, 0);
        world.step(DT, 5);
        assertThat(events()).containsExactly("0 begin 0 1");
    }

    @Test
    void growingDoesNotBeginAgain() {
        world.report(ALL);
        long a = world.add(0, 0, 1, 1);
        world.add(1.99f, 0, 1, 1);
        for (int k = 0; k < 20; k++) {
            world.setRadius(a, 1 + 0.01f * k);
            world.step(DT);
        }
        assertThat(events()).containsExactly("0 begin 0 1");
    }

    @Test
    void aHitOfAWallHasItsSideAndNumbers() {
        world.report(ALL | Events.WALL);
        world.add(0, -48, 1, 3, 0, -10);
        world.step(DT, 10);
        Events events = world.events();
        assertThat(events.size()).isEqualTo(3);
        assertThat(events.type(0)).isEqualTo(Events.BEGIN);
        assertThat(events.type(1)).isEqualTo(Events.HIT);
        assertThat(events.type(2)).isEqualTo(Events.END);
        assertThat(events.step(1)).isBetween(4, 7);
        assertThat(events.side(1)).isEqualTo(Events.Side.LOWER);
        assertThat(events.b(1)).isZero();
        assertThat(events.speed(1)).isEqualTo(10);
        assertThat(events.impulse(1)).isCloseTo(3 * 15, within(1e-4f));
        assertThat(new float[] {events.x(1), events.y(1)}).containsExactly(0, -50);
        assertThat(new float[] {events.normalX(1), events.normalY(1)}).containsExactly(0, -1);
        assertThatExceptionOfType(IndexOutOfBoundsException.class).isThrownBy(() -> events.type(3));
    }

    @Test
    void aHitSaysHowFastTheSurfacesSlid() {
        try (World rough = WorldScenes.jvm()
                .bounds(-50, -50, 50, 50)
                .friction(0.5f)
                .restitution(0.5f)
                .build()) {
            rough.kind(1).setBeltSpeed(3);
            rough.kind(2).setFriction(0).setBeltSpeed(5);
            rough.report(Events.BEGIN | Events.HIT | Events.END);
            assertThat(slip(rough, 0, 0, 0)).as("nothing slides").isZero();
            assertThat(slip(rough, 0, 0, 4)).as("one spins").isEqualTo(4);
            assertThat(slip(rough, 0, 2.5f, 0)).as("one flies past").isCloseTo(2.5f, within(0.1f));
            assertThat(slip(rough, 1, 0, 0)).as("a belt").isEqualTo(3);
            assertThat(slip(rough, 1, 0, 3)).as("one rolls on a belt").isZero();
            assertThat(slip(rough, 2, 2.5f, 4)).as("no friction").isZero();
        }
    }

    /** How fast a circle slides along a static one of a kind, which it hits with a speed along its surface and a surface speed. */
    private static float slip(World rough, int kind, float along, float spin) {
        float radius = 2;
        long target = rough.add(0, 0, radius, Float.POSITIVE_INFINITY);
        rough.setKind(target, kind);
        // on a vertical line when they touch
        long ball = rough.add(-along * 0.1f, 2 * radius + 1, radius, 1, along, -10);
        rough.setAngularVelocity(ball, spin / radius);
        float slip = -1;
        for (int k = 0; k < 20; k++) {
            rough.step(DT);
            Events events = rough.events();
            for (int i = 0; i < events.size(); i++) {
                if (events.type(i) == Events.HIT) {
                    assertThat(slip).as("a second hit").isEqualTo(-1);
                    slip = events.slipSpeed(i);
                } else if (events.type(i) == Events.END) {
                    assertThat(events.slipSpeed(i)).isZero();
                }
            }
        }
        rough.remove(target);
        rough.remove(ball);
        rough.step(DT);
        rough.events();
        return slip;
    }

    @Test
    void aHitOfAWallSaysHowFastTheSurfacesSlid() {
        for (float friction : new float[] {0, 0.5f}) {
            for (float belt : new float[] {0, -2}) {
                for (float spin : new float[] {0, -4, 4}) {
                    try (World rough = WorldScenes.jvm()
                            .bounds(-50, -50, 50, 50)
                            .friction(friction)
                            .restitution(0.5f)
                            .build()) {
                        rough.setWallSurface(Wall.MIN_Y, friction, 0, belt);
                        rough.report(Events.HIT | Events.WALL);
                        rough.setAngularVelocity(rough.add(0, -48, 1, 1, 4, -10), spin);
                        rough.step(DT, 20);
                        Events events = rough.events();
                        assertThat(events.size()).isEqualTo(1);
                        // at spin -4 it rolls to the right
                        float expected = friction == 0 ? 0 : Math.abs(4 - belt + spin);
                        assertThat(events.slipSpeed(0)).isEqualTo(expected);
                    }
                }
            }
        }
    }

    @Test
    void tenStepsInOneTripHaveTheEventsOfTenSteps() {
        Scene scene = Scenes.gas(400, 1);
        try (World one = WorldScenes.world(scene, WorldScenes.builder(scene));
                World ten = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            one.report(ALL | Events.WALL);
            ten.report(ALL | Events.WALL);
            for (int k = 0; k < 10; k++) {
                one.step(scene.timeStep());
            }
            ten.step(scene.timeStep(), 10);
            List<Event> expected = Event.of(one.events());
            assertThat(expected).hasSizeGreaterThan(50);
            assertThat(Event.of(ten.events())).isEqualTo(expected);
        }
    }

    @Test
    void aHitSpeedLeavesSlowHitsOut() {
        world.report(Events.HIT);
        for (int k = 1; k <= 20; k++) {
            world.add(0, -45 + 4 * k, 1, 1, k, 0);
            world.add(3, -45 + 4 * k, 1, 1);
        }
        world.setHitSpeed(10.5f);
        world.step(DT, 90);
        Events events = world.events();
        assertThat(events.size()).isEqualTo(10);
        for (int i = 0; i < events.size(); i++) {
            assertThat(events.speed(i)).isGreaterThan(10.5f);
        }
    }

    @Test
    void aRollbackNeitherRepeatsNorLosesEvents() {
        assertRollback(0);
        assertRollback(0.5f);
    }

    private static void assertRollback(float friction) {
        Scene scene = Scenes.thesis(300, 3);
        try (World played = WorldScenes.world(scene, WorldScenes.builder(scene).friction(friction));
                World other = WorldScenes.jvm().build()) {
            played.report(ALL | Events.WALL);
            other.report(ALL | Events.WALL);
            played.step(scene.timeStep(), 60);
            long[] handles = new long[played.size()];
            played.readHandles(handles);
            for (int k = 0; k < 40; k++) {
                played.step(scene.timeStep());
                played.events();
                if (k % 2 == 0) {
                    played.remove(handles[k]);
                }
                ByteBuffer snapshot = ByteBuffer.allocate(played.snapshotBytes());
                played.snapshot(snapshot);
                played.step(scene.timeStep(), 3);
                List<Event> expected = Event.of(played.events());
                other.restore(snapshot.flip());
                assertThat(other.events().size()).isZero();
                other.step(scene.timeStep(), 3);
                assertThat(Event.of(other.events())).isEqualTo(expected);
                played.restore(snapshot.rewind());
                played.step(scene.timeStep(), 3);
                assertThat(Event.of(played.events())).isEqualTo(expected);
                played.restore(snapshot.rewind());
            }
        }
    }

    /** What walls there are is as in the snapshot before the first step too. */
    @Test
    void aCircleThatIsRemovedBehindARestoreEndsAtTheWallOfTheSnapshot() {
        world.report(ALL | Events.WALL);
        world.setGravity(-10, 0);
        long circle = world.add(-49, 0, 1, 1);
        world.step(DT, 60);
        assertThat(events()).contains("0 begin 0 LEFT");
        ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(snapshot);
        try (World open = WorldScenes.jvm().edges(Edge.OPEN, Edge.WALL).build()) {
            open.report(ALL | Events.WALL);
            open.step(DT);
            open.restore(snapshot.flip());
            open.remove(circle);
            open.step(DT);
            assertThat(events(open)).containsExactly("0 end 0 LEFT");
        }
    }

    @Test
    void aWorldThatReportsNothingWritesTheSameSnapshotsAsBefore() {
        world.add(0, 0, 1, 1);
        world.add(1.9f, 0, 1, 1);
        world.step(DT);
        int bytes = world.snapshotBytes();
        world.report(ALL);
        world.step(DT);
        assertThat(world.snapshotBytes()).isGreaterThan(bytes);
        world.report(0);
        assertThat(world.snapshotBytes()).isEqualTo(bytes);
    }

    @Test
    void aWorldThatIsRewoundReportsTheSameAgain() {
        Scene scene = Scenes.gas(100, 1);
        try (World gas = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            Rewind rewind = new Rewind(gas, 8);
            gas.report(ALL | Events.WALL);
            gas.step(scene.timeStep(), 20);
            gas.events();
            rewind.save(0);
            gas.step(scene.timeStep(), 20);
            List<String> first = events(gas);
            rewind.restore(0);
            assertThat(events(gas)).isEmpty();
            gas.step(scene.timeStep(), 20);
            assertThat(first).isNotEmpty();
            assertThat(events(gas)).isEqualTo(first);
        }
    }

    @Test
    void aPileAtRestIsSilent() {
        assertSilent(300, 1500, 1000);
    }

    /** It shifts once more between the steps 3,000 and 4,000. */
    @Test
    @Tag("exhaustive")
    void aLargePileAtRestIsSilentForLong() {
        assertSilent(1500, 5000, 10_000);
    }

    private void assertSilent(int circles, int settling, int steps) {
        Scene scene = Scenes.thesis(circles, 1);
        try (World pile = WorldScenes.world(scene, WorldScenes.builder(scene).gravity(0, -1f))) {
            pile.step(scene.timeStep(), settling);
            pile.report(ALL | Events.WALL);
            pile.step(scene.timeStep());
            assertThat(events(pile)).hasSizeGreaterThan(circles);
            pile.step(scene.timeStep(), steps);
            List<String> events = events(pile);
            assertThat(events).filteredOn(event -> event.contains("hit")).isEmpty();
            assertThat(events).filteredOn(event -> event.contains("begin")).hasSizeLessThanOrEqualTo(2);
        }
    }

    @Test
    void reportingChangesNoBit() {
        Scene scene = Scenes.mixed(300, 1);
        try (World silent = WorldScenes.world(scene, WorldScenes.builder(scene));
                World reporting = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            reporting.report(ALL | Events.WALL);
            silent.step(scene.timeStep(), 200);
            reporting.step(scene.timeStep(), 200);
            assertThat(reporting.hash()).isEqualTo(silent.hash());
        }
    }
}
