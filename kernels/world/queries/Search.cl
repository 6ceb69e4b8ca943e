// uses: world/queries/Tree.cl
// Queries, one a work-item: the tests of the Java class CircleTests, in double precision, and searches in the tree. Found circles have an
// order: distance (of overlaps 0), then id. FILTER_WORDS: ints in front of the queries, a bit for each kind that counts, then the id LEFT_OUT.
#pragma OPENCL EXTENSION cl_khr_fp64 : enable

#define AREA_MARGIN 0x1p-21  // more than the rounding of a disc's sides
#define CAST_MARGIN 0x1p-44  // more than the rounding of the exact test, as a share of its greatest length
#define NEAREST_MARGIN 0x1p-40 // more than the rounding of a distance, by its share of it

typedef struct {
    double distance;
    float x, y;
} Place;

// shape: the top level; then where each level's boxes begin and how many there are.
typedef struct {
    global const float4 *circle;
    global const int *id;
    global const float4 *box;
    global const int *shape;
    int circles;
} Tree;

#define TREE_PARAMETERS \
    global const float4 *circle, global const int *id, global const float4 *box, global const int *shape, int circles
#define TREE {circle, id, box, shape, circles}

int topOf(const Tree *t) { return t->shape[0]; }
int startOf(const Tree *t, int level) { return t->shape[1 + 2 * level]; }
int boxesOf(const Tree *t, int level) { return t->shape[2 + 2 * level]; }

// A box has x, y for its lower left and toX, toY for its upper right corner.
typedef struct {
    int kind;
    double x, y, toX, toY, reach, unitX, unitY, length, margin;
    bool filtered;
    global const int *filter;
    global const CircleFields *fields;
} Query;

int strideOf(int kind) {
    return kind == QUERY_POINT || kind == QUERY_NEAREST ? 2 : kind == QUERY_DISC ? 3 : kind == QUERY_DISC_CAST ? 5 : 4;
}

bool isCast(int kind) { return kind == QUERY_RAY || kind == QUERY_DISC_CAST; }

Query queryOf(const Tree *t, int kind, global const int *words, int number, float within, int filtered, global const CircleFields *fields) {
    global const float *from = (global const float *) (words + FILTER_WORDS) + strideOf(kind) * number;
    Query q;
    q.kind = kind;
    q.filtered = filtered != 0;
    q.filter = words;
    q.fields = fields;
    q.x = from[0];
    q.y = from[1];
    q.toX = kind == QUERY_BOX ? from[2] : 0.0;
    q.toY = kind == QUERY_BOX ? from[3] : 0.0;
    q.reach = kind == QUERY_DISC || kind == QUERY_DISC_CAST ? from[2] : kind == QUERY_NEAREST ? within : 0.0f;
    q.unitX = 0.0;
    q.unitY = 0.0;
    q.length = 0.0;
    q.margin = 0.0;
    if (isCast(kind)) {
        double dx = from[strideOf(kind) - 2];
        double dy = from[strideOf(kind) - 1];
        q.length = sqrt(dx * dx + dy * dy);
        q.unitX = q.length == 0.0 ? 0.0 : dx / q.length;
        q.unitY = q.length == 0.0 ? 0.0 : dy / q.length;
        float4 all = t->box[startOf(t, topOf(t))];
        double span = fmax(fabs(all.x - q.x), fabs(all.z - q.x)) + fmax(fabs(all.y - q.y), fabs(all.w - q.y));
        q.margin = q.reach + (span + q.reach) * CAST_MARGIN;
    }
    return q;
}

double squaredDistance(const Query *q, float4 c) {
    double dx = c.x - q->x;
    double dy = c.y - q->y;
    return dx * dx + dy * dy;
}

bool overlapsDisc(const Query *q, float4 c) {
    double s = c.z + q->reach;
    return squaredDistance(q, c) <= s * s;
}

bool overlapsBox(const Query *q, float4 c) {
    double dx = fmax(fmax(q->x - c.x, c.x - q->toX), 0.0);
    double dy = fmax(fmax(q->y - c.y, c.y - q->toY), 0.0);
    return dx * dx + dy * dy <= (double) c.z * c.z;
}

bool meetsPath(const Query *q, float4 c, double *distance) {
    double dx = c.x - q->x;
    double dy = c.y - q->y;
    double s = c.z + q->reach;
    if (dx * dx + dy * dy <= s * s) {
        *distance = 0.0;
        return true;
    }
    double forward = dx * q->unitX + dy * q->unitY;
    double across = dx * q->unitY - dy * q->unitX;
    double square = s * s - across * across;
    if (forward <= 0.0 || square < 0.0) return false;
    double d = forward - sqrt(square);
    *distance = d > 0.0 ? d : 0.0;
    return *distance <= q->length;
}

