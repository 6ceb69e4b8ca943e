// uses: world/shared/Velocity.cl world/stages/World.cl
// What moves a circle besides impulses: gravity, a force, damping, greatest speed. Steps in which gravity alone moves all circles (driving
// is 0) read none of it.

// Of speed, in a sub-step.
float2 gainOf(const World *w, int id, float invMass) {
    if (w->k.driving == 0) return (float2)(w->k.gravityStepX, w->k.gravityStepY);
    CircleFields f = w->fields[id];
    float2 gravity = w->kindMotion[2 * f.kind].xy;
    return (float2)(gain(gravity.x, as_float(f.forceX), invMass, w->k.h), gain(gravity.y, as_float(f.forceY), invMass, w->k.h));
}

// Before any impulse. m: motion.
float2 drivenVelocity(const World *w, int id, float invMass, float4 m) {
    float4 kind = w->kindMotion[2 * w->fields[id].kind];
    float2 added = gainOf(w, id, invMass);
    float x = beforeImpulse(m.VX, added.x, kind.z);
    float y = beforeImpulse(m.VY, added.y, kind.z);
    float share = shareWithin(x, y, kind.w);
    return (float2)(share * x, share * y);
}

// What a circle that is not static moves in a step if nothing comes in its way.
float2 drivenPath(const World *w, int id, float invMass, float4 m) {
    float4 kind = w->kindMotion[2 * w->fields[id].kind + 1];
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
