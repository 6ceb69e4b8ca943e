package io.github.circles2d.world.terrain;

import java.util.Arrays;

/** Where bodies of terrain are, how they move, and where they travel, by id. Arrays may be longer than what is in use. */
public class BodyStates {
    public double[] x = new double[0];
    public double[] y = new double[0];

    /** In units of an angle. */
    public int[] angle = new int[0];

    public float[] vx = new float[0];
    public float[] vy = new float[0];
    public float[] omega = new float[0];

    /** How the body has moved in the last step, since it jumped. No later step depends on it. */
    public float[] lastVx = new float[0];

    public float[] lastVy = new float[0];
    public float[] lastOmega = new float[0];

    /** Whether the body travels to its target in the next step. */
    public boolean[] travels = new boolean[0];

    public float[] targetX = new float[0];
    public float[] targetY = new float[0];
    public int[] targetAngle = new int[0];

    /** For how many bodies there is room. */
    final int room() {
        return targetAngle.length;
    }

    /** Makes room. The array that is compared grows last: a growth that fails is tried again. */
    void setRoom(int bodies) {
        x = Arrays.copyOf(x, bodies);
        y = Arrays.copyOf(y, bodies);
        angle = Arrays.copyOf(angle, bodies);
        vx = Arrays.copyOf(vx, bodies);
        vy = Arrays.copyOf(vy, bodies);
        omega = Arrays.copyOf(omega, bodies);
        lastVx = Arrays.copyOf(lastVx, bodies);
        lastVy = Arrays.copyOf(lastVy, bodies);
        lastOmega = Arrays.copyOf(lastOmega, bodies);
        travels = Arrays.copyOf(travels, bodies);
        targetX = Arrays.copyOf(targetX, bodies);
        targetY = Arrays.copyOf(targetY, bodies);
        targetAngle = Arrays.copyOf(targetAngle, bodies);
    }

    /** Takes over the first bodies of others, for which there is room. */
    final void copy(BodyStates from, int bodies) {
        System.arraycopy(from.x, 0, x, 0, bodies);
        System.arraycopy(from.y, 0, y, 0, bodies);
        System.arraycopy(from.angle, 0, angle, 0, bodies);
        System.arraycopy(from.vx, 0, vx, 0, bodies);
        System.arraycopy(from.vy, 0, vy, 0, bodies);
        System.arraycopy(from.omega, 0, omega, 0, bodies);
        System.arraycopy(from.lastVx, 0, lastVx, 0, bodies);
        System.arraycopy(from.lastVy, 0, lastVy, 0, bodies);
        System.arraycopy(from.lastOmega, 0, lastOmega, 0, bodies);
        System.arraycopy(from.travels, 0, travels, 0, bodies);
        System.arraycopy(from.targetX, 0, targetX, 0, bodies);
        System.arraycopy(from.targetY, 0, targetY, 0, bodies);
        System.arraycopy(from.targetAngle, 0, targetAngle, 0, bodies);
    }
}
