package io.github.circles2d.playground;

import io.github.circles2d.ArcSide;
import io.github.circles2d.Chain;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.Wall;
import io.github.circles2d.World;
import io.github.circles2d.scenes.Scenes;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/** The stages of the menu: some to play with, and the published scenes. */
final class Stages {
    private static final float FIXED = Float.POSITIVE_INFINITY;
    private static final float GRAVITY = 60;

    // Kinds of terrain and static circles.
    private static final int BELT = 1;
    private static final int ROLLER = 2;
    private static final int ICE = 3;

    /** The kind of a circle that goes on where others come to rest. */
    private static final int BALL = 4;

    private static final List<Stage> ALL = List.of(
            own("sandbox", Stages::sandbox),
            own("hourglass", Stages::hourglass),
            own("pegs", Stages::pegs),
            own("marbles", Stages::marbles),
            own("crowd", builder -> builder.friction(0.6f).rollingResistance(0.02f), Stages::crowd),
            own("rest", builder -> builder.gravity(0, 0), Stages::rest),
            own("slopes-and-belts", builder -> builder.friction(0.6f).rollingResistance(0.01f), Stages::slopesAndBelts),
            own("drum", builder -> builder.friction(0.5f), Stages::drum),
            own("bridge", JointStages::bridge),
            own("blobs", builder -> builder.friction(0.4f).gravity(0, -28), JointStages::blobs),
            own("cloth", JointStages::cloth),
            own("wrecking-ball", builder -> builder.friction(0.6f).rollingResistance(0.05f), JointStages::wreckingBall),
            pushed("tower", BodyStages::tower),
            pushed("crates", BodyStages::crates),
            pushed("dominoes", BodyStages::dominoes),
            pushed("see-saw", BodyStages::seeSaw),
            pushed("shapes", BodyStages::shapes),
            own("empty", world -> {}),
            Stage.of("thesis", () -> Scenes.thesis(Scenes.THESIS_SIZE, Scenes.SEED)),
            Stage.of("packed", () -> Scenes.packed(10_000, Scenes.SEED)),
            Stage.of("gas", () -> Scenes.gas(2_500, Scenes.SEED)),
            Stage.of("pyramid", Scenes::pyramid),
            Stage.of("barrel", () -> Scenes.barrel(Scenes.SEED)),
            Stage.of("balls2", Scenes::balls2),
            Stage.of("confined", Scenes::confined),
            Stage.of("restitution", Scenes::restitution),
            Stage.of("nexus-balls2", Scenes::nexusBalls2),
            Stage.of("bouncy", () -> Scenes.bouncy(Scenes.SEED)),
            Stage.of("no-collide", Scenes::noCollide),
            Stage.of("billiards", () -> Scenes.billiards(10)),
            Stage.of("mixed", () -> Scenes.mixed(2_500, Scenes.SEED)),
            Stage.of("one-cell", () -> Scenes.oneCell(1_000, Scenes.SEED)));

    private Stages() {}

    static List<Stage> all() {
        return ALL;
    }

    /** The stage of that name; null if there is none. */
    static Stage named(String name) {
        return ALL.stream()
                .filter(stage -> stage.name().equals(name))
                .findFirst()
                .orElse(null);
    }

    private static Stage own(String name, Consumer<World> circles) {
        return own(name, builder -> builder, circles);
    }

    private static Stage own(String name, UnaryOperator<World.Builder> more, Consumer<World> circles) {
        return new Stage(
                name,
                false,
                () -> more.apply(World.builder()
                        .bounds(0, 0, 160, 100)
                        .gravity(0, -GRAVITY)
                        .restitution(0.3f)
                        .sleep(true)),
                circles);
    }

    /** A stage with bodies. */
    private static Stage pushed(String name, Consumer<World> circles) {
        return own(name, builder -> builder.friction(0.6f).restitution(0.1f), circles);
    }

    /** A pile between two ramps, and a basin. */
    private static void sandbox(World world) {
        wall(world, 4, 72, 62, 52);
        wall(world, 156, 60, 92, 40);
        world.terrain().addBody(62, 24.8f, 0).addChain(basin(24, 0.8f, 200, 340));
        heap(world, 6, 76, 56, 98, 0.7f, 1.1f, 2);
        heap(world, 104, 64, 154, 98, 0.7f, 1.1f, 3);
        world.add(62, 9, 5, 60);
        world.add(120, 8, 7, 110);
    }

