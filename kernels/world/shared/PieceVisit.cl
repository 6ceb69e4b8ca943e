// uses: world/shared/PieceSweep.cl world/shared/PieceTouch.cl world/shared/OneBody.cl world/shared/OneBodyRows.cl
// Visits of pieces of terrain, by the circles that are near them, behind those of walls: the Java class PieceVisits. A circle has its piece
// contacts to itself, so what a pass notes of them lies in global memory. Loops stay loops, in functions that are called once: few circles
// come here, and all others would pay for the registers.
//
// c: circle; m: motion; boundary: of sub-steps, from 0 to their number.

#ifdef TERRAIN
// own: of the circle. A loop that stays one.
#define EACH_PIECE(k, own)                                                                                             \
    _Pragma("unroll 1") for (int k = (own).PIECES_FIRST; k < (own).PIECES_FIRST + (own).PIECES_COUNT; k++)

bool hasPieces(const World *w, int slot) { return w->pieces[slot].PIECES_COUNT > 0; }

// Whether the contact of a circle and a piece acts, see actingImpulse.
bool pieceActs(const World *w, int k) { return actingImpulse(w->push[k].PUSH_NORMAL, w->pieceRows[k]) > 0.0f; }

bool piecesAct(const World *w, int slot) {
    int2 own = w->pieces[slot];
    bool act = false;
    EACH_PIECE(k, own) act |= pieceActs(w, k);
    return act;
}

// The base of a circle against x and y of a piece.
float2 offsetOf(const World *w, float4 c, global const float *row) {
#ifdef EDGES
    if (w->levels->periodX < INFINITY || w->levels->periodY < INFINITY) {
        float midX = row[PIECE_MID_X];
        float midY = row[PIECE_MID_Y];
        return (float2)(ACROSS_X(w, c.x - midX) + (midX - row[PIECE_X]), ACROSS_Y(w, c.y - midY) + (midY - row[PIECE_Y]));
    }
#endif
    return (float2)(c.x - row[PIECE_X], c.y - row[PIECE_Y]);
}

// Of a body that moves.
global const float *bodyOf(const World *w, int motion) {
    return (global const float *) w->terrain + w->terrain[TERRAIN_MOTION] + (BODY_HEAD + BODY_POSE * (w->k.subSteps + 1)) * motion;
}

global const float *poseOf(global const float *body, int boundary) { return body + BODY_HEAD + BODY_POSE * boundary; }

// A way as a pose turns it, and back.
float2 turnedByPose(global const float *pose, float x, float y) {
    float cos_ = pose[BODY_COS];
    float sin_ = pose[BODY_SIN];
    return (float2)(cos_ * x - sin_ * y, sin_ * x + cos_ * y);
}

float2 turnedBack(global const float *pose, float x, float y) {
    float cos_ = pose[BODY_COS];
    float sin_ = pose[BODY_SIN];
    return (float2)(cos_ * x + sin_ * y, cos_ * y - sin_ * x);
}

// Its pivot against x and y of a piece.
float2 pivotOf(global const float *row) { return (float2)(row[PIECE_PIVOT_X], row[PIECE_PIVOT_Y]); }

// A place, against x and y of a piece, in the frame of the start of the step. o: offset; d: displacement.
float2 inFrame(const World *w, global const float *row, int motion, float2 o, float2 d, int boundary) {
    if (motion == 0) return (float2)(o.x + d.x, o.y + d.y);
    global const float *body = bodyOf(w, motion);
    global const float *pose = poseOf(body, boundary);
    float2 p = pivotOf(row);
    float x = (o.x - p.x) + (d.x - pose[BODY_DX]);
    float y = (o.y - p.y) + (d.y - pose[BODY_DY]);
    return turnedBack(pose, x, y) + p;
}

bool isOneWay(const World *w, int kind) { return w->kindTerrain[KIND_TERRAIN_STRIDE * kind + KIND_TERRAIN_ONE_WAY] != 0.0f; }

bool isTwoSided(const World *w, int4 traits) {
    return formOf(traits.TRAIT_SHAPE) == PIECE_SEGMENT && !isOneWay(w, traits.TRAIT_KIND);
}

// In a corner, one piece moves a circle into the other.
#define KEEP_OUT_ROUNDS 6

