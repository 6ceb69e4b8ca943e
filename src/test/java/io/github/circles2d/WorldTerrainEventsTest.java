package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.reference.Event;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** When events of circles and pieces of terrain come, and what they say. */
@Tag("each-jdk")
class WorldTerrainEventsTest {
    private static final int ALL = Events.BEGIN | Events.HIT | Events.END;
    private static final float DT = 1 / 60f;
    private static final int GATE = 5;

    private final World world =
            WorldScenes.jvm().bounds(-50, -50, 50, 50).restitution(0.5f).build();
    private final Terrain terrain = world.terrain();

    @AfterEach
    void close() {
        world.close();
    }

    private List<String> events() {
        return events(world);
    }

    private static List<String> events(World from) {
        List<String> list = new ArrayList<>();
        Events events = from.events();
        for (int i = 0; i < events.size(); i++) {
            list.add(events.step(i) + " " + event(events, i));
        }
        return list;
    }

    private static String event(Events events, int i) {
        String type = events.type(i) == Events.BEGIN ? "begin" : events.type(i) == Events.HIT ? "hit" : "end";
        String partner = events.side(i) != null
                ? events.side(i).toString()
                : events.piece(i) != 0 ? "piece " + Terrain.id(events.piece(i)) : String.valueOf((int) events.b(i));
        return type + " " + (int) events.a(i) + " " + partner;
    }

    @Test
    void aBallThatFallsOnASegmentBeginsAndHitsAndThenIsSilent() {
        world.setGravity(0, -10);
        world.report(ALL);
        long floor = terrain.addSegment(-20, 0, 20, 0);
        long ball = world.add(3, 6, 1, 2);
        List<String> seen = new ArrayList<>();
        for (int k = 0; k < 400; k++) {
            world.step(DT);
            Events events = world.events();
            for (int i = 0; i < events.size(); i++) {
                assertThat(events.a(i)).isEqualTo(ball);
                assertThat(events.b(i)).isZero();
                assertThat(events.piece(i)).isEqualTo(floor);
                assertThat(events.side(i)).isNull();
                if (seen.size() == 1) {
                    assertThat(events.type(i)).isEqualTo(Events.HIT);
                    assertThat(events.speed(i)).isCloseTo(10, within(0.15f));
                    assertThat(events.impulse(i)).isCloseTo(2 * 1.5f * events.speed(i), within(0.5f));
                    assertThat(events.normalX(i)).isEqualTo(0, within(1e-6f));
                    assertThat(events.normalY(i)).isEqualTo(-1, within(1e-6f));
                    assertThat(events.x(i)).isEqualTo(3, within(1e-4f));
                    assertThat(events.y(i)).isEqualTo(0, within(0.1f));
                    assertThat(events.slipSpeed(i)).isZero();
                }
                seen.add(event(events, i));
            }
        }
        assertThat(seen.subList(0, 3)).containsExactly("begin 0 piece 0", "hit 0 piece 0", "end 0 piece 0");
        assertThat(seen.get(seen.size() - 1)).as("it lies").isNotEqualTo("end 0 piece 0");
        world.step(DT, 200);
        assertThat(events()).isEmpty();
        world.setPosition(ball, 3, 5);
        world.step(DT);
        assertThat(events()).containsExactly("0 end 0 piece 0");
    }

    /** A piston at speed 6 starts half a length away from a ball at rest, and stops after 20 steps. */
    @Test
    void aBodyThatComesHitsOnceWithItsOwnSpeed() {
        for (float restitution : new float[] {0f, 0.5f, 1f}) {
            try (World piston = WorldScenes.jvm()
                    .bounds(-50, -50, 50, 50)
                    .restitution(restitution)
                    .build()) {
                piston.report(ALL);
                TerrainBody body = piston.terrain().addBody(-10, 0, 0);
                long piece = body.addSegment(0, -3, 0, 3);
                long circle = piston.add(-8.5f, 0, 1, 3);
                body.setVelocity(6, 0);
                List<String> seen = new ArrayList<>();
                for (int k = 0; k < 30; k++) {
                    if (k == 20) {
                        body.setVelocity(0, 0);
                    }
                    piston.step(DT);
                    Events events = piston.events();
                    for (int i = 0; i < events.size(); i++) {
                        assertThat(events.piece(i)).isEqualTo(piece);
                        seen.add(event(events, i));
                        if (events.type(i) == Events.HIT) {
                            assertThat(events.speed(i)).isCloseTo(6, within(0.06f));
                            assertThat(events.impulse(i)).isCloseTo(3 * 6 * (1 + restitution), within(0.5f));
                            assertThat(events.normalX(i)).isCloseTo(-1, within(1e-5f));
                        }
                    }
                }
                assertThat(seen)
                        .as("restitution " + restitution)
                        .containsExactly("begin 0 piece 0", "hit 0 piece 0", "end 0 piece 0");
                assertThat(piston.vx(circle)).isCloseTo(6 * (1 + restitution), within(0.2f));
            }
        }
    }

