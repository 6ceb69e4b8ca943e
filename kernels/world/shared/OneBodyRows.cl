// uses: world/shared/OneBody.cl world/shared/Surface.cl world/shared/Walls.cl
// The rows behind the normal one of contacts with walls and terrain pieces: friction and rolling resistance, as in the Java class
// OneBodyRows. Walls and pieces move RowImpulses, the accumulated impulses of all rows.

#ifdef TURNING
typedef struct {
    global const float *surface; // see surfaceOfCircle
    float s;              // surface speed
    float inertia;        // inverse inertia by inverse mass
    RowImpulses walls[2]; // by axis of the wall
    float from[2], to[2]; // velocities across walls, before and after a visit: for those that record it
    IF_RECORDING(float slid[2];) // how fast surfaces slid before it
} Turning;

// A row as those of surfaces: that of the circle's kind, with its own values in it.
global float *surfaceOfCircle(const World *w, int slot) { return (global float *) (w->circleSurface + slot); }

// t: traits; s: surface speed.
Turning turningOf(const World *w, int slot, float4 t, float s) {
    Turning turning;
    WallRows rows = w->wallRows[slot];
    turning.surface = surfaceOfCircle(w, slot);
    turning.s = s;
    turning.inertia = w->inverseInertia[slot] / t.INVERSE_MASS;
    turning.walls[0] = rows.even;
    turning.walls[1] = rows.odd;
    return turning;
}

void keepWallRows(const World *w, int slot, const Turning *t) {
    WallRows rows;
    rows.even = t->walls[0];
    rows.odd = t->walls[1];
    w->wallRows[slot] = rows;
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
    b.friction = friction(t->surface[SURFACE_FRICTION], row[SURFACE_FRICTION]);
    b.resistance = maxf(t->surface[SURFACE_ROLLING_RESISTANCE], row[SURFACE_ROLLING_RESISTANCE]);
    b.belt = row[SURFACE_BELT];
    return b;
}

bool oneBodyRowsAct(const Between *b) { return b->friction > 0.0f || b->resistance > 0.0f; }

// What the rows give to the velocity of the circle: along the tangent.
typedef float RowGain;

// n: normal.
void pushByRows(RowGain gain, float nx, float ny, float4 *m) {
    m->VX += -ny * gain;
    m->VY += nx * gain;
}

// At a wall, whose normal has no other part. across, along: velocity across the wall and along it.
void pushAtWall(RowGain gain, int axis, float side, float *across, float *along) { *along += tangentAlong(axis, side) * gain; }

// Before the visits of a sub-step: what is accumulated acts again, unless the surfaces have changed.
RowGain warmOneBodyRows(Turning *t, const Between *b, RowImpulses *i) {
    i->FRICTION_IMPULSE = b->friction > 0.0f ? i->FRICTION_IMPULSE : 0.0f;
    i->ROLLING_IMPULSE = b->resistance > 0.0f && t->inertia > 0.0f ? i->ROLLING_IMPULSE : 0.0f;
    t->s += t->inertia * spinOfOneBody(*i);
    return tangentImpulse(*i);
}

// Behind the visit of the normal impulse. along: speed against the other's surface; belt: see slip; bounce: target speed.
RowGain visitOneBodyRows(Turning *t, const Between *b, RowImpulses *i, float along, float belt, const Visited *visited, float bounce) {
    float normalImpulse = boundingImpulse(visited);
    bool keep = rowsAreKept(visited, bounce);
    float impulse = 0.0f;
    if (b->resistance > 0.0f && t->inertia > 0.0f) {
        float next = rolling(i->ROLLING_IMPULSE, 1.0f / t->inertia, t->s, b->resistance * normalImpulse);
        t->s += t->inertia * (next - i->ROLLING_IMPULSE);
        i->ROLLING_IMPULSE = keep ? next : 0.0f;
    }
    if (b->friction > 0.0f) {
        float mass = tangentMass(0.0f, 0.0f, 1.0f, t->inertia, 1.0f);
        float next = grip(i->FRICTION_IMPULSE, mass, slip(along, 0.0f, t->s, belt), b->friction * normalImpulse);
        impulse = next - i->FRICTION_IMPULSE;
        t->s += t->inertia * -impulse;
        i->FRICTION_IMPULSE = keep ? next : 0.0f;
    }
    return impulse;
}

#ifdef RECORDING
// How fast surfaces slide that have friction; see visitOneBodyRows.
float slipOfOneBody(const Between *b, float along, float s, float belt) { return hitSlip(b->friction, along, 0.0f, s, belt); }
#endif
#endif
