package io.github.circles2d.toy;

import io.github.circles2d.ArcSide;
import io.github.circles2d.Backend;
import io.github.circles2d.Blobs;
import io.github.circles2d.Chain;
import io.github.circles2d.JointedCircles;
import io.github.circles2d.Outline;
import io.github.circles2d.Ropes;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.Wall;
import io.github.circles2d.World;
import java.util.Random;

/** What there is to begin with. */
final class Stages {
    private static final float WALL_RADIUS = 0.8f;

    private static final float FIXED = Float.POSITIVE_INFINITY;

    // Kinds of terrain and static circles.
    private static final int BELT = 1;
    private static final int ROLLER = 2;
    private static final int ICE = 3; // has the friction of the world, 0

    /** The kind of a circle that goes on where others come to rest. */
    private static final int BALL = 4;

    private Stages() {}

    /** Opens a stage by its name on the page. */
    static World open(String name) {
        World world = World.builder()
                .backend(Backend.JVM)
                .bounds(0, 0, 160, 100)
                .gravity(0, -60)
                .restitution(0.3f)
                .sleep(true)
                .build();
        switch (name) {
            case "hourglass" -> hourglass(world);
            case "drum" -> drum(world);
            case "pegs" -> pegs(world);
            case "marbles" -> marbles(world);
            case "crowd" -> heap(world, 1, 1, 159, 99, 0.62f, 0.82f, 9, 5_000);
            case "ramps" -> ramps(world);
            case "bridge" -> bridge(world);
            case "blobs" -> blobs(world);
            case "wrecking" -> wreckingBall(world);
            case "slopes" -> slopesAndBelts(world);
            case "rest" -> rest(world);
            case "tower" -> tower(world);
            case "crates" -> crates(world);
            default -> throw new IllegalArgumentException("there is no stage " + name);
        }
        return world;
    }

    /** A tower of crates, and a heavy ball that is thrown at it. */
    private static void tower(World world) {
        world.kind(0).setFriction(0.6f);
        Outline crate = Outline.box(6, 6);
        for (int row = 0; row < 12; row++) {
            for (int k = 0; k < 12 - row; k++) {
                world.bodies().add(crate, 80 + 6.2f * k + 3.1f * row, 3 + 6 * row, 0, 0.3f * crate.area());
            }
        }
        world.add(8, 30, 5, 300, 130, 22);
    }

    /** Crates among balls: light ones stay on top, heavy ones sink. */
    private static void crates(World world) {
        world.kind(0).setFriction(0.3f);
        wall(world, 40, 0, 20, 45, 0);
        wall(world, 120, 0, 140, 45, 0);
        heap(world, 38, 1, 122, 44, 0.8f, 1.2f, 41, 2_000);
        Outline crate = Outline.box(9, 9);
        for (int k = 0; k < 6; k++) {
            float density = k % 3 == 0 ? 0.1f : k % 3 == 1 ? 0.32f : 1.5f;
            world.bodies().add(crate, 50 + 12 * k, 60 + 4 * (k % 2), 0.3f * k, density * crate.area());
        }
    }

    private static void ramps(World world) {
        wall(world, 4, 72, 62, 52, 0);
        wall(world, 156, 60, 92, 40, 0);
        heap(world, 6, 76, 56, 98, 0.7f, 1.1f, 2, 600);
        heap(world, 104, 64, 154, 98, 0.7f, 1.1f, 3, 900);
        world.add(62, 7, 5, 60);
        world.add(120, 8, 7, 110);
    }

    /** Balls roll down a slope, and a belt takes them up to rollers; behind these they slide down ice onto the floor, which runs back. */
    private static void slopesAndBelts(World world) {
        world.kind(0).setFriction(0.6f).setRollingResistance(0.01f);
        world.kind(BELT).setFriction(1).setBeltSpeed(24);
        world.kind(ROLLER).setFriction(1);
        world.setWallSurface(Wall.MIN_Y, 0.6f, 0.01f, 16);
        wall(world, 2, 82, 52, 66, 0);
        wall(world, 54, 62, 112, 72, BELT);
        for (int k = 0; k < 7; k++) {
            long roller = world.add(150 - 7.5f * k, 56 - 0.7f * k, 3.2f, FIXED, 0, 0, ROLLER);
            world.setAngularVelocity(roller, 6);
        }
        wall(world, 98, 46, 52, 28, ICE);
        wall(world, 156, 66, 156, 58, 0);
        heap(world, 4, 84, 48, 99, 1, 1.6f, 10, 120);
        heap(world, 20, 2, 140, 12, 1, 1.6f, 11, 120);
    }

    private static void hourglass(World world) {
        Chain glass = Chain.from(40, 99).lineTo(120, 99).lineTo(120, 84); // clockwise: the sand is inside
        glass.lineTo(85.333f, 52.981f).arcTo(88, 50, 1.6818f).lineTo(120, 16).lineTo(120, 1);
        glass.lineTo(40, 1).lineTo(40, 16);
        glass.lineTo(74.667f, 47.019f).arcTo(72, 50, 1.6818f).lineTo(40, 84).close();
        world.terrain().addChain(glass);
        heap(world, 41, 85, 119, 98, 0.5f, 0.7f, 5, 600);
        heap(world, 58, 71, 102, 84, 0.5f, 0.7f, 6, 400);
    }