// The piece is no constraint of the circle now.
void leavePiece(const World *w, int k) {
    w->piece[k].TOUCHED_FEATURE = AT_NOTHING;
    w->push[k].PUSH_NORMAL = 0.0f;
    w->pieceRows[k] = (RowImpulses)(0.0f);
    w->standing[k].STANDING_BOUNCE = 0.0f;
}

// Returns whether the circle is at a vertex.
bool measureTouched(const World *w, int k, float4 c, float2 d, int boundary) {
    int4 touched = w->piece[k];
    float side = w->push[k].PUSH_SIDE;
    global const float *row = pieceRow(w, touched.TOUCHED_PIECE);
    int4 traits = pieceTraits(w, touched.TOUCHED_PIECE);
    float2 o = inFrame(w, row, traits.TRAIT_MOTION, offsetOf(w, c, row), d, boundary);
    w->standing[k].STANDING_PLACE = o;
    if (touched.TOUCHED_RESPONSE == PAIR_SENSE && !isTwoSided(w, traits)) {
        // As the step begins: where the circle comes from. Who touches the piece is on its way.
        if (boundary == 0 && !(distanceOfPiece(row, traits.TRAIT_SHAPE, o.x, o.y) <= c.RADIUS)) {
            w->push[k].PUSH_SIDE = isInFront(row, traits.TRAIT_SHAPE, o.x, o.y) ? 1.0f : 0.0f;
        }
        leavePiece(w, k);
        return false;
    }
    if (side == 0.0f) {
        leavePiece(w, k);
        return false;
    }
    PieceGap g;
    measurePiece(row, traits.TRAIT_SHAPE, o.x, o.y, c.RADIUS, side, &g);
    bool twoSided = isTwoSided(w, traits);
    if (isAround(&g, touched.TOUCHED_FEATURE, side)) {
        side = twoSided ? -side : 0.0f;
        w->push[k].PUSH_SIDE = side;
        if (side == 0.0f) {
            leavePiece(w, k);
            return false;
        }
        measurePiece(row, traits.TRAIT_SHAPE, o.x, o.y, c.RADIUS, side, &g);
    }
    float2 n = (float2)(g.nx, g.ny);
    if (traits.TRAIT_MOTION != 0) n = turnedByPose(poseOf(bodyOf(w, traits.TRAIT_MOTION), boundary), g.nx, g.ny);
    w->measured[k] = (float4)(n.x, n.y, g.gap, g.curve);
    w->piece[k].TOUCHED_FEATURE = g.feature;
    if (g.feature == AT_FACE) return false;
    if (g.feature == AT_NOTHING) {
        leavePiece(w, k);
        return false;
    }
    if (twoSided && g.height != 0.0f) w->push[k].PUSH_SIDE = g.height > 0.0f ? 1.0f : -1.0f;
    return true;
}

// A way from the frame of a body to that of another one.
float2 turnedWayTo(const World *w, int motion, int to, float2 d, int boundary) {
    if (motion == to) return d;
    if (motion != 0) d = turnedByPose(poseOf(bodyOf(w, motion), boundary), d.x, d.y);
    return to == 0 ? d : turnedBack(poseOf(bodyOf(w, to), boundary), d.x, d.y);
}

// Whether a piece is solid, and a circle on a side of it.
bool mayCover(const World *w, int k) {
    return w->piece[k].TOUCHED_RESPONSE == PAIR_SOLID && w->push[k].PUSH_SIDE != 0.0f;
}

float2 vertexOf(global const float *row, bool start) {
    return (float2)(row[start ? PIECE_START_X : PIECE_END_X], row[start ? PIECE_START_Y : PIECE_END_Y]);
}

// Whether a piece hides a vertex of another one's from a circle at o, which is e away from the vertex.
bool coversOther(const World *w, int other, float2 o, float2 e, float thickness, bool free, float r) {
    int piece = w->piece[other].TOUCHED_PIECE;
    return coversVertex(pieceRow(w, piece), pieceTraits(w, piece).TRAIT_SHAPE, o.x, o.y, w->push[other].PUSH_SIDE, o.x - e.x, o.y - e.y,
                        thickness, free, r);
}

bool isFree(int shape, bool start) { return (start ? startJoint(shape) : endJoint(shape)) == PIECE_FREE; }

