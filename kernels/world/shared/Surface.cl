// uses: world/shared/Velocity.cl
// Friction, rolling resistance and turning. The Java class Surface documents these formulas.

// Of all rows of a contact: how hard it acts, and what it gives along its normal, its tangent and angularly. The Java class ContactRows
// documents it.
float actingImpulse(float normalImpulse, RowImpulses i) { return normalImpulse; }
float impulseAlongNormal(float normalImpulse, RowImpulses i) { return normalImpulse; }
float tangentImpulse(RowImpulses i) { return i.FRICTION_IMPULSE; }
float angularImpulse(RowImpulses i) { return i.ROLLING_IMPULSE; }

// What those of a wall or piece give to a surface speed, by the inverse inertia.
float spinOfOneBody(RowImpulses i) { return angularImpulse(i) - tangentImpulse(i); }

#ifdef TURNING
// Whether some row of a contact has acted, which a visit may have to take back.
bool rowsHold(RowImpulses i) { return any(i != 0.0f); }

float friction(float a, float b) { return sqrt(a * b); }

// share: 1, or of B if it is heavy.
float tangentMass(float wA, float iA, float wB, float iB, float share) {
    return 1.0f / ((wA + iA) + share * (wB + iB));
}

float slip(float along, float sA, float sB, float belt) { return (along - (sA + sB)) - belt; }

float hitSlip(float friction_, float along, float sA, float sB, float belt) {
    return friction_ > 0.0f ? fabs(slip(along, sA, sB, belt)) : 0.0f;
}

float grip(float accumulated, float mass, float slip_, float limit) {
    return limit > 0.0f ? clampf(accumulated - mass * slip_, -limit, limit) : 0.0f;
}

// share: 1, or of B if it is heavy.
float rollingMass(float rA, float iA, float rB, float iB, float share) {
    return 1.0f / (iA / (rA * rA) + share * (iB / (rB * rB)));
}

float rolling(float accumulated, float mass, float omega, float limit) { return grip(accumulated, mass, omega, limit); }

float torqueGain(float torque, float inverseInertia, float r, float h) {
    return torque == 0.0f ? 0.0f : limitSpeed(torque / r * inverseInertia * h);
}

float afterAngularImpulse(float omega, float impulse, float r, float inverseInertia) {
    return limitSpeed(omega + impulse / r * inverseInertia / r);
}

// Whole turns are lost, as in Java.
int turn(int angle, float turned, float h, float r) {
    float units = turned * h / r * SURFACE_UNITS_PER_RADIAN;
    return (int) ((uint) angle + (uint) (ulong) (long) clampf(units, -0x1p62f, 0x1p62f));
}

float angularVelocity(float omega, float before, float after, float r) {
    return after == before ? omega : limitSpeed(after / r);
}
#endif
