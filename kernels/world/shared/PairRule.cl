// uses: world/shared/CircleMath.cl
// Which pairs of circles become contacts.

// d: difference of the bases.
bool isNear(float dx, float dy, float speculativeDistance, float otherSpeculativeDistance) {
    float limit = speculativeDistance + otherSpeculativeDistance;
    return dx * dx + dy * dy < limit * limit;
}

// By paths: no only if timeOfImpact is at least 1. The Java class PairRule explains it.
bool mayTouch(float dx, float dy, float ux, float uy, float sum) {
    float b = dx * ux + dy * uy;
    float c = (dx * dx + dy * dy) - sum * sum;
    return maxf(c, 0.0f) < 2.5f * b;
}
