// uses: world/shared/CircleMath.cl
// What all stages share. Every kernel of a stage takes the same list of arrays (WORLD_PARAMETERS), packed into one struct (World)
// on entry; what a kernel does not use costs nothing. The host writes both, the structs StepConstants and Levels, and the numbers
// of the words of status out of its tables: see the Java classes DeviceArray, StepParameters and StatusWord.
//
// The state between two steps is at home: circle, motion, traits, id, firstCached by slot, some slots empty (id -1). Stage Grid
// copies it, sorted, into the working arrays; stage Solver ends the step by writing it home. A step that cannot be made as it
// was enqueued is refused: it writes nothing home, nor do those behind it, until the host has enqueued it in another way.

#define NOT_FAST 2.0f // more than any time of impact
#define NOT_CARRIED 2.0f // more than any time at which a static circle takes another along
#define NOBODY INT_MAX // more than any slot
#define CARRIED (-INFINITY) // the allowance of a circle that goes to the end of its free path, whatever its velocity

// Two numbers of contacts that are constants by default: a device is compiled for a world in which they are not (TUNED), so that all
// other worlds have a register more.
#ifdef TUNED
#define DEEP_RATE_OF(k) ((k)->deepRate)
#define OR_FIXED(k, threshold) ((threshold) + (k)->fixedThreshold)
#else
#define DEEP_RATE_OF(k) DEEP_RATE
#define OR_FIXED(k, threshold) (threshold)
#endif

// An entry of the impulse cache. next: the next one of the same circle of lower id, or NONE.
int4 cacheEntry(int higherId, float normalImpulse, int next) {
    int4 entry = (int4)(0);
    entry.CACHED_HIGHER_ID = higherId;
    entry.CACHED_IMPULSE = as_int(normalImpulse);
    entry.CACHED_NEXT = next;
    return entry;
}

// How an overlap is pushed out, which is softer than a rigid contact.
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

// Why a step is refused. A kernel does not ask for what it may set itself.
bool outOfRoom(const World *w) { return w->status[OUT_OF_ROOM] != 0; }

bool tooFast(const World *w) { return w->k.sweeping == 0 && w->status[FAST] != 0; }

bool tooCrowded(const World *w) { return w->k.thinning == 0 && w->status[CROWDED] != 0; }

// All of it at once: one read after another would be a good part of the time of a short kernel.
bool refused(const World *w) {
    int room = w->status[OUT_OF_ROOM];
    int fast = w->k.sweeping ? 0 : w->status[FAST];
    int crowded = w->k.thinning ? 0 : w->status[CROWDED];
    return (room | fast | crowded) != 0;
}

// Walls that move (the Java class WallMotion). wall: 0 to 3, for left, right, lower and upper.

// How far a wall is behind its last place at the end of the sub-step.
float behindOf(const World *w, int wall) {
    return w->walls->sweep[wall] * (float) (w->k.subSteps - 1 - w->subStep);
}

// Whether a circle feels the velocity of a wall.
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

// The column (or row) of the torus of a cell's column (or row).
int onRing(int cell, int side) { return cell < side ? cell : cell % side; }

// The column (or row) of the torus that is at (0), behind (1) or before (-1) another.
int neighbour(int column, int offset, int side) {
    int moved = column + offset;
    return moved < 0 ? side - 1 : moved < side ? moved : 0;
}

// The edges of the axes (the Java class RingCells). A device is compiled for a world in which not all are walls (EDGES), so all other
// worlds have the code for walls alone.
#ifdef EDGES
// The number of the cell of a coordinate of an axis without walls.
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

// The column (or row) where a range from one coordinate to another ends, behind that of the first.
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

// The column of a coordinate where a range begins; that where it ends is behind it by as many as the torus has, or fewer.
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

// A difference of two bases, the short way round.
#define ACROSS_X(w, d) (d)
#define ACROSS_Y(w, d) (d)
#endif

