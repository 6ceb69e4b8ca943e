package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.management.ThreadMXBean;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.OpenClUnavailableException;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.device.DevicePipeline;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.snapshots.SavedState;
import java.lang.management.ManagementFactory;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A world of AUTO begins on the JVM, and moves to a device when that is ready and while it is worth it; whatever fails, it goes on. */
@Timeout(value = 300, unit = TimeUnit.SECONDS)
class RunningChoiceTest {
    private static final Scene SCENE = Scenes.packed(1500, 7);

    /** Goes to the other side every few frames. */
    private static final class Restless extends FrameRule {
        private int frames;

        @Override
        boolean frame(double nanos, int circles, int awake) {
            return ++frames % 5 == 0;
        }
    }

    /** Goes to the device, and stays. */
    private static final class Eager extends FrameRule {
        private boolean away;

        @Override
        boolean frame(double nanos, int circles, int awake) {
            return !away;
        }

        @Override
        void moved(boolean toDevice, boolean chosen) {
            away = toDevice;
        }
    }

    /** Devices in Java, which count what is asked of them. */
    private static final class Devices implements IntFunction<Pipeline> {
        final AtomicInteger opened = new AtomicInteger();
        final AtomicInteger closed = new AtomicInteger();
        final AtomicInteger compiled = new AtomicInteger();

        /** What the devices refuse, what they do beside the point of it, and of how many circles they take over a state. */
        volatile String refused = "";

        volatile Consumer<String> before = call -> {};

        volatile int most = Integer.MAX_VALUE;

        private final long millis;

        Devices(long millis) {
            this.millis = millis;
        }

        @Override
        public Pipeline apply(int circles) {
            pause();
            opened.incrementAndGet();
            Pipeline inner = new JvmPipeline(1, 1, 0, false);
            Set<Object> ready = new HashSet<>();
            AtomicInteger closings = new AtomicInteger();
            return (Pipeline) Proxy.newProxyInstance(
                    Pipeline.class.getClassLoader(), new Class<?>[] {Pipeline.class}, (proxy, method, arguments) -> {
                        switch (method.getName()) {
                            case "isReady" -> {
                                return ready.contains(arguments[0]);
                            }
                            case "compile" -> {
                                pause();
                                if (refused.equals("compile")) {
                                    throw new OpenClUnavailableException("refused");
                                }
                                compiled.incrementAndGet();
                                ready.add(arguments[0]);
                                return null;
                            }
                            case "close" -> closed.addAndGet(closings.getAndIncrement() == 0 ? 1 : 0);
                            default -> {
                                before.accept(method.getName());
                                boolean tooMany = arguments != null
                                        && arguments[0] instanceof SavedState state
                                        && state.circles > most;
                                if (method.getName().equals(refused) || tooMany) {
                                    throw new DeviceMemoryException("none left", 2, 1);
                                }
                            }
                        }
                        try {
                            return method.invoke(inner, arguments);
                        } catch (InvocationTargetException e) {
                            throw e.getCause();
                        }
                    });
        }

        private void pause() {
            try {
                Thread.sleep(millis);
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        }
    }

    private static World world(IntFunction<Pipeline> devices, FrameRule rule) {
        return world(devices, rule, new AtomicInteger());
    }

    /** homes: counts the pipelines on the JVM that are made later. */
    private static World world(IntFunction<Pipeline> devices, FrameRule rule, AtomicInteger homes) {
        Pipeline home = new JvmPipeline(1, 1, 0, false);
        RunningChoice running = new RunningChoice(
                home,
                () -> {
                    homes.incrementAndGet();
                    return new JvmPipeline(1, 1, 0, false);
                },
                devices,
                rule,
                1500);
        World.Builder builder = WorldScenes.builder(SCENE);
        return WorldScenes.load(
                SCENE, new World(builder, new BackendChoice(Backend.JVM, home, running.reason(), running)));
    }

    private static World stays() {
        return WorldScenes.world(SCENE, WorldScenes.builder(SCENE));
    }

    /** Makes steps in both until one has moved so often. */
    private static void stepUntilMoved(int moves, World world, World stays) {
        while (world.stats().moves() < moves) {
            world.step(SCENE.timeStep());
            stays.step(SCENE.timeStep());
            assertThat(world.hash()).isEqualTo(stays.hash());
        }
    }

    @Test
    void aWorldStartsAtOnceAndMovesWhenADeviceIsReady() {
        try (World world = world(new Devices(100), new Eager());
                World stays = stays()) {
            assertThat(world.stats().backend()).isEqualTo(Backend.JVM);
            assertThat(world.stats().reason()).contains("starts here");
            stepUntilMoved(1, world, stays);
            assertThat(world.stats().backend()).isEqualTo(Backend.OPENCL_GPU);
            assertThat(world.stats().reason()).contains("ms here").contains("the JVM");
            assertThat(world.stats().moveMillis()).isPositive();
        }
    }

