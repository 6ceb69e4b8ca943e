package io.github.circles2d;

import java.util.Collections;
import java.util.HashSet;
import java.util.Set;

/** Tells a user once what is worth knowing once, and those who debug every time. */
final class Notice {
    private static final Set<String> GIVEN = Collections.synchronizedSet(new HashSet<>());

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

    /** Logs a text of World at DEBUG. Does nothing on Android, which has no System.Logger. */
    static void debug(String text) {
        try {
            WorldLog.LOG.log(System.Logger.Level.DEBUG, text);
        } catch (LinkageError e) {
            return; // No world fails because it cannot say what it runs on.
        }
    }

    /** The logger, made when it is first used. */
    private static final class WorldLog {
        static final System.Logger LOG = System.getLogger(World.class.getName());
    }
}
