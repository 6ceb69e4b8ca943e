// uses: world/shared/Wall.cl world/shared/PieceSensor.cl world/shared/PieceVisit.cl world/stages/Events.cl world/shared/PairRows.cl
// Records what contacts and walls do in a step that reports events, and tells of it and of pieces of terrain. The Java classes Touches,
// WallTouches and PieceTouches are the same.
//
// touch: by contact, two float4: approach speed, impulse, normal x, y (0: not known yet); point x, y, approach speed of the sub-step,
// impulse of it that is not kept. Behind all, if circles can rotate, see touchSlips. wallTouch: by slot and axis: approach speed, impulse,
// where along the wall, how fast the surfaces slid, with the sign of the side.

#ifdef RECORDING
#ifdef TURNING
// How fast the surfaces of contacts slide, by their numbers in any plan: in the sub-step; when they approached fastest.
global float2 *touchSlips(const World *w) {
#ifdef TERRAIN
    return (global float2 *) (w->recording.touch + 4 * (size_t) w->contactRoom);
#else
    return (global float2 *) (w->recording.touch + 2 * (size_t) w->contactRoom);
#endif
}
#endif

void clearSlip(const World *w, int c) {
    IF_TURNING(touchSlips(w)[c] = (float2)(0.0f);)
}

// When they approached fastest.
float slipOf(const World *w, int c) {
#ifdef TURNING
    return touchSlips(w)[c].y;
#else
    return 0.0f;
#endif
}

// Where, only if that may be elsewhere after the step.
void noteTouch(const World *w, global float4 *t, int c, float approach, float4 n, float impulse, float separation) {
    bool touching = impulse > 0.0f || separation <= 0.0f;
    if (!touching || !(approach > t[0].x)) return;
    t[0].x = approach;
    IF_TURNING(touchSlips(w)[c].y = touchSlips(w)[c].x;)
    if (!isFastApproach(approach, w->k.dt, w->base[c].RADII)) return;
    uint lower = w->pair[c].LOWER;
    float4 own = w->circle[lower];
    float4 m = w->motion[lower];
    t[0].zw = n.NORMAL;
    t[1].xy = (float2)(touchPoint(own.x, m.DX, n.NORMAL_X, own.RADIUS, n.SEPARATION),
                       touchPoint(own.y, m.DY, n.NORMAL_Y, own.RADIUS, n.SEPARATION));
}

// notKept: of a free bounce.
void noteSolvedContact(const World *w, global float4 *touch, int c, float notKept) {
    uint2 pr = w->pair[c];
    float4 n = w->contact[c];
    global float4 *t = touch + 2 * c;
    float2 before = w->load[pr.HIGHER].BEFORE - w->load[pr.LOWER].BEFORE;
    float approach = approachSpeed(dotf(n.NORMAL_X, n.NORMAL_Y, before.x, before.y));
    t[1].zw = (float2)(approach, notKept);
#ifdef TURNING
    PairSurface s = surfaceAt(w, c);
    touchSlips(w)[c].x = slipOfPair(&s, n.NORMAL, w->load[pr.LOWER].BEFORE, w->load[pr.HIGHER].BEFORE, w->spinImpulse[pr.LOWER],
                                    w->spinImpulse[pr.HIGHER]);
#endif
    noteTouch(w, t, c, approach, n, n.NORMAL_IMPULSE + notKept, n.SEPARATION);
}

// bounced: impulse of a bounce.
void noteRelaxedContact(const World *w, global float4 *touch, int c, float bounced) {
    global float4 *t = touch + 2 * c;
    float notKept = t[1].w + bounced;
    float4 n = w->contact[c];
    float impulse = notKept + n.NORMAL_IMPULSE;
    t[1].w = 0.0f;
    t[0].y += impulse;
    noteTouch(w, t, c, t[1].z, n, impulse, INFINITY);
}

