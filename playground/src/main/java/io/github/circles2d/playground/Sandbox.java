package io.github.circles2d.playground;

import io.github.circles2d.Backend;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Joint;
import io.github.circles2d.JointType;
import io.github.circles2d.Joints;
import io.github.circles2d.Wall;
import io.github.circles2d.World;
import io.github.circles2d.WorldStats;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;

/** A world with its loop, its past and what is usual in it. Belongs to one thread. */
final class Sandbox implements AutoCloseable {
    static final float TIME_STEP = 1 / 60f;

    /** A processor is left to the window: threads that wait for each other would wait for it too. */
    private static final int THREADS = Math.min(Math.max(Runtime.getRuntime().availableProcessors() - 1, 1), 16);

    private World world;

    /** The back end that was asked for: AUTO even if the world is on the JVM. */
    private Backend asked;

    private WorldStats stats;
    private FixedStep loop;
    private Timeline timeline;
    private Grain grain;
    private Stage stage;
    private int step;

    /** The pins whose force has a limit that the world had when it came. */
    private Set<Long> ownPulls = Set.of();

    /** Where bodies were when a frame was filled. */
    private final BodyShapes bodies = new BodyShapes();

    private String news = "";

    /** What a person has set for this stage; 0 for its own. */
    private int subSteps;

    /** Whether a person has asked that circles of this stage may sleep, where its own do not. */
    private boolean withSleep;

    /** Whether worlds measure the times of their stages. */
    private boolean profiling;

    /** The gravity of the stage: a slider keeps its direction, and goes up to twice as much. */
    private float stageGravityX;

    private float stageGravityY;

    /** Opens a stage. */
    Sandbox(Stage stage, Backend backend) {
        load(stage, backend);
    }

    /** Takes a stage in place of what is. If it cannot be opened, all stays as it is. */
    void load(Stage next, Backend backend) {
        load(next, backend, 0, false);
    }

    /** The same with another number of sub-steps than the stage has, or with sleep. A saved world keeps its own. */
    private void load(Stage next, Backend backend, int wishedSubSteps, boolean wishedSleep) {
        World.Builder builder =
                next.builder().get().backend(backend).threads(THREADS).profiling(profiling);
        if (wishedSleep) {
            builder.sleep(true);
        }
        World opened = (wishedSubSteps == 0 ? builder : builder.subSteps(wishedSubSteps)).build();
        try {
            next.circles().accept(opened);
            WorldStats figures = opened.stats();
            Grain usual = Grain.of(opened);
            replace(opened, backend, figures, 0);
            grain = usual;
            stage = next;
            subSteps = wishedSubSteps;
            withSleep = wishedSleep;
            stageGravityX = opened.gravityX();
            stageGravityY = opened.gravityY();
        } catch (RuntimeException | Error e) {
            opened.close();
            throw e;
        }
    }

    /** Takes the stage from its start, with the sub-steps that a person has set. */
    void restart() {
        restart(subSteps);
    }

    /** The same with so many sub-steps, 1 to 16. */
    void restart(int wishedSubSteps) {
        load(stage, asked, wishedSubSteps, withSleep);
    }

    /** The same as a world whose circles sleep. */
    void restartWithSleep() {
        load(stage, asked, subSteps, true);
    }

    /** Goes on with the same state on another back end. If there is no such, all stays as it is. */
    void switchTo(Backend backend) {
        rebuild(backend, profiling);
    }

    /** Goes on with the same state in a world that measures the times of its stages, or in one that does not and so pays nothing for it. */
    void setProfiling(boolean wanted) {
        rebuild(asked, wanted);
    }

    private void rebuild(Backend backend, boolean measures) {
        World next = World.builder()
                .backend(backend)
                .threads(THREADS)
                .profiling(measures)
                .capacity(Math.max(world.size(), 1))
                .build();
        try {
            next.restore(snapshot());
            replace(next, backend, next.stats(), step);
            profiling = measures;
        } catch (RuntimeException | Error e) {
            next.close();
            throw e;
        }
    }

    /** Takes another world, which has made so many steps. If that fails, all stays as it is. */
    private void replace(World next, Backend backend, WorldStats figures, int at) {
        FixedStep ofNext = new FixedStep(next, TIME_STEP);
        Timeline past = new Timeline(next);
        ownPulls = pulls(next);
        World old = world;
        world = next;
        asked = backend;
        stats = figures;
        loop = ofNext;
        timeline = past;
        step = at;
        if (old != null) {
            old.close();
        }
    }

    private static Set<Long> pulls(World world) {
        Joints joints = world.joints();
        Set<Long> found = new HashSet<>();
        for (int id = 0; id < joints.idLimit(); id++) {
            long joint = joints.handle(id);
            if (joint != 0 && isPull(joints.joint(joint))) {
                found.add(joint);
            }
        }
        return found;
    }

    private static boolean isPull(Joint joint) {
        return joint.type() == JointType.PIN && joint.maxForce() < Float.POSITIVE_INFINITY;
    }

    /** Whether a joint is one by which a hand has held a circle: a world that was saved may have such joints of its own. */
    boolean isOfHand(long joint) {
        return isPull(world.joints().joint(joint)) && !ownPulls.contains(joint);
    }

