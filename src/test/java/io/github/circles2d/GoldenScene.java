package io.github.circles2d;

import static io.github.circles2d.GoldenChange.NONE;
import static io.github.circles2d.scenes.Scenes.SEED;

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
    private static GoldenScene of(
            String name,
            Scene scene,
            GoldenChange change,
            Edge edgeX,
            Edge edgeY,
            Surfaces surfaces,
            GoldenTerrain terrain) {
        return new GoldenScene(name, scene, change, edgeX, edgeY, surfaces, terrain, false, 0);
    }

    /** A scene without terrain. */
    private static GoldenScene of(
            String name, Scene scene, GoldenChange change, Edge edgeX, Edge edgeY, Surfaces surfaces) {
        return of(name, scene, change, edgeX, edgeY, surfaces, GoldenTerrain.NONE);
    }

    /** A scene with walls all around, and terrain. */
    private static GoldenScene of(
            String name, Scene scene, GoldenChange change, Surfaces surfaces, GoldenTerrain terrain) {
        return of(name, scene, change, Edge.WALL, Edge.WALL, surfaces, terrain);
    }

    /** A scene with walls all around. */
    private static GoldenScene of(String name, Scene scene, GoldenChange change) {
        return of(name, scene, change, Surfaces.NONE);
    }

    /** A scene with walls all around, in which surfaces grip. */
    private static GoldenScene of(String name, Scene scene, GoldenChange change, Surfaces surfaces) {
        return of(name, scene, change, Edge.WALL, Edge.WALL, surfaces);
    }

    /** A scene in which nothing grips. */
    private static GoldenScene of(String name, Scene scene, GoldenChange change, Edge edgeX, Edge edgeY) {
        return of(name, scene, change, edgeX, edgeY, Surfaces.NONE);
    }

    static List<GoldenScene> all() {
        return List.of(
                of("thesis", Scenes.thesis(1250, SEED), NONE),
                of("packed-100000", Scenes.packed(100_000, SEED), NONE),
                of("packed-5000-churned", Scenes.packed(5_000, SEED), GoldenChange::churn),
                of("gas", gas(), NONE),
                of("barrel", Scenes.barrel(SEED), NONE),
                of("balls2", Scenes.balls2(), NONE),
                of("mixed-churned", mixed(), GoldenChange::churn),
                of("no-collide", Scenes.noCollide(), NONE),
                of("billiards", Scenes.billiards(20), NONE),
                of("bouncy-churned", Scenes.bouncy(SEED), GoldenChange::churn),
                of("one-point", Scenes.onePoint(2_000, SEED), NONE),
                of("jam", HardScenes.jam(1_500, SEED), NONE),
                of("pile-time-steps", pile(), GoldenChange::timeStep),
                of("pile-growth", pile(), GoldenChange::growth),
                of("fence", HardScenes.fence(24, SEED), NONE),
                of("paddles", paddles(), GoldenChange::paddles),
                of("pile-kinds", pile(), GoldenChange::kinds),
                of("crowd", HardScenes.crowd(40, SEED), GoldenChange::turn),
                of("dragged", paddles(), GoldenChange::drag),
                of("pile-walls", pile(), GoldenChange::walls),
                of("wrapped", gas(), NONE, Edge.WRAP, Edge.WRAP),
                of("wrapped-mixed-churned", mixed(), GoldenChange::churn, Edge.WRAP, Edge.WALL),
                of("open", Scenes.billiards(20), NONE, Edge.OPEN, Edge.OPEN),
                of("open-bouncy-churned", Scenes.bouncy(SEED), GoldenChange::churn, Edge.OPEN, Edge.WALL),
                of("wrapped-open-paddles", paddles(), GoldenChange::paddles, Edge.WRAP, Edge.OPEN),
                of("mixed-10", Scenes.mixed(100_000, 10, SEED), NONE),
                of("mixed-100", Scenes.mixed(10_000, 100, SEED), NONE),
                of("boulder", Scenes.boulder(10_000, SEED), NONE),
                of("slope", HardScenes.slope(40, 20, SEED), NONE, grip(0.6f, 0.02f)),
                of("heap", HardScenes.heap(1_000, SEED), NONE, grip(0.6f, 0.1f)),
                of("billiards-spin", Scenes.billiards(5), GoldenChange::spin, grip(0.2f, 0f)),
                of("rollers", paddles(), GoldenChange::spin, grip(0.8f, 0f).withWall(2, 0.5f, 0f, 0.3f)),
                of("mixed-gripping-churned", mixed(), GoldenChange::churn, grip(0.6f, 0.05f)),
                of("pile-gripping-time-steps", pile(), GoldenChange::timeStep, grip(0.6f, 0.1f)),
                of("belts", pile(), GoldenChange::belts, grip(0.5f, 0.02f).withWall(2, 0.7f, 0.01f, -0.2f)),
                of("wrapped-gripping", gas(), GoldenChange::spin, Edge.WRAP, Edge.WALL, grip(0.3f, 0f)),
                of("hourglass", pile(), NONE, grip(0.2f, 0f), GoldenTerrain::hourglass),
                of("drum", HardScenes.core(1_000, 0.2f, SEED), NONE, grip(0.6f, 0f), GoldenTerrain::drum),
                of(
                        "pinball",
                        HardScenes.core(60, 0.12f, SEED),
                        GoldenTerrain::flip,
                        grip(0.2f, 0f),
                        GoldenTerrain::pinball),
                of("half-pipes", HardScenes.heap(1_000, SEED), NONE, grip(0.6f, 0.02f), GoldenTerrain::halfPipes),
                of(
                        "one-way-lifts",
                        HardScenes.pile(40, 20, SEED),
                        GoldenTerrain::lift,
                        grip(0.5f, 0f),
                        GoldenTerrain::lifts),
                of(
                        "mixed-rubble-churned",
                        Scenes.mixed(4_000, 10, SEED),
                        GoldenChange::churn,
                        Surfaces.NONE,
                        GoldenTerrain::rubble),
                of(
                        "slopes",
                        HardScenes.pile(50, 25, SEED),
                        GoldenChange::timeStep,
                        grip(0.6f, 0.05f),
                        GoldenTerrain::slopes),
                of("floor-rebuilt", pile(), GoldenTerrain::rebuild, grip(0.4f, 0f), GoldenTerrain::floor),
                of("wrapped-seams", gas(), NONE, Edge.WRAP, Edge.WRAP, Surfaces.NONE, GoldenTerrain::seams),
                of(
                        "bridge",
                        JointedScenes.bridge(GoldenJoints.PLANKS, 400),
                        NONE,
                        grip(0.5f, 0f),
                        GoldenJoints::bridge),
                of("blobs", JointedScenes.blobs(300, GoldenJoints.OF_BLOB), NONE, grip(0.3f, 0f), GoldenJoints::blobs),
                of("ropes", JointedScenes.ropes(40, GoldenJoints.LINKS), NONE, Surfaces.NONE, GoldenJoints::ropes),
                of("wheel", JointedScenes.wheel(100), GoldenChange::timeStep, grip(0.4f, 0f), GoldenJoints::wheel),
                of(
                        "wrapped-joints",
                        Scenes.gas(1_000, SEED),
                        NONE,
                        Edge.WRAP,
                        Edge.WRAP,
                        Surfaces.NONE,
                        GoldenJoints::seams),
                of("carts", JointedScenes.carts(40), NONE, grip(0.8f, 0f), GoldenJoints::carts),
                of("nets-churned", pile(), GoldenJoints::rejoin, grip(0.3f, 0f), GoldenJoints::net),
                of("asleep-ball", heap(), GoldenSleep::ball).sleeping(),
                of("asleep-pour", heap(), GoldenSleep::pour, grip(0.6f, 0.02f)).sleeping(),
                of("asleep-support", heap(), GoldenSleep::support, grip(0.4f, 0.02f))
                        .sleeping(),
                of("asleep-tilt", heap(), GoldenSleep::tilt, grip(0.6f, 0.05f)).sleeping(),
                of("asleep-calls", heap(), GoldenSleep::calls, grip(0.3f, 0f)).sleeping(),
                of("asleep-mixed", mixedHeap(), GoldenSleep::ball, grip(0.5f, 0f))
                        .sleeping(),
                of("asleep-time-steps", heap(), GoldenSleep::timeStep, grip(0.6f, 0f))
                        .sleeping(),
                of("asleep-wrapped", heap(), GoldenSleep::ball, Edge.WRAP, Edge.WALL, grip(0.5f, 0.02f))
                        .sleeping(),
                of("asleep-lift", heap(), GoldenSleep::lift, grip(0.5f, 0f), GoldenSleep::ground)
                        .sleeping(),
                of("asleep-rope", heap(), GoldenSleep::pull, grip(0.5f, 0f), GoldenSleep::rope)
                        .sleeping(),
                of("asleep-joints", heap(), GoldenSleep::changeJoints, grip(0.5f, 0.02f), GoldenSleep::joints)
                        .sleeping(),
                of("bodies-pyramid", BodyScenes.ball(), GoldenBodies::ball, grip(0.6f, 0f), GoldenBodies::pyramid)
                        .with(GoldenBodies.OF_PYRAMID),
                of("bodies-dominoes", BodyScenes.ball(), NONE, grip(0.5f, 0.01f), GoldenBodies::dominoes)
                        .with(GoldenBodies.DOMINOES),
                of("bodies-in-ball-pit", BodyScenes.pit(), NONE, grip(0.4f, 0f), GoldenBodies::crates)
                        .with(GoldenBodies.CRATES),
                of("bodies-gears", BodyScenes.ball(), GoldenBodies::drive, grip(0.1f, 0f), GoldenBodies::gears)
                        .with(2),
                of("bodies-in-drum", HardScenes.core(30, 0.15f, SEED), NONE, grip(0.6f, 0.02f), GoldenBodies::drum)
                        .with(GoldenBodies.MIXED),
                of("bodies-churned", BodyScenes.mixed(), GoldenBodies::churn, grip(0.5f, 0.02f), GoldenBodies::mixed)
                        .with(GoldenBodies.MIXED),
                of(
                                "bodies-bouncy-wrapped",
                                BodyScenes.mixed(),
                                GoldenBodies::bounce,
                                Edge.WRAP,
                                Edge.WALL,
                                grip(0.3f, 0f).withWall(2, 0.8f, 0f, 0.4f),
                                GoldenBodies::mixed)
                        .with(GoldenBodies.MIXED),
                of(
                                "bodies-open",
                                BodyScenes.mixed(),
                                GoldenChange::timeStep,
                                Edge.OPEN,
                                Edge.OPEN,
                                grip(0.6f, 0f),
                                GoldenBodies::onLand)
                        .with(GoldenBodies.MIXED),
                of("bodies-walls", BodyScenes.mixed(), GoldenChange::walls, grip(0.4f, 0f), GoldenBodies::mixed)
                        .with(GoldenBodies.MIXED),
                of(
                                "bodies-under-boulder",
                                BodyScenes.boulder(),
                                GoldenTerrain::lift,
                                grip(0.5f, 0f),
                                GoldenBodies::onLifts)
                        .with(GoldenBodies.ON_LIFTS),
                of("bodies-on-ends", BodyScenes.ball(), NONE, grip(0.4f, 0.01f), GoldenBodies::onEnds)
                        .with(GoldenBodies.ON_ENDS),
                of("bodies-driven", BodyScenes.mixed(), GoldenBodies::steer, grip(0.5f, 0.01f), GoldenBodies::groups)
                        .with(GoldenBodies.MIXED),
                of(
                                "bodies-jointed",
                                BodyScenes.mixed(),
                                GoldenBodies::rejoin,
                                Edge.WRAP,
                                Edge.WALL,
                                grip(0.5f, 0.01f),
                                GoldenBodies::machines)
                        .with(GoldenBodies.MIXED),
                of("bodies-crossed", BodyScenes.ball(), GoldenBodies::cross, grip(0.5f, 0.01f), GoldenBodies::crossed)
                        .with(GoldenBodies.CROSSED),
                of("bodies-asleep", BodyScenes.ball(), GoldenSleep::crates, grip(0.6f, 0.02f), GoldenBodies::pyramid)
                        .sleeping()
                        .with(GoldenBodies.OF_PYRAMID));
    }

    private static Surfaces grip(float friction, float rollingResistance) {
        return Surfaces.of(friction, rollingResistance);
    }

    private static Scene gas() {
        return Scenes.gas(2_500, SEED);
    }

    private static Scene mixed() {
        return Scenes.mixed(4_000, SEED);
    }

    private static Scene pile() {
        return HardScenes.pile(40, 30, SEED);
    }

    private static Scene paddles() {
        return HardScenes.paddles(20, 30, SEED);
    }

    private static Scene heap() {
        return HardScenes.pile(15, 10, SEED);
    }

    private static Scene mixedHeap() {
        return HardScenes.mixedPile(15, 10, SEED);
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
        private final SplittableRandom random = new SplittableRandom(SEED);
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
                if (change != NONE) {
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
