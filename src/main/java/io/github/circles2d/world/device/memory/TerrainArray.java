package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.model.PieceRow;

/** The tables of terrain on a device, behind {@link DeviceArray#TERRAIN}. It begins with a head: words before each of them, then what they have. */
enum TerrainArray implements TableRoom.Table {
    ROWS(Count.PIECES, PieceRow.STRIDE, "the rows of pieces"),
    TRAITS(Count.PIECES, PieceRow.traits(1), "their traits, an int4 each"),
    BOXES(Count.NODES, TerrainArray.BOX, "the boxes of nodes, a float4 each"),
    LINKS(Count.NODES, TerrainArray.LINK, "their links, an int2 each"),
    MOTION(Count.MOTION, 1, "the motion of bodies");

    /** What there is one element each of. */
    enum Count {
        PIECES,
        NODES,
        MOTION
    }

    // Of the head, behind the places of tables: numbers of nodes, of bodies, and of nodes of the ground, which come
    // first.
    static final int AT_NODES = 5;
    static final int AT_BODIES = 6;
    static final int AT_GROUND_NODES = 7;

    /** Floats of the box of a node. */
    static final int BOX = 4;

    /** Ints of its links. */
    static final int LINK = 2;

    /** Ints of the head: a multiple of 4. */
    static final int HEAD = 8;

    private final Count count;
    private final int words;
    private final String comment;

    TerrainArray(Count count, int words, String comment) {
        this.count = count;
        this.words = words;
        this.comment = comment;
    }

    /** Of no tables. */
    static TableRoom room() {
        return new TableRoom("terrain", HEAD, Count.values().length, values());
    }

    @Override
    public Count count() {
        return count;
    }

    @Override
    public int words() {
        return words;
    }

    String comment() {
        return comment;
    }
}
