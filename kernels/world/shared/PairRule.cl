// uses: world/shared/Real.cl*LANES
// Which pairs of circles become contacts.

// Whether two circles may meet within the step. dx, dy: difference of the bases; reaches: the sum of both.
MASK NAME(isNear)(REAL dx, REAL dy, REAL reaches) { return dx * dx + dy * dy < reaches * reaches; }
