package io.github.circles2d.world;

import io.github.circles2d.opencl.DeviceBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;

/** Packs the constants of a step and the shape of the grids as the structs of {@code World.cl}, and sends what changed. */
final class ClParameters {
    static final int CONSTANT_INTS = 20;
    static final int LEVEL_INTS = 4 + 5 * Levels.COUNT + 3;

    private static final int WARM_SCALE = 14;

    private final int[] constants = new int[CONSTANT_INTS];
    private final int[] levels = new int[LEVEL_INTS];
    private int[] sentConstants = new int[0];
    private int[] sentLevels = new int[0];

    /** Takes down what the next steps are made with. */
    void set(StepConstants k, Levels shape) {
        packConstants(k);
        packLevels(shape);
    }

    /** Sets the size of a tile: log2 of its columns and rows of cells. */
    void setTile(int columnsLog, int rowsLog) {
        levels[LEVEL_INTS - 2] = columnsLog;
        levels[LEVEL_INTS - 1] = rowsLog;
    }

    /** Sets what impulses of the step before are multiplied by. */
    void setWarmScale(float scale) {
        constants[WARM_SCALE] = Float.floatToRawIntBits(scale);
    }

    /** Sends both, in the order of the device's commands, where they are not there yet. */
    void send(ClBuffers buffers) {
        sentConstants = send(constants, sentConstants, buffers.get(ClBuffers.CONSTANTS));
        sentLevels = send(levels, sentLevels, buffers.get(ClBuffers.LEVELS));
    }

    private static int[] send(int[] words, int[] sent, DeviceBuffer to) {
        if (Arrays.equals(words, sent)) {
            return sent;
        }
        to.write(0, IntBuffer.wrap(words));
        if (sent.length != words.length) {
            return words.clone();
        }
        System.arraycopy(words, 0, sent, 0, words.length);
        return sent;
    }

    private void packConstants(StepConstants k) {
        float[] values = {
            k.dt,
            k.h,
            k.inverseH,
            k.gravityStepX,
            k.gravityStepY,
            k.biasRate,
            k.massScale,
            k.impulseScale,
            k.wallBiasRate,
            k.wallMassScale,
            k.wallImpulseScale,
            k.thresholdRate,
            k.pushPerLength,
            k.pushPerRoot,
            k.warmScale,
            k.bounds.minX(),
            k.bounds.minY(),
            k.bounds.maxX(),
            k.bounds.maxY()
        };
        for (int i = 0; i < values.length; i++) {
            constants[i] = Float.floatToRawIntBits(values[i]);
        }
        constants[values.length] = k.subSteps;
    }

    private void packLevels(Levels shape) {
        levels[0] = Float.floatToRawIntBits(shape.minX);
        levels[1] = Float.floatToRawIntBits(shape.minY);
        levels[2] = Float.floatToRawIntBits(shape.rmax);
        levels[3] = shape.usedCount;
        int at = 4;
        for (int level = 0; level < Levels.COUNT; level++) {
            levels[at + level] = Float.floatToRawIntBits(shape.inverseEdge[level]);
        }
        at += Levels.COUNT;
        System.arraycopy(shape.columnsLog, 0, levels, at, Levels.COUNT);
        at += Levels.COUNT;
        System.arraycopy(shape.rowsLog, 0, levels, at, Levels.COUNT);
        at += Levels.COUNT;
        System.arraycopy(shape.used, 0, levels, at, Levels.COUNT);
        at += Levels.COUNT;
        System.arraycopy(shape.first, 0, levels, at, Levels.COUNT + 1);
    }
}
