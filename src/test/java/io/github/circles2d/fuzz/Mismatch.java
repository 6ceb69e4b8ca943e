package io.github.circles2d.fuzz;

/** A program has found that worlds differ, or that a promise is broken. */
final class Mismatch extends RuntimeException {
    private static final long serialVersionUID = 1;

    /** What is wrong, without the values. */
    private final String what;

    private int line;

    Mismatch(String what, String values) {
        super(what + ": " + values);
        this.what = what;
    }

    Mismatch(String what, Throwable cause) {
        super(what + ": " + cause, cause);
        this.what = what + " " + cause.getClass().getName();
    }

    /** Found in a line, or behind it. */
    Mismatch at(int number) {
        line = number;
        return this;
    }

    /** Where it was found; lines behind that are of no matter. */
    int line() {
        return line;
    }

    /** Says the same of a shorter program if that fails alike. */
    String what() {
        return what;
    }
}
