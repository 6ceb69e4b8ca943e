package io.github.circles2d.world.queries;

/** The exact tests of one thing that a {@link BoxSearch} looks at. They compute in double precision; what touches exactly counts. */
abstract class ThingShape {
    // what normalAt and normalFrom find; the point of the surface is that of normalFrom alone
    double normalX;
    double normalY;
    double surfaceX;
    double surfaceY;

    /** Whether a disc of radius reach around (px, py) overlaps or touches it. */
    abstract boolean overlapsDisc(double px, double py, double reach);

    abstract boolean overlapsBox(double minX, double minY, double maxX, double maxY);

    /** The distance from a point to its surface; negative inside. */
    abstract double distance(double px, double py);

    /**
     * How far a disc of radius reach moves from (px, py) along the unit vector (ux, uy) until it touches the thing: 0 if it does at the start,
     * {@link CircleTests#NONE} if it does not within the distance. The vector may be 0, if the distance is 0.
     */
    abstract double castDistance(double px, double py, double reach, double ux, double uy, double most);

    /** Finds the normal of a hit: of a disc of radius reach that has come to (px, py) along (ux, uy). */
    abstract void normalAt(double px, double py, double reach, double ux, double uy);

    /** Finds the point of the surface that is nearest to a point, and the normal there. */
    abstract void normalFrom(double px, double py);
}
