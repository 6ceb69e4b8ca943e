package io.github.circles2d;

/** Takes the place of {@link Notice} in browsers, whose console is the game's. */
final class BrowserNotice {
    private BrowserNotice() {}

    static void once(String subject, String text) {}

    static void debug(String text) {}
}