    @Test
    void aBallThatRollsAlongAChainGoesFromPieceToPieceWithoutAHit() {
        world.setGravity(0, -10);
        world.report(ALL);
        float[] points = new float[2 * 11];
        for (int k = 0; k <= 10; k++) {
            points[2 * k] = 20 - 4 * k;
            points[2 * k + 1] = 0;
        }
        terrain.addChain(Chain.of(points));
        long ball = world.add(-19, 1, 1, 1);
        world.step(DT, 30);
        assertThat(events()).containsExactly("0 begin 0 piece 9");
        world.setVelocity(ball, 5, 0);
        List<String> expected = new ArrayList<>();
        List<String> seen = new ArrayList<>();
        for (int k = 0; k < 440; k++) {
            world.step(DT);
            Events events = world.events();
            for (int i = 0; i < events.size(); i++) {
                seen.add(event(events, i));
            }
        }
        for (int piece = 8; piece >= 0; piece--) {
            expected.add("begin 0 piece " + piece);
            expected.add("end 0 piece " + (piece + 1));
        }
        assertThat(seen).containsExactlyInAnyOrderElementsOf(expected);
    }

    @Test
    void aRemovedPieceEndsUnderItsHandleAndItsSuccessorBegins() {
        world.report(Events.BEGIN | Events.END);
        long a = terrain.addSegment(-5, 0, 5, 0);
        long b = terrain.addSegment(0, -5, 0, 5);
        long ball = world.add(0.95f, 0.95f, 1, 1);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 piece 0", "0 begin 0 piece 1");
        terrain.remove(a);
        terrain.remove(b);
        long c = terrain.addSegment(-5, -0.2f, 5, -0.2f);
        assertThat(Terrain.id(c)).isEqualTo(Terrain.id(a));
        world.setPosition(ball, 3, 0.75f);
        world.step(DT);
        Events events = world.events();
        assertThat(events.size()).isEqualTo(3);
        assertThat(events.type(0)).isEqualTo(Events.END);
        assertThat(events.piece(0)).isEqualTo(a);
        assertThat(events.type(1)).isEqualTo(Events.BEGIN);
        assertThat(events.piece(1)).isEqualTo(c);
        assertThat(events.type(2)).isEqualTo(Events.END);
        assertThat(events.piece(2)).isEqualTo(b);
        terrain.clear();
        world.remove(ball);
        world.step(DT);
        assertThat(events()).containsExactly("0 end 0 piece 0");
        world.step(DT);
        assertThat(events()).isEmpty();
    }

    @Test
    void piecesThatComeWhileEventsAreOffAreKnownLater() {
        terrain.addSegment(-5, 0, 5, 0);
        world.add(0, 0.95f, 1, 1);
        world.step(DT);
        long late = terrain.addSegment(-5, 0.1f, 5, 0.1f);
        world.report(Events.BEGIN);
        world.step(DT);
        assertThat(events()).contains("0 begin 0 piece 0", "0 begin 0 piece 1");
        world.report(0);
        terrain.remove(late);
        world.step(DT);
        world.report(Events.BEGIN | Events.END);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 piece 0");
    }

    // ---- sensors

    private void makeGates() {
        world.kind(GATE).setSensor(true);
        world.report(ALL);
    }

