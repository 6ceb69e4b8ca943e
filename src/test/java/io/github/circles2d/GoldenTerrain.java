package io.github.circles2d;

import io.github.circles2d.reference.ChainShape;

/** The terrain of a scene on record, in the unit arena: what is there at first, and what a caller does to it. Pieces and bodies have the lowest ids. */
@FunctionalInterface
interface GoldenTerrain {
    GoldenTerrain NONE = world -> {};

    float PI = (float) Math.PI;

    /** The kind of pieces that circles pass from behind. */
    int ONE_WAY = 1;

    /** The kind of pieces off which all bounces. */
    int BUMPER = 2;

    /** The kind of pieces whose surface runs. */
    int BELT = 3;

    int GROUND = 0;

    /** Adds it to a world. */
    void build(WorldCalls world);

    /** The handle of the body that got an id first. */
    private static long body(int id) {
        return 1L << 32 | 1 << 28 | id;
    }

    private static void line(WorldCalls world, float x1, float y1, float x2, float y2) {
        world.addSegment(GROUND, x1, y1, x2, y2, 0f, 0);
    }

    private static void chain(
            WorldCalls world, long body, boolean closed, int kind, float x, float y, float[]... ways) {
        world.addChain(body, new ChainShape(x, y, ways, closed), kind, new long[ways.length + 1]);
    }

    /** An end of a line, or the centre of an arc and its angle. */
    private static float[] to(float... way) {
        return way;
    }

    /** Loose segments; the circles of a pile are in both halves. */
    static void hourglass(WorldCalls world) {
        for (int side = -1; side <= 1; side += 2) {
            line(world, 0.5f + 0.5f * side, 0.9f, 0.5f + 0.04f * side, 0.5f);
            line(world, 0.5f + 0.04f * side, 0.5f, 0.5f + 0.04f * side, 0.46f);
            line(world, 0.5f + 0.04f * side, 0.46f, 0.5f + 0.5f * side, 0.1f);
        }
        line(world, 0.3f, 0.95f, 0.7f, 0.85f);
    }

    /** A drum with twelve paddles that turns. */
    static void drum(WorldCalls world) {
        long drum = world.addBody(0.5f, 0.5f, 0.1f);
        world.addArc(drum, 0f, 0f, 0.49f, 0f, 2f * PI, ArcSide.INNER, 0);
        for (int k = 0; k < 12; k++) {
            float x = (float) StrictMath.cos(k * StrictMath.PI / 6);
            float y = (float) StrictMath.sin(k * StrictMath.PI / 6);
            world.addSegment(drum, 0.34f * x, 0.34f * y, 0.48f * x, 0.48f * y, 0.003f, 0);
        }
        world.setBodyVelocity(drum, 0f, 0f, 0.8f);
    }

    /** A table with a round top, bumpers, two flippers (bodies 1 and 2) and a spinner (body 3). */
    static void pinball(WorldCalls world) {
        world.setKindRestitution(BUMPER, 1f);
        chain(
                world,
                GROUND,
                true,
                0,
                0.1f,
                0.2f,
                to(0.1f, 0.6f),
                to(0.5f, 0.6f, -PI),
                to(0.9f, 0.2f),
                to(0.6f, 0.05f),
                to(0.4f, 0.05f));
        for (int k = 0; k < 5; k++) {
            float x = 0.26f + 0.12f * k;
            world.addArc(GROUND, x, 0.55f + 0.1f * (k % 2), 0.035f, 0f, 2f * PI, ArcSide.OUTER, BUMPER);
        }
        world.addArc(GROUND, 0.2f, 0.4f, 0.05f, -1f, 2f, ArcSide.OUTER, BUMPER);
        for (int side = -1; side <= 1; side += 2) {
            long flipper = world.addBody(0.5f + 0.2f * side, 0.2f, 0f);
            world.addSegment(flipper, 0f, 0f, -0.14f * side, -0.03f, 0.008f, 0);
        }
        long spinner = world.addBody(0.5f, 0.4f, 0f);
        world.addSegment(spinner, -0.08f, 0f, 0.08f, 0f, 0.004f, 0);
        world.setBodyVelocity(spinner, 0f, 0f, 6f);
    }

