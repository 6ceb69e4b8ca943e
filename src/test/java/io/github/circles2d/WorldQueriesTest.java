package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalState;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.Arrays;
import java.util.ConcurrentModificationException;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What queries promise. That they find the right circles wherever those lie is tested in their own room, too. */
@Tag("each-jdk")
class WorldQueriesTest {
    private static final float STATIC = Float.POSITIVE_INFINITY;

    private final long[] handles = new long[8];
    private final float[] hit = new float[Queries.HIT_STRIDE];

    static Stream<World.Builder> backEnds() {
        return Stream.concat(
                Stream.of(WorldScenes.jvm()),
                TestDevices.all().stream().map(device -> World.builder().device(device)));
    }

    private static World tenByTen() {
        return WorldScenes.jvm().bounds(0, 0, 10, 10).build();
    }

    // ---- what is found

    @ParameterizedTest
    @MethodSource("backEnds")
    void everyBackEndFindsWhatALookAtEveryCircleFindsAndChangesThatWaitCount(World.Builder builder) {
        Scene scene = Scenes.mixed(700, Scenes.SEED);
        builder.bounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY())
                .gravity(scene.gravityX(), scene.gravityY());
        Random random = new Random(4);
        int compared = 0;
        try (World world = WorldScenes.world(scene, builder)) {
            long[] living = new long[scene.size()];
            world.readHandles(living);
            for (int frame = 0; frame < 12; frame++) {
                compared += compare(world, scene, random);
                world.step(scene.timeStep());
                compared += compare(world, scene, random);
                world.setPosition(living[frame], x(scene, random), y(scene, random));
                world.setRadius(living[frame + 20], 2 * world.radius(living[frame + 20]));
                compared += compare(world, scene, random);
                world.remove(living[frame + 40]);
                compared += compare(world, scene, random);
                world.add(x(scene, random), y(scene, random), scene.radius(0), STATIC);
                compared += compare(world, scene, random);
            }
        }
        assertThat(compared).isGreaterThan(5000);
    }

    private static float x(Scene scene, Random random) {
        return scene.minX() + (scene.maxX() - scene.minX()) * random.nextFloat();
    }

    private static float y(Scene scene, Random random) {
        return scene.minY() + (scene.maxY() - scene.minY()) * random.nextFloat();
    }

    private static int compare(World world, Scene scene, Random random) {
        QueryComparison comparison = new QueryComparison(world);
        int compared = 0;
        for (int q = 0; q < 10; q++) {
            float radius = (scene.maxX() - scene.minX()) * 0.1f * random.nextFloat();
            compared +=
                    comparison.compare(x(scene, random), y(scene, random), radius, x(scene, random), y(scene, random));
        }
        return compared;
    }

    @Test
    void queriesChangeNothing() {
        Scene scene = Scenes.packed(300, Scenes.SEED);
        try (World asked = WorldScenes.world(scene, WorldScenes.builder(scene));
                World left = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            for (int frame = 0; frame < 20; frame++) {
                asked.queries().pick(0.5f, 0.5f);
                asked.queries().rayCast(0, 0, 1, 1, hit);
                asked.step(scene.timeStep());
                left.step(scene.timeStep());
            }
            assertThat(asked.hash()).isEqualTo(left.hash());
        }
    }

    @Test
    void whatTouchesExactlyCounts() {
        try (World world = tenByTen()) {
            long ball = world.add(3, 4, 1, 1);
            Queries queries = world.queries();
            assertThat(queries.overlapCircle(0, 0, 4, handles)).isEqualTo(1);
            assertThat(handles[0]).isEqualTo(ball);
            assertThat(queries.overlapCircle(0, 0, Math.nextDown(4f), handles)).isZero();
            assertThat(queries.overlapBox(4, 0, 9, 9, handles)).isEqualTo(1);
            assertThat(queries.overlapBox(Math.nextUp(4f), 0, 9, 9, handles)).isZero();
            assertThat(queries.pick(3, 5)).isEqualTo(ball);
            assertThat(queries.pick(3, Math.nextUp(5f))).isZero();
            assertThat(queries.rayCast(0, 5, 10, 0, hit)).isEqualTo(ball);
            assertThat(hit).containsExactly(3, 3, 5, 0, 1);
            assertThat(queries.rayCast(0, 4, 2, 0, hit)).isEqualTo(ball);
            assertThat(queries.rayCast(0, 4, Math.nextDown(2f), 0, hit)).isZero();
            assertThat(queries.nearest(3, 0, 3, 1, handles, hit)).isEqualTo(1);
            assertThat(hit[0]).isEqualTo(3);
        }
    }

    @Test
    void aHitSaysHowFarWhereAndInWhichDirectionTheEdgeFaces() {
        try (World world = tenByTen()) {
            long fixed = world.add(5, 5, 1, STATIC);
            Queries queries = world.queries();
            assertThat(queries.rayCast(1, 5, 8, 0, hit)).isEqualTo(fixed);
            assertThat(hit).containsExactly(3, 4, 5, -1, 0);
            assertThat(queries.circleCast(5, 9, 0.5f, 0, -8, hit)).isEqualTo(fixed);
            assertThat(hit).containsExactly(2.5f, 5, 6.5f, 0, 1);
            assertThat(queries.rayCast(1, 5, -8, 0, hit)).as("away from it").isZero();
            assertThat(hit).containsExactly(8, -7, 5, 0, 0);
        }
    }

    @Test
    void aCastThatBeginsInACircleHitsItAtOnceAndHasANormal() {
        try (World world = tenByTen()) {
            long ball = world.add(5, 5, 1, 1);
            Queries queries = world.queries();
            assertThat(queries.rayCast(5.5f, 5, 4, 0, hit)).isEqualTo(ball);
            assertThat(hit).containsExactly(0, 5.5f, 5, 1, 0);
            assertThat(queries.rayCast(5, 5, 0, 2, hit)).isEqualTo(ball);
            assertThat(hit).containsExactly(0, 5, 5, 0, -1);
            assertThat(queries.circleCast(5, 5, 3, 0, 0, hit)).isEqualTo(ball);
            assertThat(hit).containsExactly(0, 5, 5, 0, 1);
            assertThat(queries.rayCast(1, 1, 0, 0, hit)).isZero();
            assertThat(hit).containsExactly(0, 1, 1, 0, 0);
        }
    }

    @Test
    void ofEqualsTheLowestIdComesFirst() {
        try (World world = tenByTen()) {
            long[] all = new long[6];
            for (int k = 0; k < all.length; k++) {
                all[k] = world.add(k % 2 == 0 ? 2 : 8, 5, 1, 1);
            }
            Queries queries = world.queries();
            assertThat(queries.pick(2, 5)).isEqualTo(all[0]);
            assertThat(queries.nearest(5, 5, 9, 4, handles, null)).isEqualTo(4);
            assertThat(Arrays.copyOf(handles, 4)).isEqualTo(Arrays.copyOf(all, 4));
            assertThat(queries.rayCastAll(0, 5, 10, 0, handles, null)).isEqualTo(6);
            assertThat(Arrays.copyOf(handles, 6)).containsExactly(all[0], all[2], all[4], all[1], all[3], all[5]);
        }
    }

    @Test
    void ofSeveralCirclesAtAPointThatOfTheNearestCentreIsPicked() {
        try (World world = tenByTen()) {
            world.add(5, 5, 4, STATIC);
            long small = world.add(7, 5, 0.5f, STATIC);
            assertThat(world.queries().pick(6.75f, 5)).isEqualTo(small);
            float[] distances = new float[2];
            assertThat(world.queries().nearest(6.75f, 5, 1, 2, handles, distances))
                    .isEqualTo(2);
            assertThat(distances).containsExactly(-2.25f, -0.25f);
        }
    }

    @Test
    void anEmptyWorldHasNothingToFind() {
        try (World world = tenByTen()) {
            Queries queries = world.queries();
            assertThat(queries.overlapCircle(5, 5, 100, handles)).isZero();
            assertThat(queries.overlapBox(0, 0, 10, 10, handles)).isZero();
            assertThat(queries.pick(5, 5)).isZero();
            assertThat(queries.nearest(5, 5, Float.POSITIVE_INFINITY, 3, handles, null))
                    .isZero();
            assertThat(queries.rayCast(0, 0, 10, 10, hit)).isZero();
            assertThat(queries.circleCastAll(0, 0, 1, 10, 10, handles, null)).isZero();
            long ball = world.add(5, 5, 1, 1);
            assertThat(queries.pick(5, 5)).isEqualTo(ball);
            world.remove(ball);
            assertThat(queries.pick(5, 5)).isZero();
        }
    }

    // ---- masks

    @ParameterizedTest
    @MethodSource("backEnds")
    void aMaskFindsTheCirclesOfItsCategoriesAsTheyAreNow(World.Builder builder) {
        Scene scene = Scenes.mixed(500, Scenes.SEED);
        builder.bounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY())
                .gravity(scene.gravityX(), scene.gravityY());
        Random random = new Random(6);
        try (World world = WorldScenes.world(scene, builder)) {
            long[] living = new long[scene.size()];
            world.readHandles(living);
            int compared = 0;
            for (int frame = 0; frame < 6; frame++) {
                for (int k = 0; k < 40; k++) {
                    world.setKind(living[random.nextInt(living.length)], random.nextInt(8));
                }
                world.kind(random.nextInt(8))
                        .setCategory(random.nextInt(16))
                        .setSensor(random.nextBoolean())
                        .setMask(random.nextInt());
                for (int mask : new int[] {0, 1, 2, 5, 8, -1}) {
                    QueryComparison comparison = new QueryComparison(world, mask);
                    float radius = (scene.maxX() - scene.minX()) * 0.1f;
                    compared += comparison.compare(
                            x(scene, random), y(scene, random), radius, x(scene, random), y(scene, random));
                }
                if (frame % 2 == 0) {
                    world.step(scene.timeStep());
                }
            }
            assertThat(compared).isGreaterThan(500);
        }
    }

    @Test
    void aMaskAloneDecidesAndSensorsAreFoundLikeOthers() {
        try (World world = tenByTen()) {
            long ball = world.add(2, 5, 1, 1);
            long sensor = world.add(8, 5, 1, 1, 0, 0, 3);
            world.kind(3).setSensor(true).setCategory(4).setMask(0);
            Queries all = world.queries();
            Queries sensors = all.withMask(4);
            assertThat(all.pick(8, 5)).isEqualTo(sensor);
            assertThat(sensors.pick(8, 5)).isEqualTo(sensor);
            assertThat(sensors.pick(2, 5)).isZero();
            assertThat(all.withMask(~4).pick(8, 5)).isZero();
            assertThat(sensors.withMask(1).pick(2, 5)).as("another mask").isEqualTo(ball);
            world.kind(0).setCategory(0);
            assertThat(all.withMask(-1).pick(2, 5)).as("in no category").isZero();
            assertThat(all.pick(2, 5)).isEqualTo(ball);
            world.setKind(ball, 3);
            assertThat(sensors.pick(2, 5)).isEqualTo(ball);
        }
    }

    @Test
    void oneCircleIsLeftOutOfAllQueriesUntilItIsRemoved() {
        try (World world = tenByTen()) {
            long hero = world.add(5, 5, 1, 1);
            long near = world.add(7.5f, 5, 1, 1);
            Queries others = world.queries().without(hero);
            assertThat(world.queries().rayCast(5, 5, 5, 0, hit)).isEqualTo(hero);
            assertThat(others.rayCast(5, 5, 5, 0, hit)).isEqualTo(near);
            assertThat(hit[Queries.DISTANCE]).isEqualTo(1.5f);
            assertThat(others.circleCast(5, 5, 1, 5, 0, hit)).isEqualTo(near);
            assertThat(hit[Queries.DISTANCE]).isEqualTo(0.5f);
            assertThat(others.pick(5, 5)).isZero();
            assertThat(others.overlapCircle(5, 5, 9, handles)).isEqualTo(1);
            assertThat(others.nearest(5, 5, 9, 1, handles, null)).isEqualTo(1);
            assertThat(handles[0]).isEqualTo(near);
            assertThat(others.without(near).pick(5, 5))
                    .as("in place of the first")
                    .isEqualTo(hero);
            assertThat(others.without(0).pick(5, 5)).isEqualTo(hero);
            assertThat(others.withMask(1).pick(5, 5)).as("the mask is added").isZero();
            assertThat(others.withMask(1).pick(7.5f, 5)).isEqualTo(near);
            assertThat(others.withMask(2).without(hero).pick(7.5f, 5))
                    .as("the mask stays")
                    .isZero();
            assertThat(others.terrain()).isSameAs(world.queries().terrain());
            world.remove(hero);
            long next = world.add(5, 5, 1, 1);
            assertThat(World.id(next)).isEqualTo(World.id(hero));
            assertThat(others.pick(5, 5)).as("another circle with its id").isEqualTo(next);
            long piece = world.terrain().addSegment(1, 1, 2, 2);
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> others.without(piece))
                    .withMessage("no circle has the handle " + piece + ": it is of a piece of terrain");
        }
    }

    @Test
    void anExplosionWithAMaskPushesTheCirclesOfItsCategories() {
        try (World world = tenByTen()) {
            long left = world.add(4, 5, 0.5f, 1);
            long right = world.add(6, 5, 0.5f, 1, 0, 0, 9);
            world.kind(9).setCategory(2);
            assertThat(world.explode(5, 5, 3, 1, 0, 2)).isOne();
            assertThat(world.vx(left)).isZero();
            assertThat(world.vx(right)).isEqualTo(1);
            assertThat(world.explode(5, 5, 3, 1, 0, 1)).isOne();
            assertThat(world.vx(left)).isEqualTo(-1);
            assertThat(world.explode(5, 5, 3, 1, 0, 4)).isZero();
            assertThat(world.explode(5, 5, 3, 1, 0, 3)).isEqualTo(2);
        }
    }

    // ---- batches

    @Test
    void aBatchAnswersAsSingleQueriesDo() {
        Scene scene = Scenes.packed(400, Scenes.SEED);
        Random random = new Random(2);
        int n = 50;
        float[] numbers = new float[5 * n + 3];
        for (int k = 0; k < numbers.length; k++) {
            numbers[k] = random.nextFloat() * 0.5f;
        }
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            Queries queries = world.queries();
            int[] ends = new int[n];
            long[] found = new long[400 * n];
            long[] single = new long[400];
            float[] hits = new float[Queries.HIT_STRIDE * found.length];
            float[] singleHits = new float[Queries.HIT_STRIDE * single.length];
            List<Integer> counts = List.of(
                    queries.overlapCircle(numbers, n, ends, found),
                    check(
                            n,
                            ends,
                            found,
                            single,
                            q -> queries.overlapCircle(numbers[3 * q], numbers[3 * q + 1], numbers[3 * q + 2], single)),
                    queries.rayCastAll(numbers, n, ends, found, hits),
                    check(
                            n,
                            ends,
                            found,
                            single,
                            q -> queries.rayCastAll(
                                    numbers[4 * q],
                                    numbers[4 * q + 1],
                                    numbers[4 * q + 2],
                                    numbers[4 * q + 3],
                                    single,
                                    null)),
                    queries.circleCastAll(numbers, n, ends, found, hits),
                    check(n, ends, found, single, q -> {
                        int count = queries.circleCastAll(
                                numbers[5 * q],
                                numbers[5 * q + 1],
                                numbers[5 * q + 2],
                                numbers[5 * q + 3],
                                numbers[5 * q + 4],
                                single,
                                singleHits);
                        int from = Queries.HIT_STRIDE * (q == 0 ? 0 : ends[q - 1]);
                        assertThat(Arrays.copyOfRange(hits, from, from + Queries.HIT_STRIDE * count))
                                .isEqualTo(Arrays.copyOf(singleHits, Queries.HIT_STRIDE * count));
                        return count;
                    }));
            assertThat(counts.get(0)).isEqualTo(counts.get(1)).isGreaterThan(n);
            assertThat(counts.get(2)).isEqualTo(counts.get(3)).isGreaterThan(n);
            assertThat(counts.get(4)).isEqualTo(counts.get(5)).isGreaterThan(n);
            for (int k = 0; k < n; k++) { // boxes whose right and upper sides are not less than the others
                numbers[4 * k + 2] += 0.5f;
                numbers[4 * k + 3] += 0.5f;
            }
            int boxed = queries.overlapBox(numbers, n, ends, found);
            assertThat(boxed)
                    .isEqualTo(check(
                            n,
                            ends,
                            found,
                            single,
                            q -> queries.overlapBox(
                                    numbers[4 * q],
                                    numbers[4 * q + 1],
                                    numbers[4 * q + 2],
                                    numbers[4 * q + 3],
                                    single)));
        }
    }

    private interface Single {
        int find(int query);
    }

    /** Compares the results of a batch with those of single queries, and returns how many these find. */
    private static int check(int n, int[] ends, long[] found, long[] single, Single query) {
        int from = 0;
        for (int q = 0; q < n; q++) {
            int count = query.find(q);
            assertThat(ends[q]).isEqualTo(from + count);
            assertThat(Arrays.copyOfRange(found, from, ends[q])).isEqualTo(Arrays.copyOf(single, count));
            from = ends[q];
        }
        return from;
    }

    @Test
    void aBatchThatFindsOneOrAFewForEachQueryHasAPlaceForEach() {
        try (World world = tenByTen()) {
            long left = world.add(2, 5, 1, 1);
            long right = world.add(8, 5, 1, 1);
            Queries queries = world.queries();
            long[] found = new long[6];
            assertThat(queries.pick(new float[] {8, 5, 5, 5, 2, 5}, 3, found)).isEqualTo(2);
            assertThat(Arrays.copyOf(found, 3)).containsExactly(right, 0, left);
            float[] distances = new float[6];
            assertThat(queries.nearest(new float[] {1, 5, 9, 5}, 2, 3, 3, found, distances))
                    .isEqualTo(2);
            assertThat(found).containsExactly(left, 0, 0, right, 0, 0);
            float none = Float.POSITIVE_INFINITY;
            assertThat(distances).containsExactly(0, none, none, 0, none, none);
            float[] hits = new float[2 * Queries.HIT_STRIDE];
            assertThat(queries.rayCast(new float[] {0, 0, 0, 9, 0, 5, 9, 0}, 2, found, hits))
                    .isEqualTo(1);
            assertThat(Arrays.copyOf(found, 2)).containsExactly(0, left);
            assertThat(hits).containsExactly(9, 0, 9, 0, 0, 1, 1, 5, -1, 0);
            assertThat(queries.circleCast(new float[] {10, 5, 0.5f, -9, 0}, 1, found, hits))
                    .isEqualTo(1);
            assertThat(found[0]).isEqualTo(right);
            assertThat(hits).startsWith(0.5f, 9.5f, 5, 1, 0);
        }
    }

    @Test
    void arraysThatAreTooShortHoldTheFirstResultsAndAllAreCounted() {
        try (World world = tenByTen()) {
            long[] all = new long[5];
            for (int k = 0; k < 5; k++) {
                all[k] = world.add(1 + 2 * k, 5, 1, 1);
            }
            Queries queries = world.queries();
            long[] two = new long[2];
            assertThat(queries.overlapBox(0, 0, 10, 10, two)).isEqualTo(5);
            assertThat(two).containsExactly(all[0], all[1]);
            assertThat(queries.overlapBox(0, 0, 10, 10, new long[0])).isEqualTo(5);
            long[] four = new long[4];
            assertThat(queries.rayCastAll(10, 5, -10, 0, four, new float[3 * Queries.HIT_STRIDE]))
                    .isEqualTo(5);
            assertThat(four).containsExactly(all[4], all[3], all[2], 0);
            int[] ends = new int[3];
            long[] three = new long[3];
            float[] discs = {1, 5, 0.5f, 5, 5, 1, 9, 5, 0.5f};
            assertThat(queries.overlapCircle(discs, 3, ends, three)).isEqualTo(5);
            assertThat(ends).containsExactly(1, 4, 5);
            assertThat(three).containsExactly(all[0], all[1], all[2]);
            assertThat(queries.overlapCircle(discs, 0, ends, three)).isZero();
        }
    }

    // ---- misuse

    @ParameterizedTest
    @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY})
    void whatIsNotFiniteIsRefused(float bad) {
        try (World world = tenByTen()) {
            Queries queries = world.queries();
            refused("x is " + bad, () -> queries.overlapCircle(bad, 0, 1, handles));
            refused("y is " + bad, () -> queries.overlapCircle(0, bad, 1, handles));
            refused("radius is " + bad, () -> queries.overlapCircle(0, 0, bad, handles));
            refused("minX is " + bad, () -> queries.overlapBox(bad, 0, 1, 1, handles));
            refused("minY is " + bad, () -> queries.overlapBox(0, bad, 1, 1, handles));
            refused("maxX is " + bad, () -> queries.overlapBox(0, 0, bad, 1, handles));
            refused("maxY is " + bad, () -> queries.overlapBox(0, 0, 1, bad, handles));
            refused("x is " + bad, () -> queries.pick(bad, 0));
            refused("y is " + bad, () -> queries.nearest(0, bad, 1, 1, handles, null));
            refused("dx is " + bad, () -> queries.rayCast(0, 0, bad, 0, hit));
            refused("dy is " + bad, () -> queries.rayCastAll(0, 0, 0, bad, handles, null));
            refused("radius is " + bad, () -> queries.circleCast(0, 0, bad, 0, 0, hit));
            refused("query 1: y is " + bad, () -> queries.pick(new float[] {1, 1, 1, bad}, 2, handles));
            refused(
                    "query 1: radius is " + bad,
                    () -> queries.overlapCircle(new float[] {1, 1, 1, 1, 1, bad}, 2, new int[2], handles));
            refused("query 0: dy is " + bad, () -> queries.rayCast(new float[] {1, 1, 1, bad}, 1, handles, null));
            refused("x is " + bad, () -> queries.pick(bad, 0)); // no longer in a batch
        }
    }

    private static void refused(String message, Runnable call) {
        assertThatIllegalArgumentException().isThrownBy(call::run).withMessageStartingWith(message);
    }

    @Test
    void whatIsOutOfRangeIsRefused() {
        try (World world = tenByTen()) {
            Queries queries = world.queries();
            refused("radius is -1.0", () -> queries.overlapCircle(0, 0, -1, handles));
            refused("radius is -1.0", () -> queries.circleCastAll(0, 0, -1, 1, 1, handles, null));
            refused("maxX is 0.0, but must be from 1.0", () -> queries.overlapBox(1, 0, 0, 1, handles));
            refused("maxY is -3.0, but must be from 2.0", () -> queries.overlapBox(1, 2, 3, -3, handles));
            refused("within is -1.0", () -> queries.nearest(0, 0, -1, 1, handles, null));
            refused("within is NaN", () -> queries.nearest(0, 0, Float.NaN, 1, handles, null));
            refused("most is 0", () -> queries.nearest(0, 0, 1, 0, handles, null));
            refused("handles has room for 8 elements, but needs 9", () -> queries.nearest(0, 0, 1, 9, handles, null));
            refused("distances has room for 5", () -> queries.nearest(0, 0, 1, 6, handles, hit));
            refused("hit has room for 4 elements", () -> queries.rayCast(0, 0, 1, 1, new float[4]));
            refused("hits has room for 5 elements", () -> queries.rayCast(new float[8], 2, handles, hit));
            refused("handles has room for 8", () -> queries.rayCast(new float[40], 9, handles, null));
            refused(
                    "n is 3, but must be from 0 to 2, as discs has",
                    () -> queries.overlapCircle(new float[8], 3, new int[3], handles));
            refused(
                    "n is -1, but must be from 0 to 2, as boxes",
                    () -> queries.overlapBox(new float[8], -1, new int[3], handles));
            refused(
                    "n is 3, but must be from 0 to 2, as rays",
                    () -> queries.rayCastAll(new float[8], 3, new int[3], handles, null));
            refused(
                    "n is 2, but must be from 0 to 1, as casts",
                    () -> queries.circleCast(new float[9], 2, handles, null));
            refused("n is 5, but must be from 0 to 4, as points", () -> queries.pick(new float[9], 5, handles));
            refused("ends has room for 1", () -> queries.overlapCircle(new float[6], 2, new int[1], handles));
            refused("hits has room for 4", () -> queries.circleCast(new float[5], 1, handles, new float[4]));
            refused("handles has room for 8", () -> queries.pick(new float[20], 9, handles));
        }
    }

    @Test
    void arraysThatAreNullAreNamed() {
        try (World world = tenByTen()) {
            Queries queries = world.queries();
            isNamed("handles", () -> queries.overlapCircle(0, 0, 1, null));
            isNamed("handles", () -> queries.overlapBox(0, 0, 1, 1, null));
            isNamed("handles", () -> queries.nearest(0, 0, 1, 1, null, null));
            isNamed("handles", () -> queries.rayCastAll(0, 0, 1, 1, null, hit));
            isNamed("handles", () -> queries.circleCastAll(0, 0, 1, 1, 1, null, hit));
            isNamed("discs", () -> queries.overlapCircle(null, 1, new int[1], handles));
            isNamed("ends", () -> queries.overlapCircle(new float[3], 1, null, handles));
            isNamed("handles", () -> queries.overlapCircle(new float[3], 1, new int[1], null));
            isNamed("boxes", () -> queries.overlapBox(null, 1, new int[1], handles));
            isNamed("points", () -> queries.pick(null, 1, handles));
            isNamed("handles", () -> queries.pick(new float[2], 1, null));
            isNamed("points", () -> queries.nearest(null, 1, 1, 1, handles, null));
            isNamed("rays", () -> queries.rayCast(null, 1, handles, null));
            isNamed("handles", () -> queries.rayCast(new float[4], 1, null, null));
            isNamed("rays", () -> queries.rayCastAll(null, 1, new int[1], handles, null));
            isNamed("ends", () -> queries.rayCastAll(new float[4], 1, null, handles, null));
            isNamed("casts", () -> queries.circleCast(null, 1, handles, null));
            isNamed("casts", () -> queries.circleCastAll(null, 1, new int[1], handles, null));
            assertThat(queries.pick(0, 0)).as("after all that").isZero();
        }
    }

    private static void isNamed(String parameter, Runnable call) {
        assertThatNullPointerException().isThrownBy(call::run).withMessage(parameter + " must not be null");
    }

    @Test
    void aClosedWorldGivesNoQueries() {
        World world = tenByTen();
        Queries queries = world.queries();
        world.close();
        assertThatIllegalStateException().isThrownBy(world::queries).withMessageContaining("closed");
        assertThatIllegalStateException().isThrownBy(() -> queries.withMask(1)).withMessageContaining("closed");
        assertThatIllegalStateException().isThrownBy(() -> queries.without(0)).withMessageContaining("closed");
    }

    @Test
    void aClosedWorldAnswersNoQueries() {
        World world = tenByTen();
        Queries queries = world.queries();
        assertThat(world.queries()).isSameAs(queries);
        world.close();
        assertThatIllegalStateException().isThrownBy(() -> queries.pick(0, 0)).withMessageContaining("closed");
        assertIllegalState("closed", () -> queries.rayCast(new float[0], 0, handles, null));
    }

    @Test
    @Timeout(60)
    void aQueryWhileAnotherThreadIsInsideIsRefused() throws InterruptedException {
        Scene scene = Scenes.packed(3000, Scenes.SEED);
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            AtomicBoolean refused = new AtomicBoolean();
            Thread stepping = new Thread(() -> {
                while (!refused.get()) {
                    try {
                        world.step(scene.timeStep(), 20);
                    } catch (ConcurrentModificationException e) {
                        Thread.onSpinWait(); // it is this thread's turn to be refused
                    }
                }
            });
            stepping.start();
            assertThatThrownBy(() -> {
                        for (; ; ) {
                            world.queries().pick(0, 0);
                        }
                    })
                    .isInstanceOf(ConcurrentModificationException.class);
            refused.set(true);
            stepping.join();
            assertThat(world.queries().overlapBox(-9, -9, 9, 9, handles)).isEqualTo(3000);
        }
    }
}
