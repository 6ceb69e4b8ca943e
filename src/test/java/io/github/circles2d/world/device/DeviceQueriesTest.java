package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.world.DeviceSearches;
import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.queries.BruteForce;
import io.github.circles2d.world.queries.CastSearch;
import io.github.circles2d.world.queries.QueryShape;
import io.github.circles2d.world.queries.RemoteSearch;
import io.github.circles2d.world.search.QueryFilter;
import io.github.circles2d.world.shared.Pipeline;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The searches of devices find to the bit what the tree on the host and a look at every circle find. */
class DeviceQueriesTest {
    private static final int STRIDE = CastSearch.HIT_STRIDE;
    private static final float SIDE = 100;
    private static final int QUERIES = 60;
    private static final int KINDS = 40;

    /** Radii of a world: the greatest, and how many times as great it is as the least. */
    record Radii(float greatest, float ratio) {
        float next(SplittableRandom random) {
            return greatest / (float) Math.pow(ratio, random.nextDouble());
        }
    }

    record Setting(Device device, Radii radii, int circles) {}

    static Stream<Setting> settings() {
        return TestDevices.all().stream()
                .flatMap(device -> Stream.of(
                        new Setting(device, new Radii(0.5f, 1), 3000),
                        new Setting(device, new Radii(2, 100), 1500),
                        new Setting(device, new Radii(9, 10), 40),
                        new Setting(device, new Radii(1, 1), 1)));
    }

    private final List<Long> living = new ArrayList<>();
    private SplittableRandom random;
    private Radii radii;

    /** A world on a device and the same one on the host. */
    private Simulation device;

    private Simulation host;

    /** Calls that the device must have answered, and circles that were found. */
    private int calls;

    private int found;

