package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.KindMotion;
import io.github.circles2d.world.model.KindSleep;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.model.WallMotion;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;

/** Packs the constants of a step and the shape of the grids as structs of the kernels, and sends them if they changed. */
public final class StepParameters {
    static final HostStruct<StepConstants> CONSTANTS = new HostStruct<StepConstants>("StepConstants")
            .field("float", "dt", (k, to) -> to.put(k.dt), "length of the step, seconds")
            .field("float", "h", (k, to) -> to.put(k.h), "length of a sub-step")
            .field("float", "inverseH", (k, to) -> to.put(k.inverseH), "1 / length of a sub-step")
            .field("float", "gravityStepX", (k, to) -> to.put(k.gravityStepX), "gain of speed in a sub-step")
            .field("float", "gravityStepY", (k, to) -> to.put(k.gravityStepY), "the same")
            .field("float", "fallX", (k, to) -> to.put(k.fallX), "what gravity moves a circle in the step")
            .field("float", "fallY", (k, to) -> to.put(k.fallY), "the same")
            .field("float", "biasRate", (k, to) -> to.put(k.contactSoftness.biasRate), "softness of contacts")
            .field("float", "massScale", (k, to) -> to.put(k.contactSoftness.massScale), "share of the impulse")
            .field("float", "impulseScale", (k, to) -> to.put(k.contactSoftness.impulseScale), "decay of the impulse")
            .field("float", "wallBiasRate", (k, to) -> to.put(k.oneBodySoftness.biasRate), "softness of walls")
            .field("float", "wallMassScale", (k, to) -> to.put(k.oneBodySoftness.massScale), "the same")
            .field("float", "wallImpulseScale", (k, to) -> to.put(k.oneBodySoftness.impulseScale), "the same")
            .field("float", "thresholdRate", (k, to) -> to.put(k.thresholdRate), "bounce threshold")
            .field("float", "thresholdRateX", (k, to) -> to.put(k.thresholdRateX), "the same, across the x axis")
            .field("float", "thresholdRateY", (k, to) -> to.put(k.thresholdRateY), "the same, across the y axis")
            .field("float", "restRate", (k, to) -> to.put(k.restRate), "the same, without gravity")
            .field("float", "flightRestRate", (k, to) -> to.put(k.flightRestRate), "the same, in free flight")
            .field("float", "fixedThreshold", (k, to) -> to.put(k.fixedThreshold), "in place of all of these, or 0")
            .field("float", "pushRate", (k, to) -> to.put(k.pushRate), "push-out speed per sum of radii")
            .field("float", "deepRate", (k, to) -> to.put(k.deepRate), "its gain per depth of deep overlaps")
            .field("float", "warmScale", (k, to) -> to.put(k.warmScale), "see World")
            .field("float", "minX", (k, to) -> to.put(k.bounds.minX()), "the arena")
            .field("float", "minY", (k, to) -> to.put(k.bounds.minY()), "the same")
            .field("float", "maxX", (k, to) -> to.put(k.bounds.maxX()), "the same")
            .field("float", "maxY", (k, to) -> to.put(k.bounds.maxY()), "the same")
            .field("float", "gravityX", (k, to) -> to.put(k.gravityX), "of the world")
            .field("float", "gravityY", (k, to) -> to.put(k.gravityY), "the same")
            .field("int", "subSteps", (k, to) -> to.put(k.subSteps), "sub-steps of the step")
            .field("int", "driving", (k, to) -> to.put(k.driving ? 1 : 0), "1 where kinds or forces move circles")
            .field("int", "filtering", (k, to) -> to.put(k.filtering ? 1 : 0), "1 where pairs have to be filtered")
            .apart("sweeping", "1 where the step has the stage ContinuousCollision, else it does not take fast circles")
            .apart("thinning", "1 where the step thins crowds out, else it does not take them")
            .apart("tiled", "1 where the step is made by tiles");