    @Test
    void aFeatureThatComesLaterIsMadeReadyWhileTheWorldIsAtHome() {
        Devices devices = new Devices(5);
        try (World world = world(devices, new Eager());
                World stays = stays()) {
            stepUntilMoved(1, world, stays);
            for (World each : new World[] {world, stays}) {
                each.kind(0).setFriction(0.5f);
                each.report(Events.BEGIN);
            }
            world.step(SCENE.timeStep());
            stays.step(SCENE.timeStep());
            assertThat(world.stats().backend()).isEqualTo(Backend.JVM);
            assertThat(world.stats().reason()).contains("compiles");
            stepUntilMoved(3, world, stays);
            assertThat(world.stats().backend()).isEqualTo(Backend.OPENCL_GPU);
            assertThat(devices.compiled.get()).isGreaterThanOrEqualTo(2);
            assertThat(world.events().size()).isEqualTo(stays.events().size());
        }
    }

    @Test
    void aDeviceThatIsNotThereIsToldOfOnce() {
        try (World world = world(
                        circles -> {
                            throw new OpenClUnavailableException("none here");
                        },
                        new Eager());
                World stays = stays()) {
            while (!world.stats().reason().contains("no GPU can be used: none here")) {
                world.step(SCENE.timeStep());
                stays.step(SCENE.timeStep());
            }
            assertThat(world.hash()).isEqualTo(stays.hash());
            assertThat(world.stats().moves()).isZero();
        }
    }

    @Test
    void aWorldStaysWhereADeviceRefusesItsKernelsOrHasNoMemory() {
        for (String refused : List.of("compile", "makeRoom", "prepare", "load", "step", "finish")) {
            Devices devices = new Devices(1);
            devices.refused = refused;
            try (World world = world(devices, new Eager());
                    World stays = stays()) {
                while (!world.stats().reason().contains(refused.equals("compile") ? "refuses" : "cannot take")) {
                    world.step(SCENE.timeStep());
                    stays.step(SCENE.timeStep());
                }
                assertThat(world.hash()).isEqualTo(stays.hash());
                assertThat(world.stats().moves()).isZero();
            }
        }
    }

    @Test
    void aRehearsalLeavesNoTraceInTheWorldBeside() {
        Devices devices = new Devices(1);
        AtomicInteger forgets = new AtomicInteger(); // before a rehearsal and behind it
        devices.before = call -> forgets.addAndGet(call.equals("forget") ? 1 : 0);
        try (World world = world(devices, new Eager());
                World stays = stays()) {
            for (World each : new World[] {world, stays}) {
                each.report(Events.BEGIN + Events.END);
                each.kind(0).setFriction(0.3f);
            }
            int events = 0;
            for (int frame = 0; frame < 20 || world.stats().moves() == 0; frame++) {
                world.step(SCENE.timeStep());
                stays.step(SCENE.timeStep());
                assertThat(bytes(world)).isEqualTo(bytes(stays));
                assertThat(world.hash()).isEqualTo(stays.hash());
                String told = MovesTest.text(world.events());
                assertThat(told).isEqualTo(MovesTest.text(stays.events()));
                events += told.length();
                if (world.stats().moves() == 0) {
                    assertThat(figures(world)).isEqualTo(figures(stays));
                }
            }
            assertThat(events).isPositive();
            assertThat(forgets.get()).isEqualTo(2);
            assertThat(world.stats().moves()).isOne();
            for (int frame = 0; frame < 20; frame++) {
                world.step(SCENE.timeStep());
                stays.step(SCENE.timeStep());
                assertThat(bytes(world)).isEqualTo(bytes(stays));
                assertThat(MovesTest.text(world.events())).isEqualTo(MovesTest.text(stays.events()));
                assertThat(figures(world)).isEqualTo(figures(stays));
            }
        }
    }

    private static byte[] bytes(World world) {
        ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(bytes);
        return bytes.array();
    }

    private static List<Object> figures(World world) {
        WorldStats stats = world.stats();
        return List.of(stats.circles(), stats.candidatePairs(), stats.contacts(), stats.stageMillis());
    }