// A vertex under which another piece has its face is no constraint.
void coverTouched(const World *w, int k, int2 own, float r, int boundary) {
    int4 touched = w->piece[k];
    int feature = touched.TOUCHED_FEATURE;
    if (feature <= AT_FACE || touched.TOUCHED_RESPONSE != PAIR_SOLID) return;
    int4 traits = pieceTraits(w, touched.TOUCHED_PIECE);
    bool start = feature == AT_START;
    global const float *row = pieceRow(w, touched.TOUCHED_PIECE);
    float2 place = w->standing[k].STANDING_PLACE;
    float2 vertex = vertexOf(row, start);
    float2 e = (float2)(place.x - vertex.x, place.y - vertex.y);
    bool free = isFree(traits.TRAIT_SHAPE, start);
    EACH_PIECE(other, own) {
        if (other == k || !mayCover(w, other)) continue;
        float2 d = turnedWayTo(w, traits.TRAIT_MOTION, pieceTraits(w, w->piece[other].TOUCHED_PIECE).TRAIT_MOTION, e, boundary);
        if (coversOther(w, other, w->standing[other].STANDING_PLACE, d, row[PIECE_THICKNESS], free, r)) {
            leavePiece(w, k);
            return;
        }
    }
}

// Measures all contacts of a circle, and forgets the impulses of those that are none there.
void measurePieces(const World *w, int2 own, float4 c, float2 d, int boundary) {
    bool vertices = false;
    EACH_PIECE(k, own) vertices |= measureTouched(w, k, c, d, boundary);
    if (!vertices || own.PIECES_COUNT == 1) return;
    EACH_PIECE(k, own) coverTouched(w, k, own, c.RADIUS, boundary);
}

// How fast the surface of a piece moves where a circle is nearest to it.
float2 surfaceOf(const World *w, global const float *row, int motion, float4 c, float2 d, float4 g, int boundary) {
    if (motion == 0) return (float2)(0.0f);
    global const float *body = bodyOf(w, motion);
    global const float *pose = poseOf(body, boundary);
    float reach = c.RADIUS + g.MEASURED_GAP;
    float2 p = pivotOf(row);
    float2 o = offsetOf(w, c, row);
    float x = ((o.x - p.x) + (d.x - pose[BODY_DX])) - g.MEASURED_X * reach;
    float y = ((o.y - p.y) + (d.y - pose[BODY_DY])) - g.MEASURED_Y * reach;
    float omega = body[BODY_OMEGA];
    return (float2)(body[BODY_VX] - omega * y, body[BODY_VY] + omega * x);
}

bool isConstraint(int4 touched) {
    return touched.TOUCHED_FEATURE != AT_NOTHING && touched.TOUCHED_RESPONSE == PAIR_SOLID;
}

float restitutionAt(const World *w, float own, int kind) {
    return maxf(own, w->kindTerrain[KIND_TERRAIN_STRIDE * kind + KIND_TERRAIN_RESTITUTION]);
}

#ifdef TURNING
void visitPieceRows(const World *w, int k, int kind, float4 g, float along, const Visited *visited, float bounce, float4 *m,
                    Turning *turning) {
    Between b = betweenSurfaces(w, turning, kind);
    if (!oneBodyRowsAct(&b)) return;
    RowImpulses i = w->pieceRows[k];
    RowGain gain = visitOneBodyRows(turning, &b, &i, along, b.belt + turning->surface[SURFACE_BELT], visited, bounce);
    pushByRows(gain, g.MEASURED_X, g.MEASURED_Y, m);
    w->pieceRows[k] = i;
}
#endif

// The warm start of a contact.
void startPiece(const World *w, int k, float r, float4 *m AND_TURNING(Turning *turning)) {
    int4 touched = w->piece[k];
    float2 push = w->push[k];
    float allowed = isConstraint(touched) ? minf(w->measured[k].MEASURED_GAP, 0.0f) : 0.0f;
    w->standing[k].STANDING_ALLOWED = allowed;
    if (allowed < -JAMMED * r) {
        push.PUSH_NORMAL = 0.0f;
        w->push[k].PUSH_NORMAL = 0.0f;
    }
    if (!isConstraint(touched) || !(actingImpulse(push.PUSH_NORMAL, w->pieceRows[k]) > 0.0f)) {
        w->pieceRows[k] = (RowImpulses)(0.0f);
        return;
    }
    float4 g = w->measured[k];
    m->VX += g.MEASURED_X * push.PUSH_NORMAL;
    m->VY += g.MEASURED_Y * push.PUSH_NORMAL;
#ifdef TURNING
    RowImpulses i = w->pieceRows[k];
    if (!rowsHold(i)) return;
    Between b = betweenSurfaces(w, turning, pieceTraits(w, touched.TOUCHED_PIECE).TRAIT_KIND);
    pushByRows(warmOneBodyRows(turning, &b, &i), g.MEASURED_X, g.MEASURED_Y, m);
    w->pieceRows[k] = i;
#endif
}

