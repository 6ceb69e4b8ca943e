package io.github.circles2d.world.device.memory;

/** The room of a tile and the layout of its record, for host and kernels; {@code kernels/world/tiles/Tiles.cl} explains them. */
public final class TileRecord {
    /** In local memory: as few as the largest size needs for packed circles, since more room means fewer work-groups at once. */
    public static final int CIRCLES = 1312;

    /**
     * Contacts that a tile has room for: their numbers, and differences of these, are shorts. A pass notes their parts in local memory. With
     * 2,048 more, seven work-groups of it would leave a compute unit of Hopper 28 KiB of cache, not 60.
     */
    public static final int CONTACTS = 22 << 10;

    /** Rounds that there is room for. */
    public static final int ROUNDS = 416;

    /** Work-items of a work-group: at least as many as a colour has groups around a tile. */
    public static final int GROUP = 128;

    /** Parts of rounds that there is room for. */
    public static final int PARTS = ROUNDS + CONTACTS / GROUP;

    /** Copies that tiles make of two contacts, as far as there is room for them from the start: 1.5 of each with usual tiles. */
    private static final int COPIES_IN_TWO = 3;

    /** A peak that says that no tile would do. */
    public static final int NONE = Integer.MAX_VALUE;

    // A record begins with the numbers of its circles, of its parts and of its first copy, where it is if tiles are
    // listed, and whether
    // nothing moves in it.
    public static final int AT_CIRCLES = 0;
    public static final int AT_PARTS = 1;
    public static final int AT_COPIES = 2;
    public static final int AT_CUT = 3;
    public static final int AT_STILL = 4;

    /** By part its first contact, and the end. */
    public static final int AT_STARTS = 5;

    public static final int AT_SLOTS = AT_STARTS + PARTS + 2;

    /** Ints of a record. */
    public static final int WORDS = AT_SLOTS + CIRCLES;

    private TileRecord() {}

    /** Room for copies from the start, where there is room for so many contacts. */
    static int copies(int contacts) {
        return (contacts >> 1) * COPIES_IN_TWO;
    }
}