    /** The flippers strike, and go back. */
    static void flip(GoldenScene.Run run) {
        float omega = run.steps() / GoldenChange.PERIOD % 2 == 0 ? 9f : -9f;
        run.calls().setBodyVelocity(body(1), 0f, 0f, omega);
        run.calls().setBodyVelocity(body(2), 0f, 0f, -omega);
    }

    /** A wave of arcs and lines, with sharp edges and round ones, from right to left. */
    static void halfPipes(WorldCalls world) {
        chain(
                world,
                GROUND,
                false,
                0,
                1f,
                0.5f,
                to(0.9f, 0.5f),
                to(0.75f, 0.5f, -PI),
                to(0.55f, 0.5f, 2f),
                to(0.45f, 0.3f),
                to(0.4f, 0.42f),
                to(0.38f, 0.2f),
                to(0.2f, 0.2f, -0.5f * PI),
                to(0.1f, 0.3f),
                to(0f, 0.6f));
        world.addArc(GROUND, 0.5f, 0.85f, 0.12f, PI, 2f * PI, ArcSide.INNER, 0);
        world.addArc(GROUND, 0.2f, 0.85f, 0.1f, 0.2f, 2.9f, ArcSide.OUTER, 0);
    }

    /** Lifts (bodies 1 to 3) that circles pass from below, and shelves that they pass, too. */
    static void lifts(WorldCalls world) {
        world.setOneWay(ONE_WAY, true);
        for (int k = 0; k < 3; k++) {
            long lift = world.addBody(0.2f + 0.3f * k, 0.3f + 0.1f * k, 0f);
            world.addSegment(lift, 0.12f, 0f, -0.12f, 0f, 0f, ONE_WAY);
            world.addSegment(lift, 0.12f, 0.03f, 0.12f, 0f, 0.004f, 0);
        }
        for (int k = 0; k < 4; k++) {
            world.addSegment(
                    GROUND, 0.3f + 0.25f * k, 0.15f + 0.2f * k, 0.05f + 0.25f * k, 0.2f * k + 0.2f, 0f, ONE_WAY);
        }
        chain(world, GROUND, false, ONE_WAY, 0.95f, 0.3f, to(0.8f, 0.25f), to(0.7f, 0.3f, -1f), to(0.5f, 0.2f));
    }

    /** The lifts go up and down, at different speeds, and one leans. */
    static void lift(GoldenScene.Run run) {
        int change = run.steps() / GoldenChange.PERIOD;
        for (int k = 0; k < 3; k++) {
            float speed = change / (2 + k) % 2 == 0 ? 0.3f : -0.3f;
            run.calls().setBodyVelocity(body(1 + k), 0f, speed, k == 1 ? speed : 0f);
        }
        if (change % 9 == 4) {
            run.calls().moveBodyTo(body(3), 0.8f, 0.5f, 0f);
        }
    }

    /** Pieces of all kinds and sizes, larger and smaller than circles. */
    static void rubble(WorldCalls world) {
        for (int k = 0; k < 60; k++) {
            float x = 0.05f + 0.9f * (k * 0.618034f % 1f);
            float y = 0.05f + 0.9f * (k * 0.414214f % 1f);
            float size = 0.01f + 0.002f * k;
            float a = 0.7f * k;
            float dx = size * (float) StrictMath.cos(a);
            float dy = size * (float) StrictMath.sin(a);
            switch (k % 5) {
                case 0 -> line(world, x - dx, y - dy, x + dx, y + dy);
                case 1 -> world.addSegment(GROUND, x, y, x + dx, y + dy, 0.2f * size, 0);
                case 2 -> world.addArc(GROUND, x, y, size, a, a + 0.1f * (k + 1), ArcSide.OUTER, 0);
                case 3 -> world.addArc(GROUND, x, y, size, a, a + 0.1f * (k + 1), ArcSide.INNER, 0);
                default ->
                    chain(
                            world,
                            GROUND,
                            true,
                            0,
                            x + dx,
                            y + dy,
                            to(x - dy, y + dx),
                            to(x - dx, y - dy, 1.5f),
                            to(x + dy, y - dx));
            }
        }
    }