    @Test
    void aClosingWorldEndsARehearsal() throws InterruptedException {
        Devices devices = new Devices(0);
        CountDownLatch rehearses = new CountDownLatch(1);
        CountDownLatch closed = new CountDownLatch(1);
        AtomicInteger loads = new AtomicInteger();
        devices.before = call -> {
            if (call.equals("load")) {
                loads.incrementAndGet();
                rehearses.countDown();
                await(closed);
            }
        };
        World world = world(devices, new Eager());
        while (rehearses.getCount() > 0) {
            world.step(SCENE.timeStep()); // goes on meanwhile
        }
        world.close();
        assertThat(devices.closed.get()).isZero();
        closed.countDown();
        while (devices.closed.get() == 0) {
            Thread.sleep(1);
        }
        assertThat(loads.get()).isOne();
        assertThat(devices.closed.get()).isOne();
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void aDeviceWithoutMemoryForMoreTakesThoseThatThereAre() {
        Devices devices = new Devices(0);
        devices.most = 1500;
        try (World world = world(devices, new Eager());
                World stays = stays()) {
            stepUntilMoved(1, world, stays);
            assertThat(world.stats().backend()).isEqualTo(Backend.OPENCL_GPU);
            assertThat(devices.opened.get()).isOne();
        }
    }

    @Test
    void aCrowdThatOutgrowsTheRoomIsRehearsedAgain() {
        Devices devices = new Devices(0);
        AtomicInteger forgets = new AtomicInteger(); // before a rehearsal and behind it
        devices.before = call -> forgets.addAndGet(call.equals("forget") ? 1 : 0);
        FrameRule late = new FrameRule() {
            @Override
            boolean frame(double nanos, int circles, int awake) {
                return circles == 2000;
            }

            @Override
            boolean endsGroup() {
                return false;
            }
        };
        try (World world = world(devices, late);
                World stays = stays()) {
            while (forgets.get() < 2) {
                world.step(SCENE.timeStep());
                stays.step(SCENE.timeStep());
            }
            for (int k = 0; k < 500; k++) {
                int of = k % SCENE.size();
                world.add(SCENE.x(of), SCENE.y(of), SCENE.radius(of), 1);
                stays.add(SCENE.x(of), SCENE.y(of), SCENE.radius(of), 1);
            }
            stepUntilMoved(1, world, stays);
            assertThat(forgets.get()).isEqualTo(4);
        }
    }

    @Test
    void aRehearsalThatFailsByItselfKeepsNoWorldFromItsDevice() {
        Devices devices = new Devices(0);
        AtomicInteger reads = new AtomicInteger();
        devices.before = call -> {
            if (call.equals("readCircles") && reads.getAndIncrement() == 0) {
                throw new IllegalArgumentException("not the device's fault");
            }
        };
        try (World world = world(devices, new Eager());
                World stays = stays()) {
            stepUntilMoved(1, world, stays);
            assertThat(reads.get()).isOne();
            assertThat(world.stats().backend()).isEqualTo(Backend.OPENCL_GPU);
        }
    }

    @Test
    void aDeviceThatHasNoMemoryForWhatComesIsLeft() {
        Devices devices = new Devices(1);
        try (World world = world(devices, new Eager());
                World stays = stays()) {
            stepUntilMoved(1, world, stays);
            devices.refused = "makeRoom";
            world.add(SCENE.x(0), SCENE.y(0), SCENE.radius(0), 1);
            stays.add(SCENE.x(0), SCENE.y(0), SCENE.radius(0), 1);
            stepUntilMoved(2, world, stays);
            assertThat(world.stats().backend()).isEqualTo(Backend.JVM);
            assertThat(world.stats().reason()).contains("cannot take").contains("none left");
        }
    }

    @Test
    void aWorldWhoseDeviceFailsGoesOnOnTheJvmWithASnapshot() {
        Devices devices = new Devices(1);
        try (World world = world(devices, new Eager());
                World stays = stays()) {
            stepUntilMoved(1, world, stays);
            ByteBuffer saved = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(saved);
            world.requestPositions();
            devices.refused = "step";
            assertThatThrownBy(() -> world.step(SCENE.timeStep())).isInstanceOf(DeviceMemoryException.class);
            assertThatThrownBy(() -> world.step(SCENE.timeStep()))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("this World failed earlier and lost its state:"
                            + " restore a snapshot or a frame, and it goes on on the JVM");
            assertThatThrownBy(() -> world.restore(ByteBuffer.allocate(100)))
                    .isInstanceOf(IllegalArgumentException.class);
            assertThatThrownBy(world::hash).isInstanceOf(IllegalStateException.class);
            world.restore(saved.flip());
            assertThat(world.stats().backend()).isEqualTo(Backend.JVM);
            assertThat(world.stats().reason()).contains("has failed: none left");
            assertThat(devices.closed.get()).isOne();
            assertThatThrownBy(world::takePositions).hasMessageContaining("no positions have been requested");
            for (int frame = 0; frame < 50; frame++) {
                world.step(SCENE.timeStep());
                stays.step(SCENE.timeStep());
                assertThat(world.hash()).isEqualTo(stays.hash());
            }
            assertThat(world.stats().moves()).isEqualTo(2);
            assertThat(devices.opened.get()).isOne();
        }
    }

    @Test
    void theSideThatIsNotUsedGivesItsMemoryBack() {
        Devices devices = new Devices(0);
        AtomicInteger homes = new AtomicInteger();
        try (World world = world(devices, new Eager(), homes)) {
            while (world.stats().moves() == 0) {
                world.step(SCENE.timeStep());
            }
            for (int frame = 0; frame < 650; frame++) {
                world.step(SCENE.timeStep());
            }
            assertThat(homes.get()).isZero();
            devices.refused = "makeRoom";
            world.clear();
            assertThat(homes.get()).isOne();
            assertThat(devices.closed.get()).isZero();
            world.add(SCENE.x(0), SCENE.y(0), SCENE.radius(0), 1);
            for (int frame = 0; frame < 3_700; frame++) {
                world.step(SCENE.timeStep());
            }
            assertThat(devices.closed.get()).isOne();
        }
    }

    @Test
    void stepsOfAWorldThatMayMoveLeaveNoGarbage() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        for (FrameRule rule : new FrameRule[] {new FrameRule(), new Eager()}) {
            try (World world = world(new Devices(0), rule)) {
                float[] circles = new float[4 * SCENE.size()];
                long least = Long.MAX_VALUE;
                for (int round = 0; round < 40 && least >= 1024; round++) {
                    long before = threads.getCurrentThreadAllocatedBytes();
                    for (int frame = 0; frame < 10; frame++) {
                        world.step(SCENE.timeStep());
                        world.read(circles);
                    }
                    least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
                }
                assertThat(least).isLessThan(1024);
            }
        }
    }

