// uses: world/shared/PairRule.cl world/shared/Paths.cl world/shared/TimeOfImpact.cl world/stages/World.cl
// Static circles that move take along what they come upon. The Java class Carrying explains it, function by function.

// If no static circle takes it along.
float freeShare(const World *w, int slot) { return minf(as_float(w->timeOfImpact[slot]), minf(w->near[slot].CONTACT_SHARE, 1.0f)); }

// A share of the step; more than 1: never.
float carryTime(const World *w, int slot) { return as_float(w->carryTime[slot]); }

// Whether the contact of this step suffices, since they are close or hardly move against each other.
bool contactHas(const World *w, int slot, int other, float r, float ro, float4 d) {
    if (isNear(d.x, d.y, r + MARGIN * r, ro + MARGIN * ro)) return true;
    return isNear(d.x, d.y, w->sight[slot].SIGHT_DISTANCE, w->sight[other].SIGHT_DISTANCE) && !isLonger(d.z, d.w, (0.5f * CAP) * (r + ro));
}

// When a static circle takes another along; with note, the second time, which one is first.
void meetCarried(const World *w, int slot, int other, bool note) {
    float4 c = w->circle[slot];
    float4 o = w->circle[other];
    float4 path = w->motionClamp[slot];
    float4 pathOfOther = w->motionClamp[other];
    float4 d = (float4)(ACROSS_X(w, o.x - c.x), ACROSS_Y(w, o.y - c.y), path.PATH_X - pathOfOther.PATH_X, path.PATH_Y - pathOfOther.PATH_Y);
    float t = timeOfCarry(d.x, d.y, path.PATH_X, path.PATH_Y, pathOfOther.PATH_X, pathOfOther.PATH_Y,
                          freeShare(w, other), o.RADIUS, c.RADIUS + o.RADIUS);
    bool carries = isFast(path.PATH_LENGTH, o.RADIUS) ? t <= 1.0f : t < 1.0f && !contactHas(w, slot, other, c.RADIUS, o.RADIUS, d);
    if (!carries) return;
    if (!note) {
        atomic_min(&w->carryTime[other], as_int(t));
    } else if (w->carryTime[other] == as_int(t)) {
        atomic_min(&w->carrier[other], slot);
    }
}
