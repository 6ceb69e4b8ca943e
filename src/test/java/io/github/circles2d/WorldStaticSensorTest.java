package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.reference.Event;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What static circles sense of each other and of bodies, if a kind asks for it. */
class WorldStaticSensorTest {
    private static final float DT = 1 / 60f;

    /** Pushes others. */
    private static final int STONE = 0;

    /** A sensor that asks. */
    private static final int GOAL = 1;

    /** A sensor that does not ask. */
    private static final int PLAIN = 2;

    /** Of pieces of a body: solid. */
    private static final int LIFT = 3;

    /** Of pieces of a body: a sensor that asks. */
    private static final int GATE = 4;

    private World world;

    @BeforeEach
    void makeWorld() {
        world = WorldScenes.jvm().bounds(-50, -50, 50, 50).build();
        makeKinds(world);
    }

    @AfterEach
    void close() {
        world.close();
    }

    private static void makeKinds(World of) {
        of.kind(GOAL).setSensor(true).setSensesStatic(true);
        of.kind(PLAIN).setSensor(true);
        of.kind(GATE).setSensor(true).setSensesStatic(true);
        of.report(Events.BEGIN | Events.END);
    }

    private long add(float x, float y, float r, int kind) {
        return world.add(x, y, r, Float.POSITIVE_INFINITY, 0, 0, kind);
    }

    private List<String> events() {
        List<String> list = new ArrayList<>();
        Events events = world.events();
        for (int i = 0; i < events.size(); i++) {
            String type = events.type(i) == Events.BEGIN ? "begin" : events.type(i) == Events.END ? "end" : "hit";
            String partner = events.piece(i) != 0 ? "piece" : String.valueOf(World.id(events.b(i)));
            list.add(events.step(i) + " " + type + " " + World.id(events.a(i)) + " " + partner);
        }
        return list;
    }

    private void step(String... expected) {
        world.step(DT);
        assertThat(events()).containsExactly(expected);
    }

    @Test
    void aGoalNoticesAStaticCircleThatIsTeleportedInStaysAndIsTeleportedOut() {
        add(0, 0, 2, GOAL);
        long stone = add(10, 0, 1, STONE);
        world.step(DT, 3);
        assertThat(events()).isEmpty();
        world.teleport(stone, 1, 0);
        step("0 begin 0 1");
        world.step(DT, 100);
        assertThat(events()).isEmpty();
        assertThat(world.touching(GOAL, STONE, new long[2])).isOne();
        world.teleport(stone, 10, 0);
        step("0 end 0 1");
        assertThat(world.touching(GOAL, STONE, new long[2])).isZero();
    }

    /** A static circle travels to where it is set within the step. */
    @Test
    void aGoalNoticesAStaticCircleThatIsSetThroughItWithinAStep() {
        add(0, 0, 0.5f, GOAL);
        long stone = add(-10, 0.2f, 0.3f, STONE);
        step();
        world.setPosition(stone, 10, 0.2f);
        step("0 begin 0 1");
        step("0 end 0 1");
    }

    @Test
    void aGoalNoticesAStaticCircleThatMoves() {
        add(0, 0, 1, GOAL);
        long stone = add(-3, 0, 0.5f, STONE);
        world.setVelocity(stone, 6, 0);
        world.step(DT, 100);
        // It goes a tenth a step. They touch while the centre is up to 1.5 from the middle.
        assertThat(events()).hasSize(2);
        assertThat(world.x(stone)).isPositive();
    }

    @Test
    void whoNobodyAsksForIsNotNoticed() {
        add(0, 0, 2, PLAIN);
        add(1, 0, 1, STONE);
        world.terrain().addBody(0, 0, 0).addSegment(-1, 0, 1, 0, 0, LIFT);
        world.terrain().ground().addSegment(-1, 0, 1, 0, 0, LIFT);
        step();
        world.kind(PLAIN).setSensesStatic(true);
        step("0 begin 0 1", "0 begin 0 piece");
        world.kind(PLAIN).setSensesStatic(false);
        step("0 end 0 1", "0 end 0 piece");
    }

    @Test
    void removalAndKindAndRadiusBeginAndEnd() {
        add(0, 0, 2, GOAL);
        long stone = add(2.5f, 0, 1, STONE);
        step("0 begin 0 1");
        world.setRadius(stone, 0.2f);
        step("0 end 0 1");
        world.setRadius(stone, 0.6f);
        step("0 begin 0 1");
        world.setKind(stone, PLAIN); // two sensors
        step("0 end 0 1");
        world.setKind(stone, STONE);
        step("0 begin 0 1");
        world.setGroup(stone, 7);
        world.setGroup(world.handle(0), 7);
        step("0 end 0 1");
        world.setGroup(stone, 0);
        step("0 begin 0 1");
        world.remove(stone);
        step("0 end 0 1");
    }

