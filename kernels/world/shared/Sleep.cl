// uses: world/shared/CircleMath.cl
// Which circles fall asleep, and which wake. The Java class Sleep explains it.

#ifdef SLEEPING
bool isAsleep(int rest) { return rest < 0; }

float drift(float radius, float gain_, float inverseH, float damping) {
    float drift_ = SLEEP_DRIFT * radius;
    return gain_ > 0.0f ? minf(drift_, SLEEP_SHARE_OF_FALL * (gain_ * inverseH) * (SLEEP_TIME * SLEEP_TIME))
                        : drift_ * minf(damping * SLEEP_TIME, 1.0f);
}

bool rests(float driftX, float driftY, int turned, float radius, float drift_) {
    return driftX * driftX + driftY * driftY <= drift_ * drift_ && fabs((float) turned) * SLEEP_RADIANS * radius <= drift_;
}

bool changes(float2 gain_, float knownX, float knownY, float h, float length_, float radius, float dt) {
    return lengthf(gain_.x - knownX * h, gain_.y - knownY * h) > SLEEP_CHANGE * length_ + SLEEP_ROUNDING * radius / dt;
}

int parts(float x, float gain_) { return (int) clampf(x / gain_ * SLEEP_PARTS, -SLEEP_MOST_PARTS, SLEEP_MOST_PARTS); }

int offset(float x, float y, float gain_) {
    return gain_ > 0.0f ? (parts(x, gain_) & 0xffff) | (int) ((uint) parts(y, gain_) << 16) : 0;
}

float offsetX(int offset_, float gain_) { return (float) (short) offset_ / SLEEP_PARTS * gain_; }
float offsetY(int offset_, float gain_) { return (float) (offset_ >> 16) / SLEEP_PARTS * gain_; }
bool stays(float base, float displacement) {
    return as_int(base + displacement) == as_int(base) && as_int(0.0f + displacement) == as_int(displacement);
}

bool fallsAsleep(int rest, float dt) { return (float) rest * dt >= SLEEP_TIME; }
float strong(float gainOfStep, float radius, float dt) { return maxf(gainOfStep, SLEEP_LEAST_WAKING * radius / dt); }

float hit(float approach, float separation, float inverseMass_, float otherInverseMass, float restitution, float impulse,
          float gainOfStep, float radius, float dt) {
    if (!(approach > 0.0f) || !(separation < approach * dt)) return 0.0f;
    float share = inverseMass_ / (inverseMass_ + otherInverseMass);
    float speed = share * (1.0f + restitution) * approach;
    float most = (impulse > 0.0f ? SLEEP_PUSH : SLEEP_HIT) * gainOfStep;
    return speed > most && speed > SLEEP_LEAST_HIT * radius / dt ? speed : 0.0f;
}

float tolerance(bool strict, float gain_, float load, float radius, float dt) {
    float byLoad = SLEEP_SHARE_OF_LOAD * maxf(load - SLEEP_FREE_WEIGHTS * gain_, 0.0f);
    float most = gain_ > 0.0f ? minf(byLoad, SLEEP_MOST_BY_LOAD * gain_) : byLoad;
    return (strict ? SLEEP_STRICT * gain_ : SLEEP_FLOOR * gain_ + most) + SLEEP_ROUNDING * radius / dt;
}

bool losesPatience(bool strict, float gain_, float imbalance, int steps) {
    return strict || gain_ == 0.0f || imbalance * (float) (steps * steps) >= SLEEP_PATIENCE * gain_;
}

float imbalanceOfStep(float imbalance, int subSteps, float radius, float dt) {
    return maxf(imbalance * (float) subSteps, SLEEP_LEAST_WAKING * radius / dt);
}

#ifdef JOINTS
bool drives(int angular, float speed, float maxTorque, int anchor) {
    return (angular == HOLD_TURN_SPEED && speed != 0.0f && maxTorque > 0.0f) || anchor != 0;
}

float ofSubStep(float sum, float warmScale, int subSteps) { return sum * warmScale / (float) subSteps; }
float loadOfJoint(float x, float y, bool elastic) { return (elastic ? SLEEP_SPRING_LOADS : 1.0f) * lengthf(x, y); }
#endif

float passedOn(float speed, float impulse, float load, float inverseMass_, float otherInverseMass, float gainOfStep) {
    float passed = speed * minf(2.0f * impulse / load, 1.0f) * minf(inverseMass_ / otherInverseMass, 1.0f);
    return passed > SLEEP_PUSH * gainOfStep ? passed : 0.0f;
}

float passedFreely(float speed, float separation, float inverseMass_, float otherInverseMass, float gainOfStep, float dt) {
    float passed = speed * (2.0f * inverseMass_ / (inverseMass_ + otherInverseMass));
    return separation < speed * dt && passed > SLEEP_HIT * gainOfStep ? passed : 0.0f;
}
#endif