bool admits(const Query *q, int id) {
    if (!q->filtered) return true;
    int kind = q->fields[id].kind;
    return id != q->filter[LEFT_OUT] && (q->filter[kind >> 5] >> (kind & 31) & 1) != 0;
}

bool finds(const Query *q, float4 c, double *distance) {
    *distance = 0.0;
    if (q->kind == QUERY_BOX) return overlapsBox(q, c);
    if (isCast(q->kind)) return meetsPath(q, c, distance);
    if (!overlapsDisc(q, c)) return false;
    if (q->kind == QUERY_POINT) *distance = squaredDistance(q, c);
    if (q->kind == QUERY_NEAREST) *distance = sqrt(squaredDistance(q, c)) - c.z;
    return true;
}

// A component of 0 is in the range for ever, or never.
void narrow(double from, double unit, double low, double high, double *enter, double *leave) {
    if (unit == 0.0) {
        if (from < low || from > high) *leave = -1.0;
        return;
    }
    double a = (low - from) / unit;
    double b = (high - from) / unit;
    *enter = fmax(*enter, fmin(a, b));
    *leave = fmin(*leave, fmax(a, b));
}

// A lower bound in a box; infinite if there is nothing within the limit.
double distanceOf(const Query *q, float4 box, double limit) {
    if (isCast(q->kind)) {
        double enter = 0.0;
        double leave = fmin(q->length, limit);
        narrow(q->x, q->unitX, box.x - q->margin, box.z + q->margin, &enter, &leave);
        narrow(q->y, q->unitY, box.y - q->margin, box.w + q->margin, &enter, &leave);
        return enter > leave ? INFINITY : enter;
    }
    if (q->kind == QUERY_NEAREST) {
        double dx = fmax(box.x - q->x, q->x - box.z);
        double dy = fmax(box.y - q->y, q->y - box.w);
        double d = dx <= 0.0 || dy <= 0.0 ? fmax(dx, dy) : sqrt(dx * dx + dy * dy);
        double nearestThere = d - fabs(d) * NEAREST_MARGIN;
        return nearestThere <= limit ? nearestThere : INFINITY;
    }
    bool isBox = q->kind == QUERY_BOX;
    double marginX = isBox ? 0.0 : (fabs(q->x) + q->reach) * AREA_MARGIN + q->reach;
    double marginY = isBox ? 0.0 : (fabs(q->y) + q->reach) * AREA_MARGIN + q->reach;
    double maxX = isBox ? q->toX : q->x;
    double maxY = isBox ? q->toY : q->y;
    bool meets = box.x <= maxX + marginX && box.z >= q->x - marginX && box.y <= maxY + marginY && box.w >= q->y - marginY;
    return meets ? 0.0 : INFINITY;
}

// A heap has the last in the order on top.
typedef struct {
    global int *id;
    global Place *place;
} Rows;

bool isAfter(double d, int id, double otherD, int otherId) { return d > otherD || (d == otherD && id > otherId); }

void putRow(const Rows *rows, int k, int id, Place place) {
    rows->id[k] = id;
    rows->place[k] = place;
}

void sink(const Rows *rows, int at, int id, Place place, int n) {
    int k = at;
    while (2 * k + 1 < n) {
        int child = 2 * k + 1;
        if (child + 1 < n && isAfter(rows->place[child + 1].distance, rows->id[child + 1], rows->place[child].distance, rows->id[child])) {
            child++;
        }
        if (!isAfter(rows->place[child].distance, rows->id[child], place.distance, id)) break;
        putRow(rows, k, rows->id[child], rows->place[child]);
        k = child;
    }
    putRow(rows, k, id, place);
}

void rise(const Rows *rows, int at, int id, Place place) {
    int k = at;
    while (k > 0) {
        int parent = (k - 1) / 2;
        if (!isAfter(place.distance, id, rows->place[parent].distance, rows->id[parent])) break;
        putRow(rows, k, rows->id[parent], rows->place[parent]);
        k = parent;
    }
    putRow(rows, k, id, place);
}

void sortRows(const Rows *rows, int n) {
    for (int k = n / 2 - 1; k >= 0; k--) sink(rows, k, rows->id[k], rows->place[k], n);
    for (int end = n - 1; end > 0; end--) {
        int id = rows->id[end];
        Place place = rows->place[end];
        putRow(rows, end, rows->id[0], rows->place[0]);
        sink(rows, 0, id, place, end);
    }
}