void beginTouch(const World *w, int c) {
    w->recording.touch[2 * c] = (float4)(NO_TOUCH, 0.0f, 0.0f, 0.0f);
    w->recording.touch[2 * c + 1] = (float4)(0.0f);
    clearSlip(w, c);
}

#ifdef TERRAIN
void beginPieceTouches(const World *w, int slot) {
    int2 own = w->pieces[slot];
    EACH_PIECE(k, own) clearPieceTouch(w, k);
}
#endif

// Index space: any; work-items take contacts and slots in turn.
kernel void touches_begin(WORLD_PARAMETERS RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    if (refused(&w)) return;
    int first = (int) get_global_id(0);
    int contacts = contactsListed(&w);
    for (int c = first; c < contacts; c += (int) get_global_size(0)) beginTouch(&w, c);
    for (int k = first; k < 2 * circles; k += (int) get_global_size(0)) {
        wallTouch[k] = (float4)(NO_TOUCH, 0.0f, 0.0f, 0.0f);
    }
    IF_TERRAIN(for (int slot = first; slot < circles; slot += (int) get_global_size(0)) beginPieceTouches(&w, slot);)
}

// A visit of the wall of an axis. x, d: coordinate and displacement; speed: along the axis, of the approach; from, to: before and after the
// visit; slid: how fast the surfaces did before it; solving: the wall is where it is before the sub-step.
void noteVisitOfWall(const World *w, global float4 *t, int axis, float x, float d, float r, float speed, float from, float to,
                     float along, float slid, bool solving) {
    float min_ = axis == 0 ? w->k.minX : w->k.minY;
    float max_ = axis == 0 ? w->k.maxX : w->k.maxY;
    float side = wallSide(x, min_, max_);
    int wall = wallOf(axis, side);
    float gap = wallGap(x, d, r, side, min_, max_) + behindOf(w, wall);
    if (solving) gap += sweepFor(w, wall, r);
    float4 now = *t;
    float impulse = side * (to - from);
    now.y += impulse;
    float approach = approachSpeed(side * speed - speedFor(w, wall, r));
    if ((impulse > 0.0f || gap <= 0.0f) && approach > now.x) {
        now.x = approach;
        now.z = along;
        now.w = copysign(slid, side);
    }
    *t = now;
}

// Visits of the walls of both axes, if walls are reported. d: displacement that they saw; before: velocity before any impulse, if solving; from:
// before the visits; m: motion after them.
void noteVisitsOfWalls(const World *w, int slot, float4 c, float inverseMass, float2 d, float2 before, float2 from, float4 m,
                       bool solving AND_TURNING(const Turning *turning)) {
    if (!w->recording.walls || inverseMass == 0.0f) return;
    global float4 *t = w->recording.wallTouch + 2 * slot;
    float2 slid = (float2)(0.0f);
#ifdef TURNING
    slid = (float2)(turning->slid[0], turning->slid[1]);
    from = (float2)(turning->from[0], turning->from[1]);
    m.VELOCITY = (float2)(turning->to[0], turning->to[1]);
#endif
    float2 speed = solving ? before : from;
    noteVisitOfWall(w, t, 0, c.x, d.x, c.RADIUS, speed.x, from.x, m.VX, c.y + m.DY, slid.x, solving);
    noteVisitOfWall(w, t + 1, 1, c.y, d.y, c.RADIUS, speed.y, from.y, m.VY, c.x + m.DX, slid.y, solving);
}

// sum: of contact impulses; old, m: motion before and after.
void noteWallsSolved(const World *w, int slot, float4 c, float inverseMass, float2 sum, float2 before, float4 old,
                     float4 m AND_TURNING(const Turning *turning)) {
    float2 from = (float2)(afterImpulse(before.x, inverseMass, sum.x), afterImpulse(before.y, inverseMass, sum.y));
    noteVisitsOfWalls(w, slot, c, inverseMass, old.DISPLACEMENT, before, from, m, true AND_TURNING(turning));
}