    @Test
    void aThinGateNoticesABulletThatCrossesItWithinAStep() {
        makeGates();
        long gate = terrain.addSegment(0, -2, 0, 2, 0, GATE);
        long bullet = world.add(-3, 0.5f, 0.1f, 1);
        world.setVelocity(bullet, 300, 0);
        world.step(DT);
        Events events = world.events();
        assertThat(events.size()).isEqualTo(1);
        assertThat(event(events, 0)).isEqualTo("begin 0 piece 0");
        assertThat(events.piece(0)).isEqualTo(gate);
        assertThat(events.speed(0)).isCloseTo(300, within(1f));
        assertThat(events.impulse(0)).isZero();
        assertThat(events.normalX(0)).isEqualTo(1, within(1e-5f));
        assertThat(events.x(0)).isEqualTo(0, within(1e-3f));
        assertThat(events.y(0)).isEqualTo(0.5f, within(1e-3f));
        assertThat(world.vx(bullet)).as("it pushes nothing").isEqualTo(300);
        world.step(DT);
        assertThat(events()).containsExactly("0 end 0 piece 0");
        world.setPosition(bullet, 3, -0.5f);
        world.setVelocity(bullet, -300, 0);
        world.step(DT, 2);
        assertThat(events()).as("from its other side").containsExactly("0 begin 0 piece 0", "1 end 0 piece 0");
        world.teleport(bullet, 5, 0);
        world.setVelocity(bullet, 0, 0);
        world.step(DT, 2);
        assertThat(events()).as("it is not on its way").isEmpty();
    }

    @Test
    void aGateThatIsOneWayNoticesWhatComesFromItsFront() {
        makeGates();
        world.kind(GATE).setOneWay(true);
        terrain.addSegment(0, 2, 0, -2, 0, GATE); // its right is on the left
        long bullet = world.add(-3, 0, 0.1f, 1);
        world.setVelocity(bullet, 300, 0);
        world.step(DT, 2);
        assertThat(events()).containsExactly("0 begin 0 piece 0", "1 end 0 piece 0");
        world.setPosition(bullet, 3, 0);
        world.setVelocity(bullet, -300, 0);
        world.step(DT, 3);
        assertThat(events()).isEmpty();
    }

    @Test
    void arcsAndPiecesThatMoveSenseToo() {
        makeGates();
        terrain.addArc(20, 0, 3, 0, (float) (2 * Math.PI), ArcSide.OUTER, GATE);
        TerrainBody sweeper = terrain.addBody(-20, 0, 0);
        sweeper.addSegment(0, -2, 0, 2, 0, GATE);
        long bullet = world.add(10, 0, 0.5f, 1);
        world.setVelocity(bullet, 6 * 60, 0);
        long still = world.add(-15, 1, 0.5f, 1);
        world.step(DT);
        assertThat(events()).isEmpty();
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 piece 0");
        world.step(DT);
        assertThat(events()).as("it has gone through").containsExactly("0 end 0 piece 0");
        sweeper.setVelocity(4 * 60, 0);
        world.step(DT);
        assertThat(events()).isEmpty();
        world.step(DT);
        Events events = world.events();
        assertThat(events.size()).isEqualTo(1);
        assertThat(event(events, 0)).isEqualTo("begin 1 piece 1");
        assertThat(events.a(0)).isEqualTo(still);
        assertThat(events.speed(0)).isCloseTo(240, within(1f));
        assertThat(events.normalX(0)).isEqualTo(-1, within(1e-5f));
        world.step(DT);
        assertThat(events()).containsExactly("0 end 1 piece 1");
    }

    // ---- kinds

    @Test
    void onlyPairsOfKindsThatWereAskedForReport() {
        world.report(1, 2, ALL);
        terrain.addSegment(-10, 0, 10, 0, 0, 2);
        long a = world.add(-5, 0.95f, 1, 1);
        long b = world.add(5, 0.95f, 1, 1);
        world.setKind(b, 1);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 1 piece 0");
        world.setKind(a, 1);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 piece 0");
        terrain.setKind(terrain.handle(0), 3);
        world.step(DT);
        assertThat(events()).as("they end in silence").isEmpty();
        terrain.setKind(terrain.handle(0), 2);
        world.step(DT);
        assertThat(events()).containsExactly("0 begin 0 piece 0", "0 begin 1 piece 0");
        world.report(1, 2, 0);
        world.step(DT);
        assertThat(events()).isEmpty();
    }

