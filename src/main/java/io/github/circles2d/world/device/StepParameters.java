package io.github.circles2d.world.device;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepConstants;
import java.nio.IntBuffer;
import java.util.Arrays;

/** Packs the constants of a step and the shape of the grids as the structs of {@code World.cl}, and sends what changed. */
final class StepParameters {
    private static final int FLOATS = 22;
    static final int CONSTANT_INTS = FLOATS + 4;
    static final int LEVEL_INTS = 4 + 9 * GridLevels.COUNT + 5;

    // Positions of single constants.
    private static final int WARM_SCALE = 17;
    private static final int SUB_STEPS = FLOATS;
    private static final int SWEEPING = FLOATS + 1;
    private static final int THINNING = FLOATS + 2;
    private static final int TILED = FLOATS + 3;

    private final int[] constants = new int[CONSTANT_INTS];
    private final int[] levels = new int[LEVEL_INTS];
    private final int[] otherConstants = new int[CONSTANT_INTS];
    private final int[] otherLevels = new int[LEVEL_INTS];
    private final int[] sentConstants = new int[CONSTANT_INTS];
    private final int[] sentLevels = new int[LEVEL_INTS];
    private final IntBuffer constantsView = IntBuffer.wrap(constants);
    private final IntBuffer levelsView = IntBuffer.wrap(levels);

    /** Takes down what the next steps are made with. */
    void set(StepConstants k, GridLevels shape) {
        packConstants(k, constants);
        packLevels(shape, levels);
    }

    /** Whether what was taken down last is these, but for what is set apart from it. */
    boolean areOf(StepConstants k, GridLevels shape) {
        System.arraycopy(constants, 0, otherConstants, 0, CONSTANT_INTS);
        System.arraycopy(levels, 0, otherLevels, 0, LEVEL_INTS);
        packConstants(k, otherConstants);
        packLevels(shape, otherLevels);
        otherConstants[WARM_SCALE] = constants[WARM_SCALE];
        return Arrays.equals(constants, otherConstants) && Arrays.equals(levels, otherLevels);
    }

    /** Sets the size of a tile, log2 of its columns and rows of cells, and how many there are side by side and in a column. */
    void setTile(int columnsLog, int rowsLog, int across, int down) {
        levels[LEVEL_INTS - 4] = columnsLog;
        levels[LEVEL_INTS - 3] = rowsLog;
        levels[LEVEL_INTS - 2] = across;
        levels[LEVEL_INTS - 1] = down;
    }

    /** Sets what impulses of the step before are multiplied by. */
    void setWarmScale(float scale) {
        pack(constants, WARM_SCALE, scale);
    }

    /** Sets whether the step takes fast circles, and crowds, and whether it is made by tiles. */
    void setPlan(boolean sweeping, boolean thinning, boolean tiled) {
        constants[SWEEPING] = sweeping ? 1 : 0;
        constants[THINNING] = thinning ? 1 : 0;
        constants[TILED] = tiled ? 1 : 0;
    }

    /** Sends both, in the order of the device's commands, where they are not there yet. */
    void send(DeviceArrays buffers) {
        send(constants, constantsView, sentConstants, buffers.get(DeviceArrays.CONSTANTS));
        send(levels, levelsView, sentLevels, buffers.get(DeviceArrays.LEVELS));
    }

    private static void send(int[] words, IntBuffer view, int[] sent, DeviceBuffer to) {
        // No constants and no shape are all zeros.
        if (!Arrays.equals(words, sent)) {
            to.write(0, view);
            System.arraycopy(words, 0, sent, 0, words.length);
        }
    }

    private static void packConstants(StepConstants k, int[] to) {
        pack(to, 0, k.dt);
        pack(to, 1, k.h);
        pack(to, 2, k.inverseH);
        pack(to, 3, k.gravityStepX);
        pack(to, 4, k.gravityStepY);
        pack(to, 5, k.fallX);
        pack(to, 6, k.fallY);
        pack(to, 7, k.biasRate);
        pack(to, 8, k.massScale);
        pack(to, 9, k.impulseScale);
        pack(to, 10, k.wallBiasRate);
        pack(to, 11, k.wallMassScale);
        pack(to, 12, k.wallImpulseScale);
        pack(to, 13, k.thresholdRate);
        pack(to, 14, k.restRate);
        pack(to, 15, k.pushPerLength);
        pack(to, 16, k.pushPerRoot);
        pack(to, WARM_SCALE, k.warmScale);
        pack(to, 18, k.bounds.minX());
        pack(to, 19, k.bounds.minY());
        pack(to, 20, k.bounds.maxX());
        pack(to, 21, k.bounds.maxY());
        to[SUB_STEPS] = k.subSteps;
    }

    private static void pack(int[] to, int at, float value) {
        to[at] = Float.floatToRawIntBits(value);
    }

    private static void packLevels(GridLevels shape, int[] levels) {
        levels[0] = Float.floatToRawIntBits(shape.minX);
        levels[1] = Float.floatToRawIntBits(shape.minY);
        levels[2] = Float.floatToRawIntBits(shape.rmax);
        levels[3] = shape.usedCount;
        int at = 4;
        for (int level = 0; level < GridLevels.COUNT; level++) {
            levels[at + level] = Float.floatToRawIntBits(shape.inverseEdge[level]);
        }
        at += GridLevels.COUNT;
        for (int level = 0; level < GridLevels.COUNT; level++) {
            levels[at + level] = Float.floatToRawIntBits(shape.top[level]);
        }
        at += GridLevels.COUNT;
        System.arraycopy(shape.levelOf, 0, levels, at, GridLevels.COUNT);
        at += GridLevels.COUNT;
        System.arraycopy(shape.columnsLog, 0, levels, at, GridLevels.COUNT);
        at += GridLevels.COUNT;
        System.arraycopy(shape.rowsLog, 0, levels, at, GridLevels.COUNT);
        at += GridLevels.COUNT;
        System.arraycopy(shape.columnCount, 0, levels, at, GridLevels.COUNT);
        at += GridLevels.COUNT;
        System.arraycopy(shape.rowCount, 0, levels, at, GridLevels.COUNT);
        at += GridLevels.COUNT;
        System.arraycopy(shape.used, 0, levels, at, GridLevels.COUNT);
        at += GridLevels.COUNT;
        System.arraycopy(shape.first, 0, levels, at, GridLevels.COUNT);
        levels[at + GridLevels.COUNT] = shape.buckets();
    }
}
