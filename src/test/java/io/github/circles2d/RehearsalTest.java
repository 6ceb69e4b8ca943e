package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.world.device.DevicePipeline;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.shared.Mover;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.snapshots.SavedState;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A rehearsal goes the way of a real move, and leaves room alone. {@link RunningChoiceTest} has those beside worlds, {@link RandomMoves} bits. */
class RehearsalTest {
    private static final int CIRCLES = 40;

    /** A device in Java, which is ready for one kind of world, and notes what is asked of it. */
    private static Pipeline device(Readiness ready, List<String> calls, String refused) {
        Pipeline inner = new JvmPipeline(1, 1, 0, false);
        return (Pipeline) Proxy.newProxyInstance(
                Pipeline.class.getClassLoader(), new Class<?>[] {Pipeline.class}, (proxy, method, arguments) -> {
                    String name = method.getName();
                    calls.add(name);
                    if (name.equals("isReady")) {
                        return ready.equals(arguments[0]);
                    }
                    if (name.equals(refused)) {
                        throw new DeviceMemoryException("none left", 2, 1);
                    }
                    try {
                        return method.invoke(inner, arguments);
                    } catch (InvocationTargetException e) {
                        throw e.getCause();
                    }
                });
    }

    private static BooleanSupplier rounds(int count) {
        int[] asked = {0};
        return () -> asked[0]++ < count;
    }

    private static long count(List<String> calls, String call) {
        return calls.stream().filter(call::equals).count();
    }

    @Test
    void theWorldThatIsMadeUpNeedsAllThatIsWantedAndNoMore() {
        for (int bits = 0; bits < 128 * 6; bits++) {
            Features features = Features.EDGES
                    .when((bits & 1) != 0)
                    .and(Features.TURNING.when((bits & 2) != 0))
                    .and(Features.TERRAIN.when((bits & 4) != 0))
                    .and(Features.JOINTS.when((bits & 8) != 0))
                    .and(Features.SLEEPING.when((bits & 16) != 0))
                    .and(Features.OWN_MOTION.when((bits & 32) != 0))
                    .and(Features.BODIES.when((bits & 64) != 0));
            if (features.bodies() && !features.turning()) {
                continue; // no world on a device has that
            }
            int reports = bits / 256;
            Readiness wanted = new Readiness((bits & 128) != 0, features, reports > 0, reports > 1);
            List<String> calls = new ArrayList<>();
            SavedState left = Rehearsal.of(device(wanted, calls, ""), wanted, CIRCLES, rounds(2));
            assertThat(count(calls, "load")).as("%s", wanted).isEqualTo(2);
            assertThat(count(calls, "step")).as("%s", wanted).isEqualTo(2);
            assertThat(count(calls, "save")).as("%s", wanted).isEqualTo(2);
            assertThat(left.circles).isEqualTo(CIRCLES);
            assertThat(left.impulses).as("impulses on their way").isGreaterThan(CIRCLES);
            assertThat(calls.indexOf("forget")).as("tables of the world beside").isLessThan(calls.indexOf("load"));
            assertThat(calls.subList(calls.lastIndexOf("leave"), calls.size())).contains("forget");
            assertThat(calls).doesNotContain("close", "positions", "requestPositions", "compile");
        }
    }

    @Test
    void itEndsWhenItIsTold() {
        List<String> calls = new ArrayList<>();
        Rehearsal.of(device(Readiness.USUAL, calls, ""), Readiness.USUAL, CIRCLES, rounds(7));
        assertThat(count(calls, "load")).isEqualTo(7);
        calls.clear();
        assertThat(Rehearsal.of(device(Readiness.USUAL, calls, ""), Readiness.USUAL, CIRCLES, () -> false))
                .isNull();
        assertThat(count(calls, "load")).isZero();
    }

