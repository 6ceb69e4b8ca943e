package io.github.circles2d.bench.physics;

import java.util.ArrayList;
import java.util.List;

/** An engine that writes down how the first world that a scene opens fares on another engine. */
final class Recorder implements Physics {
    /** Samples over the time that is recorded. */
    private static final int SAMPLES = 200;

    private final Physics physics;
    private final double from;
    private final double to;
    private final List<Sample> samples = new ArrayList<>();
    private boolean opened;

    /**
     * A moment.
     *
     * @param energy kinetic and that of the height
     * @param deepest overlap of the deepest pair, in usual radii
     * @param rms rms speed
     */
    record Sample(double seconds, double energy, double deepest, double rms) {}

    Recorder(Physics physics, double from, double to) {
        this.physics = physics;
        this.from = from;
        this.to = to;
    }

    List<Sample> samples() {
        return samples;
    }

    @Override
    public String name() {
        return physics.name();
    }

    @Override
    public Arena open(Setup setup) {
        Arena arena = physics.open(setup);
        if (opened) {
            return arena;
        }
        opened = true;
        return new Recorded(arena);
    }

    private final class Recorded implements Arena {
        private final Arena arena;
        private double seconds;
        private double next = from;

        Recorded(Arena arena) {
            this.arena = arena;
        }

        @Override
        public void step(double timeStep, int steps) {
            for (int step = 0; step < steps; step++) {
                arena.step(timeStep, 1);
                seconds += timeStep;
                if (seconds >= next && seconds <= to) {
                    State state = arena.state();
                    samples.add(new Sample(seconds, state.energy(), state.deepest() / Scenery.R, state.rmsSpeed()));
                    next += (to - from) / SAMPLES;
                }
            }
        }

        @Override
        public int add(double x, double y, double radius, double mass, double vx, double vy) {
            return arena.add(x, y, radius, mass, vx, vy);
        }

        @Override
        public void setPosition(int circle, double x, double y) {
            arena.setPosition(circle, x, y);
        }

        @Override
        public void setRadius(int circle, double radius) {
            arena.setRadius(circle, radius);
        }

        @Override
        public void setBounds(double minX, double minY, double maxX, double maxY, double timeStep) {
            arena.setBounds(minX, minY, maxX, maxY, timeStep);
        }

        @Override
        public State state() {
            return arena.state();
        }

        @Override
        public void close() {
            arena.close();
        }
    }
}