    @Test
    void aRestingCircleThatGetsTheKindLooksAndOneThatLosesItDoesNot() {
        long sensor = add(0, 0, 2, PLAIN);
        add(1, 0, 1, STONE);
        world.step(DT, 3);
        assertThat(events()).isEmpty();
        world.setKind(sensor, GOAL);
        step("0 begin 0 1");
        world.setKind(sensor, PLAIN);
        step("0 end 0 1");
    }

    @Test
    void massesDecideWhoIsStaticAndNothingBeginsTwice() {
        add(0, 0, 2, GOAL);
        long stone = add(1, 0, 1, STONE);
        step("0 begin 0 1");
        world.setMass(stone, 1);
        step();
        world.setMass(stone, Float.POSITIVE_INFINITY);
        world.setVelocity(stone, 0, 0);
        step();
    }

    @Test
    void twoStaticSensorsSenseEachOtherIfTheMatrixSaysSo() {
        add(0, 0, 1, GOAL);
        add(1, 0, 1, GOAL);
        add(0, 1, 1, PLAIN);
        step();
        world.setResponse(GOAL, GOAL, Response.SENSE);
        step("0 begin 0 1");
        world.setResponse(GOAL, PLAIN, Response.SENSE);
        step("0 begin 0 2", "0 begin 1 2");
        world.setResponse(PLAIN, PLAIN, Response.SENSE);
        add(0, 1, 1, PLAIN);
        step("0 begin 0 3", "0 begin 1 3");
    }

    @Test
    void masksAndReportedTypesDecideAsForOthers() {
        add(0, 0, 1, GOAL);
        add(1, 0, 1, STONE);
        world.report(Events.HIT);
        step();
        world.report(GOAL, STONE, Events.END);
        step();
        assertThat(world.touching(GOAL, STONE, new long[2])).isOne();
        world.kind(STONE).setCategory(2);
        world.kind(GOAL).setMask(1);
        step("0 end 0 1");
    }

    @Test
    void aLiftThatIsMovedBeginsAndEnds() {
        add(0, 0, 1, GOAL);
        TerrainBody lift = world.terrain().addBody(0, -5, 0);
        lift.addSegment(-2, 0, 2, 0, 0.1f, LIFT);
        step();
        for (int k = 0; k < 10; k++) {
            lift.moveTo(0, -5 + 0.5f * (k + 1), 0);
            if (k == 7) {
                step("0 begin 0 piece");
            } else {
                step();
            }
        }
        world.step(DT, 50);
        assertThat(events()).isEmpty();
        long[] pair = new long[2];
        assertThat(world.touchingPieces(GOAL, LIFT, pair)).isOne();
        assertThat(World.id(pair[0])).isZero();
        lift.teleport(0, 5, 0);
        step("0 end 0 piece");
        lift.moveTo(0, -5, 0); // through it within a step
        step("0 begin 0 piece");
        step("0 end 0 piece");
        lift.moveTo(0, 0.5f, 0);
        step("0 begin 0 piece");
        lift.remove();
        step("0 end 0 piece");
    }

    /** Its faces are the lines of a chain, each with a front. */
    @Test
    void aGoalNoticesABoxThatComesUponItFromOutside() {
        add(0, 0, 0.5f, GOAL);
        TerrainBody lift = world.terrain().addBody(0, -5, 0);
        lift.addChain(Chain.of(-2, -1, 2, -1, 2, 1, -2, 1).close(), LIFT, null);
        step();
        for (int k = 1; k <= 100; k++) {
            lift.moveTo(0, -5 + 0.1f * k, 0);
            world.step(DT);
        }
        List<String> events = events();
        assertThat(events).hasSize(2);
        assertThat(events.get(0)).endsWith("begin 0 piece");
        assertThat(events.get(1)).endsWith("end 0 piece");
    }

    @Test
    void aGateOnALiftNoticesStaticCirclesThatRest() {
        add(0, 0, 1, STONE);
        add(0, 3, 1, PLAIN);
        TerrainBody lift = world.terrain().addBody(0, -5, 0);
        lift.addSegment(-2, 0, 2, 0, 0, GATE);
        world.step(DT, 3);
        assertThat(events()).isEmpty();
        lift.moveTo(0, -0.5f, 0);
        step("0 begin 0 piece");
        world.step(DT, 10);
        assertThat(events()).isEmpty();
        lift.moveTo(0, 3, 0);
        step();
        step("0 end 0 piece");
    }

