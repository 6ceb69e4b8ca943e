package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.scenes.HardScenes;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.shared.Pipeline;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;

/** Worlds that report events have the same events and the same bits on every device and for any number of threads. */
class EventsAgreeTest {

    /** In Java on one thread and on more, and one for each plan that a device can follow. */
    private static Pipeline[] pipelines(Device device) {
        return pipelines(device, Features.NONE);
    }

    private static Pipeline[] pipelines(Device device, Features features) {
        List<Pipeline> pipelines = new ArrayList<>(List.of(Pipelines.all(device, features)));
        pipelines.add(1, new JvmPipeline(2, 1, 0, false));
        if (TestScale.EXHAUSTIVE) { // more threads than processors, which take long on a busy machine
            pipelines.add(2, new JvmPipeline(7, 1, 0, false));
        }
        return pipelines.toArray(Pipeline[]::new);
    }

    @OnEachDevice
    @Tag("long")
    void scenesHaveTheSameEvents(Device device) {
        for (Scene scene : new Scene[] {
            Scenes.thesis(600, 1),
            Scenes.gas(600, 1),
            Scenes.mixed(600, 1),
            Scenes.pyramid(),
            Scenes.billiards(300),
            Scenes.onePoint(200, 1),
            HardScenes.squeezed(28, 1)
        }) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                twins.report(ContactEvents.ALL);
                int events = 0;
                for (int k = 0; k < TestScale.of(5, 12); k++) {
                    twins.step(scene.timeStep(), 1 + k % 4);
                    events += twins.assertSameEvents(scene.name() + " after call " + k);
                }
                assertThat(events).as(scene.name()).isPositive();
                twins.assertEqual(scene.name());
            }
        }
    }

    /** Circles come, go and are moved, states are exchanged, reporting is switched, and nobody looks in between. */
    @OnEachDevice
    @Tag("long")
    void changesHaveTheSameEvents(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(300, 2), Scenes.mixed(300, 2)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                SplittableRandom random = new SplittableRandom(3);
                int[] types = {ContactEvents.ALL, 0, ContactEvents.BEGIN | ContactEvents.END, ContactEvents.ALL};
                for (int k = 0; k < TestScale.of(20, 40); k++) {
                    if (k % 10 == 0) {
                        twins.report(types[k / 10]);
                    }
                    for (int changes = 0; changes < 30; changes++) {
                        twins.change(scene, random);
                    }
                    twins.step(k % 7 == 6 ? 0.3f : 1 / 60f, 1 + k % 3);
                    if (k % 5 == 4) {
                        twins.exchange();
                    }
                    if (k % 3 == 0) {
                        twins.assertSameEvents(scene.name() + " after change " + k);
                    }
                    twins.confine();
                }
                twins.assertSameEvents(scene.name());
                twins.assertEqual(scene.name());
            }
        }
    }

    /** What a sensor notices is the same by any plan, since no plan solves it. */
    @OnEachDevice
    @Tag("long")
    void sensedPairsAreTheSameByAnyPlan(Device device) {
        for (Scene scene : new Scene[] {
            Scenes.thesis(600, 1),
            Scenes.gas(600, 1),
            Scenes.mixed(600, 1),
            Scenes.billiards(300),
            Scenes.onePoint(200, 1),
            HardScenes.squeezed(28, 1)
        }) {
            try (Twins twins = Twins.load(scene, withThreads(PipelinesAgreeTest.pipelines(device)))) {
                SplittableRandom random = new SplittableRandom(5);
                twins.giveSensors(200, 7);
                twins.giveSensors(201, 50);
                twins.report(0, 200, ContactEvents.BEGIN | ContactEvents.END);
                twins.report(0, 201, ContactEvents.OF_PAIR_TYPES);
                int events = 0;
                for (int k = 0; k < TestScale.of(5, 12); k++) {
                    twins.step(k == TestScale.of(3, 7) ? 0.5f : scene.timeStep(), 1 + k % 3);
                    if (k % 3 == 1) {
                        twins.assertSameTouching(0, 200);
                    }
                    events += twins.assertSameEvents(scene.name() + " after call " + k);
                    twins.change(scene, random);
                }
                assertThat(events).as(scene.name()).isPositive();
                twins.assertEqual(scene.name());
            }
        }
    }

    /** Static circles sense each other and bodies, since a kind asks; they come to rest, are moved and wake. */
    @OnEachDevice
    @Tag("long")
    void staticCirclesHaveTheSameEvents(Device device) {
        Scene scene = Scenes.mixed(300, 6);
        try (Twins twins = Twins.load(scene, withThreads(pipelines(device, Pipelines.INSIDE_EDGES)))) {
            SplittableRandom random = new SplittableRandom(13);
            twins.giveSensors(200, 7);
            twins.setKind(KindField.SENSES_STATIC, 200, 1);
            twins.report(ContactEvents.BEGIN | ContactEvents.END);
            for (int id = 0; id < twins.size(); id += 2) {
                twins.set(Commands.MASS, id, Float.POSITIVE_INFINITY, 0);
                twins.set(Commands.VELOCITY, id, 0, 0);
            }
            float width = scene.maxX() - scene.minX();
            for (int k = 0; k < 8; k++) {
                twins.addSpinner(
                        scene.minX() + 0.12f * k * width, scene.minY() + 0.5f * width, 0.3f * width, k - 3, k % 2);
            }
            int events = 0;
            for (int k = 0; k < TestScale.of(16, 40); k++) {
                for (int moves = 0; moves < 4; moves++) {
                    float x = scene.minX() + width * (float) random.nextDouble();
                    float y = scene.minY() + (scene.maxY() - scene.minY()) * (float) random.nextDouble();
                    twins.set(Commands.POSITION, 2 * random.nextInt(twins.size() / 2), x, y);
                }
                if (k % 5 == 4) {
                    twins.setKind(KindField.SENSES_STATIC, 0, k & 1);
                    twins.exchange();
                }
                twins.step(scene.timeStep(), 1 + k % 3);
                twins.assertSameTouching(0, 200);
                events += twins.assertSameEvents("after call " + k);
                twins.assertEqual("after call " + k);
            }
            assertThat(events).isGreaterThan(100);
        }
    }

    private static Pipeline[] withThreads(Pipeline[] pipelines) {
        Pipeline[] more = Arrays.copyOf(pipelines, pipelines.length + 1);
        more[pipelines.length] = new JvmPipeline(TestScale.of(2, 3), 1, 0, false);
        return more;
    }

    /** Pieces of terrain come, go, move and get other kinds, some of which only sense. */
    @OnEachDevice
    @Tag("each-jdk")
    @Tag("long")
    void piecesOfTerrainHaveTheSameEvents(Device device) {
        for (Scene scene : new Scene[] {Scenes.thesis(300, 4), Scenes.mixed(300, 4), Scenes.gas(300, 4)}) {
            try (Twins twins = Twins.load(scene, pipelines(device, Pipelines.INSIDE_EDGES))) {
                SplittableRandom random = new SplittableRandom(9);
                twins.report(0, 0, ContactEvents.OF_PAIR_TYPES);
                twins.report(0, 1, ContactEvents.BEGIN | ContactEvents.END);
                twins.sense(0, 1);
                int events = 0;
                for (int k = 0; k < TestScale.of(24, 60); k++) {
                    if (k == 10) {
                        twins.report(ContactEvents.ALL);
                    }
                    for (int changes = k == 0 ? 30 : 4 * (k % 3); changes > 0; changes--) {
                        twins.changeTerrain(random);
                    }
                    if (k == 15) {
                        twins.changeSurfaces(random);
                    }
                    if (k % 5 == 1) {
                        twins.change(scene, random);
                    }
                    twins.step(scene.timeStep(), 1 + k % 3);
                    if (k % 7 == 6) {
                        twins.exchange();
                    }
                    twins.assertEqual(scene.name() + " after call " + k);
                    if (k % 2 == 0) {
                        events += twins.assertSameEvents(scene.name() + " after call " + k);
                    }
                }
                assertThat(events).as(scene.name()).isGreaterThan(100);
            }
        }
    }

    @OnEachDevice
    @Tag("long")
    void piecesAcrossSeamsHaveTheSameEvents(Device device) {
        Scene scene = Scenes.gas(300, 5);
        try (Twins twins = Twins.load(scene, pipelines(device, Pipelines.INSIDE_EDGES))) {
            twins.restoreWithEdges(AxisEdge.WRAP, AxisEdge.WRAP);
            twins.report(ContactEvents.OF_PAIR_TYPES);
            twins.sense(0, 1);
            float width = scene.maxX() - scene.minX();
            for (int k = 0; k < 10; k++) {
                float x = k % 2 == 0 ? scene.minX() : scene.minX() + 0.1f * k * width;
                twins.addSpinner(x, scene.minY() + 0.11f * k * width, 0.3f * width, k % 3 - 1, k % 2);
            }
            int events = 0;
            for (int k = 0; k < TestScale.of(12, 30); k++) {
                twins.step(scene.timeStep(), 1 + k % 3);
                twins.assertEqual("after call " + k);
                events += twins.assertSameEvents("after call " + k);
            }
            assertThat(events).isGreaterThan(100);
        }
    }

    /** Requested events are those of the steps before, whatever has been made since. */
    @OnEachDevice
    void requestedEventsAreTheSame(Device device) {
        Scene scene = Scenes.gas(300, 2);
        try (Twins twins = Twins.load(scene, pipelines(device))) {
            SplittableRandom random = new SplittableRandom(11);
            twins.report(ContactEvents.ALL);
            twins.giveSensors(200, 5);
            int events = 0;
            for (int k = 0; k < TestScale.of(10, 20); k++) {
                twins.step(scene.timeStep(), 1 + k % 2);
                twins.requestEvents();
                twins.step(scene.timeStep(), k % 3 + 1);
                if (k % 4 == 0) {
                    twins.change(scene, random);
                }
                events += twins.assertSameRequestedEvents("after call " + k);
                if (k % 5 == 0) {
                    twins.assertSameEvents("all after call " + k);
                }
            }
            assertThat(events).isPositive();
            twins.assertEqual("at last");
        }
    }

    /** Walls move, kinds and forces are changed, and in an exhaustive run contacts get other settings. */
    @OnEachDevice
    @Tag("long")
    void wallsThatMoveAndContactsOfAnySettingsHaveTheSameEvents(Device device) {
        for (Scene scene : new Scene[] {Scenes.gas(300, 3), Scenes.mixed(300, 3)}) {
            try (Twins twins = Twins.load(scene, pipelines(device))) {
                twins.report(ContactEvents.ALL);
                SplittableRandom random = new SplittableRandom(7);
                int events = 0;
                for (int k = 0; k < TestScale.of(8, 30); k++) {
                    if (k == 15) { // a program that no other test needs
                        twins.restoreWith(new ContactSettings(0.05f, 30f, 5f, 1f));
                    }
                    twins.change(scene, random);
                    twins.moveWalls(random, 1.5f * scene.radius(0));
                    twins.step(scene.timeStep(), 1 + k % 3);
                    events += twins.assertSameEvents(scene.name() + " after move " + k);
                }
                assertThat(events).as(scene.name()).isPositive();
                twins.assertEqual(scene.name());
            }
        }
    }

    /** Many circles, so that several work-groups share a step; most pairs press each other step after step. */
    @OnEachDevice
    @Tag("long")
    void pilesHaveTheSameEvents(Device device) {
        Scene scene = Scenes.packed(3000, 1);
        try (Twins twins = Twins.load(scene, pipelines(device))) {
            twins.report(ContactEvents.ALL);
            int events = 0;
            for (int k = 0; k < TestScale.of(7, 12); k++) {
                twins.step(scene.timeStep(), k < 6 ? 1 : 10);
                events += twins.assertSameEvents(scene.name() + " after call " + k);
            }
            assertThat(events).isPositive();
            twins.assertEqual(scene.name());
        }
    }

    /** Two plans make steps of one world in turn: what one leaves of the pairs in touch, the other goes on from. */
    @OnEachDevice
    @Tag("long")
    void plansThatTakeTurnsHaveTheSameEvents(Device device) {
        Scene scene = Scenes.packed(1200, 5);
        try (Twins twins = Twins.load(scene, pipelines(device))) {
            twins.report(ContactEvents.ALL);
            for (int k = 0; k < 12; k++) {
                // A circle that is much larger makes a second level, which only the plan by colours takes; a new one
                // moves far off.
                if (k % 3 == 2) {
                    twins.set(Commands.RADIUS, 0, (k % 2 == 0 ? 1 : 5) * scene.radius(0), 0);
                }
                if (k % 4 == 3) {
                    twins.move(7 * k, 0.5f, 0.9f);
                }
                twins.step(scene.timeStep(), 1 + k % 3);
                if (k == 5 || k == 6) {
                    twins.exchange();
                }
                twins.assertSameEvents("turn " + k);
            }
            twins.assertEqual(scene.name());
        }
    }
}
