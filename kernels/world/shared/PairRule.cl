// uses: world/shared/Arithmetic.cl
// Which pairs of circles become contacts.

// Whether two circles may meet within the step. dx, dy: difference of the bases; reaches: the sum of both.
bool isNear(float dx, float dy, float reaches) { return dx * dx + dy * dy < reaches * reaches; }

// Whether two circles may touch within the step, by their paths: no only where timeOfImpact is at least 1, as the Java class PairRule
// explains. dx, dy: difference of the positions; ux, uy: of the paths; sum: of the radii.
bool mayTouch(float dx, float dy, float ux, float uy, float sum) {
    float b = dx * ux + dy * uy;
    float c = (dx * dx + dy * dy) - sum * sum;
    return maxf(c, 0.0f) < 2.5f * b;
}
