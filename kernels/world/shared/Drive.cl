// uses: world/shared/Velocity.cl world/stages/World.cl
// What moves a circle besides impulses: gravity, a force, damping, greatest speed. Steps in which gravity alone moves all circles (driving
// is 0) read none of it. OWN_MOTION: compiled for a world in which circles move in another way than those of their kind.

// By gravity, of speed in a sub-step.
float2 gravityGainOf(const World *w, int id, int kind) {
    IF_OWN_MOTION(float scale = w->ownMotion[id].OWN_GRAVITY_SCALE;)
    IF_OWN_MOTION(if (!isnan(scale)) return (float2)(gravityGain(w->k.gravityX, scale, w->k.h), gravityGain(w->k.gravityY, scale, w->k.h));)
    return w->kindMotion[2 * kind].xy;
}

// Of speed, in a sub-step.
float2 gainOf(const World *w, int id, float invMass) {
    if (w->k.driving == 0) return (float2)(w->k.gravityStepX, w->k.gravityStepY);
    CircleFields f = w->fields[id];
    float2 gravity = gravityGainOf(w, id, f.kind);
    return (float2)(gain(gravity.x, as_float(f.forceX), invMass, w->k.h), gain(gravity.y, as_float(f.forceY), invMass, w->k.h));
}

// Before any impulse. m: motion.
float2 drivenVelocity(const World *w, int id, float invMass, float4 m) {
    float4 kind = w->kindMotion[2 * w->fields[id].kind];
#ifdef OWN_MOTION
    float4 own = w->ownMotion[id];
    kind.z = orOfKind(dampingFactor(own.OWN_DAMPING, w->k.h), kind.z);
    kind.w = orOfKind(own.OWN_GREATEST_SPEED, kind.w);
#endif
    float2 added = gainOf(w, id, invMass);
    float x = beforeImpulse(m.VX, added.x, kind.z);
    float y = beforeImpulse(m.VY, added.y, kind.z);
    float share = shareWithin(x, y, kind.w);
    return (float2)(share * x, share * y);
}

// What a circle that is not static moves in a step if nothing comes in its way.
float2 drivenPath(const World *w, int id, float invMass, float4 m) {
    float4 kind = w->kindMotion[2 * w->fields[id].kind + 1];
#ifdef OWN_MOTION
    float4 own = w->ownMotion[id];
    if (!isnan(own.OWN_DAMPING)) {
        float factor = dampingFactor(own.OWN_DAMPING, w->k.h);
        kind.x = dampedTime(factor, w->k.subSteps, w->k.h, w->k.dt);
        kind.y = dampedFalls(factor, w->k.subSteps);
    }
    kind.z = orOfKind(own.OWN_GREATEST_SPEED * w->k.dt, kind.z);
#endif
    float2 added = gainOf(w, id, invMass);
    float x = plan(m.VX, kind.x, added.x * w->k.h * kind.y);
    float y = plan(m.VY, kind.x, added.y * w->k.h * kind.y);
    float share = shareWithin(x, y, kind.z);
    return (float2)(share * x, share * y);
}

// What the circle of a pair that is not static gains in a sub-step. If both fall, nobody asks.
bool needsGain(const World *w, float invMassA, float invMassB) {
    return w->k.driving != 0 && (invMassA == 0.0f || invMassB == 0.0f);
}

float2 gainOfPair(const World *w, uint slotA, float invMassA, uint slotB, float invMassB) {
    return invMassA == 0.0f ? gainOf(w, w->id[slotB], invMassB) : gainOf(w, w->id[slotA], invMassA);
}

float2 fallOfPair(const World *w, uint slotA, float invMassA, uint slotB, float invMassB) {
    if (needsGain(w, invMassA, invMassB)) return gainOfPair(w, slotA, invMassA, slotB, invMassB);
    return (float2)(w->k.gravityStepX, w->k.gravityStepY);
}