// The sheets of a folded level (the Java class GridLevels).

// The sheet that is at (0), behind (1) or before (-1) another.
int sheetBeside(int sheet, int offset, int sheets) {
    return sheets == ENDLESS ? sheet + offset : neighbour(sheet, offset, sheets);
}

// What the circles of a bucket are ordered by: an even number for each sheet; static circles have the odd number behind it.
int sheetKeyOf(const World *w, int atLevel, int sheetX, int sheetY) {
    return w->levels->folded[atLevel] ? (int) (2u * ((uint) sheetX * (uint) SHEET_X_FACTOR + (uint) sheetY * (uint) SHEET_Y_FACTOR)) : 0;
}

// Those of the slots [from, to) of a bucket that are of a sheet: all, or without static circles. A sheet has few in a bucket, or the
// caller looks at each of them anyway. If the bucket has few, all.
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

// The sheets of a cell, and of those beside it.
typedef struct {
    int x, y;
    bool known; // not where a range goes round the whole torus, or a level is not folded
} Sheets;

// Those of the cell of a place.
Sheets sheetsAt(const World *w, int atLevel, float x, float y) {
    Sheets sheets = {sheetXOf(w, atLevel, x), sheetYOf(w, atLevel, y), true};
    return sheets;
}

// Whether each cell of a range is of one sheet: so many columns and rows lie behind the first ones.
bool areSheetsKnown(const World *w, int atLevel, int columns, int rows) {
    return w->levels->folded[atLevel] && columns < w->levels->columnCount[atLevel] && rows < w->levels->rowCount[atLevel];
}

// The key of the cell that is over, behind (1) or before (-1), or not over (0) the seams of the torus along x and y.
int sheetKeyBeside(const World *w, int atLevel, const Sheets *sheets, int overX, int overY) {
    return sheetKeyOf(w, atLevel, sheetBeside(sheets->x, overX, w->levels->sheetsX[atLevel]),
                      sheetBeside(sheets->y, overY, w->levels->sheetsY[atLevel]));
}

bool hasOneLevel(const World *w) { return w->levels->usedCount == 1; }

// Groups of like contacts: as many as buckets. Those of one colour are consecutive: level after level, a quarter of its buckets each.
int likeGroups(const World *w) { return w->levels->first[LEVELS]; }

// The number of a group of like contacts.
int groupOf(const World *w, int atLevel, int ox, int oy) {
    int first = ((ox & 1) + 2 * (oy & 1)) * (likeGroups(w) >> 2) + (w->levels->first[atLevel] >> 2);
    return first + ((oy >> 1) << (w->levels->columnsLog[atLevel] - 1)) + (ox >> 1);
}

// The contacts [x, y) of the group of a colour that is a work-item's; none if there is no such group.
int2 contactsOfItem(const World *w, int colour) {
    int groups = likeGroups(w) >> 2;
    int item = (int) get_global_id(0);
    if (item >= groups) return (int2)(0);
    return (int2)(w->groupStart[colour * groups + item], w->groupStart[colour * groups + item + 1]);
}

// Behind them, if there are several levels, each circle has a group of its own, of the cross contacts in which it is the light one.
int crossGroupOf(const World *w, int slot) { return likeGroups(w) + slot; }

// The number of like contacts, which are listed first.
int likeContacts(const World *w) { return w->groupStart[likeGroups(w)]; }

// The number of contacts that were listed.
int contactsListed(const World *w) { return w->groupStart[hasOneLevel(w) ? likeGroups(w) : crossGroupOf(w, w->circles)]; }

// Up to four ranges of slots, as if they were one. Number i of them is slot i + offset.x where i < end.x, else i + offset.y
// where i < end.y, and so on.
typedef struct {
    int4 offset, end;
    int longest; // slots of the longest range
} Piece;

// The slots [from.x, to.x), [from.y, to.y) and so on.
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