    @Test
    void whoIsInAGateIsListed() {
        makeGates();
        long[] pairs = new long[4];
        long gate = terrain.addSegment(-5, 0, 5, 0, 0, GATE);
        long second = terrain.addSegment(-5, 0.5f, 5, 0.5f, 0, GATE);
        terrain.addSegment(-5, 5, 5, 5);
        long a = world.add(0, 0.2f, 1, 1);
        long b = world.add(3, 1.2f, 1, 1);
        world.add(3, 4.2f, 1, 1);
        world.step(DT);
        assertThat(world.touchingPieces(0, GATE, pairs)).isEqualTo(3);
        assertThat(pairs).containsExactly(a, gate, a, second);
        assertThat(world.touchingPieces(0, 0, pairs)).isEqualTo(1);
        terrain.remove(gate);
        assertThat(world.touchingPieces(0, GATE, pairs)).isEqualTo(2);
        assertThat(pairs).containsExactly(a, second, b, second);
        world.setPosition(a, 20, 20);
        world.step(DT);
        assertThat(world.touchingPieces(0, GATE, new long[0])).isEqualTo(1);
        assertThat(world.touching(0, 0, pairs)).isZero();
    }

    @Test
    void aHitSaysHowFastTheSurfacesSlid() {
        world.kind(0).setFriction(0.4f);
        world.report(ALL);
        terrain.addSegment(-10, 0, 10, 0);
        long ball = world.add(0, 1.5f, 1, 1);
        world.setVelocity(ball, 7, -4);
        world.setAngularVelocity(ball, 2);
        boolean hit = false;
        for (int k = 0; k < 20; k++) {
            world.step(DT);
            Events events = world.events();
            for (int i = 0; i < events.size(); i++) {
                if (events.type(i) == Events.HIT) {
                    assertThat(events.speed(i)).isCloseTo(4, within(1e-3f));
                    assertThat(events.slipSpeed(i)).isCloseTo(7 + 2, within(1e-2f));
                    hit = true;
                }
            }
        }
        assertThat(hit).isTrue();
    }

    // ---- many

    /** A heap that grows while it reports, on terrain that grows, too. */
    private static List<String> heap(int threads) {
        List<String> all = new ArrayList<>();
        try (World heap = WorldScenes.jvm()
                .bounds(-60, -10, 60, 200)
                .gravity(0, -10)
                .threads(threads)
                .build()) {
            Terrain ground = heap.terrain();
            heap.kind(GATE).setSensor(true);
            heap.report(ALL | Events.WALL);
            Random random = new Random(3);
            TerrainBody spinner = ground.addBody(0, 12, 0);
            spinner.addSegment(-8, 0, 8, 0, 0.3f, 0);
            spinner.setAngularVelocity(2);
            ground.addSegment(-50, 8, 50, 8, 0, GATE);
            for (int k = 0; k < 120; k++) {
                for (int n = 0; n < 25; n++) {
                    heap.add(100 * random.nextFloat() - 50, 20 + 60 * random.nextFloat(), 0.4f, 1);
                }
                if (k % 3 == 0) {
                    float x = 100 * random.nextFloat() - 50;
                    ground.addSegment(x, 4 * random.nextFloat(), x + 4, 4 * random.nextFloat());
                    ground.addArc(x, -4, 3, 0, 3.14159f, ArcSide.OUTER);
                }
                if (k % 10 == 9) {
                    ground.remove(ground.handle(2 + random.nextInt(ground.idLimit() - 2)));
                }
                heap.step(DT, 2);
                Events events = heap.events();
                for (int i = 0; i < events.size(); i++) {
                    all.add(events.step(i) + " " + event(events, i) + " " + events.speed(i) + " " + events.impulse(i)
                            + " " + events.x(i) + " " + events.y(i) + " " + events.normalX(i));
                }
            }
        }
        return all;
    }

    @Test
    void aWorldThatGrowsHasTheSameEventsForAnyNumberOfThreads() {
        List<String> one = heap(1);
        assertThat(one.stream().filter(e -> e.contains("piece")).count()).isGreaterThan(2000);
        assertThat(heap(3)).isEqualTo(one);
    }

