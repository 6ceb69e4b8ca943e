// uses: world/shared/CircleMath.cl
// Velocities and paths, by component. The Java class Velocity documents them.

float limitSpeed(float v) { return clampf(v, -GREATEST_SPEED, GREATEST_SPEED); }
float afterImpulse(float v, float w, float impulse) { return limitSpeed(v + w * impulse); }
float beforeImpulse(float v, float gain, float dampingFactor) { return (v + gain) * dampingFactor; }

float shareWithin(float x, float y, float most) {
    float length = lengthf(x, y);
    return length > most ? most / length : 1.0f;
}

float gain(float gravityGain, float force, float w, float h) {
    return force == 0.0f ? gravityGain : limitSpeed(gravityGain + force * w * h);
}

float plan(float v, float dt, float fall) { return v * dt + fall; }
float travelSpeed(float from, float to, float dt, float period) { return limitSpeed(shortWay(to - from, period) / dt); }
