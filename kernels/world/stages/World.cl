// uses: world/shared/Cells.cl
// What all stages share. Their kernels pack one list of arrays (WORLD_PARAMETERS) into a struct (World); what a kernel does not use costs
// nothing. Tables of the host give the text: DeviceArray, ElementField, StepParameters, StatusWord.
//
// Between steps the state is at home, by slot, some slots empty. Grid copies it, sorted, to working slots; Solver writes it home. A refused
// step writes nothing home, nor do those behind it, until the host has enqueued it in another way.
//
// Index space "slots": a work-item a working slot.

#define NOT_FAST 2.0f // more than any time of impact
#define NOT_CARRIED 2.0f // more than any carry time
#define NOBODY INT_MAX // more than any slot
#define CARRIED (-INFINITY) // as an allowance: to the end of the free path

// Constants by default, for a register less. TUNED: compiled for a world with other numbers.
#ifdef TUNED
#define DEEP_RATE_OF(k) ((k)->deepRate)
#define OR_FIXED(k, threshold) ((threshold) + (k)->fixedThreshold)
#else
#define DEEP_RATE_OF(k) DEEP_RATE
#define OR_FIXED(k, threshold) (threshold)
#endif

// IF_TURNING(text), and so for each feature, from the host: a statement or a member that is there if circles can rotate. AND_TURNING: a parameter or an argument.
#ifdef TURNING
#define AND_TURNING(parameter) , parameter
#else
#define AND_TURNING(parameter)
#endif

// The same of worlds with terrain.
#ifdef TERRAIN
#define AND_TERRAIN(parameter) , parameter
#else
#define AND_TERRAIN(parameter)
#endif

// next: of the same lower id, or NONE.
int4 cacheEntry(int higherId, float normalImpulse, int next) {
    int4 entry = (int4)(0);
    entry.CACHED_HIGHER_ID = higherId;
    entry.CACHED_IMPULSE = as_int(normalImpulse);
    entry.CACHED_NEXT = next;
    return entry;
}

// Of an overlap that is pushed out.
typedef struct {
    float biasRate, massScale, impulseScale;
} Softness;

Softness contactSoftness(const StepConstants *k) {
    Softness softness = {k->biasRate, k->massScale, k->impulseScale};
    return softness;
}

Softness oneBodySoftness(const StepConstants *k) {
    Softness softness = {k->wallBiasRate, k->wallMassScale, k->wallImpulseScale};
    return softness;
}

// A kernel does not ask for what it may set itself.
bool outOfRoom(const World *w) { return w->status[OUT_OF_ROOM] != 0; }
bool tooFast(const World *w) { return w->k.sweeping == 0 && w->status[FAST] != 0; }
bool tooCrowded(const World *w) { return w->k.thinning == 0 && w->status[CROWDED] != 0; }

// At once: one read after another would be a good part of a short kernel's time.
bool refused(const World *w) {
    int room = w->status[OUT_OF_ROOM];
    int fast = w->k.sweeping ? 0 : w->status[FAST];
    int crowded = w->k.thinning ? 0 : w->status[CROWDED];
    return (room | fast | crowded) != 0;
}

// As it is awake: one that sleeps has 0 in its traits. c: circle.
float awakeInverseMass(float4 c, float inTraits) {
#ifdef SLEEPING
    return inverseMass(c.MASS);
#else
    return inTraits;
#endif
}

float ownInverseMass(const World *w, int slot) { return inverseMass(w->circle[slot].MASS); }

// Walls that move: the Java class WallMotion. wall: left, right, lower, upper.

// Behind its last place, at the end of the sub-step.
float behindOf(const World *w, int wall) {
    return w->walls->sweep[wall] * (float) (w->k.subSteps - 1 - w->subStep);
}

bool feelsWall(const World *w, int wall, float r) { return fabs(w->walls->travel[wall]) <= r; }
float speedFor(const World *w, int wall, float r) { return feelsWall(w, wall, r) ? w->walls->speed[wall] : 0.0f; }
float sweepFor(const World *w, int wall, float r) { return feelsWall(w, wall, r) ? w->walls->sweep[wall] : 0.0f; }

float travelFor(const World *w, int wall, float r) {
    return feelsWall(w, wall, r) ? maxf(w->walls->travel[wall], 0.0f) : 0.0f;
}

