package io.github.circles2d.demo;

/** A command line that the demo does not accept: what was wrong, and what is allowed. */
final class UsageException extends Exception {
    private static final long serialVersionUID = 1;

    UsageException(String message) {
        super(message);
    }
}