    @Test
    void fixedPiecesAreNeverNoticed() {
        world.terrain().ground().addSegment(-5, 0, 5, 0, 0, LIFT);
        world.terrain().ground().addSegment(-5, 0, 5, 0, 0, GATE);
        add(0, 0, 1, GOAL);
        add(1, 0, 1, STONE);
        step("0 begin 0 1");
    }

    @Test
    void pairsMeetAcrossASeam() {
        try (World wrapped = WorldScenes.jvm()
                .bounds(0, 0, 20, 20)
                .edges(Edge.WRAP, Edge.WRAP)
                .build()) {
            makeKinds(wrapped);
            float infinite = Float.POSITIVE_INFINITY;
            wrapped.add(0.3f, 0.3f, 0.5f, infinite, 0, 0, GOAL);
            wrapped.add(19.7f, 19.8f, 0.5f, infinite, 0, 0, STONE);
            TerrainBody lift = wrapped.terrain().addBody(10, 19.9f, 0);
            lift.addSegment(-2, 0, 2, 0, 0, LIFT);
            long other = wrapped.add(10, 0.3f, 0.5f, infinite, 0, 0, GOAL);
            wrapped.step(DT, 2);
            assertThat(wrapped.touching(GOAL, STONE, new long[2])).isOne();
            long[] pair = new long[2];
            assertThat(wrapped.touchingPieces(GOAL, LIFT, pair)).isOne();
            assertThat(pair[0]).isEqualTo(other);
        }
    }

    @Test
    void aRestoredWorldAndAReplayGoOnWithTheSameEvents() {
        add(0, 0, 2, GOAL);
        long stone = add(1, 0, 1, STONE);
        TerrainBody lift = world.terrain().addBody(0, 1, 0);
        lift.addChain(Chain.of(-3, 0, 3, 0), LIFT, null);
        world.step(DT, 2);
        assertThat(events()).isNotEmpty();
        ByteBuffer bytes = snapshot(world);
        try (World restored = WorldScenes.jvm().build()) {
            restored.report(Events.BEGIN | Events.END);
            restored.restore(bytes);
            assertThat(restored.hash()).isEqualTo(world.hash());
            assertThat(restored.kind(GOAL).sensesStatic()).isTrue();
            restored.step(DT, 2);
            assertThat(restored.events().size()).isZero();
            restored.teleport(stone, 10, 0);
            restored.step(DT);
            assertThat(restored.events().size()).isOne();
        }
        long with = world.hash();
        world.kind(GOAL).setSensesStatic(false);
        assertThat(world.hash()).isNotEqualTo(with);
        world.kind(PLAIN).copyFrom(world.kind(GOAL).setSensesStatic(true));
        assertThat(world.kind(PLAIN).sensesStatic()).isTrue();
    }

    // ---- random scenes against a look at all pairs

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void touchingPairsAreThoseOfALookAtAll(int seed) {
        try (World jvm = Random.world(seed, Backend.JVM)) {
            new Random(seed, jvm).run(150);
        }
    }

    @OnEachOpenClBackend
    @Tag("long")
    void touchingPairsAreThoseOfALookAtAllOnEachBackEnd(Backend backend) {
        for (int seed : TestScale.EXHAUSTIVE ? new int[] {1, 4} : new int[] {4}) {
            try (World jvm = Random.world(seed, Backend.JVM);
                    World other = Random.world(seed, backend)) {
                new Random(seed, jvm, other).run(50);
            }
        }
    }

    /** Static circles, some with velocities, bodies and moving circles, which calls change before each step. */
    private static final class Random {
        private static final float SIZE = 20;

        /** Of the radius: whether a pair this near to a touch does is of no matter. */
        private static final double NEAR = 0.02;

        private final World[] worlds;
        private final SplittableRandom random;
        private final boolean wraps;
        private final List<Long> circles = new ArrayList<>();

        /** By handle of the piece: the body and the ends. */
        private final Map<Long, float[]> pieces = new TreeMap<>();

        private final List<Long> bodies = new ArrayList<>();

        /** By handle: x, y before the step and after it, radius, kind, 1 if it is static. */
        private final Map<Long, double[]> now = new HashMap<>();

        private final Map<Long, double[]> bodyBefore = new HashMap<>();
        private int seen;

        Random(int seed, World... worlds) {
            this.worlds = worlds;
            random = new SplittableRandom(seed);
            wraps = seed % 2 == 0;
        }

