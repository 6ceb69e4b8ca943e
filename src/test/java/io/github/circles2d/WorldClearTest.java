package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.reference.Event;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Removing all circles is removing each of them in the order of the ids. */
class WorldClearTest {
    private static final float STEP = 1 / 60f;

    private static World world(Backend backend) {
        World world = World.builder()
                .bounds(0, 0, 10, 10)
                .gravity(0, -10)
                .threads(1)
                .backend(backend)
                .build();
        world.kind(3).setDamping(0.5f);
        for (int k = 0; k < 40; k++) {
            world.add(1 + k % 8, 1 + k / 8, 0.52f, 1, 0, 0, k % 2 == 0 ? 3 : 0);
        }
        world.setMass(world.handle(5), Float.POSITIVE_INFINITY);
        world.step(STEP, 30);
        return world;
    }

    private static void removeEach(World world) {
        for (int id = 0; id < world.idLimit(); id++) {
            if (world.handle(id) != 0) {
                world.remove(world.handle(id));
            }
        }
    }

    private static void addSome(World world) {
        for (int k = 0; k < 25; k++) {
            world.add(1 + k % 5, 1 + k / 5, 0.55f, 1, 0, 0, k % 3);
        }
    }

    /** Changes that have not taken effect are among those before, and there are circles, forces and ways to go in the next step. */
    private static void changeSome(World world) {
        world.remove(world.handle(7));
        world.add(5, 9, 0.5f, 1, 0, 0, 3);
        world.add(6, 9, 0.5f, 1);
        world.setPosition(world.handle(5), 9, 9);
        world.applyForce(world.handle(8), 30, 0);
        world.setForce(world.handle(9), 30, 0);
        world.grow(world.handle(10), 0.7f, 5);
        world.setGroup(world.handle(11), 9);
        world.setTag(world.handle(11), 9);
        world.setBounds(0.1f, 0, 10, 10);
    }

    @OnEachBackend
    void itLeavesTheSameWorldAsRemovingEach(Backend backend) {
        for (boolean reports : new boolean[] {false, true}) {
            try (World world = world(backend);
                    World same = world(backend)) {
                for (World each : List.of(world, same)) {
                    each.report(reports ? Events.BEGIN | Events.HIT | Events.END | Events.WALL : 0);
                    each.step(STEP, 3);
                    each.events();
                    changeSome(each);
                }
                world.clear();
                removeEach(same);
                assertThat(world.size()).isZero();
                assertThat(snapshot(world)).isEqualTo(snapshot(same));
                for (World each : List.of(world, same)) {
                    addSome(each);
                    each.step(STEP, 20);
                }
                assertThat(Event.of(world.events())).isEqualTo(Event.of(same.events()));
                assertThat(world.hash()).isEqualTo(same.hash());
                assertThat(snapshot(world)).isEqualTo(snapshot(same));
            }
        }
    }

    @OnEachBackend
    void handlesAreStaleAndIdsAreFree(Backend backend) {
        try (World world = world(backend)) {
            long[] handles = new long[world.size()];
            world.readHandles(handles);
            int limit = world.idLimit();
            world.clear();
            assertThat(Arrays.stream(handles).anyMatch(world::contains)).isFalse();
            assertThat(world.idLimit()).isEqualTo(limit);
            long first = world.add(5, 5, 0.5f, 1);
            assertThat(World.id(first)).isZero();
            assertThat(first).isNotEqualTo(handles[0]);
            assertThat(world.y(first)).isEqualTo(5);
            world.step(STEP);
            assertThat(world.size()).isOne();
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void pairsThatTouchedEndInTheNextStep(boolean empty) {
        try (World world = world(Backend.JVM)) {
            world.report(Events.BEGIN | Events.END);
            world.step(STEP);
            int begun = world.events().size();
            assertThat(begun).isPositive();
            world.clear();
            if (!empty) {
                world.add(5, 5, 0.5f, 1);
            }
            world.step(STEP);
            Events events = world.events();
            assertThat(events.size()).isEqualTo(begun);
            for (int k = 0; k < begun; k++) {
                assertThat(events.type(k)).isEqualTo(Events.END);
            }
        }
    }

    @OnEachBackend
    void allElseStays(Backend backend) {
        try (World world = world(backend)) {
            world.setGravity(1, -2);
            world.setBounds(0.1f, 0, 9, 10);
            world.setResponse(3, 4, Response.IGNORE);
            world.requestPositions();
            world.clear();
            assertThat(world.takePositions().remaining()).isEqualTo(2 * 40);
            assertThat(world.gravityX()).isEqualTo(1);
            assertThat(world.maxX()).isEqualTo(9);
            assertThat(world.kind(3).damping()).isEqualTo(0.5f);
            assertThat(world.response(3, 4)).isEqualTo(Response.IGNORE);
            WorldStats stats = world.stats();
            assertThat(stats.circles()).isZero();
            assertThat(stats.contacts()).isZero();
        }
    }

    @Test
    void aWorldWithoutCirclesMayBeCleared() {
        try (World world = WorldScenes.jvm().build()) {
            world.clear();
            world.step(STEP);
            world.clear();
            world.add(0.5f, 0.5f, 0.1f, 1);
            world.step(STEP);
            assertThat(world.size()).isOne();
        }
    }
}
