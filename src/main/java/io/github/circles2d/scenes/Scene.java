package io.github.circles2d.scenes;

import java.util.Arrays;
import java.util.Objects;

/**
 * The start of a simulation: circles, the arena that holds them, and the parameters of the step. Immutable.
 *
 * <p>Lengths, masses and seconds are in the unit of the scene's source; y points up. The array accessors return a fresh
 * copy each; the accessors that take an index read one circle and allocate nothing. Indices run from 0 to
 * {@link #size()} - 1 and are the same in every array.
 */
public final class Scene {
    private final String name;
    private final float[] x;
    private final float[] y;
    private final float[] radius;
    private final float[] mass;
    private final float[] vx;
    private final float[] vy;
    private final float[] restitutions;
    private final boolean[] fixed;
    private final float minX;
    private final float minY;
    private final float maxX;
    private final float maxY;
    private final float gravityX;
    private final float gravityY;
    private final float restitution;
    private final float timeStep;

    private Scene(Builder b) {
        name = b.name;
        x = b.x;
        y = b.y;
        radius = b.radius;
        mass = b.mass;
        vx = b.vx;
        vy = b.vy;
        restitutions = b.restitutions;
        fixed = b.fixed;
        minX = b.minX;
        minY = b.minY;
        maxX = b.maxX;
        maxY = b.maxY;
        gravityX = b.gravityX;
        gravityY = b.gravityY;
        restitution = b.restitution;
        timeStep = b.timeStep;
    }

    /**
     * The scene's name, as used in tables.
     *
     * @return a short name, such as {@code packed}
     */
    public String name() {
        return name;
    }

    /**
     * The number of circles.
     *
     * @return at least 1
     */
    public int size() {
        return x.length;
    }

    /**
     * The x of every centre.
     *
     * @return a new array of {@link #size()} elements
     */
    public float[] x() {
        return x.clone();
    }

    /**
     * The y of every centre.
     *
     * @return a new array of {@link #size()} elements
     */
    public float[] y() {
        return y.clone();
    }

    /**
     * Every radius.
     *
     * @return a new array of {@link #size()} elements, all greater than 0
     */
    public float[] radius() {
        return radius.clone();
    }

    /**
     * Every mass, that of the static circles included.
     *
     * @return a new array of {@link #size()} elements, all finite and greater than 0
     */
    public float[] mass() {
        return mass.clone();
    }

    /**
     * The x component of every velocity.
     *
     * @return a new array of {@link #size()} elements
     */
    public float[] vx() {
        return vx.clone();
    }

    /**
     * The y component of every velocity.
     *
     * @return a new array of {@link #size()} elements
     */
    public float[] vy() {
        return vy.clone();
    }

    /**
     * Every circle's own restitution; {@link #restitution()} wherever the scene has one value for all.
     *
     * @return a new array of {@link #size()} elements from 0 to 1
     */
    public float[] restitutions() {
        return restitutions.clone();
    }

    /**
     * Which circles never move.
     *
     * @return a new array of {@link #size()} elements
     */
    public boolean[] fixed() {
        return fixed.clone();
    }

    /**
     * The x of one centre.
     *
     * @param i the circle's index
     * @return x
     */
    public float x(int i) {
        return x[i];
    }

    /**
     * The y of one centre.
     *
     * @param i the circle's index
     * @return y
     */
    public float y(int i) {
        return y[i];
    }

    /**
     * One radius.
     *
     * @param i the circle's index
     * @return greater than 0
     */
    public float radius(int i) {
        return radius[i];
    }

    /**
     * One mass.
     *
     * @param i the circle's index
     * @return finite and greater than 0
     */
    public float mass(int i) {
        return mass[i];
    }

    /**
     * The x component of one velocity.
     *
     * @param i the circle's index
     * @return lengths a second
     */
    public float vx(int i) {
        return vx[i];
    }

    /**
     * The y component of one velocity.
     *
     * @param i the circle's index
     * @return lengths a second
     */
    public float vy(int i) {
        return vy[i];
    }