#ifdef RECORDING
#ifdef TURNING
// How fast surfaces slide that have friction. u: velocity against that of the piece; s: surface speed of the circle.
float slipAtPiece(const World *w, const Turning *turning, int kind, float4 g, float2 u, float s) {
    Between b = betweenSurfaces(w, turning, kind);
    float along = g.MEASURED_X * u.y - g.MEASURED_Y * u.x;
    return slipOfOneBody(&b, along, s, b.belt + turning->surface[SURFACE_BELT]);
}
#endif
#endif

// spin: surface speed before any impulse, if that is recorded.
void solvePiece(const World *w, int k, float4 c, float restitution, float2 before, bool loaded,
                float4 *m AND_TURNING(Turning *turning) AND_TURNING(float spin)) {
    const StepConstants *s = &w->k;
    int4 touched = w->piece[k];
    if (!isConstraint(touched)) return;
    int4 traits = pieceTraits(w, touched.TOUCHED_PIECE);
    float4 g = w->measured[k];
    float impulse = w->push[k].PUSH_NORMAL;
    float gap = g.MEASURED_GAP;
    float nx = g.MEASURED_X;
    float ny = g.MEASURED_Y;
    float2 surface =
        surfaceOf(w, pieceRow(w, touched.TOUCHED_PIECE), traits.TRAIT_MOTION, c, m->DISPLACEMENT, g, w->subStep);
    float ux = m->VX - surface.x;
    float uy = m->VY - surface.y;
    w->standing[k].STANDING_BOUNCE = 0.0f;
    // The move ends there instead.
    if (gap > MARGIN * c.RADIUS && impulse == 0.0f && isLonger(ux * s->h, uy * s->h, CAP * c.RADIUS)) return;
    float along = nx * uy - ny * ux;
    float vn = (nx * ux + ny * uy) - turnedWay(g.MEASURED_CURVE, along, s->h);
    float vnBefore = nx * (before.x - surface.x) + ny * (before.y - surface.y);
    if (!(impulse > 0.0f) && staysClear(s, gap, vn, vnBefore)) return;
    Found f = foundOneBody(s, gap, c.RADIUS, restitutionAt(w, restitution, traits.TRAIT_KIND), s->thresholdRate, impulse, loaded);
    f.before = vnBefore;
    Visited visited;
    float bounce = solveOneBody(s, &f, vn, &visited);
    float change = visited.leaves ? 0.0f : visited.impulse;
#ifdef RECORDING
    if (w->recording.pieces) {
        float slid = 0.0f;
        IF_TURNING(slid = slipAtPiece(w, turning, traits.TRAIT_KIND, g, before - surface, spin);)
        notePieceVisit(w, k, c, m->DISPLACEMENT, g, vnBefore, impulse + change, slid, surface);
    }
#endif
    bool bounces = bouncesFreely(&visited);
    if (bounces) {
        float behind = leftBehind(gap, vn, change, s->dt, c.RADIUS);
        m->DX -= nx * behind;
        m->DY -= ny * behind;
    }
    w->standing[k].STANDING_BOUNCE = bounce;
    m->VX += nx * change;
    m->VY += ny * change;
    w->push[k].PUSH_NORMAL = visited.normalImpulse;
    IF_TURNING(if (bounces) visitPieceRows(w, k, traits.TRAIT_KIND, g, along, &visited, bounce, m, turning);)
}