    /** Slopes one above the other, of which some run. */
    static void slopes(WorldCalls world) {
        world.setSurface(BELT, 0.8f, 0.02f, -0.2f);
        for (int k = 0; k < 6; k++) {
            float y = 0.15f + 0.13f * k;
            float lean = 0.02f + 0.012f * k;
            boolean right = k % 2 == 0;
            int kind = k % 3 == 2 ? BELT : 0;
            world.addSegment(GROUND, right ? 0.15f : 0f, y + (right ? -lean : lean), right ? 1f : 0.85f, y, 0f, kind);
        }
        chain(world, GROUND, false, 0, 1f, 0.12f, to(0.7f, 0.03f), to(0.3f, 0.03f), to(0f, 0.12f));
    }

    /** Pieces across the seams of axes that wrap, and bodies that cross them. */
    static void seams(WorldCalls world) {
        world.addSegment(GROUND, 0.9f, 0.3f, 1.15f, 0.35f, 0f, 0);
        world.addSegment(GROUND, 0.5f, -0.1f, 0.55f, 0.15f, 0.01f, 0);
        world.addArc(GROUND, 0f, 0f, 0.12f, 0f, 2f * PI, ArcSide.OUTER, 0);
        world.addArc(GROUND, 1f, 0.6f, 0.15f, 1f, 5f, ArcSide.INNER, 0);
        chain(world, GROUND, true, 0, 0.3f, 0.95f, to(0.2f, 1.05f), to(0.1f, 0.95f));
        for (int k = 0; k < 3; k++) {
            long body = world.addBody(0.2f + 0.3f * k, 0.8f, k);
            world.addSegment(body, -0.1f, 0f, 0.1f, 0f, 0f, 0);
            world.addArc(body, 0f, 0.05f, 0.03f, 0f, 2f * PI, ArcSide.OUTER, 0);
            world.setBodyVelocity(body, 0.3f * (k - 1), 0.2f * (k + 1), 2f * k - 1f);
        }
    }

    /** Pieces go and come, and bodies jump, while circles lie on them. */
    static void rebuild(GoldenScene.Run run) {
        WorldCalls world = run.calls();
        int change = run.steps() / GoldenChange.PERIOD;
        float at = 0.1f + 0.8f * (change * 0.618034f % 1f);
        switch (change % 6) {
            case 0 -> world.addSegment(GROUND, at, 0.05f, 0.5f, 0.3f, 0.005f, 0);
            case 1 -> world.addSegment(GROUND, 0f, 0.2f + 0.5f * at, at, 0.2f, 0f, 0);
            case 2 -> world.teleportBody(body(1), at, 0.3f, at);
            case 3 -> world.setBodyVelocity(body(1), 0.5f - at, 0.1f, 1f - 2f * at);
            case 4 -> world.moveBodyTo(body(1), at, 0.4f, 2f * at);
            default -> {
                world.setPairs(4, 1, change % 12 == 5 ? 0 : -1, false);
                world.addArc(GROUND, at, 0.1f, 0.08f, 0f, PI, ArcSide.OUTER, 4);
            }
        }
    }

    /** A body that {@link #rebuild} moves, on a floor of short lines. */
    static void floor(WorldCalls world) {
        float[][] ways = new float[40][];
        for (int k = 0; k < ways.length; k++) {
            ways[k] = to(1f - (k + 1) / 40f, 0.04f + 0.01f * (k * k % 7 % 3));
        }
        chain(world, GROUND, false, 0, 1f, 0.04f, ways);
        long body = world.addBody(0.5f, 0.4f, 0.3f);
        chain(world, body, true, 0, 0.1f, 0.05f, to(-0.1f, 0.05f), to(-0.1f, 0f, PI), to(0.1f, -0.05f));
    }
}
