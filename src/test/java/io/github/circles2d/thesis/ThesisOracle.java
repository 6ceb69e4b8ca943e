package io.github.circles2d.thesis;

import java.util.ArrayList;
import java.util.List;

/**
 * The mathematics of the thesis in plain, sequential Java, one method a stage: what every kernel is held against. Slots are
 * visited in order, so it is the race-free reading of what the resolve kernels do.
 */
final class ThesisOracle {
    /** A pair that barely touches and moves no faster than this along its normal comes out alike either way. */
    private static final float NO_SPEED = 1e-5f;

    final int n;
    final float[] x;
    final float[] y;
    final float[] radius;
    final float[] mass;
    final float[] vx;
    final float[] vy;
    final float[] mtvX;
    final float[] mtvY;
    private final float h;
    private final float e;
    private final float gx;
    private final float gy;

    /** How near the decisions since the last call of {@link #takeMargin} came to falling the other way. */
    private double margin = Double.POSITIVE_INFINITY;

    ThesisOracle(TestScene scene, float timeStep, float restitution, float gravityX, float gravityY) {
        n = scene.size();
        x = scene.x.clone();
        y = scene.y.clone();
        radius = scene.radius.clone();
        mass = scene.mass.clone();
        vx = scene.vx.clone();
        vy = scene.vy.clone();
        int slots = (int) PairSlots.count(n);
        mtvX = new float[slots];
        mtvY = new float[slots];
        h = timeStep;
        e = restitution;
        gx = gravityX;
        gy = gravityY;
    }

    void step() {
        update();
        detect();
        resolve();
    }

    void update() {
        for (int i = 0; i < n; i++) {
            float newX = x[i] + vx[i] * h + 0.5f * gx * h * h;
            float newY = y[i] + vy[i] * h + 0.5f * gy * h * h;
            float bounceX = 0;
            float bounceY = 0;
            boolean bounced = false;
            margin = Math.min(margin, wallMargin(newX, radius[i]));
            margin = Math.min(margin, wallMargin(newY, radius[i]));
            if (newX - radius[i] < 0) {
                newX = -(newX - radius[i]) + radius[i];
                bounceX += -2 * e * vx[i];
                bounced = true;
            } else if (newX + radius[i] > 1) {
                newX = 2 - (newX + radius[i]) - radius[i];
                bounceX += -2 * e * vx[i];
                bounced = true;
            }
            if (newY - radius[i] < 0) {
                newY = -(newY - radius[i]) + radius[i];
                bounceY += -2 * e * vy[i];
                bounced = true;
            } else if (newY + radius[i] > 1) {
                newY = 2 - (newY + radius[i]) - radius[i];
                bounceY += -2 * e * vy[i];
                bounced = true;
            }
            float newVx = vx[i] + gx * h;
            float newVy = vy[i] + gy * h;
            vx[i] = bounced ? e * newVx + bounceX : newVx;
            vy[i] = bounced ? e * newVy + bounceY : newVy;
            x[i] = newX;
            y[i] = newY;
        }
    }

    private static double wallMargin(float position, float radius) {
        return Math.min(Math.abs(position - radius), Math.abs(position + radius - 1));
    }

    void detect() {
        int slot = 0;
        for (int i = 0; i < n; i++) {
            for (int j = i + 1; j < n; j++, slot++) {
                float dx = x[j] - x[i];
                float dy = y[j] - y[i];
                float distance = (float) Math.sqrt(dx * dx + dy * dy);
                float reach = radius[i] + radius[j];
                float speed = Math.abs((vx[j] - vx[i]) * dx + (vy[j] - vy[i]) * dy) / distance;
                if (speed > NO_SPEED) {
                    margin = Math.min(margin, Math.abs(reach - distance));
                }
                boolean overlap = distance < reach;
                mtvX[slot] = overlap ? (reach - distance) * (dx / distance) : 0;
                mtvY[slot] = overlap ? (reach - distance) * (dy / distance) : 0;
            }
        }
    }

    void resolve() {
        int slot = 0;
        for (int i = 0; i < n; i++) {
            for (int j = i + 1; j < n; j++, slot++) {
                if (mtvX[slot] != 0 || mtvY[slot] != 0) {
                    resolve(i, j, mtvX[slot], mtvY[slot]);
                }
            }
        }
    }

    private void resolve(int i, int j, float mtvX, float mtvY) {
        x[i] -= 0.5f * mtvX;
        y[i] -= 0.5f * mtvY;
        x[j] += 0.5f * mtvX;
        y[j] += 0.5f * mtvY;
        float length = (float) Math.sqrt(mtvX * mtvX + mtvY * mtvY);
        float normalX = mtvX / length;
        float normalY = mtvY / length;
        float approach = (vx[i] - vx[j]) * normalX + (vy[i] - vy[j]) * normalY;
        float impulse = -(1 + e) * approach / (1 / mass[i] + 1 / mass[j]);
        vx[i] += impulse / mass[i] * normalX;
        vy[i] += impulse / mass[i] * normalY;
        vx[j] -= impulse / mass[j] * normalX;
        vy[j] -= impulse / mass[j] * normalY;
    }

    /** Returns the overlapping pairs as {i, j}. */
    List<int[]> contacts() {
        List<int[]> contacts = new ArrayList<>();
        int slot = 0;
        for (int i = 0; i < n; i++) {
            for (int j = i + 1; j < n; j++, slot++) {
                if (mtvX[slot] != 0 || mtvY[slot] != 0) {
                    contacts.add(new int[] {i, j});
                }
            }
        }
        return contacts;
    }

    /** Tells whether some circle is part of two contacts: there the kernels race, and nothing is comparable. */
    boolean someCircleHasTwoContacts() {
        boolean[] taken = new boolean[n];
        for (int[] pair : contacts()) {
            if (taken[pair[0]] || taken[pair[1]]) {
                return true;
            }
            taken[pair[0]] = true;
            taken[pair[1]] = true;
        }
        return false;
    }

    /**
     * Returns by how little the nearest decision since the last call (touching or apart, through a wall or not) was taken. A
     * device that rounds otherwise decides alike as long as this is far more than a rounding error.
     */
    double takeMargin() {
        double taken = margin;
        margin = Double.POSITIVE_INFINITY;
        return taken;
    }
}
