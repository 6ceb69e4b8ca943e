package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.model.PieceRow;

/**
 * Where the tables of terrain lie behind {@link DeviceArray#TERRAIN}, which begins with a head: so many floats before the rows of pieces, their
 * traits, the boxes of nodes, their links, and the motion of bodies; then the number of nodes, and of rows of bodies.
 */
final class TerrainRoom {
    static final int ROWS = 0;
    static final int TRAITS = 1;
    static final int BOXES = 2;
    static final int LINKS = 3;
    static final int MOTION = 4;
    static final int NODES = 5;
    static final int BODIES = 6;

    /** Number of nodes of the ground, which come first. */
    static final int GROUND_NODES = 7;

    /** Ints of the head: a multiple of 4, as all that follows, for kernels that read vectors. */
    static final int HEAD = 8;

    /** Floats of the box of a node. */
    static final int BOX = 4;

    /** Ints of its links. */
    static final int LINK = 2;

    private int pieces;
    private int nodes;
    private int motionFloats;

    /** Counts how often tables have moved, which then have to be written again. */
    private int version;

    /** More room, if this is too little; or null. */
    TerrainRoom with(int morePieces, int moreNodes, int moreFloats) {
        if (morePieces <= pieces && moreNodes <= nodes && moreFloats <= motionFloats) {
            return null;
        }
        TerrainRoom more = new TerrainRoom();
        more.pieces = room(pieces, morePieces);
        more.nodes = room(nodes, moreNodes);
        more.motionFloats = room(motionFloats, moreFloats);
        return more;
    }

    private static int room(int capacity, int needed) {
        return needed <= capacity ? capacity : DeviceArrays.grown(capacity, needed);
    }

    /** Becomes as another one. */
    void take(TerrainRoom other) {
        pieces = other.pieces;
        nodes = other.nodes;
        motionFloats = other.motionFloats;
        version++;
    }

    int version() {
        return version;
    }

    /** Floats of all tables, with those before these: a multiple of 4, since kernels read vectors behind them. */
    int floats() {
        return DeviceArray.TERRAIN_AT + at(MOTION) + motionFloats + 3 & ~3;
    }

    /** Floats from {@link DeviceArray#TERRAIN} to a part of one of these tables, which has room for it: others lie behind it. */
    int at(int table, int from, int to) {
        int room =
                switch (table) {
                    case ROWS -> PieceRow.of(pieces);
                    case TRAITS -> PieceRow.traits(pieces);
                    case BOXES -> BOX * nodes;
                    case LINKS -> LINK * nodes;
                    default -> motionFloats;
                };
        return at(table) + DeviceArrays.requireRange("terrain", table, from, to, room);
    }

    /** Floats from {@link DeviceArray#TERRAIN} to one of these. */
    int at(int table) {
        int rows = HEAD;
        int traits = rows + PieceRow.of(pieces);
        int boxes = traits + PieceRow.traits(pieces);
        int links = boxes + BOX * nodes;
        int motion = links + LINK * nodes + 3 & ~3;
        return switch (table) {
            case ROWS -> rows;
            case TRAITS -> traits;
            case BOXES -> boxes;
            case LINKS -> links;
            case MOTION -> motion;
            default -> throw new IllegalArgumentException("no table " + table);
        };
    }
}
