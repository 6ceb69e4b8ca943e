package io.github.circles2d;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Tells a user once what is worth knowing once, and those who debug every time. */
final class Notice {
    private static final Set<String> GIVEN = ConcurrentHashMap.newKeySet();

    private Notice() {}

    /**
     * Returns the level to log something at.
     *
     * @param first the level of the first time
     * @param subject what makes two notices the same
     * @return that level, or DEBUG if it has been given before
     */
    static System.Logger.Level level(System.Logger.Level first, String subject) {
        return GIVEN.add(subject) ? first : System.Logger.Level.DEBUG;
    }
}
