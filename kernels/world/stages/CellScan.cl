// uses: world/stages/World.cl
// The circles in the cells that a rectangle meets, row by row: for what looks farther than 3 x 3 cells.

typedef struct {
    int level;
    int column, row;         // the first ones
    int endColumn, endRow;   // behind the last ones; no more than once around the torus
    Sheets sheets;           // of the first cell
} CellRange;

CellRange cellsAround(const World *w, int level, float left, float right, float low, float high) {
    CellRange r;
    r.level = level;
    r.column = firstOf(axisX(w, level), left);
    r.row = firstOf(axisY(w, level), low);
    int columns = lastOf(axisX(w, level), left, right) - r.column;
    int rows = lastOf(axisY(w, level), low, high) - r.row;
    r.sheets = sheetsAt(w, level, left, low);
    r.sheets.known = areSheetsKnown(w, level, columns, rows);
    r.endColumn = r.column + min(columns + 1, w->levels->columnCount[level]);
    r.endRow = r.row + min(rows + 1, w->levels->rowCount[level]);
    return r;
}

// As columns and rows are numbered in the range.
typedef struct {
    int column, row;
} CellCursor;

CellCursor firstCells(const CellRange *r) {
    CellCursor at = {r->column, r->row};
    return at;
}

// [x, y): of the first of so many columns from a cell of the torus on, up to its seam. Sets how many columns that are: one where it tells sheets
// apart, all where that would take longer than to look at their circles. over: whether the seam is between the first cell of the range and
// this one.
int2 slotsInCells(const World *w, const CellRange *r, int row, int column, int *columns, int overX, int overY, bool withStatics) {
    global const int *start = w->bucketStart + w->levels->first[r->level] + (row << w->levels->columnsLog[r->level]) + column;
    int2 slots = (int2)(start[0], start[*columns]);
    if (!r->sheets.known || (withStatics && slots.y - slots.x <= FEW * *columns)) return slots;
    *columns = 1;
    return slotsOfSheet(w, slots.x, start[1], sheetKeyBeside(w, r->level, &r->sheets, overX, overY), withStatics);
}

// Those that lie one behind the other. Returns whether there were any.
bool nextCells(const World *w, const CellRange *r, CellCursor *at, bool withStatics, int2 *slots) {
    if (at->row >= r->endRow) return false;
    int columns = w->levels->columnCount[r->level];
    int rows = w->levels->rowCount[r->level];
    int overX = onRing(r->column, columns) + (at->column - r->column) >= columns ? 1 : 0;
    int overY = onRing(r->row, rows) + (at->row - r->row) >= rows ? 1 : 0;
    int column = onRing(at->column, columns);
    int many = min(r->endColumn - at->column, columns - column);
    *slots = slotsInCells(w, r, onRing(at->row, rows), column, &many, overX, overY, withStatics);
    at->column += many;
    if (at->column >= r->endColumn) {
        at->column = r->column;
        at->row++;
    }
    return true;
}
