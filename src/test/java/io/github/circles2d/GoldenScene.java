package io.github.circles2d;

import io.github.circles2d.reference.Surfaces;
import io.github.circles2d.scenes.BodyScenes;
import io.github.circles2d.scenes.HardScenes;
import io.github.circles2d.scenes.JointedScenes;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.SceneLoader;
import io.github.circles2d.scenes.Scenes;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A scene whose hashes are on record, and what a caller does to it while it runs.
 *
 * @param name the name on record
 * @param scene the start
 * @param change what a caller does every few steps
 * @param edgeX what there is at the left and the right edge
 * @param edgeY what there is at the lower and the upper edge
 * @param surfaces what circles and walls touch each other with
 * @param terrain what there is besides circles: terrain, joints, bodies that are pushed
 * @param sleeps whether circles fall asleep
 * @param bodies how many bodies that are pushed there are, about
 */
record GoldenScene(
        String name,
        Scene scene,
        GoldenChange change,
        Edge edgeX,
        Edge edgeY,
        Surfaces surfaces,
        GoldenTerrain terrain,
        boolean sleeps,
        int bodies) {
    /** What a body that is pushed costs in a step, in circles. */
    private static final int COST_OF_BODY = 10;

    /** A scene in which nobody sleeps. */
    GoldenScene(
            String name,
            Scene scene,
            GoldenChange change,
            Edge edgeX,
            Edge edgeY,
            Surfaces surfaces,
            GoldenTerrain terrain) {
        this(name, scene, change, edgeX, edgeY, surfaces, terrain, false, 0);
    }

    /** A scene without terrain. */
    GoldenScene(String name, Scene scene, GoldenChange change, Edge edgeX, Edge edgeY, Surfaces surfaces) {
        this(name, scene, change, edgeX, edgeY, surfaces, GoldenTerrain.NONE);
    }

    /** A scene with walls all around, and terrain. */
    GoldenScene(String name, Scene scene, GoldenChange change, Surfaces surfaces, GoldenTerrain terrain) {
        this(name, scene, change, Edge.WALL, Edge.WALL, surfaces, terrain);
    }

    /** A scene with walls all around. */
    GoldenScene(String name, Scene scene, GoldenChange change) {
        this(name, scene, change, Surfaces.NONE);
    }

    /** A scene with walls all around, in which surfaces grip. */
    GoldenScene(String name, Scene scene, GoldenChange change, Surfaces surfaces) {
        this(name, scene, change, Edge.WALL, Edge.WALL, surfaces);
    }

    /** A scene in which nothing grips. */
    GoldenScene(String name, Scene scene, GoldenChange change, Edge edgeX, Edge edgeY) {
        this(name, scene, change, edgeX, edgeY, Surfaces.NONE);
    }

    static List<GoldenScene> all() {
        return List.of(
                new GoldenScene("thesis", Scenes.thesis(1250, Scenes.SEED), GoldenChange.NONE),
                new GoldenScene("packed-100000", Scenes.packed(100_000, Scenes.SEED), GoldenChange.NONE),
                new GoldenScene("packed-5000-churned", Scenes.packed(5_000, Scenes.SEED), GoldenChange::churn),
                new GoldenScene("gas", Scenes.gas(2_500, Scenes.SEED), GoldenChange.NONE),
                new GoldenScene("barrel", Scenes.barrel(Scenes.SEED), GoldenChange.NONE),
                new GoldenScene("balls2", Scenes.balls2(), GoldenChange.NONE),
                new GoldenScene("mixed-churned", Scenes.mixed(4_000, Scenes.SEED), GoldenChange::churn),
                new GoldenScene("no-collide", Scenes.noCollide(), GoldenChange.NONE),
                new GoldenScene("billiards", Scenes.billiards(20), GoldenChange.NONE),
                new GoldenScene("bouncy-churned", Scenes.bouncy(Scenes.SEED), GoldenChange::churn),
                new GoldenScene("one-point", Scenes.onePoint(2_000, Scenes.SEED), GoldenChange.NONE),
                new GoldenScene("jam", HardScenes.jam(1_500, Scenes.SEED), GoldenChange.NONE),
                new GoldenScene("pile-time-steps", HardScenes.pile(40, 30, Scenes.SEED), GoldenChange::timeStep),
                new GoldenScene("pile-growth", HardScenes.pile(40, 30, Scenes.SEED), GoldenChange::growth),
                new GoldenScene("fence", HardScenes.fence(24, Scenes.SEED), GoldenChange.NONE),
                new GoldenScene("paddles", HardScenes.paddles(20, 30, Scenes.SEED), GoldenChange::paddles),
                new GoldenScene("pile-kinds", HardScenes.pile(40, 30, Scenes.SEED), GoldenChange::kinds),
                new GoldenScene("crowd", HardScenes.crowd(40, Scenes.SEED), GoldenChange::turn),
                new GoldenScene("dragged", HardScenes.paddles(20, 30, Scenes.SEED), GoldenChange::drag),
                new GoldenScene("pile-walls", HardScenes.pile(40, 30, Scenes.SEED), GoldenChange::walls),
                new GoldenScene("wrapped", Scenes.gas(2_500, Scenes.SEED), GoldenChange.NONE, Edge.WRAP, Edge.WRAP),
                new GoldenScene(
                        "wrapped-mixed-churned",
                        Scenes.mixed(4_000, Scenes.SEED),
                        GoldenChange::churn,
                        Edge.WRAP,
                        Edge.WALL),
                new GoldenScene("open", Scenes.billiards(20), GoldenChange.NONE, Edge.OPEN, Edge.OPEN),
                new GoldenScene(
                        "open-bouncy-churned", Scenes.bouncy(Scenes.SEED), GoldenChange::churn, Edge.OPEN, Edge.WALL),
                new GoldenScene(
                        "wrapped-open-paddles",
                        HardScenes.paddles(20, 30, Scenes.SEED),
                        GoldenChange::paddles,
                        Edge.WRAP,
                        Edge.OPEN),
                new GoldenScene("mixed-10", Scenes.mixed(100_000, 10, Scenes.SEED), GoldenChange.NONE),
                new GoldenScene("mixed-100", Scenes.mixed(10_000, 100, Scenes.SEED), GoldenChange.NONE),
                new GoldenScene("boulder", Scenes.boulder(10_000, Scenes.SEED), GoldenChange.NONE),
                new GoldenScene(
                        "slope", HardScenes.slope(40, 20, Scenes.SEED), GoldenChange.NONE, Surfaces.of(0.6f, 0.02f)),
                new GoldenScene(
                        "heap", HardScenes.heap(1_000, Scenes.SEED), GoldenChange.NONE, Surfaces.of(0.6f, 0.1f)),
                new GoldenScene("billiards-spin", Scenes.billiards(5), GoldenChange::spin, Surfaces.of(0.2f, 0f)),
                new GoldenScene(
                        "rollers",
                        HardScenes.paddles(20, 30, Scenes.SEED),
                        GoldenChange::spin,
                        Surfaces.of(0.8f, 0f).withWall(2, 0.5f, 0f, 0.3f)),
                new GoldenScene(
                        "mixed-gripping-churned",
                        Scenes.mixed(4_000, Scenes.SEED),
                        GoldenChange::churn,
                        Surfaces.of(0.6f, 0.05f)),
                new GoldenScene(
                        "pile-gripping-time-steps",
                        HardScenes.pile(40, 30, Scenes.SEED),
                        GoldenChange::timeStep,
                        Surfaces.of(0.6f, 0.1f)),
                new GoldenScene(
                        "belts",
                        HardScenes.pile(40, 30, Scenes.SEED),
                        GoldenChange::belts,
                        Surfaces.of(0.5f, 0.02f).withWall(2, 0.7f, 0.01f, -0.2f)),
                new GoldenScene(
                        "wrapped-gripping",
                        Scenes.gas(2_500, Scenes.SEED),
                        GoldenChange::spin,
                        Edge.WRAP,
                        Edge.WALL,
                        Surfaces.of(0.3f, 0f)),
                new GoldenScene(
                        "hourglass",
                        HardScenes.pile(40, 30, Scenes.SEED),
                        GoldenChange.NONE,
                        Surfaces.of(0.2f, 0f),
                        GoldenTerrain::hourglass),
                new GoldenScene(
                        "drum",
                        HardScenes.core(1_000, 0.2f, Scenes.SEED),
                        GoldenChange.NONE,
                        Surfaces.of(0.6f, 0f),
                        GoldenTerrain::drum),
                new GoldenScene(
                        "pinball",
                        HardScenes.core(60, 0.12f, Scenes.SEED),
                        GoldenTerrain::flip,
                        Surfaces.of(0.2f, 0f),
                        GoldenTerrain::pinball),
                new GoldenScene(
                        "half-pipes",
                        HardScenes.heap(1_000, Scenes.SEED),
                        GoldenChange.NONE,
                        Surfaces.of(0.6f, 0.02f),
                        GoldenTerrain::halfPipes),
                new GoldenScene(
                        "one-way-lifts",
                        HardScenes.pile(40, 20, Scenes.SEED),
                        GoldenTerrain::lift,
                        Surfaces.of(0.5f, 0f),
                        GoldenTerrain::lifts),
                new GoldenScene(
                        "mixed-rubble-churned",
                        Scenes.mixed(4_000, 10, Scenes.SEED),
                        GoldenChange::churn,
                        Surfaces.NONE,
                        GoldenTerrain::rubble),
                new GoldenScene(
                        "slopes",
                        HardScenes.pile(50, 25, Scenes.SEED),
                        GoldenChange::timeStep,
                        Surfaces.of(0.6f, 0.05f),
                        GoldenTerrain::slopes),
                new GoldenScene(
                        "floor-rebuilt",
                        HardScenes.pile(40, 30, Scenes.SEED),
                        GoldenTerrain::rebuild,
                        Surfaces.of(0.4f, 0f),
                        GoldenTerrain::floor),
                new GoldenScene(
                        "wrapped-seams",
                        Scenes.gas(2_500, Scenes.SEED),
                        GoldenChange.NONE,
                        Edge.WRAP,
                        Edge.WRAP,
                        Surfaces.NONE,
                        GoldenTerrain::seams),
                new GoldenScene(
                        "bridge",
                        JointedScenes.bridge(GoldenJoints.PLANKS, 400),
                        GoldenChange.NONE,
                        Surfaces.of(0.5f, 0f),
                        GoldenJoints::bridge),
                new GoldenScene(
                        "blobs",
                        JointedScenes.blobs(300, GoldenJoints.OF_BLOB),
                        GoldenChange.NONE,
                        Surfaces.of(0.3f, 0f),
                        GoldenJoints::blobs),
                new GoldenScene(
                        "ropes",
                        JointedScenes.ropes(40, GoldenJoints.LINKS),
                        GoldenChange.NONE,
                        Surfaces.NONE,
                        GoldenJoints::ropes),
                new GoldenScene(
                        "wheel",
                        JointedScenes.wheel(100),
                        GoldenChange::timeStep,
                        Surfaces.of(0.4f, 0f),
                        GoldenJoints::wheel),
                new GoldenScene(
                        "wrapped-joints",
                        Scenes.gas(1_000, Scenes.SEED),
                        GoldenChange.NONE,
                        Edge.WRAP,
                        Edge.WRAP,
                        Surfaces.NONE,
                        GoldenJoints::seams),
                new GoldenScene(
                        "carts",
                        JointedScenes.carts(40),
                        GoldenChange.NONE,
                        Surfaces.of(0.8f, 0f),
                        GoldenJoints::carts),
                new GoldenScene(
                        "nets-churned",
                        HardScenes.pile(40, 30, Scenes.SEED),
                        GoldenJoints::rejoin,
                        Surfaces.of(0.3f, 0f),
                        GoldenJoints::net),
                new GoldenScene("asleep-ball", heap(), GoldenSleep::ball).sleeping(),
                new GoldenScene("asleep-pour", heap(), GoldenSleep::pour, Surfaces.of(0.6f, 0.02f)).sleeping(),
                new GoldenScene("asleep-support", heap(), GoldenSleep::support, Surfaces.of(0.4f, 0.02f)).sleeping(),
                new GoldenScene("asleep-tilt", heap(), GoldenSleep::tilt, Surfaces.of(0.6f, 0.05f)).sleeping(),
                new GoldenScene("asleep-calls", heap(), GoldenSleep::calls, Surfaces.of(0.3f, 0f)).sleeping(),
                new GoldenScene("asleep-mixed", mixedHeap(), GoldenSleep::ball, Surfaces.of(0.5f, 0f)).sleeping(),
                new GoldenScene("asleep-time-steps", heap(), GoldenSleep::timeStep, Surfaces.of(0.6f, 0f)).sleeping(),
                new GoldenScene(
                                "asleep-wrapped",
                                heap(),
                                GoldenSleep::ball,
                                Edge.WRAP,
                                Edge.WALL,
                                Surfaces.of(0.5f, 0.02f))
                        .sleeping(),
                new GoldenScene("asleep-lift", heap(), GoldenSleep::lift, Surfaces.of(0.5f, 0f), GoldenSleep::ground)
                        .sleeping(),
                new GoldenScene("asleep-rope", heap(), GoldenSleep::pull, Surfaces.of(0.5f, 0f), GoldenSleep::rope)
                        .sleeping(),
                new GoldenScene(
                                "asleep-joints",
                                heap(),
                                GoldenSleep::changeJoints,
                                Surfaces.of(0.5f, 0.02f),
                                GoldenSleep::joints)
                        .sleeping(),
                new GoldenScene(
                                "bodies-pyramid",
                                BodyScenes.ball(),
                                GoldenBodies::ball,
                                Surfaces.of(0.6f, 0f),
                                GoldenBodies::pyramid)
                        .with(GoldenBodies.OF_PYRAMID),
                new GoldenScene(
                                "bodies-dominoes",
                                BodyScenes.ball(),
                                GoldenChange.NONE,
                                Surfaces.of(0.5f, 0.01f),
                                GoldenBodies::dominoes)
                        .with(GoldenBodies.DOMINOES),
                new GoldenScene(
                                "bodies-in-ball-pit",
                                BodyScenes.pit(),
                                GoldenChange.NONE,
                                Surfaces.of(0.4f, 0f),
                                GoldenBodies::crates)
                        .with(GoldenBodies.CRATES),
                new GoldenScene(
                                "bodies-gears",
                                BodyScenes.ball(),
                                GoldenBodies::drive,
                                Surfaces.of(0.1f, 0f),
                                GoldenBodies::gears)
                        .with(2),
                new GoldenScene(
                                "bodies-in-drum",
                                HardScenes.core(30, 0.15f, Scenes.SEED),
                                GoldenChange.NONE,
                                Surfaces.of(0.6f, 0.02f),
                                GoldenBodies::drum)
                        .with(GoldenBodies.MIXED),
                new GoldenScene(
                                "bodies-churned",
                                BodyScenes.mixed(),
                                GoldenBodies::churn,
                                Surfaces.of(0.5f, 0.02f),
                                GoldenBodies::mixed)
                        .with(GoldenBodies.MIXED),
                new GoldenScene(
                                "bodies-bouncy-wrapped",
                                BodyScenes.mixed(),
                                GoldenBodies::bounce,
                                Edge.WRAP,
                                Edge.WALL,
                                Surfaces.of(0.3f, 0f).withWall(2, 0.8f, 0f, 0.4f),
                                GoldenBodies::mixed)
                        .with(GoldenBodies.MIXED),
                new GoldenScene(
                                "bodies-open",
                                BodyScenes.mixed(),
                                GoldenChange::timeStep,
                                Edge.OPEN,
                                Edge.OPEN,
                                Surfaces.of(0.6f, 0f),
                                GoldenBodies::onLand)
                        .with(GoldenBodies.MIXED),
                new GoldenScene(
                                "bodies-walls",
                                BodyScenes.mixed(),
                                GoldenChange::walls,
                                Surfaces.of(0.4f, 0f),
                                GoldenBodies::mixed)
                        .with(GoldenBodies.MIXED),
                new GoldenScene(
                                "bodies-under-boulder",
                                BodyScenes.boulder(),
                                GoldenTerrain::lift,
                                Surfaces.of(0.5f, 0f),
                                GoldenBodies::onLifts)
                        .with(GoldenBodies.ON_LIFTS),
                new GoldenScene(
                                "bodies-on-ends",
                                BodyScenes.ball(),
                                GoldenChange.NONE,
                                Surfaces.of(0.4f, 0.01f),
                                GoldenBodies::onEnds)
                        .with(GoldenBodies.ON_ENDS),
                new GoldenScene(
                                "bodies-driven",
                                BodyScenes.mixed(),
                                GoldenBodies::steer,
                                Surfaces.of(0.5f, 0.01f),
                                GoldenBodies::groups)
                        .with(GoldenBodies.MIXED),
                new GoldenScene(
                                "bodies-jointed",
                                BodyScenes.mixed(),
                                GoldenBodies::rejoin,
                                Edge.WRAP,
                                Edge.WALL,
                                Surfaces.of(0.5f, 0.01f),
                                GoldenBodies::machines)
                        .with(GoldenBodies.MIXED),
                new GoldenScene(
                                "bodies-crossed",
                                BodyScenes.ball(),
                                GoldenBodies::cross,
                                Surfaces.of(0.5f, 0.01f),
                                GoldenBodies::crossed)
                        .with(GoldenBodies.CROSSED),
                new GoldenScene(
                                "bodies-asleep",
                                BodyScenes.ball(),
                                GoldenSleep::crates,
                                Surfaces.of(0.6f, 0.02f),
                                GoldenBodies::pyramid)
                        .sleeping()
                        .with(GoldenBodies.OF_PYRAMID));
    }

    private static Scene heap() {
        return HardScenes.pile(15, 10, Scenes.SEED);
    }

    private static Scene mixedHeap() {
        return HardScenes.mixedPile(15, 10, Scenes.SEED);
    }

    private GoldenScene sleeping() {
        return new GoldenScene(name, scene, change, edgeX, edgeY, surfaces, terrain, true, bodies);
    }

    private GoldenScene with(int itsBodies) {
        return new GoldenScene(name, scene, change, edgeX, edgeY, surfaces, terrain, sleeps, itsBodies);
    }

    /** What a step costs, in circles. */
    int cost() {
        return scene.size() + COST_OF_BODY * bodies;
    }

    /** Whether there are walls all around, and nothing but circles, none of which grips or sleeps: such a scene needs no kernels of its own. */
    boolean isPlain() {
        return edgeX == Edge.WALL
                && edgeY == Edge.WALL
                && surfaces == Surfaces.NONE
                && terrain == GoldenTerrain.NONE
                && !sleeps;
    }

    /** A run of the scene in a world that was built by {@link #builder} and has no circles. */
    Run start(World empty) {
        World world = WorldScenes.load(scene, empty);
        terrain.build(WorldCalls.of(world));
        return new Run(world, WorldCalls.of(world));
    }

    /** A run of the scene in a world that has its gravity, restitution and bounds, and no circles; there is no World then. */
    Run start(WorldCalls empty) {
        SceneLoader.circles(scene, empty::add, empty::setRestitution);
        terrain.build(empty);
        return new Run(null, empty);
    }

    World.Builder builder() {
        return WorldScenes.with(surfaces, WorldScenes.builder(scene).edges(edgeX, edgeY))
                .sleep(sleeps);
    }

    @Override
    public String toString() {
        return name;
    }

    final class Run implements AutoCloseable {
        private final World owned;
        private final WorldCalls world;
        private final SplittableRandom random = new SplittableRandom(Scenes.SEED);
        private float timeStep = scene.timeStep();
        private int steps;

        private Run(World owned, WorldCalls world) {
            this.owned = owned;
            this.world = world;
        }

        World world() {
            return owned;
        }

        long hash() {
            return world.hash();
        }

        /** The steps made since the start. */
        int steps() {
            return steps;
        }

        /** Goes on until so many steps have been made since the start. */
        void advanceTo(int target) {
            while (steps < target) {
                if (steps > 0 && steps % GoldenChange.PERIOD == 0) {
                    change.apply(this);
                }
                int next = target;
                if (change != GoldenChange.NONE) {
                    next = Math.min(target, steps - steps % GoldenChange.PERIOD + GoldenChange.PERIOD);
                }
                world.step(timeStep, next - steps);
                steps = next;
            }
        }

        Scene scene() {
            return scene;
        }

        /** What a change calls: the world, or what it is compared with. */
        WorldCalls calls() {
            return world;
        }

        /** The random numbers of the changes. */
        SplittableRandom random() {
            return random;
        }

        void setTimeStep(float timeStep) {
            this.timeStep = timeStep;
        }

        long[] readHandles() {
            long[] handles = new long[world.size()];
            world.readHandles(handles);
            return handles;
        }

        /** Position, radius and mass of every circle, in the order of the handles. */
        float[] readCircles() {
            float[] circles = new float[4 * world.size()];
            world.read(circles);
            return circles;
        }

        @Override
        public void close() {
            if (owned != null) {
                owned.close();
            }
        }
    }
}
