// uses: world/shared/OneBody.cl world/shared/Surface.cl
// The grip of a circle and something that is no circle: the Java class OneBodyGrip. Walls are the first kind.

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

// Of a circle and a wall.
typedef struct {
    float friction, resistance;
    float belt; // of the wall
} Between;

Between betweenWall(const World *w, const Turning *t, int wall) {
    global const float *row = w->surfaces + SURFACE_STRIDE * (SURFACE_OF_WALLS + wall);
    Between b;
    b.friction = friction(t->skin.FRICTION, row[SURFACE_FRICTION]);
    b.resistance = maxf(t->skin.ROLLING_RESISTANCE, row[SURFACE_ROLLING_RESISTANCE]);
    b.belt = row[SURFACE_BELT];
    return b;
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

// Before the visits of a sub-step: what is accumulated acts again, unless the surfaces have changed. along: velocity along the wall.
void warmGripOfWall(const World *w, Turning *t, int axis, float side, int wall, float *along) {
    Between b = betweenWall(w, t, wall);
    t->friction[axis] = b.friction > 0.0f ? t->friction[axis] : 0.0f;
    t->rolling[axis] = b.resistance > 0.0f && t->inertia > 0.0f ? t->rolling[axis] : 0.0f;
    t->s += t->inertia * (t->rolling[axis] - t->friction[axis]);
    *along += tangentAlong(axis, side) * t->friction[axis];
}

// A visit. keep: whether what acts accumulates.
void gripWall(const World *w, Turning *t, int axis, float side, int wall, float *along, float normalImpulse, bool keep) {
    Between b = betweenWall(w, t, wall);
    if (!(b.friction > 0.0f || b.resistance > 0.0f)) return;
    float impulse = 0.0f;
    if (b.resistance > 0.0f && t->inertia > 0.0f) {
        float next = rolling(t->rolling[axis], 1.0f / t->inertia, t->s, b.resistance * normalImpulse);
        t->s += t->inertia * (next - t->rolling[axis]);
        t->rolling[axis] = keep ? next : 0.0f;
    }
    if (b.friction > 0.0f) {
        float slip_ = slip(againstWall(axis, side, *along, b.belt), 0.0f, t->s, t->skin.BELT);
        float next = grip(t->friction[axis], tangentMass(0.0f, 0.0f, 1.0f, t->inertia), slip_, b.friction * normalImpulse);
        impulse = next - t->friction[axis];
        t->s += t->inertia * -impulse;
        t->friction[axis] = keep ? next : 0.0f;
    }
    *along += tangentAlong(axis, side) * impulse;
}
#endif
