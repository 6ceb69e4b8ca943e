// uses: world/shared/Paths.cl world/stages/Pieces.cl world/stages/Sensing.cl world/stages/Touches.cl
// Tells of static circles that sense each other, and of pieces of bodies that they sense, if a kind asks for it. The Java classes Sensing and
// StaticPieces do the same.
//
// seeking: as for Sensing.cl; by kind also ASKS.

#ifdef REPORTING

#define ASKS 4
#define MEETS_STATIC 8 // it asks, or a kind that it senses

// Whether a static circle senses others that are static.
bool sensesStatic(const World *w, const Sensed *s, int part) {
    IF_SLEEPING(if (isAsleep(w->homeSleep[s->slot].REST)) return false;)
    return s->isStatic && (part & MEETS_STATIC) != 0;
}

void senseStaticIn(const World *w, global const float2 *start, global const int *seeking, const Sensed *s, int part, int from, int to) {
    for (int slot = from; slot < to; slot++) {
        CircleFields fields = w->fields[w->homeId[slot]];
        int row = seekingOf(seeking, s->fields.kind, fields.kind);
        if (row == SENSOR_NONE || slot == s->slot || w->homeTraits[slot].INVERSE_MASS != 0.0f) continue;
        int other = seeking[SEEKING_KINDS + fields.kind];
        if (!((part | other) & ASKS) || areOfOneGroup(fields, s->fields)) continue;
        Sensed o = sensedAt(w, start, slot);
        int seeks = !(part & ASKS) ? SENSOR_FOUND : other & ASKS ? SENSOR_BOTH_SEEK : SENSOR_SEEKS;
        if (!sensesStatic(w, &o, other) || !findsSensed(seeks, s->isFast, s->path, s->id, o.isFast, o.path, o.id)) continue;
        tellOfBothSensed(w, s, &o);
    }
}

// Index space: slots at home. Cost: the cells around its path, if it is static and its kind asks.
kernel void statics_find(WORLD_PARAMETERS, global const float2 *start, global const int *seeking REPORTING_PARAMETERS) {
    World w = WORLD;
    REPORT_IN(w);
    int slot = (int) get_global_id(0);
    if (slot >= circles || !isMade(&w)) return;
    int part = seeking[SEEKING_KINDS + w.fields[w.homeId[slot]].kind];
    if (!(part & MEETS_STATIC) || w.homeTraits[slot].INVERSE_MASS != 0.0f) return;
    Sensed s = sensedAt(&w, start, slot);
    if (!sensesStatic(&w, &s, part) || (!s.isFast && !(part & ASKS))) return;
    for (int l = 0; l < levels->usedCount; l++) {
        CellRange range = cellsToSense(&w, &s, levels->used[l]);
        CellCursor at = firstCells(&range);
        int2 found;
        while (nextCells(&w, &range, &at, true, &found)) senseStaticIn(&w, start, seeking, &s, part, found.x, found.y);
    }
}

#if defined(TERRAIN) && defined(RECORDING)
// Whether a box meets one around a place, or around an image of it.
bool meetsBox(const World *w, float4 box, float x, float y, float m) {
    int timesX = 0;
    int timesY = 0;
#ifdef EDGES
    timesX = w->levels->periodX < INFINITY ? 1 : 0;
    timesY = w->levels->periodY < INFINITY ? 1 : 0;
#endif
    bool some = false;
#pragma unroll 1
    for (int u = -timesX; u <= timesX; u++) {
        float atX = u == 0 ? x : x + (float) u * w->levels->periodX;
        float mx = u == 0 ? m : m + fabs(atX) * 0x1p-22f + w->levels->periodX * 0x1p-22f; // off by a rounding
#pragma unroll 1
        for (int v = -timesY; v <= timesY; v++) {
            float atY = v == 0 ? y : y + (float) v * w->levels->periodY;
            float my = v == 0 ? m : m + fabs(atY) * 0x1p-22f + w->levels->periodY * 0x1p-22f;
            some |= box.x <= atX + mx && box.y <= atY + my && box.z >= atX - mx && box.w >= atY - my;
        }
    }
    return some;
}

// What a static circle does at a piece, if it senses it.
void tellOfStaticAt(const World *w, const Sensed *s, int piece) {
    global const float *row = pieceRow(w, piece);
    int4 traits = pieceTraits(w, piece);
    float2 offset = offsetOf(w, (float4)(s->x, s->y, s->r, 0.0f), row);
    float far = sight(s->r, s->path) + row[PIECE_MOST];
    if (!(distanceOfPiece(row, traits.TRAIT_SHAPE, offset.x, offset.y) < far)) return;
    int code = FIRST_PIECE + piece;
    float2 o = inFrame(w, row, traits.TRAIT_MOTION, offset, (float2)(0.0f), 0);
    float2 end = inFrame(w, row, traits.TRAIT_MOTION, offset, (float2)(s->px, s->py), w->k.subSteps);
    float side = findTouching(w, s->id, code) == NONE ? 0.0f : 1.0f;
    if (!(distanceOfPiece(row, traits.TRAIT_SHAPE, o.x, o.y) <= s->r)) {
        side = isInFront(row, traits.TRAIT_SHAPE, o.x, o.y) ? 1.0f : 0.0f;
    }
    SensedTouch t;
    if (!touchesSensedPiece(w, piece, o, end, s->r, side, &t)) return;
    Told told;
    if (concerns(w, s->id, code, t.touching, t.approach, 0.0f, MAXFLOAT, &told)) {
        tell(w, &told, t.approach, 0.0f, t.vn, -t.normal, t.point, 0.0f);
    }
}

// Index space: slots at home. Cost: the nodes of the tree of bodies that are near, if it is static and its kind, or that of a piece, asks.
kernel void statics_findPieces(WORLD_PARAMETERS, global const float2 *start, global const int *seeking REPORTING_PARAMETERS) {
    World w = WORLD;
    REPORT_IN(w);
    int slot = (int) get_global_id(0);
    if (slot >= circles || !isMade(&w)) return;
    int part = seeking[SEEKING_KINDS + w.fields[w.homeId[slot]].kind];
    if (!(part & MEETS_STATIC) || w.homeTraits[slot].INVERSE_MASS != 0.0f) return;
    Sensed s = sensedAt(&w, start, slot);
    if (!sensesStatic(&w, &s, part)) return;
    global const float4 *boxes = (global const float4 *) (w.terrain + w.terrain[TERRAIN_BOXES]);
    global const int2 *links = (global const int2 *) (w.terrain + w.terrain[TERRAIN_LINKS]);
    int nodes = w.terrain[TERRAIN_NODES];
    float m = SIGHT_SLACK * sight(s.r, s.path);
#pragma unroll 1
    for (int node = w.terrain[TERRAIN_GROUND_NODES]; node < nodes;) {
        int2 link = links[node];
        if (!meetsBox(&w, boxes[node], s.x, s.y, m)) {
            node = link.x;
            continue;
        }
        if (link.y >= 0) {
            int kind = pieceTraits(&w, link.y).TRAIT_KIND;
            int row = seekingOf(seeking, s.fields.kind, kind);
            bool asks = ((part | seeking[SEEKING_KINDS + kind]) & ASKS) != 0;
            if (row != SENSOR_NONE && asks) tellOfStaticAt(&w, &s, link.y);
        }
        node++;
    }
}
#endif
#endif