// v: before the visits; m: motion after them.
void noteWallsRelaxed(const World *w, int slot, float4 c, float inverseMass, float2 v, float4 m AND_TURNING(const Turning *turning)) {
    noteVisitsOfWalls(w, slot, c, inverseMass, m.DISPLACEMENT, v, v, m, false AND_TURNING(turning));
}

// Tells of the wall of an axis. c, m: circle and motion after the step.
void tellOfWall(const World *w, float4 t, int slot, int axis, float4 c, float4 m) {
    float x = axis == 0 ? c.x : c.y;
    float dx = axis == 0 ? m.DX : m.DY;
    float v = axis == 0 ? m.VX : m.VY;
    float min_ = axis == 0 ? w->k.minX : w->k.minY;
    float max_ = axis == 0 ? w->k.maxX : w->k.maxY;
    float rate = axis == 0 ? w->k.thresholdRateX : w->k.thresholdRateY;
    float nearer = wallSide(x, min_, max_);
    float gap = wallGap(x, dx, c.RADIUS, nearer, min_, max_);
    bool touched = t.x >= 0.0f;
    float touchedSide = copysign(1.0f, t.w);
    bool isNear_ = staysInTouch(NO_TOUCH, gap, 2.0f * c.RADIUS);
    float threshold = bounceThreshold(&w->k, 2.0f * c.RADIUS, 0.0f, rate);
    for (int k = 0; k < 2; k++) {
        bool first = k == 0;
        if (first ? !touched : !isNear_ || (touched && touchedSide == nearer)) continue;
        float side = first ? touchedSide : nearer;
        float at = side > 0.0f ? min_ : max_;
        float place = first ? t.z : axis == 0 ? c.y : c.x;
        int wall = wallOf(axis, side);
        float vn = side * v - speedFor(w, wall, c.RADIUS);
        float2 normal = axis == 0 ? (float2)(-side, 0.0f) : (float2)(0.0f, -side);
        float2 point = axis == 0 ? (float2)(at, place) : (float2)(place, at);
        float approach = first ? t.x : 0.0f;
        float impulse = first ? c.MASS * t.y : 0.0f;
        Told told;
        if (concerns(w, w->homeId[slot], FIRST_WALL + wall, first || touches(NO_TOUCH, gap), approach, impulse, threshold, &told)) {
            tell(w, &told, approach, impulse, vn, normal, point, first ? fabs(t.w) : 0.0f);
        }
    }
}

// Tells of the walls that a circle is in touch with after the step.
void tellOfWallsOf(const World *w, int slot) {
    if (w->homeTraits[slot].INVERSE_MASS == 0.0f) return;
    global const float4 *t = w->recording.wallTouch + 2 * slot;
    tellOfWall(w, t[0], slot, 0, w->homeCircle[slot], w->homeMotion[slot]);
    tellOfWall(w, t[1], slot, 1, w->homeCircle[slot], w->homeMotion[slot]);
}

bool isKnown(float2 normal) { return normal.x != 0.0f || normal.y != 0.0f; }

// Tells of a pair of circles after a step, if it is in touch. pr: slots; n: contact; approach, impulse: of the step; normal, point: where
// it touched, if that is known; else it is where it touches now; slid: how fast its surfaces did.
void tellOfPair(const World *w, uint2 pr, float4 n, float radii, float approach, float impulse, float2 normal, float2 point, float slid) {
    if (!staysInTouch(approach, n.SEPARATION, radii)) return;
    float threshold = bounceThreshold(&w->k, radii, 0.0f, w->k.thresholdRate);
    float fastest = maxf(approach, 0.0f);
    Told told;
    if (!concerns(w, w->id[pr.LOWER], w->id[pr.HIGHER], touches(approach, n.SEPARATION), fastest, impulse, threshold, &told)) return;
    if (!isKnown(normal)) {
        float4 lower = w->homeCircle[pr.LOWER];
        normal = n.NORMAL;
        point = (float2)(touchPoint(lower.x, 0.0f, n.NORMAL_X, lower.RADIUS, n.SEPARATION),
                         touchPoint(lower.y, 0.0f, n.NORMAL_Y, lower.RADIUS, n.SEPARATION));
    }
    float4 mi = w->homeMotion[pr.LOWER];
    float4 mj = w->homeMotion[pr.HIGHER];
    float vn = dotf(n.NORMAL_X, n.NORMAL_Y, mj.VX - mi.VX, mj.VY - mi.VY);
    tell(w, &told, fastest, impulse, vn, normal, point, slid);
}