// The biased pass over the pieces of a circle. before: velocity before any impulse.
void solvePieces(const World *w, int slot, float4 c, float restitution, float2 before, bool loaded,
                 float4 *m AND_TURNING(Turning *turning)) {
    int2 own = w->pieces[slot];
    measurePieces(w, own, c, m->DISPLACEMENT, w->subStep);
#ifdef RECORDING
    if (w->recording.pieces && w->subStep == 0) {
        EACH_PIECE(k, own) noteSensedStart(w, k);
    }
#endif
#ifdef TURNING
#ifdef RECORDING
    float spin = w->spinImpulse[slot];
#else
    float spin = 0.0f;
#endif
#endif
    EACH_PIECE(k, own) startPiece(w, k, c.RADIUS, m AND_TURNING(turning));
    EACH_PIECE(k, own) {
        solvePiece(w, k, c, restitution, before, loaded, m AND_TURNING(turning) AND_TURNING(spin));
    }
}

void relaxPiece(const World *w, int k, float4 c, float restitution, bool loaded, float4 *m AND_TURNING(Turning *turning)) {
    const StepConstants *s = &w->k;
    int4 touched = w->piece[k];
    if (!isConstraint(touched)) return;
    float4 g = w->measured[k];
    float2 push = w->push[k];
    float gap = g.MEASURED_GAP;
    float bounce = w->standing[k].STANDING_BOUNCE;
    bool held = false;
    IF_TURNING(held = rowsHold(w->pieceRows[k]);)
    if (gap > 0.0f && !(push.PUSH_NORMAL > 0.0f) && !(bounce > 0.0f) && !held) return;
    int4 traits = pieceTraits(w, touched.TOUCHED_PIECE);
    float2 surface =
        surfaceOf(w, pieceRow(w, touched.TOUCHED_PIECE), traits.TRAIT_MOTION, c, m->DISPLACEMENT, g, w->subStep + 1);
    float nx = g.MEASURED_X;
    float ny = g.MEASURED_Y;
    float ux = m->VX - surface.x;
    float uy = m->VY - surface.y;
    float vn = nx * ux + ny * uy;
    Found f = foundOneBody(s, gap, c.RADIUS, restitutionAt(w, restitution, traits.TRAIT_KIND), s->thresholdRate, push.PUSH_NORMAL, loaded);
    IF_TURNING(f.held = held;)
    Visited visited;
    relaxOneBody(s, &f, bounce, vn, &visited);
#ifdef RECORDING
    if (w->recording.pieces) {
        float slid = 0.0f;
        IF_TURNING(slid = slipAtPiece(w, turning, traits.TRAIT_KIND, g, (float2)(ux, uy), turning->s);)
        notePieceVisit(w, k, c, m->DISPLACEMENT, g, vn, visited.leaves ? 0.0f : visited.impulse, slid, surface);
    }
#endif
    if (!visited.leaves) {
        m->VX += nx * visited.impulse;
        m->VY += ny * visited.impulse;
        w->push[k].PUSH_NORMAL = bounce > 0.0f ? 0.0f : visited.normalImpulse; // that of a bounce is not kept
    }
    IF_TURNING(visitPieceRows(w, k, traits.TRAIT_KIND, g, nx * uy - ny * ux, &visited, bounce, m, turning);)
}

// The relaxing pass over the pieces of a circle, behind movePieces.
void relaxPieces(const World *w, int slot, float4 c, float restitution, bool loaded, float4 *m AND_TURNING(Turning *turning)) {
    int2 own = w->pieces[slot];
    EACH_PIECE(k, own) {
        relaxPiece(w, k, c, restitution, loaded, m AND_TURNING(turning));
    }
}

// What stops a circle first in a sub-step, if anything does.
typedef struct {
    int contact;  // NONE: nothing
    float share;  // of the move
    float2 place; // against x and y of the piece, in the frame of the start of the step
} Stop;

// Of a body: 0 if it does not turn in the step.
float omegaOf(const World *w, int motion) { return motion == 0 ? 0.0f : bodyOf(w, motion)[BODY_OMEGA]; }

// A move in the frame of the body of a piece: from x, y by z, w. from, to: displacements.
float4 wayTo(const World *w, global const float *row, int motion, float4 c, float2 from, float2 to) {
    float2 o = offsetOf(w, c, row);
    float2 at = inFrame(w, row, motion, o, from, w->subStep);
    if (motion == 0) return (float4)(at.x, at.y, to.x - from.x, to.y - from.y);
    float2 then = inFrame(w, row, motion, o, to, w->subStep + 1);
    return (float4)(at.x, at.y, then.x - at.x, then.y - at.y);
}

