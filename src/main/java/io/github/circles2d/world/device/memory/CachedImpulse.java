package io.github.circles2d.world.device.memory;

/** An entry of the impulse cache: an int4 of {@link DeviceArray#IMPULSE_CACHE}. */
public final class CachedImpulse {
    /** Ints of an entry. */
    public static final int STRIDE = 4;

    /** The id of its circle of higher id. */
    public static final int AT_HIGHER_ID = 0;

    /** The bits of its impulse. */
    public static final int AT_IMPULSE = 1;

    /** The next entry of its circle of lower id, or {@link #NONE}. */
    public static final int AT_NEXT = 2;

    /** No entry; in other arrays no slot or no id. */
    public static final int NONE = -1;

    /** Instead of a circle's first entry: impulses under its id are not its own. */
    public static final int FRESH = -2;

    private CachedImpulse() {}
}