// Tells of contacts from one on, every so many.
void tellOfContacts(const World *w, int first, int each) {
    int contacts = contactsListed(w);
    for (int c = first; c < contacts; c += each) {
        global const float4 *touch = w->recording.touch + 2 * c;
        float4 t = touch[0];
        tellOfPair(w, w->pair[c], w->contact[c], w->base[c].RADII, t.x, t.y, t.zw, touch[1].xy, slipOf(w, c));
    }
}

#ifdef TERRAIN
// Tells of a piece contact. Nothing changes of what has been recorded: a step may be told of again. t: as it has been recorded, or would be.
void tellOfPiece(const World *w, int k, int slot, const float4 *t, bool touches, float impulse, float vn, float threshold) {
    Told told;
    int code = FIRST_PIECE + w->piece[k].TOUCHED_PIECE;
    if (concerns(w, w->homeId[slot], code, touches, t[0].x, impulse, threshold, &told)) {
        tell(w, &told, t[0].x, impulse, vn, -t[0].zw, t[1].xy, t[1].z);
    }
}

// m: motion after the step.
void tellOfSolidPiece(const World *w, int k, int slot, float4 c, float4 m) {
    float4 t[2] = {pieceTouch(w, k)[0], pieceTouch(w, k)[1]};
    bool touching = t[0].x >= 0.0f;
    if (!touching) {
        float4 g = w->measured[k];
        if (w->piece[k].TOUCHED_FEATURE == AT_NOTHING || !staysInTouch(NO_TOUCH, g.MEASURED_GAP, 2.0f * c.RADIUS)) return;
        touching = touches(NO_TOUCH, g.MEASURED_GAP);
        float2 place = placeOfTouch(c, (float2)(0.0f), g);
        t[0] = (float4)(0.0f, t[0].y, g.MEASURED_X, g.MEASURED_Y);
        t[1] = (float4)(place.x, place.y, 0.0f, 0.0f);
    }
    float vn = (t[0].z * m.VX + t[0].w * m.VY) - t[1].w;
    float threshold = bounceThreshold(&w->k, 2.0f * c.RADIUS, 0.0f, w->k.thresholdRate);
    tellOfPiece(w, k, slot, t, touching, c.MASS * t[0].y, vn, threshold);
}

// A place in the frame of a piece, which may have moved: where it is after the step, with the normal.
float4 placeSensed(const World *w, global const float *row, int motion, const PieceGap *g, float x, float y) {
    if (motion == 0) return (float4)(g->nx, g->ny, row[PIECE_X] + x, row[PIECE_Y] + y);
    global const float *pose = poseOf(bodyOf(w, motion), w->k.subSteps);
    float2 pivot = pivotOf(row);
    float2 n = turnedByPose(pose, g->nx, g->ny);
    float2 at = turnedByPose(pose, x - pivot.x, y - pivot.y);
    return (float4)(n.x, n.y, ((row[PIECE_X] + pivot.x) + pose[BODY_DX]) + at.x, ((row[PIECE_Y] + pivot.y) + pose[BODY_DY]) + at.y);
}

typedef struct {
    bool touching;
    float approach, vn;
    float2 normal, point; // towards the circle
} SensedTouch;

