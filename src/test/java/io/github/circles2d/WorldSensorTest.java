package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.reference.Event;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What sensors notice, and which pairs of kinds report. */
class WorldSensorTest {
    private static final int ALL = Events.BEGIN | Events.HIT | Events.END;
    private static final float DT = 1 / 60f;
    private static final int BODY = 1;
    private static final int SENSOR = 2;
    private static final int OTHER = 3;

    private final World world = WorldScenes.jvm().bounds(-50, -50, 50, 50).build();

    @BeforeEach
    void makeSensors() {
        world.kind(SENSOR).setSensor(true);
        world.report(BODY, SENSOR, Events.BEGIN | Events.END);
    }

    @AfterEach
    void close() {
        world.close();
    }

    private long add(float x, float y, float r, float vx, int kind) {
        return world.add(x, y, r, 1, vx, 0, kind);
    }

    private long addStatic(float x, float y, float r, int kind) {
        return world.add(x, y, r, Float.POSITIVE_INFINITY, 0, 0, kind);
    }

    private List<String> events() {
        List<String> list = new ArrayList<>();
        Events events = world.events();
        for (int i = 0; i < events.size(); i++) {
            String type = events.type(i) == Events.BEGIN ? "begin" : events.type(i) == Events.HIT ? "hit" : "end";
            String partner = events.side(i) == null ? String.valueOf(World.id(events.b(i))) : "" + events.side(i);
            list.add(events.step(i) + " " + type + " " + World.id(events.a(i)) + " " + partner);
        }
        return list;
    }

    @Test
    void aCircleThatComesAndGoesBeginsAndEndsOnce() {
        addStatic(0, 0, 1, SENSOR);
        add(-3, 0.5f, 0.5f, 6, BODY);
        world.step(DT, 100);
        List<String> events = events();
        assertThat(events).hasSize(2);
        // It goes a tenth a step. They touch while the centre is up to sqrt(2) from the middle.
        assertThat(events.get(0)).isEqualTo("15 begin 0 1");
        assertThat(events.get(1)).isEqualTo("45 end 0 1");
        assertThat(world.vx(world.handle(1))).isEqualTo(6);
    }

    @Test
    void aBeginHasTheNumbersOfTheFirstTouch() {
        addStatic(0, 0, 1, SENSOR);
        add(-3, 0, 0.5f, 60, BODY);
        world.step(DT, 2);
        Events events = world.events();
        assertThat(events.size()).isOne();
        assertThat(events.step(0)).isOne();
        assertThat(events.speed(0)).isCloseTo(60, within(1e-3f));
        assertThat(events.impulse(0)).isZero();
        assertThat(events.x(0)).isCloseTo(-1, within(1e-5f));
        assertThat(events.y(0)).isZero();
        assertThat(events.normalX(0)).isEqualTo(-1);
        assertThat(events.normalY(0)).isZero();
    }

    /** At 30 diameters of both a step. */
    @Test
    void aBulletThatFliesThroughASmallSensorWithinAStepIsNoticed() {
        addStatic(5, 0, 0.1f, SENSOR);
        addStatic(5, 1, 0.1f, SENSOR);
        add(-1.3f, 0.05f, 0.1f, 360, BODY);
        world.step(DT, 4);
        assertThat(events()).containsExactly("1 begin 0 2", "2 end 0 2");
    }

    @Test
    void aFastSensorNoticesWhatItFliesThrough() {
        add(5, -0.1f, 0.1f, 0, BODY);
        add(6, 0.15f, 0.1f, -360, BODY);
        add(-1.3f, 0.05f, 0.1f, 360, SENSOR);
        world.step(DT, 4);
        assertThat(events()).containsExactly("0 begin 1 2", "1 begin 0 2", "1 end 1 2", "2 end 0 2");
    }