        static World world(int seed, Backend backend) {
            World world = World.builder()
                    .backend(backend)
                    .bounds(0, 0, SIZE, SIZE)
                    .edges(seed % 2 == 0 ? Edge.WRAP : Edge.WALL, seed % 4 == 0 ? Edge.WRAP : Edge.OPEN)
                    .sleep(seed > 2)
                    .build();
            makeKinds(world);
            world.setResponse(GOAL, PLAIN, Response.SENSE);
            world.setResponse(GOAL, GOAL, Response.SENSE);
            return world;
        }

        void run(int steps) {
            for (int k = 0; k < steps; k++) {
                for (int changes = random.nextInt(6); changes >= 0; changes--) {
                    change();
                }
                look(0);
                for (World world : worlds) {
                    world.step(DT);
                }
                look(2);
                compare("step " + k);
            }
            assertThat(seen).isGreaterThan(steps / 2);
        }

        private float at() {
            return SIZE * (float) random.nextDouble();
        }

        private float by(float most) {
            return most * (float) random.nextDouble();
        }

        private void change() {
            int call = random.nextInt(circles.size() < 60 ? 16 : 12);
            long some = circles.isEmpty() ? 0 : circles.get(random.nextInt(circles.size()));
            long body = bodies.isEmpty() ? 0 : bodies.get(random.nextInt(bodies.size()));
            float x = at();
            float y = at();
            float r = 0.2f + by(0.8f);
            float v = random.nextInt(3) == 0 ? by(4) - 2 : 0;
            float mass = random.nextInt(5) == 0 ? 1 : Float.POSITIVE_INFINITY;
            int kind = random.nextInt(3);
            boolean flag = random.nextInt(4) > 0;
            if (call == 11 && bodies.size() < 6) {
                long[] handles = new long[worlds.length];
                float length = 0.5f + by(2);
                int ofPiece = random.nextBoolean() ? LIFT : GATE;
                long piece = 0;
                for (int w = 0; w < worlds.length; w++) {
                    TerrainBody made = worlds[w].terrain().addBody(x, y, 0);
                    piece = made.addSegment(-length, 0, length, 0, 0, ofPiece);
                    handles[w] = made.handle();
                }
                assertThat(handles).containsOnly(handles[0]);
                bodies.add(handles[0]);
                pieces.put(piece, new float[] {bodies.size() - 1, length, ofPiece});
                return;
            }
            if (call >= 12 || circles.isEmpty()) {
                long handle = 0;
                for (World world : worlds) {
                    handle = world.add(x, y, r, mass, v, v, kind);
                }
                circles.add(handle);
                return;
            }
            for (World world : worlds) {
                switch (call) {
                    case 0, 1 -> world.teleport(some, x, y);
                    case 2 -> world.setPosition(some, x, y);
                    case 3 -> world.setRadius(some, r);
                    case 4 -> world.setKind(some, kind);
                    case 5 -> world.setMass(some, mass);
                    case 6 -> world.setVelocity(some, v, -v);
                    case 7 -> world.kind(kind).setSensesStatic(kind == GOAL || !flag);
                    case 8 -> world.remove(some);
                    default -> {
                        if (body != 0) {
                            TerrainBody moved = world.terrain().body(body);
                            float dx = 0.4f * (flag ? r : -r);
                            if (call == 9) {
                                moved.moveTo(Math.min(Math.max(moved.x() + dx, 0), SIZE), moved.y(), 0);
                            } else {
                                moved.setVelocity(0, flag ? 0 : v);
                            }
                        }
                    }
                }
            }
            if (call == 8) {
                circles.remove(some);
            }
        }

        /** Reads where all is, into places from one on. */
        private void look(int to) {
            World world = worlds[0];
            if (to == 0) {
                now.clear();
                bodyBefore.clear();
            }
            for (long handle : circles) {
                double[] c = now.computeIfAbsent(handle, key -> new double[7]);
                c[to] = world.x(handle);
                c[to + 1] = world.y(handle);
                c[4] = world.radius(handle);
                c[5] = world.kindOf(handle);
                c[6] = world.mass(handle) == Float.POSITIVE_INFINITY ? 1 : 0;
            }
            for (long body : bodies) {
                double[] b = bodyBefore.computeIfAbsent(body, key -> new double[4]);
                b[to] = world.terrain().body(body).x();
                b[to + 1] = world.terrain().body(body).y();
            }
        }

