package io.github.circles2d.fuzz;

/** How much has been tried. */
final class Counts {
    int programs;
    long calls;
    long refused;
    long steps;

    /** Calls that have met an OutOfMemoryError. */
    long ended;

    /** Those of them that have lost the state, or ended a frame, and so were not made again. */
    long stopped;

    @Override
    public String toString() {
        return programs + " programs, " + calls + " calls, " + refused + " lines refused, " + steps
                + " lines of steps, " + ended + " calls without memory";
    }
}