    /** As the step begins, the two are not near to each other, and neither moves. */
    @Test
    void aCircleThatAnotherKnocksAgainstOneOfItsKindIsSensedInThatStep() {
        world.setResponse(OTHER, OTHER, Response.SENSE);
        world.report(OTHER, OTHER, Events.BEGIN | Events.END);
        long hit = add(0, 0, 1, 0, OTHER);
        add(2.15f, 0, 1, 0, OTHER);
        float ofStep = 14 * DT;
        world.add(-2.02f - 3 * ofStep, 0, 1, 1000, 14, 0, BODY);
        world.step(DT, 3);
        assertThat(events()).isEmpty();
        assertThat(world.vx(hit)).isZero();
        world.step(DT);
        assertThat(world.x(hit)).isGreaterThan(0.15f);
        assertThat(events()).containsExactly("0 begin 0 1");
    }

    @Test
    void circlesThatAreAddedMovedOrRemovedBeginAndEndWithTheNextStep() {
        addStatic(0, 0, 3, SENSOR);
        long inside = add(1, 0, 0.5f, 0, BODY);
        assertThat(events()).isEmpty();
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 1");
        world.setPosition(inside, 20, 20);
        world.step(DT);
        assertThat(events()).containsExactly("0 end 0 1");
        world.teleport(inside, 0, 0);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 1");
        world.remove(inside);
        assertThat(events()).isEmpty();
        world.step(DT);
        assertThat(events()).containsExactly("0 end 0 1");
    }

    @Test
    void aStaticSensorThatIsMovedNoticesWhatItComesUpon() {
        long sensor = addStatic(-10, 0, 1, SENSOR);
        add(0, 0, 0.5f, 0, BODY);
        world.step(DT);
        world.setPosition(sensor, 10, 0);
        world.step(DT, 2);
        assertThat(events()).containsExactly("1 begin 0 1", "2 end 0 1");
    }

    @Test
    void sensorsAndStaticCirclesNoticeNoneOfTheirOwn() {
        world.report(ALL);
        addStatic(0, 0, 1, SENSOR);
        add(0.5f, 0, 1, 0, SENSOR);
        addStatic(1, 0, 1, BODY);
        world.step(DT);
        // The sensor that is not static notices the static body.
        assertThat(events()).containsExactly("0 begin 1 2");
        world.setResponse(SENSOR, SENSOR, Response.SENSE);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 1");
    }

    @Test
    void theMatrixMakesAnyKindsSensed() {
        world.setResponse(BODY, BODY, Response.SENSE);
        world.setResponse(BODY, SENSOR, Response.IGNORE);
        world.report(BODY, BODY, ALL);
        add(0, 0, 1, 0, BODY);
        add(1, 0, 1, 0, BODY);
        add(0, 1, 1, 0, SENSOR);
        world.step(DT, 3);
        assertThat(events()).containsExactly("0 begin 0 1");
        world.setResponse(BODY, BODY, Response.SOLID);
        world.step(DT);
        assertThat(events()).as("it goes on touching").isEmpty();
        world.setResponse(BODY, BODY, Response.IGNORE);
        world.step(DT);
        assertThat(events()).containsExactly("0 end 0 1");
    }

    @Test
    void circlesOfOneGroupAreNotSensed() {
        addStatic(0, 0, 3, SENSOR);
        long inside = add(1, 0, 0.5f, 0, BODY);
        world.setGroup(inside, 7);
        world.setGroup(world.handle(0), 7);
        world.step(DT);
        assertThat(events()).isEmpty();
        world.setGroup(inside, 0);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 1");
    }

    @Test
    void onlyPairsOfKindsThatWereAskedForReport() {
        world.report(0);
        world.report(BODY, OTHER, Events.BEGIN);
        world.report(OTHER, OTHER, Events.END);
        add(0, 0, 1, 0, BODY);
        add(1.9f, 0, 1, 0, BODY);
        add(0, 1.9f, 1, 0, OTHER);
        add(-40, 0, 1, 0, OTHER);
        long b = add(-38.1f, 0, 1, 0, OTHER);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 2");
        world.remove(b);
        world.setKind(world.handle(2), BODY);
        world.step(DT);
        assertThat(events()).containsExactly("0 end 3 4");
        world.setKind(world.handle(2), OTHER);
        world.step(DT);
        assertThat(events()).as("it was not reported in between").containsExactly("0 begin 0 2");
    }

