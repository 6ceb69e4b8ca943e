package io.github.circles2d.fuzz;

/**
 * An argument, or the receiver, of a call in a program. It is found once in the state before the call, in the first world, and handed to each
 * world. Its text is that of Java, as far as it can be.
 */
interface Value {
    /** The value, for all worlds: handles, numbers, arrays. */
    Object find(Player first);

    /** The same for one of the worlds, for one call. */
    default Object on(Player player, Object found) throws Throwable {
        return Copy.of(found);
    }
}
