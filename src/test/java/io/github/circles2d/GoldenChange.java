package io.github.circles2d;

import io.github.circles2d.scenes.Scene;
import java.util.SplittableRandom;

/** What a caller does to a scene every few steps while it runs. */
@FunctionalInterface
interface GoldenChange {
    /** The steps between two changes. */
    int PERIOD = 7;

    /** No change: the steps up to a mark are made by one call. */
    GoldenChange NONE = run -> {};

    /** Changes the world of a run, or the time step of the steps to come. */
    void apply(GoldenScene.Run run);

    /** Some circles go, as many come, some are pushed, moved, resized or get another restitution. */
    static void churn(GoldenScene.Run run) {
        Scene scene = run.scene();
        WorldCalls world = run.calls();
        SplittableRandom random = run.random();
        int n = world.size();
        long[] handles = run.readHandles();
        float[] circles = run.readCircles();
        float width = scene.maxX() - scene.minX();
        float height = scene.maxY() - scene.minY();
        for (int k = 0; k < 5; k++) {
            int gone = random.nextInt(n);
            if (world.contains(handles[gone])) {
                world.remove(handles[gone]);
                float x = scene.minX() + unit(random) * width;
                float y = scene.minY() + unit(random) * height;
                world.add(x, y, circles[4 * gone + 2], circles[4 * gone + 3], 0, 0);
            }
        }
        int some = random.nextInt(n);
        if (world.contains(handles[some])) {
            float mass = circles[4 * some + 3];
            world.applyImpulse(handles[some], 0.1f * (unit(random) - 0.5f) * mass, 0.1f * unit(random) * mass);
        }
        some = random.nextInt(n);
        if (world.contains(handles[some])) {
            world.setPosition(handles[some], scene.minX() + unit(random) * width, scene.minY() + unit(random) * height);
            world.setVelocity(
                    handles[some], 0.5f * width * (unit(random) - 0.5f), 0.5f * height * (unit(random) - 0.5f));
        }
        some = random.nextInt(n);
        if (world.contains(handles[some])) {
            world.setRadius(handles[some], circles[4 * some + 2] * (0.75f + 0.25f * unit(random)));
            world.setMass(handles[some], 0.5f * circles[4 * some + 3]);
            world.setRestitution(handles[some], unit(random));
        }
    }

    /** The time step becomes another one between 1/240 and 1/30 s. */
    static void timeStep(GoldenScene.Run run) {
        run.setTimeStep(1f / 240 + (1f / 30 - 1f / 240) * unit(run.random()));
    }

    /** The static circles set out for places that they reach by the next change; some of them lie outside the bounds. */
    static void paddles(GoldenScene.Run run) {
        Scene scene = run.scene();
        float perSecond = 1 / (PERIOD * scene.timeStep());
        long[] handles = run.readHandles();
        float[] circles = run.readCircles();
        for (int i = 0; i < run.calls().size(); i++) {
            if (circles[4 * i + 3] == Float.POSITIVE_INFINITY) {
                float x = scene.minX() + (1.1f * unit(run.random()) - 0.05f) * (scene.maxX() - scene.minX());
                float y = scene.minY() + (1.1f * unit(run.random()) - 0.05f) * (scene.maxY() - scene.minY());
                run.calls()
                        .setVelocity(
                                handles[i], (x - circles[4 * i]) * perSecond, (y - circles[4 * i + 1]) * perSecond);
            }
        }
    }

    /** The static circles turn round when they have passed three quarters of the arena, or are near its floor. */
    static void turn(GoldenScene.Run run) {
        long[] handles = run.readHandles();
        float[] circles = run.readCircles();
        for (int i = 0; i < run.calls().size(); i++) {
            float y = circles[4 * i + 1];
            if (circles[4 * i + 3] == Float.POSITIVE_INFINITY && (y > 0.75f || y < 0.1f)) {
                float speed = 2 * circles[4 * i + 2] / run.scene().timeStep();
                run.calls().setVelocity(handles[i], 0, y > 0.75f ? -speed : speed);
            }
        }
    }

    /** Half of the static circles are set to places up to four of their radii away, and some of the others anywhere. */
    static void drag(GoldenScene.Run run) {
        Scene scene = run.scene();
        SplittableRandom random = run.random();
        long[] handles = run.readHandles();
        float[] circles = run.readCircles();
        for (int i = 0; i < run.calls().size(); i++) {
            float radius = circles[4 * i + 2];
            if (circles[4 * i + 3] != Float.POSITIVE_INFINITY) {
                continue;
            }
            int kind = random.nextInt(16);
            if (kind < 8) {
                float x = circles[4 * i] + 8 * radius * (unit(random) - 0.5f);
                float y = circles[4 * i + 1] + 8 * radius * (unit(random) - 0.5f);
                run.calls().setPosition(handles[i], inside(x, scene), inside(y, scene));
            } else if (kind == 8) {
                run.calls().setPosition(handles[i], unit(random), unit(random));
            } else if (kind == 9) {
                run.calls().teleport(handles[i], unit(random), unit(random));
            }
        }
    }

    private static float inside(float coordinate, Scene scene) {
        return Math.max(scene.minX(), Math.min(coordinate, scene.maxX()));
    }