// What a circle and a piece that senses it do. o, end: the centre as the step begins and after it, in the frame of the piece; side: of a piece
// that has a front, 1 if the circle has come from there. Returns whether they are in touch, or near enough to stay so.
bool touchesSensedPiece(const World *w, int piece, float2 o, float2 end, float radius, float came, SensedTouch *t) {
    global const float *row = pieceRow(w, piece);
    int4 traits = pieceTraits(w, piece);
    float ux = end.x - o.x;
    float uy = end.y - o.y;
    bool twoSided = isTwoSided(w, traits);
    bool behind = !twoSided && !(came > 0.0f);
    float side = twoSided && !isInFront(row, traits.TRAIT_SHAPE, o.x, o.y) ? -1.0f : 1.0f;
    float time = behind ? timeOfReturn(row, traits.TRAIT_SHAPE, o.x, o.y, ux, uy, radius)
                        : timeOfSensing(row, traits.TRAIT_SHAPE, o.x, o.y, ux, uy, radius);
    t->touching = time <= 1.0f;
    if (!t->touching) {
        float gap = distanceOfPiece(row, traits.TRAIT_SHAPE, end.x, end.y) - radius;
        if (behind || !staysInTouch(NO_TOUCH, gap, 2.0f * radius)) return false;
        time = 1.0f;
    }
    float x = o.x + time * ux;
    float y = o.y + time * uy;
    PieceGap g;
    measurePiece(row, traits.TRAIT_SHAPE, x, y, radius, side, &g);
    t->vn = (g.nx * ux + g.ny * uy) / w->k.dt;
    t->approach = approachSpeed(t->vn);
    float away = radius + 0.5f * g.gap;
    float4 at = placeSensed(w, row, traits.TRAIT_MOTION, &g, x - away * g.nx, y - away * g.ny);
    t->normal = at.xy;
    t->point = at.zw;
    return true;
}

void tellOfSensedPiece(const World *w, int k, int slot, float4 c) {
    SensedTouch s;
    float2 o = pieceTouch(w, k)[0].zw;
    if (!touchesSensedPiece(w, w->piece[k].TOUCHED_PIECE, o, w->standing[k].STANDING_PLACE, c.RADIUS, w->push[k].PUSH_SIDE, &s)) return;
    float4 t[2] = {(float4)(s.approach, 0.0f, s.normal), (float4)(s.point, 0.0f, 0.0f)};
    tellOfPiece(w, k, slot, t, s.touching, 0.0f, s.vn, MAXFLOAT);
}

// Tells of the pieces that a circle is in touch with after the step.
void tellOfPiecesOf(const World *w, int slot) {
    if (w->homeTraits[slot].INVERSE_MASS == 0.0f) return;
    int2 own = w->pieces[slot];
    float4 c = w->homeCircle[slot];
    EACH_PIECE(k, own) {
        if (w->piece[k].TOUCHED_RESPONSE == PAIR_SENSE) {
            tellOfSensedPiece(w, k, slot, c);
        } else {
            tellOfSolidPiece(w, k, slot, c, w->homeMotion[slot]);
        }
    }
}
#endif

// Tells of the walls and pieces that circles are in touch with, if they are reported. first, each: which circles.
void tellOfWalls(const World *w, int first, int each) {
    int circles = w->recording.walls ? w->circles : 0;
    for (int slot = first; slot < circles; slot += each) tellOfWallsOf(w, slot);
    IF_TERRAIN(circles = w->recording.pieces ? w->circles : 0;)
    IF_TERRAIN(for (int slot = first; slot < circles; slot += each) tellOfPiecesOf(w, slot);)
}

// Tells of pairs and walls after the step. Index space: any number of work-items, which take contacts and slots in turn.
kernel void touches_tell(WORLD_PARAMETERS RECORDING_PARAMETERS REPORTING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    REPORT_IN(w);
    if (!isMade(&w)) return;
    tellOfContacts(&w, (int) get_global_id(0), (int) get_global_size(0));
    tellOfWalls(&w, (int) get_global_id(0), (int) get_global_size(0));
}
#endif
