// uses: world/shared/Wall.cl
// How a circle turns through a step. The Java class world.jvm.Turning does the same.

#ifdef TURNING
float orOfKind(float own, float ofKind) { return isnan(own) ? ofKind : own; }

// Makes a circle ready for a step. c: circle; from: the slot at home.
void gatherTurning(const World *w, int slot, int from, int id, float4 c, float inverseMass) {
    global const float *kind = w->surfaces + SURFACE_STRIDE * w->fields[id].kind;
    int2 turn_ = w->homeTurn[from];
    float4 own = w->homeOwn[from];
    float4 spin = (float4)(0.0f);
    float4 skin = (float4)(0.0f);
    spin.SURFACE_SPEED = as_float(turn_.ANGULAR_VELOCITY) * c.RADIUS;
    spin.INVERSE_INERTIA = inverseMass * kind[SURFACE_INERTIA];
    skin.FRICTION = orOfKind(own.OWN_FRICTION, kind[SURFACE_FRICTION]);
    skin.ROLLING_RESISTANCE = orOfKind(own.OWN_ROLLING_RESISTANCE, kind[SURFACE_ROLLING_RESISTANCE]);
    skin.BELT = kind[SURFACE_BELT];
    skin.ANGULAR_FACTOR = kind[SURFACE_DAMPING_FACTOR];
    w->turn[slot] = turn_;
    w->own[slot] = own;
    w->wallGrip[slot] = w->homeWallGrip[from];
    w->spin[slot] = spin;
    w->skin[slot] = skin;
}

// The surface speed s of a circle that is not static, as it starts into a sub-step: a torque, damping, the impulses of the one before.
float startedSpin(const World *w, int slot, float r, float s, float impulse, float inverseInertia, float angularFactor) {
    float gain_ = torqueGain(w->own[slot].OWN_TORQUE, inverseInertia, r, w->k.h);
    return afterImpulse(beforeImpulse(s, gain_, angularFactor), inverseInertia, impulse);
}

void startTurning(const World *w, int slot, float r, Turning *t) {
    t->spin.SURFACE_SPEED = startedSpin(w, slot, r, t->spin.SURFACE_SPEED, t->spin.SPIN_IMPULSE, t->spin.INVERSE_INERTIA,
                                        t->skin.ANGULAR_FACTOR);
}

// The warm start of walls that press. stored: their impulses; v: velocity.
void startWallGrips(const World *w, float4 c, const float *stored, float *v, Turning *t) {
    float x[2] = {c.x, c.y};
    float low[2] = {w->k.minX, w->k.minY};
    float high[2] = {w->k.maxX, w->k.maxY};
    if (stored[0] == 0.0f && stored[1] == 0.0f) return;
    for (int axis = 0; axis < 2; axis++) {
        if (!isHeld(t, axis)) continue;
        float side = wallSide(x[axis], low[axis], high[axis]);
        if (wallImpulse(stored[axis], side) > 0.0f) {
            warmGripOfWall(w, t, axis, side, wallOf(axis, side), v + (1 - axis));
        } else {
            t->friction[axis] = 0.0f;
            t->rolling[axis] = 0.0f;
        }
    }
}

// In a sub-step.
void moveTurning(Turning *t) {
    t->spin.SURFACE_SPEED = limitSpeed(t->spin.SURFACE_SPEED);
    t->spin.TURNED += t->spin.SURFACE_SPEED;
    t->spin.SPIN_IMPULSE = 0.0f;
}

// Ends the step; all goes home.
void finalizeTurning(const World *w, int slot, float r) {
    int2 old = w->turn[slot];
    float4 spin = w->spin[slot];
    float omega = as_float(old.ANGULAR_VELOCITY);
    int2 next = (int2)(0);
    next.ANGLE = turn(old.ANGLE, spin.TURNED, w->k.h, r);
    next.ANGULAR_VELOCITY = as_int(angularVelocity(omega, omega * r, spin.SURFACE_SPEED, r));
    w->homeTurn[slot] = next;
    w->homeWallGrip[slot] = w->wallGrip[slot];
    w->homeOwn[slot] = w->own[slot];
}
#endif