    /** Sand that runs through a neck. Whoever holds the glass can turn it over. */
    private static void hourglass(World world) {
        Chain glass = Chain.from(-30, 38).lineTo(30, 38).lineTo(30, 32); // clockwise: the sand is inside
        glass.lineTo(3.532f, 2.682f).arcTo(6.5f, 0, 1.469f).lineTo(30, -32).lineTo(30, -38);
        glass.lineTo(-30, -38).lineTo(-30, -32);
        glass.lineTo(-3.532f, -2.682f).arcTo(-6.5f, 0, 1.469f).lineTo(-30, 32).close();
        world.terrain().addBody(80, 50, 0).addChain(glass);
        for (int row = 0; row < 22; row++) {
            float y = 56 + 1.41f * row;
            float half = Math.min(30, 4 + 26 * (y - 52) / 30) - 1;
            heap(world, 80 - half, y, 80 + half, y + 1.41f, 0.5f, 0.7f, 5 + row);
        }
    }

    /** A board of nails, above bins. */
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
        heap(world, 40, 80, 120, 98, 0.7f, 0.9f, 7);
    }

    /** A few large and lively ones. */
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

    /** Balls roll down a slope, and a belt takes them up to rollers; behind these they slide down ice onto the floor, which runs back. */
    private static void slopesAndBelts(World world) {
        world.kind(BELT).setFriction(1).setBeltSpeed(24);
        world.kind(ROLLER).setFriction(1);
        world.kind(ICE).setFriction(0);
        world.setWallSurface(Wall.MIN_Y, 0.6f, 0.01f, 16);
        wall(world, 2, 82, 52, 66);
        wall(world, 54, 62, 112, 72, BELT);
        for (int k = 0; k < 7; k++) {
            long roller = world.add(150 - 7.5f * k, 56 - 0.7f * k, 3.2f, FIXED, 0, 0, ROLLER);
            world.setAngularVelocity(roller, 6);
        }
        wall(world, 98, 46, 52, 28, ICE);
        wall(world, 156, 66, 156, 58);
        heap(world, 4, 84, 48, 99, 1, 1.6f, 10);
        heap(world, 20, 2, 140, 12, 1, 1.6f, 11);
    }

    /** A drum with paddles that turns, half full. */
    private static void drum(World world) {
        TerrainBody drum = world.terrain().addBody(80, 50, 0);
        drum.addArc(0, 0, 46, 0, 2 * (float) Math.PI, ArcSide.INNER);
        for (int k = 0; k < 8; k++) {
            float x = (float) StrictMath.cos(k * Math.PI / 4);
            float y = (float) StrictMath.sin(k * Math.PI / 4);
            drum.addSegment(46 * x, 46 * y, 37 * x, 37 * y, 0.6f, 0);
        }
        drum.setAngularVelocity(0.5f);
        for (int row = 0; row < 20; row++) {
            float y = 16 + 2.4f * row;
            float half = (float) Math.sqrt(34 * 34 - (y - 50) * (y - 50)) - 2;
            heap(world, 80 - half, y, 80 + half, y + 2.4f, 0.8f, 1.1f, 20 + row);
        }
    }

    /** Ten thousand. */
    private static void crowd(World world) {
        heap(world, 1, 1, 159, 99, 0.44f, 0.58f, 9);
    }

    /** A hundred thousand grains lie still on a table that is seen from above, and a ball rolls through. */
    private static void rest(World world) {
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

    /** Circles in rows, a little apart and a little out of line. */
    static void heap(World world, float left, float bottom, float right, float top, float least, float most, int seed) {
        Random random = new Random(seed);
        float pitch = 2 * most + 0.15f;
        for (float y = bottom + most; y <= top - most; y += pitch * 0.87f) {
            float shift = pitch / 2 * random.nextFloat();
            for (float x = left + most + shift; x <= right - most; x += pitch) {
                float r = least + (most - least) * random.nextFloat();
                world.add(x, y, r, r * r);
            }
        }
    }

    /** A thick segment, which can be moved and turned around its middle. */
    static void wall(World world, float x, float y, float toX, float toY) {
        wall(world, x, y, toX, toY, 0);
    }

    private static void wall(World world, float x, float y, float toX, float toY, int kind) {
        float halfX = (toX - x) / 2;
        float halfY = (toY - y) / 2;
        world.terrain().addBody(x + halfX, y + halfY, 0).addSegment(-halfX, -halfY, halfX, halfY, 0.8f, kind);
    }

    /** A part of a ring, with round ends: anticlockwise along the outer arc, and back along the inner one. */
    private static Chain basin(float radius, float thickness, int fromDegrees, int toDegrees) {
        double from = Math.toRadians(fromDegrees);
        double to = Math.toRadians(toDegrees);
        float outer = radius + thickness;
        float half = (float) Math.PI;
        return Chain.from(outer * (float) StrictMath.cos(from), outer * (float) StrictMath.sin(from))
                .arcTo(0, 0, (float) (to - from))
                .arcTo(radius * (float) StrictMath.cos(to), radius * (float) StrictMath.sin(to), half)
                .arcTo(0, 0, (float) (from - to))
                .arcTo(radius * (float) StrictMath.cos(from), radius * (float) StrictMath.sin(from), half)
                .close();
    }
}
