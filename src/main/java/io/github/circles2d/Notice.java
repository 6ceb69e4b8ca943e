package io.github.circles2d;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Logs what a user should be told of once: the first time at a level that is seen, later for those who debug. */
final class Notice {
    private static final Set<String> GIVEN = ConcurrentHashMap.newKeySet();

    private Notice() {}

    /**
     * Logs a text.
     *
     * @param log where
     * @param level the level of the first time
     * @param subject what makes two notices the same
     * @param text what to say
     */
    static void once(System.Logger log, System.Logger.Level level, String subject, String text) {
        log.log(GIVEN.add(subject) ? level : System.Logger.Level.DEBUG, text);
    }
}