// Whether a vertex is covered that a circle touches after a share t of its move. e: from the vertex to the circle then.
bool isCovered(const World *w, int2 own, float4 c, float2 from, float2 to, int k, bool start, float2 e, float t) {
    int piece = w->piece[k].TOUCHED_PIECE;
    float thickness = pieceRow(w, piece)[PIECE_THICKNESS];
    int4 traits = pieceTraits(w, piece);
    bool free = isFree(traits.TRAIT_SHAPE, start);
    EACH_PIECE(other, own) {
        if (other == k || !mayCover(w, other)) continue;
        int under = w->piece[other].TOUCHED_PIECE;
        int motion = pieceTraits(w, under).TRAIT_MOTION;
        // Frames that are one, or stay parallel within the step.
        if (motion != traits.TRAIT_MOTION && !(omegaOf(w, motion) == 0.0f && omegaOf(w, traits.TRAIT_MOTION) == 0.0f)) continue;
        float4 way = wayTo(w, pieceRow(w, under), motion, c, from, to);
        if (coversOther(w, other, (float2)(way.x + t * way.z, way.y + t * way.w), e, thickness, free, c.RADIUS)) return true;
    }
    return false;
}

// from, to: displacements; moving: whether pieces that move count. A vertex that is covered stops nobody.
Stop firstStop(const World *w, int2 own, float4 c, float2 from, float2 to, bool moving) {
    Stop stop = {NONE, 1.0f, (float2)(0.0f)};
    bool fast = isLonger(to.x - from.x, to.y - from.y, CAP * c.RADIUS);
    if (!fast && !(moving && w->terrain[TERRAIN_BODIES] > 1)) return stop;
    EACH_PIECE(k, own) {
        int4 touched = w->piece[k];
        float side = w->push[k].PUSH_SIDE;
        int4 traits = pieceTraits(w, touched.TOUCHED_PIECE);
        int motion = traits.TRAIT_MOTION;
        if (side == 0.0f || touched.TOUCHED_RESPONSE != PAIR_SOLID || (motion == 0 ? !fast : !moving)) continue;
        global const float *row = pieceRow(w, touched.TOUCHED_PIECE);
        float4 way = wayTo(w, row, motion, c, from, to);
        if (motion != 0 && !isLonger(way.z, way.w, CAP * c.RADIUS)) continue;
#pragma unroll 1
        for (int feature = AT_FACE; feature <= AT_END; feature++) {
            bool start = feature == AT_START;
            float t = feature == AT_FACE
                          ? timeOfFace(row, traits.TRAIT_SHAPE, way.x, way.y, way.z, way.w, c.RADIUS, side)
                          : timeOfVertex(row, traits.TRAIT_SHAPE, start, way.x, way.y, way.z, way.w, c.RADIUS);
            if (!(t < stop.share)) continue;
            float2 place = (float2)(way.x + t * way.z, way.y + t * way.w);
            if (feature != AT_FACE) {
                float2 vertex = vertexOf(row, start);
                float2 e = (float2)(place.x - vertex.x, place.y - vertex.y);
                if (isCovered(w, own, c, from, to, k, start, e, t)) continue;
            }
            stop.share = t;
            stop.contact = k;
            stop.place = place;
        }
    }
    return stop;
}

// The displacement at the place where a piece that moves has met the circle, as the piece has it at a boundary.
float2 takenAlong(const World *w, int piece, float4 c, float2 place, int boundary) {
    global const float *row = pieceRow(w, piece);
    global const float *body = bodyOf(w, pieceTraits(w, piece).TRAIT_MOTION);
    global const float *pose = poseOf(body, boundary);
    float2 p = pivotOf(row);
    float2 at = turnedByPose(pose, place.x - p.x, place.y - p.y);
    float2 o = offsetOf(w, c, row);
    return (float2)((at.x - (o.x - p.x)) + pose[BODY_DX], (at.y - (o.y - p.y)) + pose[BODY_DY]);
}