    private void open(Device on, Radii sizes) {
        random = new SplittableRandom(sizes.hashCode());
        radii = sizes;
        WorldParameters parameters = new WorldParameters(new Bounds(0, 0, SIDE, SIDE), 0, -9, 0.5f, 4, 0);
        device = DeviceSearches.always(new Simulation(new DevicePipeline(on, 0, false, true), parameters));
        Pipeline jvm = new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false);
        host = new Simulation(jvm, parameters);
    }

    @AfterEach
    void close() {
        if (device != null) {
            device.close();
            host.close();
        }
    }

    @ParameterizedTest
    @MethodSource("settings")
    @Tag("long")
    void theyFindWhatTheHostAndALookAtEveryCircleFind(Setting setting) {
        open(setting.device, setting.radii);
        for (int k = 0; k < setting.circles; k++) {
            add();
        }
        for (int kind = 0; kind < KINDS; kind++) {
            int category = random.nextInt();
            both(kind, (s, k) -> s.kinds.set(KindField.CATEGORY, k, category));
        }
        compareAll();
        for (int frame = 0; frame < 2; frame++) {
            step();
            compareAll();
            change();
            compareAll();
        }
        assertThat(DeviceSearches.answered(device))
                .as("calls that the device has answered")
                .isEqualTo(calls);
        assertThat(DeviceSearches.answered(host)).isZero();
        assertThat(found).isGreaterThan(setting.circles);
    }

    private interface Change {
        void make(Simulation simulation, int k);
    }

    private void both(int k, Change change) {
        change.make(device, k);
        change.make(host, k);
    }

    // ---- changes

    private void add() {
        float x = coordinate();
        float y = coordinate();
        float radius = radii.next(random);
        float mass = random.nextInt(20) == 0 ? Float.POSITIVE_INFINITY : 1;
        float speed = random.nextInt(10) == 0 ? 3000 : 5;
        float vx = speed * (random.nextFloat() - 0.5f);
        int kind = random.nextInt(KINDS);
        long handle = device.newCircles.add(x, y, radius, mass, vx, speed, kind);
        assertThat(host.newCircles.add(x, y, radius, mass, vx, speed, kind)).isEqualTo(handle);
        living.add(handle);
    }

    private void step() {
        both(0, (s, k) -> s.step(1 / 60f, 2));
    }

    /** Changes of every sort, which wait until the next query or step. */
    private void change() {
        for (int k = 0; k < 6 && living.size() > 1; k++) {
            long removed = living.remove(random.nextInt(living.size()));
            both(0, (s, i) -> s.circles.remove(removed));
        }
        add();
        long moved = any();
        float x = coordinate();
        float y = coordinate();
        both(0, (s, i) -> s.circles.move(moved, x, y));
        long resized = any();
        both(0, (s, i) -> s.circles.set(Commands.RADIUS, resized, radii.greatest * 0.8f, 0));
        long other = any();
        int kind = random.nextInt(KINDS);
        both(kind, (s, i) -> s.fields.set(CircleField.KIND, other, i));
        int category = random.nextInt();
        both(kind, (s, i) -> s.kinds.set(KindField.CATEGORY, i, category));
    }

    private long any() {
        return living.get(random.nextInt(living.size()));
    }

    private float coordinate() {
        return random.nextFloat() * SIDE;
    }

    // ---- comparisons

    private void compareAll() {
        leftOut = random.nextInt(3) == 0 ? any() : 0;
        for (Integer mask : new Integer[] {null, 1 << random.nextInt(32), random.nextInt(3) - 1}) {
            BruteForce truth = truth(mask);
            for (QueryShape shape : QueryShape.values()) {
                float[] queries = queries(shape);
                switch (shape) {
                    case DISC, BOX -> compareFindsOfAll(truth, mask, shape, queries);
                    case RAY, DISC_CAST -> {
                        compareFindsOfAll(truth, mask, shape, queries);
                        compareFindsOfOne(truth, mask, shape, queries);
                    }
                    case POINT -> compareFindsOfOne(truth, mask, shape, queries);
                    case NEAREST -> {
                        compareNearest(truth, mask, queries, random.nextFloat() * 9, 1);
                        compareNearest(truth, mask, queries, Float.POSITIVE_INFINITY, 3);
                        compareNearest(truth, mask, queries, 0, 2);
                        compareNearest(truth, mask, queries, Float.POSITIVE_INFINITY, 40);
                    }
                }
            }
        }
    }

    /** The handles of the circles that a mask admits. */
    private long[] admitted;

    /** A circle that all queries leave out, or 0. */
    private long leftOut;

    private BruteForce truth(Integer mask) {
        long[] handles = new long[host.circles.size()];
        float[] circles = new float[4 * handles.length];
        host.readings.readHandles(handles);
        host.readings.read(circles);
        int n = 0;
        for (int k = 0; k < handles.length; k++) {
            int kind = (int) host.fields.get(CircleField.KIND, handles[k]);
            boolean counts = mask == null || (host.kinds.get(KindField.CATEGORY, kind) & mask) != 0;
            if (counts && handles[k] != leftOut) {
                System.arraycopy(circles, 4 * k, circles, 4 * n, 4);
                handles[n++] = handles[k];
            }
        }
        admitted = handles;
        return new BruteForce(circles, n);
    }

    private QueryFilter filter(Simulation simulation, Integer mask) {
        QueryFilter masked = mask == null ? null : simulation.searches.filter(null, mask);
        return leftOut == 0 ? masked : simulation.searches.without(masked, leftOut);
    }

    private float[] queries(QueryShape shape) {
        float[] queries = new float[shape.stride() * QUERIES];
        for (int q = 0; q < QUERIES; q++) {
            int at = shape.stride() * q;
            boolean outside = random.nextInt(8) == 0;
            queries[at] = outside ? 5 * coordinate() - 200 : coordinate();
            queries[at + 1] = coordinate();
            float first = random.nextInt(6) == 0 ? 0 : random.nextFloat() * 15;
            float second = random.nextInt(6) == 0 ? 0 : random.nextFloat() * 15;
            switch (shape) {
                case DISC -> queries[at + 2] = first;
                case BOX -> {
                    queries[at + 2] = queries[at] + first;
                    queries[at + 3] = queries[at + 1] + second;
                }
                case RAY, DISC_CAST -> {
                    float far = random.nextInt(4) == 0 ? 20 : 2;
                    queries[at + shape.stride() - 2] = far * (random.nextBoolean() ? first : -first);
                    queries[at + shape.stride() - 1] = far * (random.nextBoolean() ? second : -second);
                    if (shape == QueryShape.DISC_CAST) {
                        queries[at + 2] = random.nextFloat() * 2;
                    }
                }
                default -> {}
            }
        }
        return queries;
    }

    private void compareFindsOfAll(BruteForce truth, Integer mask, QueryShape shape, float[] queries) {
        int[] ends = new int[QUERIES];
        int[] endsOnHost = new int[QUERIES];
        int total = host.searches.all(filter(host, mask), shape, queries, QUERIES, endsOnHost, new long[0], null);
        int room = random.nextBoolean() ? total : random.nextInt(total + 1);
        long[] handles = new long[room];
        float[] hits = shape.isCast() ? new float[STRIDE * room] : null;
        assertThat(device.searches.all(filter(device, mask), shape, queries, QUERIES, ends, handles, hits))
                .isEqualTo(total);
        calls++;
        found += room;
        assertThat(ends).isEqualTo(endsOnHost);
        long[] handlesOnHost = new long[room];
        float[] hitsOnHost = shape.isCast() ? new float[STRIDE * room] : null;
        host.searches.all(filter(host, mask), shape, queries, QUERIES, ends, handlesOnHost, hitsOnHost);
        assertThat(handles).isEqualTo(handlesOnHost);
        assertThat(hits).isEqualTo(hitsOnHost);
        for (int q = 0; q < QUERIES; q++) {
            int from = Math.min(room, q == 0 ? 0 : ends[q - 1]);
            long[] expected = handles(truthOfAll(truth, shape, queries, shape.stride() * q));
            int listed = Math.min(room, ends[q]) - from;
            assertThat(ends[q] - (q == 0 ? 0 : ends[q - 1])).isEqualTo(expected.length);
            assertThat(Arrays.copyOfRange(handles, from, from + listed)).isEqualTo(Arrays.copyOf(expected, listed));
        }
    }

    private static int[] truthOfAll(BruteForce truth, QueryShape shape, float[] q, int at) {
        return switch (shape) {
            case DISC -> truth.disc(q[at], q[at + 1], q[at + 2]);
            case BOX -> truth.box(q[at], q[at + 1], q[at + 2], q[at + 3]);
            default ->
                truthOfPath(truth, shape, q, at).stream()
                        .mapToInt(BruteForce.Hit::circle)
                        .toArray();
        };
    }

    private static List<BruteForce.Hit> truthOfPath(BruteForce truth, QueryShape shape, float[] q, int at) {
        return truth.cast(q[at], q[at + 1], shape.radius(q, at), shape.dx(q, at), shape.dy(q, at));
    }

    private long[] handles(int[] circles) {
        return Arrays.stream(circles).mapToLong(i -> admitted[i]).toArray();
    }

    private void compareFindsOfOne(BruteForce truth, Integer mask, QueryShape shape, float[] queries) {
        long[] handles = new long[QUERIES];
        float[] hits = shape.isCast() ? new float[STRIDE * QUERIES] : null;
        int count = device.searches.one(filter(device, mask), shape, queries, QUERIES, handles, hits);
        calls++;
        found += count;
        long[] handlesOnHost = new long[QUERIES];
        float[] hitsOnHost = shape.isCast() ? new float[STRIDE * QUERIES] : null;
        assertThat(host.searches.one(filter(host, mask), shape, queries, QUERIES, handlesOnHost, hitsOnHost))
                .isEqualTo(count);
        assertThat(handles).isEqualTo(handlesOnHost);
        assertThat(hits).isEqualTo(hitsOnHost);
        for (int q = 0; q < QUERIES; q++) {
            int at = shape.stride() * q;
            if (shape == QueryShape.POINT) {
                int pick = truth.pick(queries[at], queries[at + 1]);
                assertThat(handles[q]).isEqualTo(pick < 0 ? 0 : admitted[pick]);
            } else {
                List<BruteForce.Hit> path = truthOfPath(truth, shape, queries, at);
                assertThat(handles[q])
                        .isEqualTo(path.isEmpty() ? 0 : admitted[path.get(0).circle()]);
                if (!path.isEmpty()) {
                    assertThat(Arrays.copyOfRange(hits, STRIDE * q, STRIDE * (q + 1)))
                            .isEqualTo(path.get(0).row());
                }
            }
        }
    }

    private void compareNearest(BruteForce truth, Integer mask, float[] points, float within, int most) {
        long[] handles = new long[most * QUERIES];
        float[] distances = new float[handles.length];
        int count = device.searches.nearest(filter(device, mask), points, QUERIES, within, most, handles, distances);
        calls++;
        found += count;
        long[] handlesOnHost = new long[handles.length];
        float[] distancesOnHost = new float[handles.length];
        assertThat(host.searches.nearest(
                        filter(host, mask), points, QUERIES, within, most, handlesOnHost, distancesOnHost))
                .isEqualTo(count);
        assertThat(handles).isEqualTo(handlesOnHost);
        assertThat(distances).isEqualTo(distancesOnHost);
        for (int q = 0; q < QUERIES; q++) {
            List<BruteForce.Hit> nearest = truth.nearest(points[2 * q], points[2 * q + 1], within, most);
            for (int k = 0; k < most; k++) {
                long expected = k < nearest.size() ? admitted[nearest.get(k).circle()] : 0;
                assertThat(handles[most * q + k]).isEqualTo(expected);
            }
        }
    }

    // ---- special worlds

    @OnEachDevice
    void singleQueriesAndRefusalsAreAsOnTheHost(Device on) {
        open(on, new Radii(1, 3));
        for (int k = 0; k < 300; k++) {
            add();
        }
        long[] handles = new long[300];
        float[] hit = new float[STRIDE];
        int total = device.searches.all(null, QueryShape.BOX, 0, 0, SIDE, SIDE, 0, handles, null);
        assertThat(total).isEqualTo(300);
        long first = device.searches.one(null, QueryShape.RAY, 0, 50, SIDE, 0, 0, hit);
        float[] hitOnHost = new float[STRIDE];
        assertThat(first)
                .isEqualTo(host.searches.one(null, QueryShape.RAY, 0, 50, SIDE, 0, 0, hitOnHost))
                .isPositive();
        assertThat(hit).isEqualTo(hitOnHost);
        assertThat(DeviceSearches.answered(device)).isEqualTo(2);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> device.searches.one(
                        null, QueryShape.RAY, new float[] {1, 1, 1, 1, 1, Float.NaN, 1, 1}, 2, handles, null))
                .withMessageStartingWith("query 1: y is NaN");
        for (long handle : living) {
            both(0, (s, k) -> s.circles.remove(handle));
        }
        assertThat(device.searches.one(null, QueryShape.POINT, 5, 5, 0, 0, 0, null))
                .isZero();
        assertThat(device.searches.nearest(null, 5, 5, Float.POSITIVE_INFINITY, 3, handles, null))
                .isZero();
    }

    /** The cells of the tree are those of all circles: one far away leaves the others a single one. */
    @OnEachDevice
    void theHostAnswersWhereCirclesCrowdInACellOrFindTooMuch(Device on) {
        random = new SplittableRandom(5);
        WorldParameters parameters = new WorldParameters(new Bounds(0, 0, 1e6f, 1e6f), 0, 0, 0.5f, 4, 0);
        try (Simulation crowded =
                DeviceSearches.always(new Simulation(new DevicePipeline(on, 0, false, true), parameters))) {
            for (int k = 0; k < 5000; k++) {
                crowded.newCircles.add(10 + coordinate(), 10 + coordinate(), 1, 1, 0, 0, 0);
            }
            long[] handles = new long[5000];
            int[] ends = new int[1000];
            float[] discs = new float[3000];
            for (int q = 0; q < 1000; q++) {
                discs[3 * q + 2] = 1000;
            }
            assertThat(crowded.searches.all(null, QueryShape.DISC, discs, 3, ends, handles, null))
                    .isEqualTo(15_000);
            assertThat(DeviceSearches.answered(crowded)).isOne();
            assertThat(crowded.searches.all(null, QueryShape.DISC, discs, 1000, ends, new long[5_000_000], null))
                    .isEqualTo(5_000_000);
            assertThat(DeviceSearches.answered(crowded))
                    .as("more than it lists")
                    .isOne();
            crowded.newCircles.add(9e5f, 9e5f, 1, 1, 0, 0, 0);
            assertThat(crowded.searches.all(null, QueryShape.DISC, discs, 3, ends, handles, null))
                    .isEqualTo(15_000);
            assertThat(DeviceSearches.answered(crowded)).as("in a crowd").isOne();
        }
    }

    /** On a device that says of itself that it is worth while, as a GPU does. */
    @Test
    void aDeviceAnswersLargeBatchesInLargeWorldsAndTheFirstFewOtherCalls() {
        int circles = 20_000;
        WorldParameters parameters = new WorldParameters(new Bounds(0, 0, SIDE, SIDE), 0, 0, 0.5f, 4, 0);
        Pipeline pipeline = new DevicePipeline(TestDevices.all().get(0), circles, false, true);
        RemoteSearch search = overriding(RemoteSearch.class, "pays", () -> true, pipeline::search);
        Pipeline gpu = overriding(Pipeline.class, "search", () -> search, () -> pipeline);
        try (Simulation world = new Simulation(gpu, parameters)) {
            float[] points = new float[2 * 512];
            long[] handles = new long[512];
            for (int k = 1; k < 1000; k++) {
                world.newCircles.add(0.5f + k % 99, 0.5f + k / 99 * 0.4f, 0.1f, 1, 0, 0, 0);
            }
            world.searches.one(null, QueryShape.POINT, points, 512, handles, null);
            assertThat(DeviceSearches.answered(world)).as("a small world").isZero();
            for (int k = 1000; k < circles; k++) {
                world.newCircles.add(0.5f + k % 99, 0.5f + k / 99 * 0.4f, 0.1f, 1, 0, 0, 0);
            }
            world.searches.one(null, QueryShape.POINT, points, 512, handles, null);
            assertThat(DeviceSearches.answered(world)).as("a large batch").isOne();
            world.searches.one(null, QueryShape.POINT, points, 511, handles, null);
            assertThat(DeviceSearches.answered(world))
                    .as("a smaller one, and not enough circles for that")
                    .isOne();
            world.newCircles.add(0.5f, 0.5f, 0.1f, 1, 0, 0, 0);
            for (int k = 0; k < 30; k++) {
                assertThat(world.searches.one(null, QueryShape.POINT, 1.5f, 0.5f, 0, 0, 0, null))
                        .isPositive();
            }
            assertThat(DeviceSearches.answered(world))
                    .as("a call for 1,000 circles")
                    .isEqualTo(21);
            world.searches.one(null, QueryShape.POINT, points, 511, handles, null);
            assertThat(DeviceSearches.answered(world)).isEqualTo(21);
            world.searches.one(null, QueryShape.POINT, points, 512, handles, null);
            assertThat(DeviceSearches.answered(world)).isEqualTo(22);
            world.newCircles.add(0.5f, 0.5f, 0.1f, 1, 0, 0, 0);
            world.searches.one(null, QueryShape.POINT, 1.5f, 0.5f, 0, 0, 0, null);
            assertThat(DeviceSearches.answered(world)).as("after a change").isEqualTo(23);
        }
    }

    /** An object whose methods are those of another, but one. */
    private static <T> T overriding(Class<T> type, String method, Supplier<?> answer, Supplier<T> other) {
        return type.cast(
                Proxy.newProxyInstance(type.getClassLoader(), new Class<?>[] {type}, (proxy, called, arguments) -> {
                    try {
                        return called.getName().equals(method) ? answer.get() : called.invoke(other.get(), arguments);
                    } catch (InvocationTargetException e) {
                        throw e.getCause();
                    }
                }));
    }

    /** What a world holds for queries comes with the first of them, and the steps go on as without. */
    @Test
    void queriesOnADeviceChangeNoStep() {
        open(TestDevices.all().get(0), new Radii(1, 4));
        for (int k = 0; k < 400; k++) {
            add();
        }
        for (int frame = 0; frame < 5; frame++) {
            float[] queries = queries(QueryShape.DISC_CAST);
            device.searches.one(null, QueryShape.DISC_CAST, queries, QUERIES, new long[QUERIES], null);
            step();
            assertThat(device.figures().contacts()).isEqualTo(host.figures().contacts());
            assertThat(device.hash()).isEqualTo(host.hash());
        }
        assertThat(DeviceSearches.answered(device)).isEqualTo(5);
    }
}
