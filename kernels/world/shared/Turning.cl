// uses: world/shared/Wall.cl
// How a circle turns through a step. The Java class world.jvm.state.Turning does the same.

#ifdef TURNING
// Makes a circle ready for a step. c: circle; from: the slot at home.
void gatherTurning(const World *w, int slot, int from, int id, float4 c, float inverseMass) {
    global const float *kind = w->surfaces + SURFACE_STRIDE * w->fields[id].kind;
    bool any = w->surfaces[SURFACE_OWN] != 0.0f;
    int2 turn_ = w->homeTurn[from];
    float4 own = any ? w->homeOwn[from] : INITIAL_OWN;
    global float *surface = surfaceOfCircle(w, slot);
    vstore8(vload8(0, kind), 0, surface);
    for (int k = 0; k < SURFACE_FIELDS; k++) {
        surface[SURFACE_OF_CIRCLES + k] = orOfKind(((const float *) &own)[k], kind[SURFACE_OF_CIRCLES + k]);
    }
    w->turn[slot] = turn_;
    if (any) w->own[slot] = own;
    w->wallRows[slot] = w->homeWallRows[from];
    w->surfaceSpeed[slot] = as_float(turn_.ANGULAR_VELOCITY) * c.RADIUS;
    w->spinImpulse[slot] = 0.0f;
    w->turned[slot] = 0.0f;
    w->inverseInertia[slot] = inverseMass * kind[SURFACE_INERTIA];
}

// The surface speed s of a circle that is not static, as it starts into a sub-step: a torque, damping, the impulses of the one before.
// Until the move, their place has the speed before impulses, for bodies and those who record touches.
float startedSpin(const World *w, int slot, float r, float s, float impulse) {
    float inertia = w->inverseInertia[slot];
    float before = s + 0.0f;
    if (w->surfaces[SURFACE_DRIVES] != 0.0f) {
        float torque = w->surfaces[SURFACE_OWN] != 0.0f ? w->own[slot].OWN_TORQUE : 0.0f;
        before = beforeImpulse(s, torqueGain(torque, inertia, r, w->k.h), surfaceOfCircle(w, slot)[SURFACE_DAMPING_FACTOR]);
    }
#if defined(RECORDING) || defined(BODIES)
    w->spinImpulse[slot] = before;
#endif
    return afterImpulse(before, inertia, impulse);
}

// The warm start of walls of which some act. stored: their impulses; v: velocity.
void startWallRows(const World *w, float4 c, const float *stored, float *v, Turning *t) {
    float x[2] = {c.x, c.y};
    float low[2] = {w->k.minX, w->k.minY};
    float high[2] = {w->k.maxX, w->k.maxY};
    for (int axis = 0; axis < 2; axis++) {
        if (!rowsHold(t->walls[axis])) continue;
        float side = wallSide(x[axis], low[axis], high[axis]);
        if (actingImpulse(wallImpulse(stored[axis], side), t->walls[axis]) > 0.0f) {
            warmWallRows(w, t, axis, side, wallOf(axis, side), v + axis, v + (1 - axis));
        } else {
            t->walls[axis] = (RowImpulses)(0.0f);
        }
    }
}

// In a sub-step. Returns the surface speed.
float moveTurning(const World *w, int slot, float s) {
    s = limitSpeed(s);
    w->turned[slot] += s;
    return s;
}

// Ends the step; all goes home.
void finalizeTurning(const World *w, int slot, float r) {
    int2 old = w->turn[slot];
    float omega = as_float(old.ANGULAR_VELOCITY);
    int2 next = (int2)(0);
    next.ANGLE = turn(old.ANGLE, w->turned[slot], w->k.h, r);
    next.ANGULAR_VELOCITY = as_int(angularVelocity(omega, omega * r, w->surfaceSpeed[slot], r));
    w->homeTurn[slot] = next;
    w->homeWallRows[slot] = w->wallRows[slot];
    if (w->surfaces[SURFACE_OWN] != 0.0f) w->homeOwn[slot] = w->own[slot];
}
#endif