    @Test
    void eventsAreInOrderAndEachBeginHasItsEnd() {
        world.setGravity(0, -10);
        world.report(Events.BEGIN | Events.END | Events.WALL);
        Random random = new Random(4);
        for (int k = 0; k < 30; k++) {
            float x = 80 * random.nextFloat() - 40;
            terrain.addSegment(x, 20 * random.nextFloat() - 30, x + 8, 20 * random.nextFloat() - 30);
        }
        for (int k = 0; k < 200; k++) {
            world.add(90 * random.nextFloat() - 45, 40 * random.nextFloat(), 0.5f, 1);
        }
        List<String> touching = new ArrayList<>();
        int ofPieces = 0;
        for (int k = 0; k < 200; k++) {
            world.step(DT);
            Events events = world.events();
            long before = -1;
            for (int i = 0; i < events.size(); i++) {
                String pair = event(events, i).replaceAll("^\\w+ ", "");
                long partner = events.piece(i) != 0
                        ? 10_000_000 + Terrain.id(events.piece(i))
                        : events.side(i) != null ? 1_000_000 + events.side(i).ordinal() : (int) events.b(i);
                long key = (int) events.a(i) * 100_000_000L + partner;
                assertThat(key).isGreaterThan(before);
                before = key;
                ofPieces += events.piece(i) != 0 ? 1 : 0;
                if (events.type(i) == Events.BEGIN) {
                    assertThat(touching).doesNotContain(pair);
                    touching.add(pair);
                } else {
                    assertThat(touching.remove(pair)).isTrue();
                }
            }
        }
        assertThat(ofPieces).isGreaterThan(200);
    }

    @Test
    void aRollbackNeitherRepeatsNorLosesEvents() {
        try (World played = heapWorld();
                World other = WorldScenes.jvm().build()) {
            played.kind(GATE).setSensor(true);
            played.report(ALL | Events.WALL);
            other.report(ALL | Events.WALL);
            Terrain ground = played.terrain();
            TerrainBody spinner = ground.addBody(0, 3, 0);
            spinner.addSegment(-4, 0, 4, 0, 0.2f, 0);
            spinner.setAngularVelocity(3);
            ground.addSegment(-10, 2, 10, 2, 0, GATE);
            played.step(DT, 90);
            int ofPieces = 0;
            int late = 0;
            for (int k = 0; k < 60; k++) {
                played.step(DT);
                played.events();
                if (k % 4 == 0) {
                    ground.remove(ground.handle(k % 3));
                    float y = 1 + k % 7 * 0.1f;
                    ground.addSegment(9 - k / 8f, y, -9 + k / 8f, y);
                }
                if (k % 5 == 0) {
                    played.remove(played.handle(k));
                }
                ByteBuffer snapshot = ByteBuffer.allocate(played.snapshotBytes());
                played.snapshot(snapshot);
                played.step(DT, 3);
                List<Event> expected = Event.of(played.events());
                ofPieces += (int) expected.stream().filter(e -> e.piece() != 0).count();
                late += (int) expected.stream()
                        .filter(e -> e.piece() != 0 && !ground.contains(e.piece()))
                        .count();
                other.restore(snapshot.flip());
                assertThat(other.events().size()).isZero();
                other.step(DT, 3);
                assertThat(Event.of(other.events())).isEqualTo(expected);
                played.restore(snapshot.rewind());
                played.step(DT, 3);
                assertThat(Event.of(played.events())).isEqualTo(expected);
                played.restore(snapshot.rewind());
            }
            assertThat(ofPieces).isGreaterThan(300);
            assertThat(late).isGreaterThan(10);
        }
    }

    @Test
    void aWorldWithTerrainThatReportsNothingWritesNothingOfTouches() {
        try (World heap = heapWorld()) {
            heap.step(DT, 100);
            int bytes = heap.snapshotBytes();
            heap.report(ALL);
            heap.step(DT);
            assertThat(heap.snapshotBytes()).isGreaterThan(bytes);
            heap.report(0);
            heap.step(DT);
            assertThat(heap.snapshotBytes()).isCloseTo(bytes, within(400));
        }
    }

    @Test
    void reportingChangesNoBit() {
        float[] before = heapPositions(0);
        assertThat(heapPositions(ALL | Events.WALL)).isEqualTo(before);
    }

    private static World heapWorld() {
        World heap = WorldScenes.jvm()
                .bounds(-20, -10, 20, 40)
                .gravity(0, -10)
                .restitution(0.5f)
                .build();
        heap.kind(0).setFriction(0.5f);
        heap.terrain().addChain(Chain.of(20, 0, 5, -3, -5, -3, -20, 0));
        heap.terrain().addArc(0, 0, 2, 0, 3, ArcSide.OUTER);
        for (int k = 0; k < 150; k++) {
            heap.add(-9 + (k % 15) * 1.2f, 5 + (k / 15) * 1.2f, 0.5f, 1);
        }
        return heap;
    }

    private static float[] heapPositions(int types) {
        try (World heap = heapWorld()) {
            heap.report(types);
            heap.step(DT, 200);
            float[] circles = new float[4 * heap.size()];
            heap.read(circles);
            return circles;
        }
    }
}
