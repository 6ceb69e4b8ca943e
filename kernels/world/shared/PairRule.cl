// uses: world/shared/Real.cl*LANES
// Which pairs of circles become contacts.

// Whether two circles may meet within the step. dx, dy: difference of the bases; reaches: the sum of both.
MASK NAME(isNear)(REAL dx, REAL dy, REAL reaches) { return dx * dx + dy * dy < reaches * reaches; }

// Whether two circles may touch within the step, by their paths: no only where timeOfImpact is at least 1, as the Java class PairRule
// explains. dx, dy: difference of the positions; ux, uy: of the paths; sum: of the radii.
MASK NAME(mayTouch)(REAL dx, REAL dy, REAL ux, REAL uy, REAL sum) {
    REAL b = dx * ux + dy * uy;
    REAL c = (dx * dx + dy * dy) - sum * sum;
    return NAME(greatest)(c, (REAL)(0.0f)) < 2.5f * b;
}