int levelOf(const World *w, float r) { return w->levels->levelOf[sizeClass(r, w->levels->rmax)]; }

int levelOfBucket(const World *w, int bucket) {
    constant Levels *levels = w->levels;
    int n = 0;
    while (n < levels->usedCount - 1 && bucket >= levels->first[levels->used[n + 1]]) n++;
    return levels->used[n];
}

// The column (or row) of the torus of one that is not negative.
int onRing(int cell, int side) { return cell < side ? cell : cell % side; }

// Behind (1), before (-1) or at (0) another.
int neighbour(int column, int offset, int side) {
    int moved = column + offset;
    return moved < 0 ? side - 1 : moved < side ? moved : 0;
}

// RingCells of GridLevels.java. EDGES: compiled for a world in which not all edges are walls.
typedef struct {
    int edge, side, units, sheets;
    float low, inverseEdge, scale;
} Axis;

Axis axisX(const World *w, int atLevel) {
    constant Levels *l = w->levels;
    Axis a = {l->edgeX, l->columnCount[atLevel], l->unitsX[atLevel], l->sheetsX[atLevel], l->minX,
              l->inverseEdge[atLevel], l->scaleX[atLevel]};
    return a;
}

Axis axisY(const World *w, int atLevel) {
    constant Levels *l = w->levels;
    Axis a = {l->edgeY, l->rowCount[atLevel], l->unitsY[atLevel], l->sheetsY[atLevel], l->minY,
              l->inverseEdge[atLevel], l->scaleY[atLevel]};
    return a;
}

#ifdef EDGES
bool isWalled(Axis a) { return a.edge == EDGE_WALL; }

// The short way round.
#define ACROSS_X(w, d) shortWay(d, (w)->levels->periodX)
#define ACROSS_Y(w, d) shortWay(d, (w)->levels->periodY)
#else
bool isWalled(Axis a) { return true; }

#define ACROSS_X(w, d) (d)
#define ACROSS_Y(w, d) (d)
#endif

int cellAtWall(Axis a, float x) { return cell(x, a.low, a.inverseEdge); }

long cellAlong(Axis a, float x) {
    if (a.edge == EDGE_OPEN) {
        long unit = (long) clampf(x * a.scale, -0x1p62f, 0x1p62f);
        long cell_ = unit / a.units;
        return unit < 0 && cell_ * a.units != unit ? cell_ - 1 : cell_;
    }
    return (long) floor(clampf((x - a.low) * a.scale, -0x1p30f, 0x1p30f));
}

int longOnRing(long cell_, int side) {
    int rest = (int) (cell_ % side);
    return rest < 0 ? rest + side : rest;
}

// The column (or row) of the torus.
int ringOf(Axis a, float x) { return isWalled(a) ? onRing(cellAtWall(a, x), a.side) : longOnRing(cellAlong(a, x), a.side); }

// Where a range begins. It ends at most once around the torus behind that.
int firstOf(Axis a, float x) { return isWalled(a) ? cellAtWall(a, x) : ringOf(a, x); }

int lastOf(Axis a, float from, float to) {
    if (isWalled(a)) return cellAtWall(a, to);
    long first = cellAlong(a, from);
    long more = cellAlong(a, to) - first;
    return longOnRing(first, a.side) + (int) (more < a.side ? more : a.side);
}

int sheetOf(Axis a, float x) {
    if (isWalled(a)) return cellAtWall(a, x) / a.side;
    long cell_ = cellAlong(a, x);
    long sheet = cell_ / a.side;
    if (cell_ < 0 && sheet * a.side != cell_) sheet--;
    return a.sheets == ENDLESS ? (int) sheet : longOnRing(sheet, a.sheets);
}

// Sheets of a folded level: the Java class GridLevels.

// As neighbour.
int sheetBeside(int sheet, int offset, int sheets) {
    return sheets == ENDLESS ? (int) ((uint) sheet + (uint) offset) : neighbour(sheet, offset, sheets);
}

// Orders the circles of a bucket: an even number a sheet; static circles have the odd one behind it.
int sheetKeyOf(const World *w, int atLevel, int sheetX, int sheetY) {
    return w->levels->folded[atLevel] ? (int) (2u * ((uint) sheetX * (uint) SHEET_X_FACTOR + (uint) sheetY * (uint) SHEET_Y_FACTOR)) : 0;
}

