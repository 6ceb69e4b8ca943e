// uses: world/shared/SensorRule.cl world/stages/Events.cl world/stages/CellScan.cl world/stages/PairFilter.cl
// Tells of pairs that are only sensed and touched in a step. The Java class Sensing does the same.
//
// start: by id, x, y as the step began. seeking: the table of pairs of kinds, packed as responses; then by kind: SENSED_BY_ANY, SEEKS_ANY.

#ifdef REPORTING

#define SEEKING_KINDS (256 * 16) // where the numbers by kind begin
#define SENSED_BY_ANY 1
#define SEEKS_ANY 2

// Index space: slots at home.
kernel void sensing_begin(global const int *homeId, global const float4 *homeCircle, int slots, global const int *status,
                          global float2 *start) {
    int slot = (int) get_global_id(0);
    if (status[OUT_OF_ROOM]) return; // the step before may need what is there once more
    if (slot < slots && homeId[slot] >= 0) start[homeId[slot]] = homeCircle[slot].xy;
}

typedef struct {
    float x, y, px, py, r, path;
    int id, slot;
    CircleFields fields;
    bool isStatic, isFast;
} Sensed;

Sensed sensedAt(const World *w, global const float2 *start, int slot) {
    float4 c = w->homeCircle[slot];
    Sensed s;
    s.id = w->homeId[slot];
    s.slot = slot;
    s.x = start[s.id].x;
    s.y = start[s.id].y;
    s.px = ACROSS_X(w, c.x - s.x);
    s.py = ACROSS_Y(w, c.y - s.y);
    s.r = c.RADIUS;
    s.path = lengthf(s.px, s.py);
    s.fields = w->fields[s.id];
    s.isStatic = w->homeTraits[slot].INVERSE_MASS == 0.0f;
    s.isFast = isFastSensed(s.path, s.r);
    return s;
}

// If it is in touch. a: the lower id.
void tellOfSensed(const World *w, const Sensed *a, const Sensed *b) {
    float dx = ACROSS_X(w, b->x - a->x);
    float dy = ACROSS_Y(w, b->y - a->y);
    float ux = b->px - a->px;
    float uy = b->py - a->py;
    float sum = a->r + b->r;
    float closest = timeOfClosest(dx, dy, ux, uy);
    float least_ = sensedSeparation(dx, dy, ux, uy, closest, sum);
    bool touching = touches(NO_TOUCH, least_);
    Told told;
    if (!staysInTouch(NO_TOUCH, least_, sum) || !concerns(w, a->id, b->id, touching, 0.0f, 0.0f, INFINITY, &told)) return;
    float t = touching ? timeSensed(dx, dy, ux, uy, sum) : closest;
    float mx = dx + t * ux;
    float my = dy + t * uy;
    float distance_ = lengthf(mx, my);
    bool apart = distance_ > COINCIDENT * sum;
    int hash = pairHash(a->id, b->id);
    float towardsX = apart ? mx : partingX(hash);
    float towardsY = apart ? my : partingY(hash);
    float length_ = lengthf(towardsX, towardsY);
    float nx = towardsX / length_;
    float ny = towardsY / length_;
    float vn = dotf(nx, ny, ux / w->k.dt, uy / w->k.dt);
    float separation = distance_ - sum;
    float2 point = (float2)(touchPoint(a->x, t * a->px, nx, a->r, separation), touchPoint(a->y, t * a->py, ny, a->r, separation));
    tell(w, &told, approachSpeed(vn), 0.0f, vn, (float2)(nx, ny), point, 0.0f);
}

void tellOfBothSensed(const World *w, const Sensed *a, const Sensed *b) {
    if (a->id < b->id) {
        tellOfSensed(w, a, b);
    } else {
        tellOfSensed(w, b, a);
    }
}

// Whether circles of a kind look for those of another.
int seekingOf(global const int *seeking, int kind, int other) { return (seeking[kind << 4 | other >> 4] >> 2 * (other & 15)) & 3; }

// The cells around the path of a circle.
CellRange cellsToSense(const World *w, const Sensed *s, int level) {
    float toX = s->x + s->px;
    float toY = s->y + s->py;
    float margin = sensorMargin(s->r, s->path, w->levels->top[level]);
    return cellsAround(w, level, minf(s->x, toX) - margin, maxf(s->x, toX) + margin, minf(s->y, toY) - margin, maxf(s->y, toY) + margin);
}

void senseIn(const World *w, global const float2 *start, global const int *seeking, const Sensed *s, int from, int to) {
    for (int slot = from; slot < to; slot++) {
        CircleFields fields = w->fields[w->homeId[slot]];
        int row = seekingOf(seeking, s->fields.kind, fields.kind);
        if (row == SENSOR_NONE || slot == s->slot) continue;
        if (areOfOneGroup(fields, s->fields)) continue;
        Sensed o = sensedAt(w, start, slot);
        if ((s->isStatic && o.isStatic) || !findsSensed(row, s->isFast, s->path, s->id, o.isFast, o.path, o.id)) continue;
        tellOfBothSensed(w, s, &o);
    }
}

// Index space: slots at home. Cost: the cells around its path, if it looks for others.
kernel void sensing_find(WORLD_PARAMETERS, global const float2 *start, global const int *seeking REPORTING_PARAMETERS) {
    World w = WORLD;
    REPORT_IN(w);
    int slot = (int) get_global_id(0);
    // A step that was not made has left home in another order.
    if (slot >= circles || !isMade(&w)) return;
    int part = seeking[SEEKING_KINDS + w.fields[w.homeId[slot]].kind];
    if (part == 0) return;
    Sensed s = sensedAt(&w, start, slot);
    if (!s.isFast && !(part & SEEKS_ANY)) return;
    for (int l = 0; l < levels->usedCount; l++) {
        CellRange range = cellsToSense(&w, &s, levels->used[l]);
        CellCursor at = firstCells(&range);
        int2 found;
        while (nextCells(&w, &range, &at, !s.isStatic, &found)) senseIn(&w, start, seeking, &s, found.x, found.y);
    }
}
#endif
