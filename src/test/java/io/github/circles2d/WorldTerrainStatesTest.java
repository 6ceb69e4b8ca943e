package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A world with terrain that is saved, restored, recorded or rolled back goes on as if nothing had been. */
class WorldTerrainStatesTest {
    private static final float STEP = 1 / 60f;
    private static final float PI = (float) Math.PI;
    private static final int ONE_WAY = 5;

    private static World.Builder builder(Edge x) {
        return WorldScenes.jvm()
                .bounds(0, 0, 40, 30)
                .edges(x, Edge.WALL)
                .gravity(0, -10)
                .threads(1);
    }

    /** A bowl, a slope, loose segments, a drum that turns, a lift, a one-way floor that moves; balls that roll in and on all that. */
    private static World world(Edge x) {
        World world = builder(x).build();
        Terrain terrain = world.terrain();
        world.kind(0).setFriction(0.6f).setRollingResistance(0.02f);
        world.kind(ONE_WAY).setOneWay(true).setFriction(0.5f);
        terrain.addChain(Chain.from(20, 8).lineTo(12, 3).arcTo(10, 6, -1.5f).lineTo(1, 12));
        for (int k = 0; k < 8; k++) {
            terrain.addSegment(20 + 2 * k, 2, 22 + 2 * k, 2 + k % 2 * 0.3f, k % 3 * 0.1f, 0);
        }
        TerrainBody drum = terrain.addBody(30, 12, 0);
        drum.addArc(0, 0, 6, 0, 2 * PI, ArcSide.INNER);
        drum.addSegment(-6, 0, -4.5f, 0);
        drum.addSegment(4.5f, 0, 6, 0);
        drum.setAngularVelocity(1.5f);
        TerrainBody lift = terrain.addBody(5, 18, 0);
        lift.addSegments(new float[] {3, 0, -3, 0}, ONE_WAY, null);
        lift.setVelocity(0, -1);
        for (int k = 0; k < 60; k++) {
            float at = 2 + k * 0.55f;
            world.add(at, 22 + k % 5, 0.2f + 0.02f * (k % 7), 1);
        }
        for (int k = 0; k < 12; k++) {
            world.add(28 + k % 4, 10 + k / 4, 0.3f, 1);
        }
        return world;
    }

    /** What a game does with terrain before a step. */
    private static void play(World world, int frame, int known) {
        Random input = new Random(frame <= known ? frame : -1);
        Terrain terrain = world.terrain();
        long some = 0;
        while (some == 0) {
            some = terrain.handle(input.nextInt(terrain.idLimit()));
        }
        switch (input.nextInt(8)) {
            case 0 -> terrain.remove(some);
            case 1 -> terrain.addSegment(2, 20 + input.nextFloat(), 9, 21);
            case 2 -> terrain.setKind(some, input.nextBoolean() ? 0 : ONE_WAY);
            case 3 -> move(terrain, terrain.bodyOf(some), input);
            case 4 -> terrain.addChain(Chain.of(14, 9 + input.nextFloat(), 10, 8, 7, 9), 0, null);
            case 5 -> terrain.addBody(input.nextInt(40), 20, input.nextFloat()).addSegment(-1, 0, 1, 0);
            case 6 -> terrain.addArc(input.nextInt(40), 3, 0.5f, 0, 2 * PI, ArcSide.OUTER);
            default -> world.add(input.nextInt(36) + 2, 28, 0.3f, 1);
        }
    }

    private static void move(Terrain terrain, TerrainBody body, Random input) {
        if (body != terrain.ground()) {
            switch (input.nextInt(4)) {
                case 0 -> body.moveTo(body.x() + input.nextFloat() - 0.5f, body.y(), body.angle() + 0.1f);
                case 1 -> body.teleport(input.nextInt(40), 10, 1);
                case 2 -> body.setVelocity(input.nextFloat(), 0);
                default -> body.setAngularVelocity(input.nextFloat() * 4);
            }
        }
    }

    @Test
    void aWorldThatIsRestoredGoesOnTheSame() {
        for (Edge edge : Edge.values()) {
            try (World world = world(edge);
                    World other = builder(edge).build()) {
                world.report(Events.BEGIN | Events.END | Events.HIT | Events.WALL);
                other.report(Events.BEGIN | Events.END | Events.HIT | Events.WALL);
                for (int frame = 0; frame < 240; frame++) {
                    if (frame % 20 == 7) {
                        ByteBuffer saved = snapshot(world);
                        other.restore(saved);
                        assertThat(snapshot(other)).isEqualTo(saved.rewind());
                    }
                    play(world, frame, frame);
                    world.step(STEP);
                    if (frame >= 7) {
                        play(other, frame, frame);
                        other.step(STEP);
                        assertThat(other.hash()).as("%s, frame %d", edge, frame).isEqualTo(world.hash());
                    }
                }
                assertThat(snapshot(other)).isEqualTo(snapshot(world));
            }
        }
    }

    @Test
    void contactsWithTerrainAreInSnapshots() {
        try (World world = world(Edge.WALL);
                World other = builder(Edge.WALL).build()) {
            world.step(STEP, 120);
            other.restore(snapshot(world));
            assertThat(other.hash()).isEqualTo(world.hash());
            long hash = world.hash();
            for (int id = 0; id < world.idLimit(); id++) {
                other.teleport(other.handle(id), other.x(other.handle(id)), other.y(other.handle(id)));
            }
            assertThat(other.hash())
                    .as("a circle that is put somewhere has none")
                    .isNotEqualTo(hash);
        }
    }

    @Test
    void aSurfaceThatGripsNoMoreLetsGoInARestoredWorldToo() {
        try (World world = builder(Edge.WALL).build();
                World other = builder(Edge.WALL).build()) {
            world.kind(0).setFriction(0.9f).setInertia(Inertia.NONE);
            world.terrain().addSegment(0, 5, 20, 10);
            world.add(10, 8.2f, 0.5f, 1);
            world.step(STEP, 60);
            world.kind(0).setFriction(Float.NaN);
            ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(bytes);
            other.restore(bytes.flip());
            world.step(STEP);
            other.step(STEP);
            assertThat(other.hash()).isEqualTo(world.hash());
        }
    }

    @Test
    void rollingBackTenFramesInEachFrameGivesTheBitsOfRunningStraight() {
        StateRuns.rollBack(() -> world(Edge.OPEN), 90, WorldTerrainStatesTest::play);
    }

    @Test
    void aLogOfTerrainIsMadeAgain() throws IOException {
        World player = builder(Edge.WALL).build();
        StateRuns.replay(world(Edge.WALL), player, 150, WorldTerrainStatesTest::play, world -> world.terrain()
                .clear());
    }

    /** Bodies move in each step of a call. */
    @Test
    void manyStepsInOneCallAreThoseOfManyCalls() {
        StateRuns.manySteps(() -> world(Edge.WALL), 50);
    }

    @Test
    void clearingTheTerrainLetsCirclesFallAndLeavesNoContact() {
        try (World world = world(Edge.WALL);
                World other = builder(Edge.WALL).build()) {
            world.step(STEP, 200);
            world.terrain().clear();
            assertThat(world.terrain().size()).isZero();
            other.restore(snapshot(world));
            assertThat(other.hash()).isEqualTo(world.hash());
            world.step(STEP, 300);
            other.step(STEP, 300);
            assertThat(other.hash()).isEqualTo(world.hash());
            for (int id = 0; id < world.idLimit(); id++) {
                assertThat(world.y(world.handle(id))).isLessThan(12);
            }
        }
    }
}
