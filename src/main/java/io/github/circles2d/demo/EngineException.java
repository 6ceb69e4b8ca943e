package io.github.circles2d.demo;

/** An engine that cannot be opened or cannot go on, with a message for the person at the screen. */
final class EngineException extends Exception {
    private static final long serialVersionUID = 1;

    EngineException(String message, Throwable cause) {
        super(message, cause);
    }
}