    /** Read in memory where it is needed: few circles are at walls, and hardly any wall moves. */
    static final HostStruct<WallMotion> WALLS = new HostStruct<WallMotion>("WallMotion")
            .field("float", "travel[4]", WallMotion.COUNT, (m, to) -> to.put(m.travel), "by wall: what it comes in")
            .field("float", "sweep[4]", WallMotion.COUNT, (m, to) -> to.put(m.advance), "in a sub-step; 0 outwards")
            .field("float", "speed[4]", WallMotion.COUNT, (m, to) -> to.put(m.speed), "positive inwards")
            .field("int", "any", (m, to) -> to.put(m.any() ? 1 : 0), "whether any moves");

    static final HostStruct<GridLevels> LEVELS = new HostStruct<GridLevels>("Levels")
            .field("float", "minX", (s, to) -> to.put(s.minX), "where cells begin")
            .field("float", "minY", (s, to) -> to.put(s.minY), "the same")
            .field("float", "rmax", (s, to) -> to.put(s.rmax), "greatest radius")
            .field("int", "usedCount", (s, to) -> to.put(s.usedCount), "levels that have circles")
            .field("float", "inverseEdge[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.inverseEdge), "of a cell")
            .field("float", "top[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.top), "greatest radius")
            .field("int", "levelOf[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.levelOf), "by size class")
            .field("int", "columnsLog[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.columnsLog), "rounded up")
            .field("int", "rowsLog[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.rowsLog), "the same")
            .field("int", "columnCount[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.columnCount), "of the torus")
            .field("int", "rowCount[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.rowCount), "of the torus")
            .field("int", "used[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.used), "levels, finest first")
            .field(
                    "int",
                    "first[LEVELS + 1]",
                    GridLevels.COUNT + 1,
                    (s, to) -> to.put(s.first).put(s.buckets()),
                    "first bucket, and first group; and the end")
            .field("int", "haveSheets", (s, to) -> to.put(s.haveSheets() ? 1 : 0), "1 where sheetKey is in use")
            .field("int", "folded[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.folded), "1: cells share buckets")
            .field("int", "sheetsX[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.sheetsX), "before they begin again")
            .field("int", "sheetsY[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.sheetsY), "the same")
            .field("int", "edgeX", (s, to) -> to.put(s.bounds.edgeX().ordinal()), "EDGE_WALL, EDGE_OPEN, or it wraps")
            .field("int", "edgeY", (s, to) -> to.put(s.bounds.edgeY().ordinal()), "the same")
            .field("float", "periodX", (s, to) -> to.put(s.bounds.periodX()), "infinite if it does not wrap")
            .field("float", "periodY", (s, to) -> to.put(s.bounds.periodY()), "the same")
            .field("float", "lastX", (s, to) -> to.put(s.bounds.lastX()), "greatest coordinate, if it wraps")
            .field("float", "lastY", (s, to) -> to.put(s.bounds.lastY()), "the same")
            .field("float", "scaleX[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.scaleX), "see cellAlong")
            .field("float", "scaleY[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.scaleY), "the same")
            .field("int", "unitsX[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.unitsX), "of a cell, if it is open")
            .field("int", "unitsY[LEVELS]", GridLevels.COUNT, (s, to) -> to.put(s.unitsY), "the same")
            .apart("tileColumnsLog[LEVELS]", GridLevels.COUNT, "cells of a tile (Tiles.cl)")
            .apart("tileRowsLog[LEVELS]", GridLevels.COUNT, "the same")
            .apart("tilesAcross[LEVELS]", GridLevels.COUNT, "tiles side by side that may hold circles")
            .apart("firstTile[LEVELS]", GridLevels.COUNT, "first tile")
            .apart("tileCount", "tiles of all levels");

    /** No version is that. */
    private static final int NEVER = -1;

    private static final int WARM_SCALE = CONSTANTS.at("warmScale");
    private static final int SWEEPING = CONSTANTS.at("sweeping");
    private static final int THINNING = CONSTANTS.at("thinning");
    private static final int TILED = CONSTANTS.at("tiled");
    private static final int TILE_COLUMNS_LOG = LEVELS.at("tileColumnsLog[LEVELS]");
    private static final int TILE_ROWS_LOG = LEVELS.at("tileRowsLog[LEVELS]");
    private static final int TILES_ACROSS = LEVELS.at("tilesAcross[LEVELS]");
    private static final int FIRST_TILE = LEVELS.at("firstTile[LEVELS]");
    private static final int TILE_COUNT = LEVELS.at("tileCount");

    private final int[] constants = new int[CONSTANTS.words()];
    private final int[] levels = new int[LEVELS.words()];
    private final int[] walls = new int[WALLS.words()];
    private final int[] otherConstants = new int[CONSTANTS.words()];
    private final int[] otherLevels = new int[LEVELS.words()];
    private final int[] otherWalls = new int[WALLS.words()];
    private final int[] sentConstants = new int[CONSTANTS.words()];
    private final int[] sentLevels = new int[LEVELS.words()];
    /** The table of {@link DeviceArray#RESPONSES}; all zeros at first, as on the device. */
    private final int[] responses = new int[PairTable.WORDS];

    private int responsesVersion;
    private boolean responsesSent = true;
    private final IntBuffer responsesView = IntBuffer.wrap(responses);
    private final Table motion = new Table(KindMotion.of(PairTable.KINDS), 0);
    private final Table surfaces = new Table(KindSurface.FLOATS, DeviceArray.SURFACES_AT);
    private final Table sleep = new Table(KindSleep.of(PairTable.KINDS), DeviceArray.KIND_SLEEP_AT);

    /** Whether {@link #surfaces} has those of steps in which circles turn. */
    private boolean turning;

    private final TerrainUpload terrain = new TerrainUpload();
    private final JointUpload joints = new JointUpload();
    private final int[] sentWalls = new int[WALLS.words()];
    private final IntBuffer constantsView = IntBuffer.wrap(constants);
    private final IntBuffer levelsView = IntBuffer.wrap(levels);
    private final IntBuffer wallsView = IntBuffer.wrap(walls);

    /** Nothing has been sent. */
    public StepParameters() {
        // No constants and no shape are all zeros. The motion of walls may be, but it has no -1 at the end.
        Arrays.fill(sentWalls, -1);
        clearSurfaces();
    }

    /** What comes is of another world, whose tables may have the versions of those that have been sent. */
    public void forget() {
        responsesVersion = NEVER;
        motion.version = NEVER;
        surfaces.version = NEVER;
        sleep.version = NEVER;
        terrain.forget();
        joints.forget();
    }

    /** Takes down what the next steps are made with. */
    public void set(StepInput input, GridLevels shape) {
        CONSTANTS.pack(input.constants, constants);
        WALLS.pack(input.constants.walls, walls);
        LEVELS.pack(shape, levels);
        if (responsesVersion != input.responsesVersion) {
            System.arraycopy(input.responses, 0, responses, 0, responses.length);
            responsesVersion = input.responsesVersion;
            responsesSent = false;
        }
        motion.take(input.motion.rows, input.motion.version);
        sleep.take(input.sleep.rows, input.sleep.version);
        if (!surfacesAreOf(input)) {
            setSurfaces(input);
        }
        terrain.set(input);
        joints.set(input);
    }

    /** Makes room for tables of what was taken down last. */
    public void ensureRoom(DeviceArrays arrays) {
        terrain.ensureRoom(arrays);
        joints.ensureRoom(arrays);
    }

    /** The joints of what was taken down last. */
    public JointUpload joints() {
        return joints;
    }

    /** For steps that do not turn: surfaces that change nothing. */
    private void clearSurfaces() {
        Arrays.fill(surfaces.rows, 0f);
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            surfaces.rows[KindSurface.of(kind) + KindSurface.DAMPING_FACTOR] = 1f;
        }
    }

    private void setSurfaces(StepInput input) {
        turning = input.constants.turning;
        if (turning) {
            surfaces.copy(input.surfaces.rows, input.surfaces.version);
        } else {
            clearSurfaces();
            surfaces.isSent = false;
        }
    }

    private boolean surfacesAreOf(StepInput input) {
        return turning == input.constants.turning && (!turning || surfaces.version == input.surfaces.version);
    }

    /** Whether what was taken down last is these, but for what is set apart from it. */
    public boolean areOf(StepInput input, GridLevels shape) {
        System.arraycopy(constants, 0, otherConstants, 0, constants.length);
        System.arraycopy(levels, 0, otherLevels, 0, levels.length);
        CONSTANTS.pack(input.constants, otherConstants);
        WALLS.pack(input.constants.walls, otherWalls);
        LEVELS.pack(shape, otherLevels);
        otherConstants[WARM_SCALE] = constants[WARM_SCALE];
        return responsesVersion == input.responsesVersion
                && motion.version == input.motion.version
                && sleep.version == input.sleep.version
                && surfacesAreOf(input)
                && terrain.areOf(input)
                && joints.areOf(input)
                && Arrays.equals(constants, otherConstants)
                && Arrays.equals(levels, otherLevels)
                && Arrays.equals(walls, otherWalls);
    }

    /** Log2 of the columns and rows of cells of a tile, tiles side by side, and the number of the first. */
    public void setTiles(int level, int columnsLog, int rowsLog, int across, int first) {
        levels[TILE_COLUMNS_LOG + level] = columnsLog;
        levels[TILE_ROWS_LOG + level] = rowsLog;
        levels[TILES_ACROSS + level] = across;
        levels[FIRST_TILE + level] = first;
    }

    public void setTileCount(int tiles) {
        levels[TILE_COUNT] = tiles;
    }

    /** Sets what impulses of the step before are multiplied by. */
    public void setWarmScale(float scale) {
        constants[WARM_SCALE] = Float.floatToRawIntBits(scale);
    }

    /** Sets whether the step takes fast circles, and crowds, and whether it is made by tiles. */
    public void setWay(boolean sweeping, boolean thinning, boolean tiled) {
        constants[SWEEPING] = sweeping ? 1 : 0;
        constants[THINNING] = thinning ? 1 : 0;
        constants[TILED] = tiled ? 1 : 0;
    }

    /** Sends all, in the order of the device's commands, where they are not there yet. */
    public void send(DeviceArrays arrays) {
        send(constants, constantsView, sentConstants, arrays.get(DeviceArray.CONSTANTS));
        send(levels, levelsView, sentLevels, arrays.get(DeviceArray.LEVELS));
        send(walls, wallsView, sentWalls, arrays.get(DeviceArray.WALLS));
        if (!responsesSent) {
            arrays.get(DeviceArray.RESPONSES).write(0, responsesView);
            responsesSent = true;
        }
        motion.send(arrays, true);
        surfaces.send(arrays, arrays.features().turning());
        sleep.send(arrays, arrays.features().sleeping());
        terrain.send(arrays);
        joints.send(arrays);
    }

    private static void send(int[] words, IntBuffer view, int[] sent, DeviceBuffer to) {
        if (!Arrays.equals(words, sent)) {
            to.write(0, view);
            System.arraycopy(words, 0, sent, 0, words.length);
        }
    }

    /** A copy of a table of kinds of the host's, which changes with its version. */
    private static final class Table {
        final float[] rows;
        private final FloatBuffer view;

        /** Floats before it in the buffer of tables. */
        private final int at;

        int version;
        boolean isSent;

        Table(int floats, int at) {
            rows = new float[floats];
            view = FloatBuffer.wrap(rows);
            this.at = at;
        }

        void take(float[] from, int newVersion) {
            if (version != newVersion) {
                copy(from, newVersion);
            }
        }

        void copy(float[] from, int newVersion) {
            System.arraycopy(from, 0, rows, 0, rows.length);
            version = newVersion;
            isSent = false;
        }

        /** Sends it, unless it is there or has no room. */
        void send(DeviceArrays arrays, boolean hasRoom) {
            if (!isSent && hasRoom) {
                arrays.writeTable(at, view);
                isSent = true;
            }
        }
    }
}
