package io.github.circles2d.toy;

import io.github.circles2d.World;
import org.teavm.jso.typedarrays.Float32Array;

/** What the page draws: four numbers a circle, which are x, y, radius and shade. */
final class Picture {
    static final int PLAIN = 0;
    static final int SPEED = 1;
    static final int PRESSURE = 2;

    /** The shade of a circle that nothing moves. */
    private static final float STATIC = -1;

    private static final int TINTS = 8;

    /** The speed that has the last colour. */
    private static final float FAST = 70;

    /** Of the mean pressure, so that some circles have the last colour. */
    private static final float RANGE = 3;

    private float[] circles = new float[0];
    private float[] more = new float[0];
    private float meanPressure;

    /** Draws the world as it is. */
    Float32Array of(World world, int mode) {
        int ids = world.idLimit();
        circles = atLeast(circles, 4 * ids);
        more = atLeast(more, 2 * ids);
        world.readById(circles, null);
        if (mode == SPEED) {
            world.readVelocitiesById(more, null);
        } else if (mode == PRESSURE) {
            world.readLoadsById(more, null);
        }
        int count = 0;
        for (int id = 0; id < ids; id++) {
            if (!Float.isNaN(circles[4 * id])) {
                float shade = circles[4 * id + 3] == Float.POSITIVE_INFINITY ? STATIC : shade(id, mode);
                System.arraycopy(circles, 4 * id, circles, 4 * count, 3);
                circles[4 * count + 3] = shade;
                count++;
            }
        }
        if (mode == PRESSURE) {
            follow(ids);
        }
        Float32Array picture = new Float32Array(4 * count);
        for (int k = 0; k < 4 * count; k++) {
            picture.set(k, circles[k]);
        }
        return picture;
    }

    private static float[] atLeast(float[] array, int length) {
        return array.length >= length ? array : new float[length + length / 2];
    }

    /** From 0 to 1. */
    private float shade(int id, int mode) {
        float a = more[2 * id];
        float b = more[2 * id + 1];
        return switch (mode) {
            case SPEED -> Math.min((float) Math.sqrt(Math.sqrt(a * a + b * b) / FAST), 1);
            case PRESSURE -> meanPressure == 0 ? 0 : Math.min(b / (RANGE * meanPressure), 1);
            default -> (id * 5 + (id >>> 3)) % TINTS / (float) (TINTS - 1);
        };
    }

    /** The scale follows the mean, slowly. */
    private void follow(int ids) {
        float sum = 0;
        int pressed = 0;
        for (int id = 0; id < ids; id++) {
            if (more[2 * id + 1] > 0) {
                sum += more[2 * id + 1];
                pressed++;
            }
        }
        if (pressed > 0) {
            float mean = sum / pressed;
            meanPressure = meanPressure == 0 ? mean : meanPressure + 0.05f * (mean - meanPressure);
        }
    }
}