    @Test
    void wallsReportByKind() {
        world.report(0);
        world.reportWalls(OTHER, Events.BEGIN);
        add(-49, 0, 1, 0, BODY);
        add(49, 0, 1, 0, OTHER);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 1 RIGHT");
        world.report(ALL | Events.WALL);
        world.reportWalls(OTHER, 0);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 LEFT");
    }

    @Test
    void pairsThatTouchAreListedByKinds() {
        world.report(ALL);
        long sensor = addStatic(0, 0, 3, SENSOR);
        long near = add(2, 0, 0.5f, 0, BODY);
        long other = add(-2, 0, 0.5f, 0, BODY);
        long beside = add(2.9f, 0, 0.5f, 0, BODY);
        long[] pairs = new long[5];
        assertThat(world.touching(BODY, SENSOR, pairs)).isZero();
        world.step(DT);
        assertThat(world.touching(BODY, SENSOR, pairs)).isEqualTo(3);
        assertThat(pairs).containsExactly(near, sensor, other, sensor, 0);
        assertThat(world.touching(SENSOR, BODY, pairs)).isEqualTo(3);
        assertThat(pairs).containsExactly(sensor, near, sensor, other, 0);
        assertThat(world.touching(BODY, BODY, pairs)).isOne();
        assertThat(pairs).startsWith(near, beside);
        assertThat(world.touching(OTHER, BODY, new long[0])).isZero();
        world.remove(near);
        assertThat(world.touching(BODY, SENSOR, pairs)).isEqualTo(2);
        assertThat(pairs).startsWith(other, sensor, beside, sensor);
        assertIllegalArgument("256", () -> world.touching(256, 0, pairs));
    }

    @Test
    void requestedEventsAreThoseUpToTheRequest() {
        assertThatIllegalStateException().isThrownBy(world::takeEvents).withMessageContaining("requestEvents");
        addStatic(0, 0, 3, SENSOR);
        long inside = add(1, 0, 0.5f, 0, BODY);
        world.step(DT, 2);
        world.requestEvents();
        world.remove(inside);
        world.step(DT, 2);
        Events taken = world.takeEvents();
        assertThat(taken.size()).isOne();
        assertThat(taken.type(0)).isEqualTo(Events.BEGIN);
        assertThatIllegalStateException().isThrownBy(world::takeEvents);
        add(1, 0, 0.5f, 0, BODY);
        world.step(DT, 2);
        world.requestEvents();
        assertThat(events()).containsExactly("0 end 0 1", "2 begin 0 1");
        assertThatIllegalStateException().isThrownBy(world::takeEvents);
    }

    @Test
    void whatIsRefused() {
        assertIllegalArgument("8", () -> world.report(0, 0, Events.WALL));
        assertIllegalArgument("-1", () -> world.report(-1, 0, 0));
        assertIllegalArgument("256", () -> world.report(0, 256, 0));
        assertIllegalArgument("16", () -> world.reportWalls(0, 16));
    }

    @Test
    void sensingChangesNoBitAndARestoredWorldGoesOn() {
        Scene scene = Scenes.mixed(300, 1);
        try (World silent = WorldScenes.world(scene, WorldScenes.builder(scene));
                World sensing = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            for (World each : new World[] {silent, sensing}) {
                each.kind(SENSOR).setSensor(true);
                for (int id = 0; id < each.idLimit(); id += 7) {
                    each.setKind(each.handle(id), SENSOR);
                }
            }
            sensing.report(0, SENSOR, ALL);
            silent.step(scene.timeStep(), 60);
            sensing.step(scene.timeStep(), 60);
            assertThat(sensing.hash()).isEqualTo(silent.hash());
            assertThat(sensing.events().size()).isPositive();
            ByteBuffer snapshot = ByteBuffer.allocate(sensing.snapshotBytes());
            sensing.snapshot(snapshot);
            sensing.step(scene.timeStep(), 20);
            List<Event> expected = Event.of(sensing.events());
            assertThat(expected).isNotEmpty();
            sensing.restore(snapshot.flip());
            sensing.step(scene.timeStep(), 20);
            assertThat(Event.of(sensing.events())).isEqualTo(expected);
        }
    }
}
