// uses: world/shared/CircleMath.cl
// What all stages share. Their kernels take one list of arrays (WORLD_PARAMETERS) and pack it into a struct (World); what a kernel does not
// use costs nothing. The text comes from tables of the host: DeviceArray, ElementField, StepParameters, StatusWord.
//
// Between steps the state is at home, by slot, some slots empty. Grid copies it, sorted, to working slots; Solver writes it home. A step
// that cannot be made as it was enqueued is refused: it writes nothing home, nor do those behind it.
//
// Index space "slots": a work-item a working slot.

#define NOT_FAST 2.0f // more than any time of impact
#define NOT_CARRIED 2.0f // more than any time at which a static circle takes another along
#define NOBODY INT_MAX // more than any slot
#define CARRIED (-INFINITY) // the allowance of a circle that goes to the end of its free path, whatever its velocity

// Constants by default, for a register less. TUNED: compiled for a world with other numbers.
#ifdef TUNED
#define DEEP_RATE_OF(k) ((k)->deepRate)
#define OR_FIXED(k, threshold) ((threshold) + (k)->fixedThreshold)
#else
#define DEEP_RATE_OF(k) DEEP_RATE
#define OR_FIXED(k, threshold) (threshold)
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

// The Java class RingCells. EDGES: compiled for a world in which not all are walls; others have the code for walls alone.
#ifdef EDGES
// Of an axis without walls.
long cellAlong(int edge, float x, float min_, float scale, int units) {
    if (edge == EDGE_OPEN) {
        long unit = (long) clampf(x * scale, -0x1p62f, 0x1p62f);
        long cell_ = unit / units;
        return unit < 0 && cell_ * units != unit ? cell_ - 1 : cell_;
    }
    return (long) floor(clampf((x - min_) * scale, -0x1p30f, 0x1p30f));
}

int longOnRing(long cell_, int side) {
    int rest = (int) (cell_ % side);
    return rest < 0 ? rest + side : rest;
}

// As far behind the column of the first as the range goes.
int lastAlong(int edge, float from, float to, float min_, float scale, int units, int side) {
    long first = cellAlong(edge, from, min_, scale, units);
    long more = cellAlong(edge, to, min_, scale, units) - first;
    return longOnRing(first, side) + (int) (more < side ? more : side);
}

int columnOf(const World *w, int atLevel, float x) {
    constant Levels *l = w->levels;
    if (l->edgeX == EDGE_WALL) return onRing(cell(x, l->minX, l->inverseEdge[atLevel]), l->columnCount[atLevel]);
    return longOnRing(cellAlong(l->edgeX, x, l->minX, l->scaleX[atLevel], l->unitsX[atLevel]), l->columnCount[atLevel]);
}

int rowOf(const World *w, int atLevel, float y) {
    constant Levels *l = w->levels;
    if (l->edgeY == EDGE_WALL) return onRing(cell(y, l->minY, l->inverseEdge[atLevel]), l->rowCount[atLevel]);
    return longOnRing(cellAlong(l->edgeY, y, l->minY, l->scaleY[atLevel], l->unitsY[atLevel]), l->rowCount[atLevel]);
}

// Where a range begins. It ends, see columnTo, at most once around the torus behind that.
int columnFrom(const World *w, int atLevel, float x) {
    constant Levels *l = w->levels;
    return l->edgeX == EDGE_WALL ? cell(x, l->minX, l->inverseEdge[atLevel]) : columnOf(w, atLevel, x);
}

int columnTo(const World *w, int atLevel, float from, float to) {
    constant Levels *l = w->levels;
    if (l->edgeX == EDGE_WALL) return cell(to, l->minX, l->inverseEdge[atLevel]);
    return lastAlong(l->edgeX, from, to, l->minX, l->scaleX[atLevel], l->unitsX[atLevel], l->columnCount[atLevel]);
}

int rowFrom(const World *w, int atLevel, float y) {
    constant Levels *l = w->levels;
    return l->edgeY == EDGE_WALL ? cell(y, l->minY, l->inverseEdge[atLevel]) : rowOf(w, atLevel, y);
}