    /** The state, ready to be restored. */
    ByteBuffer snapshot() {
        ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(bytes);
        return bytes.flip();
    }

    void save(Path file) throws IOException {
        Files.write(file, snapshot().array());
    }

    /** Takes a saved world in place of what is; all stays as it is if the file has none. */
    void open(Path file) throws IOException {
        load(Stage.saved(file.getFileName().toString(), Files.readAllBytes(file)), asked);
    }

    /** Makes the steps that are due, and tells how many. */
    int advance(float seconds, Runnable beforeStep) {
        return loop.advance(seconds, () -> {
            prepare(beforeStep);
            step++;
        });
    }

    /** Makes one step. */
    void stepOnce(Runnable beforeStep) {
        prepare(beforeStep);
        world.step(TIME_STEP);
        step++;
        loop.reset();
    }

    private void prepare(Runnable beforeStep) {
        timeline.save(step);
        beforeStep.run();
    }

    /** Goes back by a step, and tells whether there was one. */
    boolean back() {
        int before = timeline.back(step);
        boolean went = before < step;
        step = before;
        if (went) {
            loop.reset();
        }
        return went;
    }

    int stepsToRewind() {
        return timeline.stepsBefore(step);
    }

    /** The friction of walls and of the circles that have none by their kind: those of kind 0, which the tools add, too. */
    float friction() {
        float own = world.kind(0).friction();
        return own == own ? own : world.defaultFriction();
    }

    /** The same of rolling resistance. */
    float rollingResistance() {
        float own = world.kind(0).rollingResistance();
        return own == own ? own : world.defaultRollingResistance();
    }

    /** Gives walls and the circles of kind 0 another surface. Belts stay. */
    void setSurface(float friction, float rollingResistance) {
        world.kind(0).setFriction(friction).setRollingResistance(rollingResistance);
        for (Wall wall : Wall.values()) {
            world.setWallSurface(wall, friction, rollingResistance, world.wallBeltSpeed(wall));
        }
    }

    /** Whether circles that lie still fall asleep: those of kind 0. */
    boolean sleeps() {
        return world.sleeps() && world.kind(0).sleeps();
    }

    /** Lets circles of kind 0 fall asleep, or keeps them awake, in a world that sleeps. */
    void setSleeps(boolean sleeps) {
        world.kind(0).setSleeps(sleeps);
    }

    float gravity() {
        return (float) Math.hypot(world.gravityX(), world.gravityY());
    }

    /** Twice that of the stage; for one without gravity, what crosses half of the arena in about a second. */
    float greatestGravity() {
        float given = (float) Math.hypot(stageGravityX, stageGravityY);
        return given > 0 ? 2 * given : world.maxY() - world.minY();
    }

    /** Gives gravity another strength, in the direction that the stage has; downwards if it has none. */
    void setGravity(float strength) {
        float given = (float) Math.hypot(stageGravityX, stageGravityY);
        float factor = given > 0 ? strength / given : 0;
        world.setGravity(factor * stageGravityX, given > 0 ? factor * stageGravityY : -strength);
    }

    /** The restitution that new circles get. */
    float restitution() {
        float own = world.kind(0).restitution();
        return own == own ? own : world.defaultRestitution();
    }

    /** Gives all circles and the terrain of kind 0 a restitution, and those that are to come. */
    void setRestitution(float restitution) {
        world.kind(0).setRestitution(restitution);
        int[] kinds = new int[world.idLimit()];
        world.readKindsById(kinds, null); // in one look: a look at each would take long on a device
        for (int id = 0; id < kinds.length; id++) {
            long circle = world.handle(id);
            if (circle != 0 && kinds[id] == 0) {
                world.setRestitution(circle, restitution);
            }
        }
    }

    World world() {
        return world;
    }

    BodyShapes bodies() {
        return bodies;
    }

    /** The body around a place, as it is shown; 0 if there is none. */
    long bodyAt(float x, float y) {
        long body = bodies.at(x, y);
        return body != 0 && world.bodies().contains(body) ? body : 0;
    }

    /** Takes note of what a tool has to say. */
    void say(String text) {
        news = text;
    }

    /** What a tool has said since the last call; the empty string if nothing. */
    String takeNews() {
        String taken = news;
        news = "";
        return taken;
    }

    /** The energy of a mass of 1 at a place, above the corner where it is least. */
    static double height(World world, double x, double y) {
        double gx = world.gravityX();
        double gy = world.gravityY();
        double lowX = gx > 0 ? world.maxX() : world.minX();
        double lowY = gy > 0 ? world.maxY() : world.minY();
        return -gx * (x - lowX) - gy * (y - lowY);
    }

    FixedStep loop() {
        return loop;
    }

    /** The back end that was asked for. */
    Backend asked() {
        return asked;
    }

    /** As it was built, or at the last {@link #look}. */
    WorldStats stats() {
        return stats;
    }

    /** Looks where the world is now, if it may move. */
    WorldStats look() {
        stats = asked == Backend.AUTO ? world.stats() : stats;
        return stats;
    }

    boolean isProfiling() {
        return profiling;
    }

    Grain grain() {
        return grain;
    }

    Stage stage() {
        return stage;
    }

    int step() {
        return step;
    }

    @Override
    public void close() {
        world.close();
    }
}
