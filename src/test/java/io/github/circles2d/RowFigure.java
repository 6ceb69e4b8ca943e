package io.github.circles2d;

/**
 * A figure of World on a scene of the page on its physics.
 *
 * @param row the row of the table
 * @param what what was measured, with its unit
 * @param exact what theory says; NaN if it says nothing
 * @param box2d that of Box2D v3 (main of August 2026) on the same scene, with as many sub-steps; NaN if it was not measured
 * @param least what is asked of World at least
 * @param greatest what is asked of World at most
 * @param floor what the tests ask of a figure that is not met yet; NaN if it is
 */
record RowFigure(
        String row,
        String what,
        double exact,
        double box2d,
        double least,
        double greatest,
        double floor,
        double world) {
    /** A figure that is to be the exact one, but for a share of it. */
    static RowFigure share(String row, String what, double exact, double box2d, double share, double world) {
        return within(row, what, exact, box2d, share * Math.abs(exact), world);
    }

    /** A figure that is to be the exact one, but for a difference. */
    static RowFigure within(String row, String what, double exact, double box2d, double difference, double world) {
        return new RowFigure(row, what, exact, box2d, exact - difference, exact + difference, Double.NaN, world);
    }

    /** A figure that theory does not say. */
    static RowFigure between(String row, String what, double box2d, double least, double greatest, double world) {
        return new RowFigure(row, what, Double.NaN, box2d, least, greatest, Double.NaN, world);
    }

    /** This figure, which does not meet what is asked yet, but is not to be worse than another one. */
    RowFigure notBelow(double floor) {
        return new RowFigure(row, what, exact, box2d, least, greatest, floor, world);
    }

    boolean met() {
        return world >= least && world <= greatest;
    }

    /** Whether it is met, or not worse than it was. */
    boolean holds() {
        return met() || world >= floor;
    }

    @Override
    public String toString() {
        return row + ": " + what + " is " + world + ", asked is " + least + " to " + greatest + ", exact is " + exact;
    }
}
