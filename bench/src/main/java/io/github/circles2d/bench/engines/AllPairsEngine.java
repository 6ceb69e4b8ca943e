package io.github.circles2d.bench.engines;

import io.github.circles2d.scenes.Scene;

/**
 * The thesis's physics as a reader would first write it in Java: one thread, one loop over all pairs, no buffer of
 * contacts, each overlap resolved as soon as it is seen. Arena and walls are the thesis's, [0, 1] x [0, 1].
 */
final class AllPairsEngine implements Engine {
    private Scene scene;
    private float[] x;
    private float[] y;
    private float[] radius;
    private float[] mass;
    private float[] vx;
    private float[] vy;

    @Override
    public void load(Scene start) {
        UnitArena.require(start, "the all-pairs loop");
        scene = start;
        x = start.x();
        y = start.y();
        radius = start.radius();
        mass = start.mass();
        vx = start.vx();
        vy = start.vy();
    }

    @Override
    public void step() {
        update();
        for (int i = 0; i < x.length; i++) {
            for (int j = i + 1; j < x.length; j++) {
                float dx = x[j] - x[i];
                float dy = y[j] - y[i];
                float reach = radius[i] + radius[j];
                float square = dx * dx + dy * dy;
                if (square < reach * reach && square > 0) {
                    resolve(i, j, dx, dy, reach, (float) Math.sqrt(square));
                }
            }
        }
    }

    private void update() {
        float h = scene.timeStep();
        float e = scene.restitution();
        float gx = scene.gravityX();
        float gy = scene.gravityY();
        for (int i = 0; i < x.length; i++) {
            float r = radius[i];
            float bounceX = 0;
            float bounceY = 0;
            x[i] += vx[i] * h + 0.5f * gx * h * h;
            y[i] += vy[i] * h + 0.5f * gy * h * h;
            if (x[i] - r < 0) {
                x[i] = 2 * r - x[i];
                bounceX = -2 * e * vx[i];
            } else if (x[i] + r > 1) {
                x[i] = 2 - 2 * r - x[i];
                bounceX = -2 * e * vx[i];
            }
            if (y[i] - r < 0) {
                y[i] = 2 * r - y[i];
                bounceY = -2 * e * vy[i];
            } else if (y[i] + r > 1) {
                y[i] = 2 - 2 * r - y[i];
                bounceY = -2 * e * vy[i];
            }
            vx[i] += gx * h;
            vy[i] += gy * h;
            if (bounceX != 0 || bounceY != 0) {
                vx[i] = e * vx[i] + bounceX;
                vy[i] = e * vy[i] + bounceY;
            }
        }
    }

    private void resolve(int i, int j, float dx, float dy, float reach, float distance) {
        float nx = dx / distance;
        float ny = dy / distance;
        float half = 0.5f * (reach - distance);
        x[i] -= half * nx;
        y[i] -= half * ny;
        x[j] += half * nx;
        y[j] += half * ny;
        float speed = (vx[i] - vx[j]) * nx + (vy[i] - vy[j]) * ny;
        float impulse = -(1 + scene.restitution()) * speed / (1 / mass[i] + 1 / mass[j]);
        vx[i] += impulse / mass[i] * nx;
        vy[i] += impulse / mass[i] * ny;
        vx[j] -= impulse / mass[j] * nx;
        vy[j] -= impulse / mass[j] * ny;
    }

    @Override
    public void read(Motion motion) {
        System.arraycopy(x, 0, motion.x, 0, x.length);
        System.arraycopy(y, 0, motion.y, 0, x.length);
        System.arraycopy(vx, 0, motion.vx, 0, x.length);
        System.arraycopy(vy, 0, motion.vy, 0, x.length);
    }

    @Override
    public boolean repeatable() {
        return true;
    }

    @Override
    public void close() {
        scene = null;
    }
}
