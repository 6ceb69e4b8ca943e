package io.github.circles2d.bench.physics;

import io.github.circles2d.World;
import java.util.Arrays;

/** A world of this library. */
final class WorldArena implements Arena {
    private final World world;
    private long[] handles = new long[16];
    private int size;

    WorldArena(World world) {
        this.world = world;
    }

    @Override
    public int add(double x, double y, double radius, double mass, double vx, double vy) {
        if (size == handles.length) {
            handles = Arrays.copyOf(handles, 2 * size);
        }
        handles[size] = world.add((float) x, (float) y, (float) radius, (float) mass, (float) vx, (float) vy);
        return size++;
    }

    @Override
    public void setPosition(int circle, double x, double y) {
        world.setPosition(handles[circle], (float) x, (float) y);
    }

    @Override
    public void setRadius(int circle, double radius) {
        world.setRadius(handles[circle], (float) radius);
    }

    @Override
    public void setBounds(double minX, double minY, double maxX, double maxY, double timeStep) {
        world.setBounds((float) minX, (float) minY, (float) maxX, (float) maxY);
    }

    @Override
    public void step(double timeStep, int steps) {
        world.step((float) timeStep, steps);
    }

    @Override
    public State state() {
        float[] circles = new float[4 * size];
        float[] velocities = new float[2 * size];
        world.read(circles);
        world.readVelocities(velocities);
        State state = new State(size, world.gravityY(), world.minX(), world.minY(), world.maxX(), world.maxY());
        for (int i = 0; i < size; i++) {
            state.x[i] = circles[4 * i];
            state.y[i] = circles[4 * i + 1];
            state.radius[i] = circles[4 * i + 2];
            state.mass[i] = circles[4 * i + 3];
            state.vx[i] = velocities[2 * i];
            state.vy[i] = velocities[2 * i + 1];
        }
        return state;
    }

    @Override
    public void close() {
        world.close();
    }
}
