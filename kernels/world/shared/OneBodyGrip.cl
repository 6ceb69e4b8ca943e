// uses: world/shared/OneBody.cl world/shared/Surface.cl
// Friction and rolling of contacts with walls and terrain pieces: the Java class OneBodyRows.

#ifdef TURNING
typedef struct {
    float4 skin;
    float s;                       // surface speed
    float inertia;                 // inverse inertia by inverse mass
    float friction[2], rolling[2]; // accumulated, by axis of the wall
    float from[2], to[2];          // velocities across walls, before and after a visit: for those that record it
#ifdef RECORDING
    float slid[2]; // how fast surfaces slid before it
#endif
} Turning;

// t: traits; s: surface speed.
Turning turningOf(const World *w, int slot, float4 t, float s) {
    Turning turning;
    float4 held = w->wallGrip[slot];
    turning.skin = w->skin[slot];
    turning.s = s;
    turning.inertia = w->inverseInertia[slot] / t.INVERSE_MASS;
    turning.friction[0] = held.FRICTION_X;
    turning.friction[1] = held.FRICTION_Y;
    turning.rolling[0] = held.ROLLING_X;
    turning.rolling[1] = held.ROLLING_Y;
    return turning;
}

void keepWallGrip(const World *w, int slot, const Turning *t) {
    float4 held = (float4)(0.0f);
    held.FRICTION_X = t->friction[0];
    held.FRICTION_Y = t->friction[1];
    held.ROLLING_X = t->rolling[0];
    held.ROLLING_Y = t->rolling[1];
    w->wallGrip[slot] = held;
}

// Of a circle and something else.
typedef struct {
    float friction, resistance;
    float belt; // of the other
} Between;

// number: of a row of surfaces.
Between betweenSurfaces(const World *w, const Turning *t, int number) {
    global const float *row = w->surfaces + SURFACE_STRIDE * number;
    Between b;
    b.friction = friction(t->skin.FRICTION, row[SURFACE_FRICTION]);
    b.resistance = maxf(t->skin.ROLLING_RESISTANCE, row[SURFACE_ROLLING_RESISTANCE]);
    b.belt = row[SURFACE_BELT];
    return b;
}

Between betweenWall(const World *w, const Turning *t, int wall) { return betweenSurfaces(w, t, SURFACE_OF_WALLS + wall); }

// Before the visits of a sub-step: what is accumulated acts again, unless the surfaces have changed. Returns the impulse along the tangent.
float warmGrip(Turning *t, const Between *b, float *friction_, float *rolling_) {
    *friction_ = b->friction > 0.0f ? *friction_ : 0.0f;
    *rolling_ = b->resistance > 0.0f && t->inertia > 0.0f ? *rolling_ : 0.0f;
    t->s += t->inertia * (*rolling_ - *friction_);
    return *friction_;
}

// A visit. along: speed against the other's surface; belt: see slip; keep: whether what acts accumulates. Returns the impulse along the
// tangent.
float visitGrip(Turning *t, const Between *b, float *friction_, float *rolling_, float along, float belt, float normalImpulse, bool keep) {
    float impulse = 0.0f;
    if (b->resistance > 0.0f && t->inertia > 0.0f) {
        float next = rolling(*rolling_, 1.0f / t->inertia, t->s, b->resistance * normalImpulse);
        t->s += t->inertia * (next - *rolling_);
        *rolling_ = keep ? next : 0.0f;
    }
    if (b->friction > 0.0f) {
        float next = grip(*friction_, tangentMass(0.0f, 0.0f, 1.0f, t->inertia), slip(along, 0.0f, t->s, belt), b->friction * normalImpulse);
        impulse = next - *friction_;
        t->s += t->inertia * -impulse;
        *friction_ = keep ? next : 0.0f;
    }
    return impulse;
}

// Whether the wall of an axis holds the circle, which a visit may have to take back.
bool isHeld(const Turning *t, int axis) { return t->friction[axis] != 0.0f || t->rolling[axis] != 0.0f; }

// The part of the tangent along a wall.
float tangentAlong(int axis, float side) { return axis == 0 ? side : -side; }

// v: velocity along the wall; belt: of the wall.
float againstWall(int axis, float side, float v, float belt) { return tangentAlong(axis, side) * (v - belt); }

#ifdef RECORDING
// How fast surfaces slide that grip. v: velocity along the wall; s: surface speed.
float slipAtWall(const World *w, const Turning *t, int axis, float side, int wall, float v, float s) {
    Between b = betweenWall(w, t, wall);
    return hitSlip(b.friction, againstWall(axis, side, v, b.belt), 0.0f, s, t->skin.BELT);
}
#endif

// As warmGrip. along: velocity along the wall.
void warmGripOfWall(const World *w, Turning *t, int axis, float side, int wall, float *along) {
    Between b = betweenWall(w, t, wall);
    *along += tangentAlong(axis, side) * warmGrip(t, &b, t->friction + axis, t->rolling + axis);
}

// As visitGrip.
void gripWall(const World *w, Turning *t, int axis, float side, int wall, float *along, float normalImpulse, bool keep) {
    Between b = betweenWall(w, t, wall);
    if (!(b.friction > 0.0f || b.resistance > 0.0f)) return;
    float impulse = visitGrip(t, &b, t->friction + axis, t->rolling + axis, againstWall(axis, side, *along, b.belt), t->skin.BELT,
                              normalImpulse, keep);
    *along += tangentAlong(axis, side) * impulse;
}
#endif