    @Test
    void itThrowsWhatADeviceRefusesAndForgetsWhatIsThere() {
        for (String refused : List.of("prepare", "makeRoom", "load", "prepareSteps", "step", "readCircles", "save")) {
            List<String> calls = new ArrayList<>();
            assertThatThrownBy(() ->
                            Rehearsal.of(device(Readiness.USUAL, calls, refused), Readiness.USUAL, CIRCLES, () -> true))
                    .as(refused)
                    .isInstanceOf(DeviceMemoryException.class);
            assertThat(calls).contains("forget").doesNotContain("close");
        }
    }

    @Test
    void itIsLeftOutWhereTheHeapIsTooSmall() {
        List<String> calls = new ArrayList<>();
        assertThat(Rehearsal.of(device(Readiness.USUAL, calls, ""), Readiness.USUAL, 1 << 29, () -> true))
                .isNull();
        assertThat(calls).isEmpty();
    }

    /** Goes to a device before the first step. */
    private record Goes(Pipeline home, Pipeline device) implements Mover {
        @Override
        public Pipeline choose(Pipeline now, Readiness wanted, int circles, int awake, double nanos) {
            return device;
        }

        @Override
        public boolean isHome(Pipeline pipeline) {
            return pipeline == home;
        }

        @Override
        public void moved(Pipeline from, Pipeline to, long nanos, Throwable cause) {
            assertThat(to).isSameAs(device);
        }

        @Override
        public void refused(Pipeline chosen, Throwable why) {
            throw new AssertionError(why);
        }

        @Override
        public void lost(Pipeline failed, Throwable why) {
            throw new AssertionError(why);
        }

        @Override
        public void close() {
            home.close();
        }
    }

    /** Tables are told apart by how often they have changed: here, as often as those of the world that is made up. */
    @Test
    @Tag("long")
    void tablesOfTheWorldThatIsMadeUpAreNotTakenForOthers() {
        Features all = Features.TURNING
                .and(Features.TERRAIN)
                .and(Features.JOINTS)
                .and(Features.SLEEPING)
                .and(Features.OWN_MOTION);
        Readiness wanted = new Readiness(false, all, false, false);
        for (Device device : TestDevices.all()) {
            try (DevicePipeline pipeline = new DevicePipeline(device, CIRCLES, false, true);
                    World stays = other(null)) {
                pipeline.compile(wanted);
                Rehearsal.of(pipeline, wanted, CIRCLES, rounds(3));
                try (World goes = other(pipeline)) {
                    for (int step = 0; step < 40; step++) {
                        goes.step(1 / 60f);
                        stays.step(1 / 60f);
                        assertThat(goes.hash()).as("step %d", step).isEqualTo(stays.hash());
                    }
                }
            }
        }
    }

    /** Made by calls as {@link Rehearsal} makes, with other values. */
    private static World other(Pipeline device) {
        Pipeline home = new JvmPipeline(1, 1, 0, false);
        World world = new World(
                World.builder().bounds(0, 0, 20, 20).gravity(0, -10).sleep(true).friction(0.9f),
                new BackendChoice(Backend.JVM, home, "a test"));
        long first = world.add(5, 5, 0.5f, 1, 3, 0, 1);
        for (int k = 0; k < 8; k++) {
            world.add(3 + 1.5f * k, 8, 0.5f, 1);
        }
        long last = world.add(9, 5, 0.5f, 2);
        world.terrain().addSegment(2, 4, 18, 1, 0, 2);
        world.joints().add(first, last, Joint.rope(2));
        world.setGravityScale(first, 0.2f);
        if (device != null) {
            world.simulation().moves.by(new Goes(home, device));
        }
        return world;
    }

    @Test
    @Tag("long")
    void itLeavesNoTimesOnADevice() {
        for (Device device : TestDevices.all()) {
            try (DevicePipeline pipeline = new DevicePipeline(device, CIRCLES, true, true)) {
                pipeline.compile(Readiness.USUAL);
                assertThat(Rehearsal.of(pipeline, Readiness.USUAL, CIRCLES, rounds(1)))
                        .isNotNull();
                assertThat(pipeline.stageMillis()).isEmpty();
            }
        }
    }
}
