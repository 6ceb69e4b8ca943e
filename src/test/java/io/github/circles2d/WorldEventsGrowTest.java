package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.reference.Event;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;

/** Worlds that report events while they grow from the default capacity have the same events and snapshots on every back end. */
class WorldEventsGrowTest {
    private static final int ALL = Events.BEGIN | Events.HIT | Events.END | Events.WALL;
    private static final int SEEDS = 9;
    private static final int STEPS = 150;

    @OnEachOpenClBackend
    void pouredBallsHaveTheSameEventsAndSnapshots(Backend backend) {
        for (int seed = 0; seed < SEEDS; seed++) {
            try (World oracle = world(Backend.JVM);
                    World world = world(backend)) {
                oracle.report(ALL);
                world.report(ALL);
                int events = 0;
                for (int step = 0; step < STEPS; step++) {
                    pour(oracle, new Random(1000L * seed + step));
                    pour(world, new Random(1000L * seed + step));
                    oracle.step(1 / 60f);
                    world.step(1 / 60f);
                    events += assertSame(oracle, world, "seed " + seed + ", step " + step);
                }
                assertThat(events).isPositive();
            }
        }
    }

    /** Circles come and go, kinds and what is reported change, states are restored, and events are read seldom or by request. */
    @OnEachOpenClBackend
    @Tag("long")
    void soHaveWorldsInWhichAnythingHappens(Backend backend) {
        for (int seed = 0; seed < TestScale.of(1, 3, SEEDS); seed++) {
            compare(backend, seed, false);
        }
    }

    /** The same with terrain, which grows, too, moves, and goes. */
    @OnEachOpenClBackend
    @Tag("long")
    void soHaveWorldsWithTerrain(Backend backend) {
        for (int seed = 0; seed < TestScale.of(2, SEEDS); seed++) {
            compare(backend, 100 + seed, true);
        }
    }

    private static void compare(Backend backend, int seed, boolean withTerrain) {
        try (World oracle = world(Backend.JVM);
                World world = world(backend)) {
            Changes ofOracle = new Changes(oracle, seed, withTerrain);
            Changes ofWorld = new Changes(world, seed, withTerrain);
            int ofPieces = 0;
            for (int step = 0; step < STEPS; step++) {
                String what = "seed " + seed + ", step " + step + ", after " + ofOracle.change(step);
                ofWorld.change(step);
                List<Event> expected = ofOracle.events(step);
                ofPieces += (int) expected.stream().filter(e -> e.piece() != 0).count();
                assertThat(ofWorld.events(step)).as(what).isEqualTo(expected);
                assertThat(world.hash()).as(what).isEqualTo(oracle.hash());
                if (step % 3 == 0) {
                    assertThat(snapshot(world)).as(what).isEqualTo(snapshot(oracle));
                }
            }
            assertThat(ofPieces).isBetween(withTerrain ? 20 : 0, withTerrain ? Integer.MAX_VALUE : 0);
        }
    }

    private static World world(Backend backend) {
        return World.builder().bounds(0, 0, 50, 50).backend(backend).build();
    }

    private static void pour(World world, Random random) {
        for (int k = 0; k < 5; k++) {
            world.add(1 + 48 * random.nextFloat(), 49, 0.5f, 1, 4 * random.nextFloat() - 2, -5);
        }
    }

    private static int assertSame(World oracle, World world, String when) {
        List<Event> expected = Event.of(oracle.events());
        assertThat(Event.of(world.events())).as(when).isEqualTo(expected);
        assertThat(snapshot(world)).as(when).isEqualTo(snapshot(oracle));
        return expected.size();
    }

    /** The same calls on any world, by a seed. */
    private static final class Changes {
        private final World world;
        private final Random random;
        private final List<Long> handles = new ArrayList<>();
        private ByteBuffer saved;
        private List<Long> savedHandles;
        private boolean requested;
        private final boolean withTerrain;

        Changes(World world, long seed, boolean withTerrain) {
            this.world = world;
            this.withTerrain = withTerrain;
            random = new Random(seed);
            world.report(ALL);
        }