    /**
     * One circle's own restitution.
     *
     * @param i the circle's index
     * @return 0 to 1
     */
    public float restitution(int i) {
        return restitutions[i];
    }

    /**
     * Whether one circle never moves.
     *
     * @param i the circle's index
     * @return true where it stays in place
     */
    public boolean fixed(int i) {
        return fixed[i];
    }

    /**
     * The left wall.
     *
     * @return less than {@link #maxX()}
     */
    public float minX() {
        return minX;
    }

    /**
     * The lower wall.
     *
     * @return less than {@link #maxY()}
     */
    public float minY() {
        return minY;
    }

    /**
     * The right wall.
     *
     * @return greater than {@link #minX()}
     */
    public float maxX() {
        return maxX;
    }

    /**
     * The upper wall.
     *
     * @return greater than {@link #minY()}
     */
    public float maxY() {
        return maxY;
    }

    /**
     * The x component of gravity.
     *
     * @return lengths per second squared
     */
    public float gravityX() {
        return gravityX;
    }

    /**
     * The y component of gravity.
     *
     * @return lengths per second squared, negative downwards
     */
    public float gravityY() {
        return gravityY;
    }

    /**
     * The scene's restitution: that of the walls, and of every circle unless {@link #restitutions()} says otherwise.
     *
     * @return 0 (inelastic) to 1 (elastic)
     */
    public float restitution() {
        return restitution;
    }

    /**
     * The length of a step.
     *
     * @return seconds, greater than 0
     */
    public float timeStep() {
        return timeStep;
    }

    /**
     * The circles' area over the arena's. Circles of one size can cover 0.9069 of a plane at most.
     *
     * @return greater than 0; greater than 1 where the circles cannot fit
     */
    public double fill() {
        double area = 0;
        for (float r : radius) {
            area += Math.PI * r * r;
        }
        return area / (((double) maxX - minX) * ((double) maxY - minY));
    }

    @Override
    public String toString() {
        return name + " (" + size() + " circles)";
    }

    /** Gathers a scene. Starts with the unit arena, no gravity, no velocities and steps of 1/60 s. */
    static final class Builder {
        private final String name;
        final float[] x;
        final float[] y;
        final float[] radius;
        final float[] mass;
        final float[] vx;
        final float[] vy;
        final boolean[] fixed;
        private float[] restitutions;
        private float minX = 0;
        private float minY = 0;
        private float maxX = 1;
        private float maxY = 1;
        private float gravityX;
        private float gravityY;
        private float restitution;
        private float timeStep = 1f / 60f;

        Builder(String name, int n) {
            if (n < 1) {
                throw new IllegalArgumentException("a scene has at least 1 circle, not " + n);
            }
            this.name = Objects.requireNonNull(name);
            x = new float[n];
            y = new float[n];
            radius = new float[n];
            mass = new float[n];
            vx = new float[n];
            vy = new float[n];
            fixed = new boolean[n];
        }

        Builder arena(float minX, float minY, float maxX, float maxY) {
            this.minX = minX;
            this.minY = minY;
            this.maxX = maxX;
            this.maxY = maxY;
            return this;
        }

        Builder gravity(float gravityX, float gravityY) {
            this.gravityX = gravityX;
            this.gravityY = gravityY;
            return this;
        }

        Builder restitution(float restitution) {
            this.restitution = restitution;
            return this;
        }

        /** A restitution of its own for every circle. */
        Builder restitutions(float[] restitutions) {
            this.restitutions = restitutions;
            return this;
        }

        void circle(int i, float x, float y, float radius, float mass) {
            this.x[i] = x;
            this.y[i] = y;
            this.radius[i] = radius;
            this.mass[i] = mass;
        }

        void velocity(int i, float vx, float vy) {
            this.vx[i] = vx;
            this.vy[i] = vy;
        }

        /** Hands the arrays over: the builder is not to be used afterwards. */
        Scene build() {
            if (restitutions == null) {
                restitutions = new float[x.length];
                Arrays.fill(restitutions, restitution);
            }
            return new Scene(this);
        }
    }
}