int rowTo(const World *w, int atLevel, float from, float to) {
    constant Levels *l = w->levels;
    if (l->edgeY == EDGE_WALL) return cell(to, l->minY, l->inverseEdge[atLevel]);
    return lastAlong(l->edgeY, from, to, l->minY, l->scaleY[atLevel], l->unitsY[atLevel], l->rowCount[atLevel]);
}

bool rowsHaveWalls(const World *w) { return w->levels->edgeY == EDGE_WALL; }

int sheetAlong(int edge, float x, float min_, float scale, int units, int side, int sheets) {
    long cell_ = cellAlong(edge, x, min_, scale, units);
    long sheet = cell_ / side;
    if (cell_ < 0 && sheet * side != cell_) sheet--;
    return sheets == ENDLESS ? (int) sheet : longOnRing(sheet, sheets);
}

int sheetXOf(const World *w, int atLevel, float x) {
    constant Levels *l = w->levels;
    if (l->edgeX == EDGE_WALL) return cell(x, l->minX, l->inverseEdge[atLevel]) / l->columnCount[atLevel];
    return sheetAlong(l->edgeX, x, l->minX, l->scaleX[atLevel], l->unitsX[atLevel], l->columnCount[atLevel], l->sheetsX[atLevel]);
}

int sheetYOf(const World *w, int atLevel, float y) {
    constant Levels *l = w->levels;
    if (l->edgeY == EDGE_WALL) return cell(y, l->minY, l->inverseEdge[atLevel]) / l->rowCount[atLevel];
    return sheetAlong(l->edgeY, y, l->minY, l->scaleY[atLevel], l->unitsY[atLevel], l->rowCount[atLevel], l->sheetsY[atLevel]);
}

#define ACROSS_X(w, d) shortWay(d, (w)->levels->periodX)
#define ACROSS_Y(w, d) shortWay(d, (w)->levels->periodY)
#else
int columnOf(const World *w, int atLevel, float x) {
    return onRing(cell(x, w->levels->minX, w->levels->inverseEdge[atLevel]), w->levels->columnCount[atLevel]);
}

int rowOf(const World *w, int atLevel, float y) {
    return onRing(cell(y, w->levels->minY, w->levels->inverseEdge[atLevel]), w->levels->rowCount[atLevel]);
}

int sheetXOf(const World *w, int atLevel, float x) {
    return cell(x, w->levels->minX, w->levels->inverseEdge[atLevel]) / w->levels->columnCount[atLevel];
}

int sheetYOf(const World *w, int atLevel, float y) {
    return cell(y, w->levels->minY, w->levels->inverseEdge[atLevel]) / w->levels->rowCount[atLevel];
}

#define columnFrom(w, atLevel, x) cell(x, (w)->levels->minX, (w)->levels->inverseEdge[atLevel])
#define columnTo(w, atLevel, from, to) columnFrom(w, atLevel, to)
#define rowFrom(w, atLevel, y) cell(y, (w)->levels->minY, (w)->levels->inverseEdge[atLevel])
#define rowTo(w, atLevel, from, to) rowFrom(w, atLevel, to)
#define rowsHaveWalls(w) true

// The short way round.
#define ACROSS_X(w, d) (d)
#define ACROSS_Y(w, d) (d)
#endif

// Sheets of a folded level: the Java class GridLevels.

// As neighbour.
int sheetBeside(int sheet, int offset, int sheets) {
    return sheets == ENDLESS ? sheet + offset : neighbour(sheet, offset, sheets);
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
    bool known; // not where a range goes round the whole torus, or a level is not folded
} Sheets;

Sheets sheetsAt(const World *w, int atLevel, float x, float y) {
    Sheets sheets = {sheetXOf(w, atLevel, x), sheetYOf(w, atLevel, y), true};
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
} Piece;

Piece pieceOfRanges(int4 from, int4 to) {
    int4 count = max(to - from, (int4)(0));
    Piece p;
    p.end.x = count.x;
    p.end.y = p.end.x + count.y;
    p.end.z = p.end.y + count.z;
    p.end.w = p.end.z + count.w;
    p.offset = from - (p.end - count);
    p.longest = max(max(count.x, count.y), max(count.z, count.w));
    return p;
}

int slotInPiece(const Piece *p, int i) {
    return i + (i < p->end.x ? p->offset.x : i < p->end.y ? p->offset.y : i < p->end.z ? p->offset.z : p->offset.w);
}