// Where a circle would pass a piece, its move ends; a piece that moves takes it along. stopped: whether there was one. stopper: the contact at rest
// that has stopped it, or NONE; left: of the move.
float2 stopAtPieces(const World *w, int2 own, float4 c, float2 from, float2 to, bool *stopped, int *stopper, float2 *left) {
    *stopped = false;
    *stopper = NONE;
    // A loop, so that what looks for them is there once: first at all, then, if one takes it along, at those at rest.
#pragma unroll 1
    for (int moving = 1; moving >= 0; moving--) {
        Stop stop = firstStop(w, own, c, from, to, moving != 0);
        if (stop.contact == NONE) break;
        *stopped = true;
        int piece = w->piece[stop.contact].TOUCHED_PIECE;
        if (moving == 0 || pieceTraits(w, piece).TRAIT_MOTION == 0) {
            float2 at = (float2)(from.x + stop.share * (to.x - from.x), from.y + stop.share * (to.y - from.y));
            *stopper = stop.contact;
            *left = (float2)(to.x - at.x, to.y - at.y);
            return at;
        }
        to = takenAlong(w, piece, c, stop.place, w->subStep + 1);
    }
    return to;
}

// Moves a circle out of the pieces that it is deeper in than before the sub-step; returns whether there were some. d: displacement.
bool keepOut(const World *w, int2 own, float2 *d) {
    float outX = 0.0f;
    float outY = 0.0f;
    EACH_PIECE(k, own) {
        if (!isConstraint(w->piece[k])) continue;
        float4 g = w->measured[k];
        float out = w->standing[k].STANDING_ALLOWED - (g.MEASURED_GAP + (g.MEASURED_X * outX + g.MEASURED_Y * outY));
        if (out > 0.0f) {
            outX += g.MEASURED_X * out;
            outY += g.MEASURED_Y * out;
        }
    }
    if (outX == 0.0f && outY == 0.0f) return false;
    *d = (float2)(d->x + outX, d->y + outY);
    return true;
}

// What is left of a move goes on along what has stopped it, a short way: else a circle that is always pressed against it could never leave.
// d: displacement.
bool slide(const World *w, int stopper, float4 c, float2 left, float2 *d) {
    int4 touched = w->piece[stopper];
    if (!isConstraint(touched) || touched.TOUCHED_FEATURE != AT_FACE) return false; // around an end it would pass
    float4 g = w->measured[stopper];
    float most = CAP * c.RADIUS;
    float way = clampf(g.MEASURED_X * left.y - g.MEASURED_Y * left.x, -most, most);
    *d = (float2)(d->x - g.MEASURED_Y * way, d->y + g.MEASURED_X * way);
    return way != 0.0f;
}

// Ends a circle's move in a sub-step, from a displacement to another, so that no piece is passed, or entered; and measures the contacts there.
float2 movePieces(const World *w, int slot, float4 c, float2 from, float2 to) {
    int2 own = w->pieces[slot];
    bool stopped;
    int stopper;
    float2 left = (float2)(0.0f);
    to = stopAtPieces(w, own, c, from, to, &stopped, &stopper, &left);
#pragma unroll 1
    for (int round = 0;; round++) {
        measurePieces(w, own, c, to, w->subStep + 1);
        if (stopper != NONE) {
            bool slides = slide(w, stopper, c, left, &to);
            stopper = NONE;
            if (slides) {
                round = -1;
                continue;
            }
        }
        if (round == KEEP_OUT_ROUNDS || !keepOut(w, own, &to)) break;
    }
    if (stopped) {
        // The circle touches what has stopped it, also where rounding leaves a gap: else it would stand there for ever.
        EACH_PIECE(k, own) {
            float gap = w->measured[k].MEASURED_GAP;
            if (gap <= GRAZE * c.RADIUS) w->measured[k].MEASURED_GAP = minf(gap, 0.0f);
        }
    }
    return to;
}

// Ends the step; all goes home.
void finalizePieces(const World *w, int slot) {
    int2 own = w->pieces[slot];
    IF_SLEEPING(if (own.PIECES_COUNT < 0) own.PIECES_COUNT = ~own.PIECES_COUNT;) // see keepPieces
    w->homePieces[slot] = own;
    EACH_PIECE(k, own) {
        w->homePiece[k] = w->piece[k].TOUCHED;
        w->homePush[k] = w->push[k];
        w->homePieceRows[k] = w->pieceRows[k];
    }
}
#endif