    /** Every tenth radius grows at once, early and again when the circles have come to rest, then another tenth of them. */
    static void growth(GoldenScene.Run run) {
        int first = run.steps() == 2 * PERIOD ? 0 : 5;
        if (run.steps() == 2 * PERIOD || run.steps() == 30 * PERIOD) {
            long[] handles = run.readHandles();
            float[] circles = run.readCircles();
            for (int i = first; i < run.calls().size(); i += 10) {
                run.calls().setRadius(handles[i], 1.6f * circles[4 * i + 2]);
            }
        }
    }

    /** Circles get kinds, groups and forces, and what kinds do to each other changes while they touch. */
    static void kinds(GoldenScene.Run run) {
        WorldCalls world = run.calls();
        SplittableRandom random = run.random();
        int n = world.size();
        long[] handles = run.readHandles();
        for (int k = 0; k < n / 16; k++) {
            world.setKind(handles[random.nextInt(n)], random.nextInt(4));
            world.setGroup(handles[random.nextInt(n)], random.nextInt(3));
        }
        for (int k = 0; k < 8; k++) {
            world.setForce(handles[random.nextInt(n)], 20 * unit(random) - 10, 10 * unit(random));
            world.applyForce(handles[random.nextInt(n)], 200 * unit(random) - 100, 0);
        }
        switch (random.nextInt(5)) {
            case 4 -> world.setMotion(random.nextInt(4), 2 * unit(random), unit(random), 1 + unit(random));
            case 0 -> world.setResponse(random.nextInt(4), random.nextInt(4), Response.values()[random.nextInt(4)]);
            case 1 -> world.setPairs(1, 1 << random.nextInt(2), -1 - random.nextInt(3), false);
            case 2 -> world.setPairs(2, 2, 3, random.nextInt(8) == 0);
            default -> world.setKindRestitution(3, unit(random));
        }
    }

    /** Some circles, static ones among them, get other angular velocities, and some are spun. */
    static void spin(GoldenScene.Run run) {
        WorldCalls world = run.calls();
        SplittableRandom random = run.random();
        int n = world.size();
        long[] handles = run.readHandles();
        float[] circles = run.readCircles();
        for (int k = 0; k <= n / 16; k++) {
            int some = random.nextInt(n);
            world.setAngularVelocity(handles[some], 60 * (unit(random) - 0.5f));
            some = random.nextInt(n);
            if (circles[4 * some + 3] < Float.POSITIVE_INFINITY) {
                float inertia = circles[4 * some + 3] * circles[4 * some + 2] * circles[4 * some + 2];
                world.applyAngularImpulse(handles[some], 5 * inertia * (unit(random) - 0.5f));
            }
        }
        for (int i = 0; i < n; i++) {
            if (circles[4 * i + 3] == Float.POSITIVE_INFINITY && random.nextInt(4) == 0) {
                world.setAngularVelocity(handles[i], 20 * (unit(random) - 0.5f));
            }
        }
    }

    /** Circles get surfaces of their own or other kinds, torques and angles, and kinds and walls other surfaces, belts and inertias. */
    static void belts(GoldenScene.Run run) {
        WorldCalls world = run.calls();
        SplittableRandom random = run.random();
        int n = world.size();
        long[] handles = run.readHandles();
        float[] circles = run.readCircles();
        for (int k = 0; k < n / 16; k++) {
            int some = random.nextInt(n);
            float inertia = circles[4 * some + 3] * circles[4 * some + 2] * circles[4 * some + 2];
            switch (random.nextInt(6)) {
                case 0 -> world.setFriction(handles[some], random.nextInt(3) == 0 ? Float.NaN : 1.5f * unit(random));
                case 1 -> world.setRollingResistance(handles[some], random.nextInt(3) == 0 ? Float.NaN : unit(random));
                case 2 -> world.setTorque(handles[some], 100 * inertia * (unit(random) - 0.5f));
                case 3 -> world.applyTorque(handles[some], 1000 * inertia * (unit(random) - 0.5f));
                case 4 -> world.setAngle(handles[some], 10 * (unit(random) - 0.5f));
                default -> world.setKind(handles[some], random.nextInt(4));
            }
        }
        float speed = 0.4f * (unit(random) - 0.5f);
        switch (random.nextInt(3)) {
            case 0 -> {
                Wall wall = Wall.values()[random.nextInt(4)];
                boolean towardsLesser =
                        wall == Wall.MIN_X || wall == Wall.MAX_Y; // the recorded hashes are of belts towards greater
                world.setWallSurface(wall, unit(random), 0.1f * unit(random), towardsLesser ? -speed : speed);
            }
            case 1 -> world.setSurface(1 + random.nextInt(3), unit(random), 0.1f * unit(random), -speed);
            default -> world.setTurning(1 + random.nextInt(3), Inertia.values()[random.nextInt(3)], unit(random));
        }
    }

    /** Every wall goes to a place beside its own: some way in, farther than some circles are large. */
    static void walls(GoldenScene.Run run) {
        Scene scene = run.scene();
        float most = 0.03f * (scene.maxX() - scene.minX());
        run.calls()
                .setBounds(
                        scene.minX() + most * unit(run.random()),
                        scene.minY() + most * unit(run.random()),
                        scene.maxX() - most * unit(run.random()),
                        scene.maxY() - most * unit(run.random()));
    }

    static float unit(SplittableRandom random) {
        return random.nextInt(1 << 24) * 0x1p-24f;
    }
}
