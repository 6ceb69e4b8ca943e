package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.world.Pipeline;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.SavedState;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepConstants;
import java.nio.FloatBuffer;
import java.util.SplittableRandom;

/** A world's host side, with as many pipelines as are to be compared. */
final class Twins implements AutoCloseable {
    private final HandleTable roster = new HandleTable();
    private final Commands commands = new Commands();
    private final GridLevels levels = new GridLevels();
    private final Pipeline[] pipelines;
    private Bounds bounds;
    private final float gx;
    private final float gy;
    private int subSteps = 4;
    private float previousDt;

    /** The circles at the last request for positions. */
    private float[] requested;

    Twins(Bounds bounds, float gx, float gy, Pipeline... pipelines) {
        this.bounds = bounds;
        this.gx = gx;
        this.gy = gy;
        this.pipelines = pipelines;
    }

    /** Sets the number of sub-steps a step, which is 4 otherwise. */
    Twins subSteps(int count) {
        subSteps = count;
        return this;
    }

    void apply() {
        for (Pipeline pipeline : pipelines) {
            pipeline.makeRoom(commands);
            pipeline.apply(commands);
        }
        commands.clear();
    }

    /** What all pipelines are to do before the next step. */
    Commands commands() {
        return commands;
    }

    void step(float dt, int steps) {
        apply();
        for (Pipeline pipeline : pipelines) {
            StepConstants constants = new StepConstants();
            constants.set(dt, subSteps, gx, gy, bounds, previousDt == 0 ? dt : previousDt);
            levels.layOut(bounds, roster.greatestRadius(), roster.population());
            pipeline.step(constants, levels, steps);
        }
        previousDt = dt;
    }

    void assertEqual(String when) {
        long expected = pipelines[0].hash();
        for (Pipeline pipeline : pipelines) {
            assertThat(pipeline.hash()).as(when + " on " + pipeline.device()).isEqualTo(expected);
        }
    }

    void assertSameFigures() {
        for (Pipeline pipeline : pipelines) {
            assertThat(pipeline.contacts()).isEqualTo(pipelines[0].contacts());
            assertThat(pipeline.greatestContacts()).isEqualTo(pipelines[0].greatestContacts());
            assertThat(pipeline.candidatePairs()).isEqualTo(pipelines[0].candidatePairs());
        }
    }

    void assertSameReadings() {
        float[][] circles = new float[pipelines.length][4 * roster.size()];
        float[][] velocities = new float[pipelines.length][2 * roster.size()];
        for (int k = 0; k < pipelines.length; k++) {
            pipelines[k].readCircles(roster, circles[k]);
            pipelines[k].readVelocities(roster, velocities[k]);
            assertThat(circles[k]).isEqualTo(circles[0]);
            assertThat(velocities[k]).isEqualTo(velocities[0]);
            assertPositions(pipelines[k].positions(roster), circles[0]);
        }
        requestPositions();
        assertSameRequestedPositions();
    }

    /** Asks every pipeline for the positions as they are now. */
    void requestPositions() {
        apply();
        requested = new float[4 * roster.size()];
        // Of the first pipeline alone: the others are not to come to rest before they are asked.
        pipelines[0].readCircles(roster, requested);
        for (Pipeline pipeline : pipelines) {
            pipeline.requestPositions(roster);
        }
    }

    /** Takes the positions from every pipeline: those of the request. */
    void assertSameRequestedPositions() {
        for (Pipeline pipeline : pipelines) {
            assertPositions(pipeline.takePositions(), requested);
        }
    }

    private static void assertPositions(FloatBuffer positions, float[] circles) {
        assertThat(positions.remaining()).isEqualTo(circles.length / 2);
        for (int i = 0; i < circles.length / 4; i++) {
            assertThat(positions.get()).isEqualTo(circles[4 * i]);
            assertThat(positions.get()).isEqualTo(circles[4 * i + 1]);
        }
    }

    /** Makes the arena a little smaller. */
    void confine() {
        apply();
        float width = bounds.maxX() - bounds.minX();
        bounds = new Bounds(bounds.minX() + 0.01f * width, bounds.minY(), bounds.maxX() - 0.01f * width, bounds.maxY());
        for (Pipeline pipeline : pipelines) {
            pipeline.confine(bounds);
        }
    }

    /** Saves every pipeline, and lets each go on from what another has saved. */
    void exchange() {
        apply();
        SavedState[] saved = new SavedState[pipelines.length];
        for (int k = 0; k < pipelines.length; k++) {
            saved[k] = new SavedState();
            roster.save(saved[k]);
            pipelines[k].save(saved[k]);
        }
        for (int k = 0; k < pipelines.length; k++) {
            SavedState other = saved[(k + 1) % pipelines.length];
            pipelines[k].makeRoom(other);
            pipelines[k].load(other);
        }
    }

    /** Asks for another circle. */
    void add(float x, float y, float r, float mass, float restitution, float vx, float vy) {
        commands.add(roster.add(r), x, y, r, mass, restitution, vx, vy);
    }

    /** Asks for another radius of a circle. */
    void setRadius(int id, float r) {
        roster.setRadius(id, r);
        commands.set(Commands.RADIUS, id, r, 0);
    }

    /** Asks for some change of each kind. */
    void change(Scene scene, SplittableRandom random) {
        int id = random.nextInt(roster.end());
        if (roster.lives(id)) {
            roster.remove(id);
            commands.remove(id);
        }
        float r = scene.radius()[random.nextInt(scene.size())];
        if (random.nextInt(4) > 0) {
            float x = between(random, bounds.minX(), bounds.maxX());
            float y = between(random, bounds.minY(), bounds.maxY());
            add(x, y, r, between(random, 1, 2), 0.5f, between(random, -r, r), between(random, -r, r));
        }
        for (int operation = Commands.POSITION; operation <= Commands.IMPULSE; operation++) {
            id = random.nextInt(roster.end());
            if (!roster.lives(id)) {
                continue;
            }
            switch (operation) {
                case Commands.POSITION ->
                    commands.set(
                            operation,
                            id,
                            between(random, bounds.minX(), bounds.maxX()),
                            between(random, bounds.minY(), bounds.maxY()));
                case Commands.VELOCITY, Commands.IMPULSE ->
                    commands.set(operation, id, between(random, -9 * r, 9 * r), between(random, -9 * r, 9 * r));
                case Commands.RADIUS -> setRadius(id, r);
                default -> commands.set(operation, id, between(random, 0.1f, 1), 0);
            }
        }
    }

    private static float between(SplittableRandom random, float low, float high) {
        return low + (float) random.nextDouble() * (high - low);
    }

    @Override
    public void close() {
        for (Pipeline pipeline : pipelines) {
            pipeline.close();
        }
    }

    /** A scene, on several pipelines. */
    static Twins load(Scene scene, Pipeline... pipelines) {
        Twins twins = new Twins(
                new Bounds(scene.minX(), scene.minY(), scene.maxX(), scene.maxY()),
                scene.gravityX(),
                scene.gravityY(),
                pipelines);
        for (int i = 0; i < scene.size(); i++) {
            float m = scene.fixed()[i] ? Float.POSITIVE_INFINITY : scene.mass()[i];
            twins.add(
                    scene.x()[i],
                    scene.y()[i],
                    scene.radius()[i],
                    m,
                    scene.restitution(),
                    scene.vx()[i],
                    scene.vy()[i]);
        }
        return twins;
    }
}