    /** Leaves the JVM while a device is opened, or compiles. */
    static final class Leaves {
        public static void main(String[] arguments) throws InterruptedException {
            World world = world(
                    circles -> new DevicePipeline(TestDevices.all().get(0), circles, false, false), new Restless());
            world.step(SCENE.timeStep()); // nothing is opened beside the first step
            world.step(SCENE.timeStep());
            Thread.sleep(Long.parseLong(arguments[0]));
            System.out.println("left");
        }
    }

    @Test
    @Tag("long")
    void anExitMeanwhileIsClean() {
        TestDevices.all();
        for (int millis : new int[] {0, 200, 1000, 3000}) {
            ForkedJvm.Result result = new ForkedJvm().run(Leaves.class, Integer.toString(millis));
            assertThat(result.output()).contains("left").doesNotContain("Exception");
            assertThat(result.exitStatus()).isZero();
        }
    }

    @Test
    void worldsThatOpenAndCloseLeaveNoDeviceOpen() throws InterruptedException {
        Devices devices = new Devices(3);
        for (int k = 0; k < 50; k++) {
            World world = world(devices, new Restless());
            for (int step = 0; step < 2 + k % 7; step++) {
                world.step(SCENE.timeStep());
                Thread.sleep(k % 3);
            }
            world.close();
            world.close();
        }
        while (devices.opened.get() < 50 || devices.closed.get() < devices.opened.get()) {
            Thread.sleep(1);
        }
        assertThat(devices.opened.get()).isEqualTo(50);
    }

    @Test
    void twoWorldsMoveAtOnce() throws InterruptedException {
        moveAtOnce(new Devices(5), 10);
    }

    @Test
    @Tag("long")
    void twoWorldsMoveAtOnceToOneDevice() throws InterruptedException {
        for (Device device : TestDevices.all()) {
            moveAtOnce(circles -> new DevicePipeline(device, circles, false, true), 6);
        }
    }

    private static void moveAtOnce(IntFunction<Pipeline> devices, int moves) throws InterruptedException {
        List<Throwable> failures = new ArrayList<>();
        CountDownLatch begins = new CountDownLatch(1);
        List<Thread> threads = new ArrayList<>();
        for (int k = 0; k < 2; k++) {
            Thread thread = new Thread(() -> {
                try (World world = world(devices, new Restless());
                        World stays = stays()) {
                    begins.await();
                    stepUntilMoved(moves, world, stays);
                } catch (Throwable e) {
                    synchronized (failures) {
                        failures.add(e);
                    }
                }
            });
            thread.start();
            threads.add(thread);
        }
        begins.countDown();
        for (Thread thread : threads) {
            thread.join();
        }
        assertThatCode(() -> {
                    for (Throwable failure : failures) {
                        throw failure;
                    }
                })
                .doesNotThrowAnyException();
    }
}
