// uses: world/shared/CircleMath.cl
// Velocities and paths, by component. The Java class Velocity documents them.

float limitSpeed(float v) { return clampf(v, -GREATEST_SPEED, GREATEST_SPEED); }
float afterImpulse(float v, float w, float impulse) { return limitSpeed(v + w * impulse); }
float beforeImpulse(float v, float gain, float dampingFactor) { return (v + gain) * dampingFactor; }

float shareWithin(float x, float y, float most) {
    float length = lengthf(x, y);
    return length > most ? most / length : 1.0f;
}

float gravityGain(float gravity, float scale, float h) { return limitSpeed(gravity * scale) * h; }
float dampingFactor(float damping, float h) { return 1.0f / (1.0f + damping * h); }

float dampedTime(float factor, int subSteps, float h, float dt) {
    float power = 1.0f;
    float powers = 0.0f;
    for (int subStep = 0; subStep < subSteps; subStep++) {
        power *= factor;
        powers += power;
    }
    return factor == 1.0f ? dt : h * powers;
}

float dampedFalls(float factor, int subSteps) {
    float power = 1.0f;
    float powers = 0.0f;
    float falls = 0.0f;
    for (int subStep = 0; subStep < subSteps; subStep++) {
        power *= factor;
        powers += power;
        falls += powers;
    }
    return falls;
}

float gain(float gravityGain, float force, float w, float h) {
    return force == 0.0f ? gravityGain : limitSpeed(gravityGain + force * w * h);
}

float plan(float v, float dt, float fall) { return v * dt + fall; }
float travelSpeed(float from, float to, float dt, float period) { return limitSpeed(shortWay(to - from, period) / dt); }