        String change(int step) {
            for (int k = random.nextInt(9); k > 0; k--) {
                float radius = random.nextInt(20) == 0 ? 3 : 0.3f + 0.4f * random.nextFloat();
                handles.add(world.add(
                        4 + 42 * random.nextFloat(),
                        4 + 42 * random.nextFloat(),
                        radius,
                        1,
                        random.nextInt(20) - 10,
                        -9));
            }
            for (int k = handles.isEmpty() ? 0 : random.nextInt(4); k > 0 && !handles.isEmpty(); k--) {
                world.remove(handles.remove(random.nextInt(handles.size())));
            }
            String what = "adding and removing";
            switch (random.nextInt(12)) {
                case 0:
                    what = "setKind";
                    for (int k = 0; k < handles.size(); k += 7) {
                        world.setKind(handles.get(k), random.nextInt(4));
                    }
                    break;
                case 1:
                    what = "report of two kinds";
                    world.report(random.nextInt(4), random.nextInt(4), random.nextInt(8));
                    break;
                case 2:
                    what = "report";
                    world.report(random.nextInt(16));
                    break;
                case 3:
                    what = "sensor";
                    world.kind(3).setSensor(random.nextBoolean());
                    break;
                case 4:
                    what = "snapshot";
                    saved = snapshot(world);
                    savedHandles = new ArrayList<>(handles);
                    break;
                case 5:
                    if (saved != null) {
                        what = "restore";
                        world.restore(saved.duplicate());
                        handles.clear();
                        handles.addAll(savedHandles);
                        requested = false;
                    }
                    break;
                case 6:
                    what = "hit speed";
                    world.setHitSpeed(random.nextInt(3));
                    break;
                case 7:
                    what = "mask";
                    world.kind(2).setMask(random.nextInt(2) - 1);
                    break;
                case 8:
                    what = "clear";
                    if (random.nextInt(4) == 0) {
                        world.clear();
                        handles.clear();
                    }
                    break;
                default:
            }
            for (int k = withTerrain ? random.nextInt(3) : 0; k > 0; k--) {
                changeTerrain();
            }
            world.step(1 / 60f, 1 + random.nextInt(3));
            return what;
        }

        private void changeTerrain() {
            Terrain terrain = world.terrain();
            float x = 5 + 40 * random.nextFloat();
            float y = 2 + 30 * random.nextFloat();
            float dx = 8 * random.nextFloat() - 4;
            int kind = random.nextInt(4);
            long piece = terrain.idLimit() == 0 ? 0 : terrain.handle(random.nextInt(terrain.idLimit()));
            switch (random.nextInt(7)) {
                case 0 -> terrain.addSegment(x, y, x + dx, y + 1, 0, kind);
                case 1 -> terrain.addArc(x, y, 3, dx, dx + 3, dx > 0 ? ArcSide.OUTER : ArcSide.INNER, kind);
                case 2 -> terrain.addChain(Chain.of(x + 4, y, x, y - 1, x - 4, y + dx), kind, null);
                case 3 -> {
                    TerrainBody body = terrain.addBody(x, y, dx);
                    body.addSegment(-3, 0, 3, 0, 0.2f, kind);
                    body.setAngularVelocity(dx);
                    body.setVelocity(0.3f * dx, 0);
                }
                case 4, 5 -> {
                    if (piece != 0) {
                        terrain.remove(piece);
                    }
                }
                default -> {
                    if (piece != 0) {
                        terrain.setKind(piece, kind);
                    }
                }
            }
        }

        /** Events are taken at once, not at all, or by a request in the step before. */
        List<Event> events(int step) {
            int how = random.nextInt(4);
            if (how == 0) {
                return List.of();
            }
            if (how == 1) {
                requested = false;
                return Event.of(world.events());
            }
            List<Event> taken = requested ? Event.of(world.takeEvents()) : List.of();
            world.requestEvents();
            requested = true;
            return taken;
        }
    }
}