    /** A drum with paddles that turns. */
    private static void drum(World world) {
        TerrainBody drum = world.terrain().addBody(80, 50, 0);
        drum.addArc(0, 0, 46, 0, 2 * (float) Math.PI, ArcSide.INNER);
        for (int k = 0; k < 8; k++) {
            float x = (float) StrictMath.cos(k * Math.PI / 4);
            float y = (float) StrictMath.sin(k * Math.PI / 4);
            drum.addSegment(46 * x, 46 * y, 37 * x, 37 * y, 0.6f, 0);
        }
        drum.setAngularVelocity(0.5f);
        world.kind(0).setFriction(0.5f);
        heap(world, 50, 24, 110, 76, 0.8f, 1.1f, 20, 700);
    }

    /** A bridge between two cliffs, and balls that roll onto it. */
    private static void bridge(World world) {
        wall(world, 2, 60, 33, 52, 0);
        wall(world, 158, 60, 127, 52, 0);
        Ropes.bridge(world, Ropes.at(32, 50), Ropes.at(128, 50), 40, 1, 1.5f, 0);
        heap(world, 4, 64, 28, 90, 0.9f, 1.3f, 31, 100);
        heap(world, 132, 64, 156, 90, 0.9f, 1.3f, 32, 100);
        world.add(60, 70, 4, 24);
    }

    /** Soft rings fall down a stair of pegs. */
    private static void blobs(World world) {
        world.setGravity(0, -28);
        for (int row = 0; row < 3; row++) {
            for (float x = 16 + 16 * (row % 2); x < 156; x += 32) {
                world.terrain().addArc(x, 20 + 17 * row, 3, 0, 2 * (float) Math.PI, ArcSide.OUTER);
            }
        }
        world.kind(0).setFriction(0.4f);
        int count = 24;
        float side = 2 * 5.5f * (float) StrictMath.sin(Math.PI / count); // from circle to circle
        for (int k = 0; k < 14; k++) {
            float y = 76 + 15 * (k / 7);
            JointedCircles blob = Blobs.ring(world, 14 + 22 * (k % 7), y, 5.5f, count, 0.45f * side, 0.4f, 10, 0.7f);
            for (int skin = 0; skin < count; skin++) { // nothing slips between its circles
                world.joints().setLimits(blob.joints()[skin], side, side);
            }
            BlobShapes.tag(world, blob, k);
        }
    }

    /** A heavy ball on a chain swings into a wall of balls. */
    private static void wreckingBall(World world) {
        world.kind(0).setFriction(0.6f).setRollingResistance(0.05f);
        long ball = world.add(16, 90, 7, 150);
        Ropes.rope(world, Ropes.at(68, 90), Ropes.circle(ball), 18, 0.9f, 1, 0);
        for (int column = 0; column < 14; column++) {
            for (int row = 0; row < 16; row++) {
                world.add(90 + 3 * column + (row % 2 == 0 ? 0 : 1.5f), 1.5f + 2.61f * row, 1.5f, 2.25f);
            }
        }
        wall(world, 86, 0, 86, 8, 0);
    }

    private static void pegs(World world) {
        for (int row = 0; row < 9; row++) {
            for (int column = 0; column < 25; column++) {
                float x = 8 + 6 * column + 3 * (row % 2);
                if (x < 155) {
                    world.add(x, 32 + 5 * row, 0.7f, FIXED);
                }
            }
        }
        for (int wall = 1; wall < 14; wall++) {
            world.terrain().addSegment(160f * wall / 14, 0, 160f * wall / 14, 22, 0.5f, 0);
        }
        heap(world, 40, 80, 120, 98, 0.7f, 0.9f, 7, 900);
    }

    private static void marbles(World world) {
        Random random = new Random(8);
        for (int k = 0; k < 40; k++) {
            float r = 2.5f + 3.5f * random.nextFloat();
            float x = 10 + 18 * (k % 8) + 4 * random.nextFloat();
            float y = 12 + 17 * (k / 8) + 3 * random.nextFloat();
            long marble = world.add(x, y, r, r * r, 30 * random.nextFloat() - 15, 0);
            world.setRestitution(marble, 0.85f);
        }
    }

    /** A hundred thousand grains lie still on a table that is seen from above, and a ball rolls through. */
    private static void rest(World world) {
        world.setGravity(0, 0);
        world.kind(0).setDamping(20).setRestitution(0);
        world.kind(BALL).setDamping(0.4f);
        Random random = new Random(12);
        float[] grains = new float[4 * 100_000];
        int at = 0;
        for (int row = 0; at < grains.length; row++) {
            float y = 0.2f + 0.368f * row;
            for (float x = 0.2f + 0.2f * random.nextFloat(); x < 159.8f && at < grains.length; x += 0.427f) {
                float r = 0.12f + 0.04f * random.nextFloat();
                if (Math.hypot(x - 12, y - 24) > 2.2) { // the ball's place
                    grains[at++] = x;
                    grains[at++] = y;
                    grains[at++] = r;
                    grains[at++] = r * r;
                }
            }
        }
        world.addAll(grains, null);
        world.step(1, 2); // all sleep after a second in which nothing moves
        world.add(12, 24, 2, 400, 18, 8, BALL);
    }

    /** Circles in rows, a little out of line, from below to above. */
    private static void heap(
            World world,
            float left,
            float bottom,
            float right,
            float top,
            float least,
            float most,
            int seed,
            int count) {
        Random random = new Random(seed);
        float pitch = 2 * most + 0.1f;
        int room = count;
        for (float y = bottom + most; y <= top - most; y += pitch * 0.87f) {
            float shift = pitch / 2 * random.nextFloat();
            for (float x = left + most + shift; x <= right - most && room > 0; x += pitch) {
                float r = least + (most - least) * random.nextFloat();
                world.add(x, y, r, r * r);
                room--;
            }
        }
    }

    private static void wall(World world, float x, float y, float toX, float toY, int kind) {
        world.terrain().addSegment(x, y, toX, toY, WALL_RADIUS, kind);
    }
}