// Without a stack: from a box to the first in it, else to the next. Returns how many it finds.
int findAll(const Tree *t, const Query *q, const Rows *rows) {
    int count = 0;
    int level = topOf(t);
    int b = 0;
    while (level <= topOf(t)) {
        if (distanceOf(q, t->box[startOf(t, level) + b], INFINITY) < INFINITY) {
            if (level > 0) {
                level--;
                b *= BOXES_A_BOX;
                continue;
            }
            int end = min(CIRCLES_A_BOX * (b + 1), t->circles);
            for (int k = CIRCLES_A_BOX * b; k < end; k++) {
                float4 c = t->circle[k];
                double distance;
                if (finds(q, c, &distance) && admits(q, t->id[k])) {
                    Place place = {distance, c.x, c.y};
                    if (rows) putRow(rows, count, t->id[k], place);
                    count++;
                }
            }
        }
        b++;
        while (level <= topOf(t) && (b % BOXES_A_BOX == 0 || b >= boxesOf(t, level))) {
            b = (b - 1) / BOXES_A_BOX + 1;
            level++;
        }
    }
    return count;
}

#define QUERY_PARAMETERS \
    TREE_PARAMETERS, int kind, global const int *words, int filtered, global const CircleFields *fields, int n

// Index space: a query.
kernel void queries_count(QUERY_PARAMETERS, global int *counts) {
    int number = (int) get_global_id(0);
    if (number >= n) return;
    Tree tree = TREE;
    Query q = queryOf(&tree, kind, words, number, 0.0f, filtered, fields);
    counts[number] = findAll(&tree, &q, 0);
}

// Index space: a query.
kernel void queries_list(QUERY_PARAMETERS, global const int *ends, global int *foundId, global Place *foundPlace) {
    int number = (int) get_global_id(0);
    if (number >= n) return;
    Tree tree = TREE;
    Query q = queryOf(&tree, kind, words, number, 0.0f, filtered, fields);
    int from = number == 0 ? 0 : ends[number - 1];
    Rows rows = {foundId + from, foundPlace + from};
    sortRows(&rows, findAll(&tree, &q, &rows));
}

// Three siblings at most wait for each level, and four of the last.
#define MOST_WAITING (BOXES_A_BOX * (TREE_LEVELS + 1))

// Goes into the nearest that waits: boxes of a level that share one of the next, or at level -1 the circles of a box.
int findFew(const Tree *t, const Query *q, int most, const Rows *rows) {
    int waitingLevel[MOST_WAITING];
    int waitingBox[MOST_WAITING];
    double waitingDistance[MOST_WAITING];
    double farthest = q->kind == QUERY_NEAREST ? q->reach + q->reach * NEAREST_MARGIN : INFINITY;
    double limit = farthest;
    int count = 0;
    int waiting = 1;
    waitingLevel[0] = topOf(t);
    waitingBox[0] = 0;
    waitingDistance[0] = -INFINITY;
    while (waiting > 0) {
        waiting--;
        int level = waitingLevel[waiting];
        int b = waitingBox[waiting];
        if (waitingDistance[waiting] > limit) continue;
        if (level < 0) {
            int end = min(CIRCLES_A_BOX * (b + 1), t->circles);
            for (int k = CIRCLES_A_BOX * b; k < end; k++) {
                float4 c = t->circle[k];
                Place place = {0.0, c.x, c.y};
                int id = t->id[k];
                if (!finds(q, c, &place.distance) || !admits(q, id)) continue;
                if (count < most) {
                    rise(rows, count++, id, place);
                } else if (isAfter(rows->place[0].distance, rows->id[0], place.distance, id)) {
                    sink(rows, 0, id, place, count);
                }
            }
            if (count == most) limit = fmin(farthest, rows->place[0].distance);
            continue;
        }
        int base = waiting;
        int end = min(BOXES_A_BOX * (b + 1), boxesOf(t, level));
        for (int k = BOXES_A_BOX * b; k < end; k++) {
            double distance = distanceOf(q, t->box[startOf(t, level) + k], limit);
            if (distance == INFINITY) continue;
            int to = waiting++;
            while (to > base && waitingDistance[to - 1] < distance) {
                waitingLevel[to] = waitingLevel[to - 1];
                waitingBox[to] = waitingBox[to - 1];
                waitingDistance[to] = waitingDistance[to - 1];
                to--;
            }
            waitingLevel[to] = level - 1;
            waitingBox[to] = k;
            waitingDistance[to] = distance;
        }
    }
    return count;
}

// Index space: a query.
kernel void queries_few(QUERY_PARAMETERS, float within, int most, global int *foundId, global Place *foundPlace) {
    int number = (int) get_global_id(0);
    if (number >= n) return;
    Tree tree = TREE;
    Query q = queryOf(&tree, kind, words, number, within, filtered, fields);
    Rows rows = {foundId + most * number, foundPlace + most * number};
    int count = findFew(&tree, &q, most, &rows);
    sortRows(&rows, count);
    for (int k = count; k < most; k++) rows.id[k] = NONE;
}
