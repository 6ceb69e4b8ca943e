// uses: world/shared/CircleMath.cl
// A circle and the nearer wall of an axis. The Java class Walls documents it.

float wallSide(float x, float min, float max) { return x - min <= max - x ? 1.0f : -1.0f; }

float wallGap(float base, float displacement, float r, float side, float min, float max) {
    return side > 0.0f ? ((base - min) - r) + displacement : ((max - base) - r) - displacement;
}

float marginAtWall(float from, float to, float margin) {
    return from == to || fabs(to - from) > margin ? margin : 0.0f;
}

float wallImpulse(float sign, float side) { return maxf(side * sign, 0.0f); }

float stopAtFarWall(float v, float displacement, float kept, float side) {
    return (side > 0.0f ? kept < displacement : kept > displacement) ? 0.0f : v;
}

float tangentAlong(int axis, float side) { return axis == 0 ? side : -side; }