        private void compare(String when) {
            List<Event> expected = null;
            for (World world : worlds) {
                Map<String, Boolean> touching = touching(world);
                for (int i = 0; i < circles.size(); i++) {
                    for (int j = i + 1; j < circles.size(); j++) {
                        comparePair(when, touching, circles.get(i), circles.get(j));
                    }
                    compareWithPieces(when, touching, circles.get(i));
                }
                List<Event> events = Event.of(world.events());
                assertThat(events).as(when).isEqualTo(expected == null ? events : expected);
                expected = events;
                assertThat(world.hash()).as(when).isEqualTo(worlds[0].hash());
            }
        }

        private Map<String, Boolean> touching(World world) {
            Map<String, Boolean> all = new HashMap<>();
            for (int a = 0; a < 3; a++) {
                for (int b = a; b < 3; b++) {
                    long[] pairs = new long[10_000];
                    int count = world.touching(a, b, pairs);
                    for (int k = 0; k < count; k++) {
                        all.put(name(pairs[2 * k], pairs[2 * k + 1]), true);
                    }
                }
                for (int b = LIFT; b <= GATE; b++) {
                    long[] pairs = new long[10_000];
                    int count = world.touchingPieces(a, b, pairs);
                    for (int k = 0; k < count; k++) {
                        all.put(name(pairs[2 * k], pairs[2 * k + 1]), true);
                    }
                }
            }
            return all;
        }

        private static String name(long a, long b) {
            return Math.min(a, b) + " " + Math.max(a, b);
        }

        private void comparePair(String when, Map<String, Boolean> touching, long a, long b) {
            double[] p = now.get(a);
            double[] q = now.get(b);
            int kinds = (int) Math.min(p[5], q[5]) * 3 + (int) Math.max(p[5], q[5]);
            boolean senses = kinds != STONE * 3 + STONE && kinds != PLAIN * 3 + PLAIN;
            if (!senses) {
                return; // contacts, or nothing
            }
            boolean asks = worlds[0].kind((int) p[5]).sensesStatic()
                    || worlds[0].kind((int) q[5]).sensesStatic();
            double sum = p[4] + q[4];
            double least = least(p, q, 0);
            if (Math.abs(least - sum) > NEAR * sum) {
                boolean expected = least < sum && (asks || p[6] + q[6] < 2);
                assertThat(touching.containsKey(name(a, b)))
                        .as("%s: %s and %s of kinds %d, %s from touching", when, a, b, kinds, least - sum)
                        .isEqualTo(expected);
                seen += expected && p[6] + q[6] == 2 ? 1 : 0;
            }
        }

        private void compareWithPieces(String when, Map<String, Boolean> touching, long a) {
            double[] c = now.get(a);
            for (Map.Entry<Long, float[]> piece : pieces.entrySet()) {
                int kind = (int) piece.getValue()[2];
                boolean asks = worlds[0].kind((int) c[5]).sensesStatic() || kind == GATE;
                boolean senses = asks && (kind == LIFT ? c[5] != STONE : c[5] == STONE);
                double[] body = bodyBefore.get(bodies.get((int) piece.getValue()[0]));
                double least = least(c, body, piece.getValue()[1]);
                if (c[6] == 1 && Math.abs(least - c[4]) > NEAR * c[4]) {
                    boolean expected = senses && least < c[4];
                    assertThat(touching.containsKey(name(a, piece.getKey())))
                            .as("%s: %s and piece %s of kind %d", when, a, piece.getKey(), kind)
                            .isEqualTo(expected);
                    seen += expected ? 1 : 0;
                }
            }
        }

        private double way(double from, double to, boolean wrapped) {
            double d = to - from;
            return wrapped ? d - SIZE * Math.rint(d / SIZE) : d;
        }

        /** The least distance of a centre from another one, or from a line along x around it, within the step. */
        private double least(double[] p, double[] q, double halfLength) {
            boolean wrapsY = worlds[0].edgeY() == Edge.WRAP;
            double dx = way(p[0], q[0], wraps);
            double dy = way(p[1], q[1], wrapsY);
            double ux = way(q[0], q[2], wraps) - way(p[0], p[2], wraps);
            double uy = way(q[1], q[3], wrapsY) - way(p[1], p[3], wrapsY);
            double least = Double.POSITIVE_INFINITY;
            for (int k = 0; k <= 512; k++) {
                double x = dx + ux * k / 512;
                double y = dy + uy * k / 512;
                double beyond = Math.max(Math.abs(x) - halfLength, 0);
                least = Math.min(least, Math.sqrt(beyond * beyond + y * y));
            }
            return least;
        }
    }
}