// Of the slots [from, to) of a bucket those of a sheet; all, if they are few: callers look at each anyway.
int2 slotsOfSheet(const World *w, int from, int to, int sheet, bool withStatics) {
    if (withStatics && to - from <= FEW) return (int2)(from, to);
    int low = from;
    int high = to;
    while (low < high) {
        int middle = (low + high) >> 1;
        if (w->sheetKey[middle] < sheet) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    int last = sheet + (withStatics ? 1 : 0);
    while (high < to && w->sheetKey[high] <= last) high++;
    return (int2)(low, high);
}

typedef struct {
    int x, y;
    bool known; // see areSheetsKnown
} Sheets;

Sheets sheetsAt(const World *w, int atLevel, float x, float y) {
    Sheets sheets = {sheetOf(axisX(w, atLevel), x), sheetOf(axisY(w, atLevel), y), true};
    return sheets;
}

// Unless the range goes round the whole torus.
bool areSheetsKnown(const World *w, int atLevel, int columns, int rows) {
    return w->levels->folded[atLevel] && columns < w->levels->columnCount[atLevel] && rows < w->levels->rowCount[atLevel];
}

// over: behind (1) or before (-1) the seam of the torus, or not over it.
int sheetKeyBeside(const World *w, int atLevel, const Sheets *sheets, int overX, int overY) {
    return sheetKeyOf(w, atLevel, sheetBeside(sheets->x, overX, w->levels->sheetsX[atLevel]),
                      sheetBeside(sheets->y, overY, w->levels->sheetsY[atLevel]));
}

bool hasOneLevel(const World *w) { return w->levels->usedCount == 1; }

// By tiles: whether between passes circles are as Solver.cl has them, since others than like contacts visit them: cross contacts, joints, bodies.
bool sharesPasses(const World *w) {
    IF_BODIES(return true;)
    IF_JOINTS(if (w->joints->any) return true;)
    return !hasOneLevel(w);
}

// Groups of like contacts: a bucket each. A colour's are consecutive: level after level, a quarter of its buckets.
int likeGroups(const World *w) { return w->levels->first[LEVELS]; }

int groupOf(const World *w, int atLevel, int ox, int oy) {
    int first = ((ox & 1) + 2 * (oy & 1)) * (likeGroups(w) >> 2) + (w->levels->first[atLevel] >> 2);
    return first + ((oy >> 1) << (w->levels->columnsLog[atLevel] - 1)) + (ox >> 1);
}

// Those of the group of a colour that is a work-item's: [x, y).
int2 contactsOfItem(const World *w, int colour) {
    int groups = likeGroups(w) >> 2;
    int item = (int) get_global_id(0);
    if (item >= groups) return (int2)(0);
    return (int2)(w->groupStart[colour * groups + item], w->groupStart[colour * groups + item + 1]);
}

// Behind them, with several levels, a group a circle: its cross contacts as the light one.
int crossGroupOf(const World *w, int slot) { return likeGroups(w) + slot; }

// Like contacts are listed first.
int likeContacts(const World *w) { return w->groupStart[likeGroups(w)]; }
int contactsListed(const World *w) { return w->groupStart[hasOneLevel(w) ? likeGroups(w) : crossGroupOf(w, w->circles)]; }

// Up to four ranges of slots as one: number i is slot i + offset.x if i < end.x, else i + offset.y if i < end.y, and so on.
typedef struct {
    int4 offset, end;
    int longest; // slots of the longest range
} SlotRange;

SlotRange joinedRanges(int4 from, int4 to) {
    int4 count = max(to - from, (int4)(0));
    SlotRange p;
    p.end.x = count.x;
    p.end.y = p.end.x + count.y;
    p.end.z = p.end.y + count.z;
    p.end.w = p.end.z + count.w;
    p.offset = from - (p.end - count);
    p.longest = max(max(count.x, count.y), max(count.z, count.w));
    return p;
}

int slotInRange(const SlotRange *p, int i) {
    return i + (i < p->end.x ? p->offset.x : i < p->end.y ? p->offset.y : i < p->end.z ? p->offset.z : p->offset.w);
}
