// uses: world/shared/CircleMath.cl
// What a visit of a joint does to its impulses, and angles. The Java class JointMath documents these formulas.

#ifdef JOINTS
float keptImpulse(float impulse) { return clampf(impulse, -JOINT_GREATEST_IMPULSE, JOINT_GREATEST_IMPULSE); }
float jointMass(float inverse) { return inverse > 0.0f ? 1.0f / inverse : 0.0f; }

float springShare(float share, float split) { return maxf(split * share, 1.0f); }

bool jointLoads(float strain, float radius) { return strain > JOINT_STRAIN * radius; }

float solvedImpulse(float impulse, float m, float v, float c, float massScale, float biasRate, float impulseScale) {
    return keptImpulse((impulse - m * (massScale * v + massScale * (biasRate * c))) - impulseScale * impulse);
}

float greatestPush(float radius, float inverseH) { return JOINT_PUSH * radius * inverseH; }

float heldUnkept(float impulse, float m, float v, float c, float massScale, float biasRate, float impulseScale, float most) {
    float soft = m * (massScale * (biasRate * c)) + impulseScale * impulse;
    return (impulse - m * (massScale * v)) - clampf(soft, -1.0f * (m * most), m * most);
}

float heldImpulse(float impulse, float m, float v, float c, float massScale, float biasRate, float impulseScale, float most) {
    return keptImpulse(heldUnkept(impulse, m, v, c, massScale, biasRate, impulseScale, most));
}

float relaxedImpulse(float impulse, float m, float v) { return keptImpulse(impulse - m * v); }

float springImpulse(float m, float v, float begun, float c, float now, float ofBegun, float way) {
    return keptImpulse(-1.0f * (m * ((now * v + ofBegun * begun) + way * c)));
}

float solvedLimit(float impulse, float m, float v, float gap, float inverseH, float massScale, float biasRate, float impulseScale,
                  float most) {
    float next = gap > 0.0f ? impulse - m * (v + gap * inverseH)
                            : heldUnkept(impulse, m, v, gap, massScale, biasRate, impulseScale, most);
    return clampf(next, 0.0f, JOINT_GREATEST_IMPULSE);
}

float relaxedLimit(float impulse, float m, float v, float gap, float inverseH) {
    float next = impulse - m * (gap > 0.0f ? v + gap * inverseH : v);
    return clampf(next, 0.0f, JOINT_GREATEST_IMPULSE);
}

// As in Java, integers overflow.
int turnSince(int angle, int reference) { return (int) ((uint) angle - (uint) reference); }

float turnedAway(int angleA, int referenceA, float turnedA, int angleB, int referenceB, float turnedB) {
    int units = turnSince(turnSince(angleA, referenceA), turnSince(angleB, referenceB));
    return (float) units * JOINT_RADIANS_PER_UNIT + (turnedA - turnedB);
}

int meanTurn(int angleA, int referenceA, float turnedA, int angleB, int referenceB, float turnedB) {
    int a = turnSince(angleA, referenceA);
    int b = turnSince(angleB, referenceB);
    float half_ = 0.5f * (turnedA + turnedB) * SURFACE_UNITS_PER_RADIAN;
    uint units = (uint) (ulong) (long) clampf(half_, -0x1p62f, 0x1p62f);
    return (int) ((uint) b + (uint) (turnSince(a, b) >> 1) + units);
}

float sinOfEighth(float x) {
    float z = x * x;
    return x + x * (z * (-1.6666667e-1f + z * (8.3333310e-3f + z * -1.9840874e-4f)));
}

float cosOfEighth(float x) {
    float z = x * x;
    return 1.0f - z * (0.5f - z * (4.1666666e-2f + z * (-1.3888397e-3f + z * 2.4760495e-5f)));
}

float sinOfUnits(int units) {
    uint quarter = ((uint) units + (1u << 29)) >> 30;
    float x = (float) (int) ((uint) units - (quarter << 30)) * JOINT_RADIANS_PER_UNIT;
    float value = (quarter & 1) == 0 ? sinOfEighth(x) : cosOfEighth(x);
    return (quarter & 2) == 0 ? value : -1.0f * value;
}

float cosOfUnits(int units) { return sinOfUnits((int) ((uint) units + (1u << 30))); }
#endif
