// uses: world/shared/CircleMath.cl world/stages/World.cl
// Pieces of terrain: where a circle stands to one. The Java class PieceGap documents these formulas.
// row: of the piece; o: the centre against its x and y, in the frame of the start of the step.

#ifdef TERRAIN
// Where a circle is at.
#define AT_NOTHING 0 // the piece is no constraint there
#define AT_FACE 1
#define AT_START 2
#define AT_END 3

typedef struct {
    int feature;
    float nx, ny; // unit normal towards the circle
    float gap;
    float curve;  // how the way at this gap curves towards the circle
    float height; // of the centre, over the front
} PieceGap;

global const float *pieceRow(const World *w, int piece) {
    return (global const float *) w->terrain + w->terrain[TERRAIN_ROWS] + PIECE_STRIDE * piece;
}

int4 pieceTraits(const World *w, int piece) {
    return ((global const int4 *) (w->terrain + w->terrain[TERRAIN_TRAITS]))[piece];
}

int formOf(int shape) { return shape & PIECE_FORM; }
int startJoint(int shape) { return shape >> PIECE_START_LOG & PIECE_JOINT; }
int endJoint(int shape) { return shape >> PIECE_END_LOG & PIECE_JOINT; }

// Beyond an end; nx, ny: for a centre in the end itself.
void measureVertex(global const float *row, bool before, int joint, float ox, float oy, float reach, float nx, float ny, PieceGap *g) {
    float ex = ox - row[before ? PIECE_START_X : PIECE_END_X];
    float ey = oy - row[before ? PIECE_START_Y : PIECE_END_Y];
    float d = lengthf(ex, ey);
    bool central = d == 0.0f;
    g->nx = central ? nx : ex / d;
    g->ny = central ? ny : ey / d;
    g->gap = d - reach;
    g->curve = central ? 0.0f : -1.0f / d;
    // A joint belongs to the piece that ends there, up to where the next one begins.
    bool claims = joint == PIECE_FREE ||
                  (joint == PIECE_CONVEX && !before && ex * row[PIECE_NEXT_X] + ey * row[PIECE_NEXT_Y] < 0.0f);
    g->feature = !claims ? AT_NOTHING : before ? AT_START : AT_END;
}

// At a concave joint a line goes on, so that no circle slips in: not behind what follows there.
bool goesOn(float t, float length, float r) {
    float more = CORNER * r;
    return t >= -more && t <= length + more;
}

void measureLine(global const float *row, int shape, float ox, float oy, float r, float side, PieceGap *g) {
    float tx = row[PIECE_TX];
    float ty = row[PIECE_TY];
    float t = ox * tx + oy * ty;
    g->height = ox * ty - oy * tx;
    float reach = r + row[PIECE_THICKNESS];
    bool before = t < 0.0f;
    bool behind = t > row[PIECE_LENGTH];
    int joint = before ? startJoint(shape) : endJoint(shape);
    if ((!before && !behind) || joint == PIECE_CONCAVE) {
        g->feature = goesOn(t, row[PIECE_LENGTH], r) ? AT_FACE : AT_NOTHING;
        g->nx = side * ty;
        g->ny = side * -tx;
        g->gap = side * g->height - reach;
        g->curve = 0.0f;
    } else {
        measureVertex(row, before, joint, ox, oy, reach, side * ty, side * -tx, g);
    }
}

void measureArc(global const float *row, int shape, float ox, float oy, float r, PieceGap *g) {
    float tx = row[PIECE_TX];
    float ty = row[PIECE_TY];
    float length = row[PIECE_LENGTH];
    float out = (shape & PIECE_SOLID_OUTSIDE) != 0 ? -1.0f : 1.0f;
    float d = lengthf(ox, oy);
    float cos_ = ox * tx + oy * ty;
    if (cos_ >= row[PIECE_SPREAD] * d) {
        bool central = d == 0.0f;
        g->feature = AT_FACE;
        g->nx = central ? out * tx : out * (ox / d);
        g->ny = central ? out * ty : out * (oy / d);
        g->height = out * (d - length);
        g->gap = g->height - r;
        g->curve = central ? 0.0f : -out / d;
    } else {
        bool left = tx * oy - ty * ox > 0.0f;
        bool before = left == (out < 0.0f);
        int joint = before ? startJoint(shape) : endJoint(shape);
        measureVertex(row, before, joint, ox, oy, r, out * tx, out * ty, g);
    }
}

// side: 1 or -1 for a segment, 1 for a piece that has a front.
void measurePiece(global const float *row, int shape, float ox, float oy, float r, float side, PieceGap *g) {
    g->height = 0.0f;
    if (formOf(shape) == PIECE_ARC) {
        measureArc(row, shape, ox, oy, r, g);
    } else {
        measureLine(row, shape, ox, oy, r, side, g);
    }
}

// How fast a way that curves turns away from a straight one on average, in a time h, at a speed along it; never faster than that.
float turnedWay(float curve, float along, float h) {
    float most = fabs(along);
    return clampf(0.5f * curve * along * along * h, -most, most);
}

// Whether a circle that was beyond an end has come behind the piece: around that end, since no circle passes a face.
bool isAround(const PieceGap *g, int featureBefore, float side) {
    return g->feature == AT_FACE && featureBefore != AT_FACE && side * g->height < 0.0f;
}

// Whether a centre is in front of a piece, or at the tip of it and the next piece in front of that one. Beside an arc its tangents at the ends
// decide: who comes from there has not passed it.
bool isInFront(global const float *row, int shape, float ox, float oy) {
    float tx = row[PIECE_TX];
    float ty = row[PIECE_TY];
    float length = row[PIECE_LENGTH];
    float cos_ = ox * tx + oy * ty;
    float ex = ox - row[PIECE_END_X];
    float ey = oy - row[PIECE_END_Y];
    bool front;
    bool beyond;
    if (formOf(shape) == PIECE_ARC) {
        bool inner = (shape & PIECE_SOLID_OUTSIDE) != 0;
        float d = lengthf(ox, oy);
        float height = d - length;
        beyond = false;
        if (!(cos_ >= row[PIECE_SPREAD] * d)) {
            beyond = (tx * oy - ty * ox > 0.0f) != inner;
            float atX = row[beyond ? PIECE_END_X : PIECE_START_X];
            float atY = row[beyond ? PIECE_END_Y : PIECE_START_Y];
            height = atX * (ox - atX) + atY * (oy - atY);
        }
        front = inner ? height <= 0.0f : height >= 0.0f;
    } else {
        front = ox * ty - oy * tx >= 0.0f;
        beyond = cos_ > length;
    }
    return front ||
           (beyond && endJoint(shape) == PIECE_CONVEX && ex * row[PIECE_NEXT_Y] - ey * row[PIECE_NEXT_X] >= 0.0f);
}

// Of a centre and the nearest point of a piece with its thickness; joints do not matter.
float distanceOfPiece(global const float *row, int shape, float ox, float oy) {
    float tx = row[PIECE_TX];
    float ty = row[PIECE_TY];
    float length = row[PIECE_LENGTH];
    float cos_ = ox * tx + oy * ty;
    if (formOf(shape) != PIECE_ARC) {
        float t = clampf(cos_, 0.0f, length);
        return lengthf(ox - t * tx, oy - t * ty) - row[PIECE_THICKNESS];
    }
    float d = lengthf(ox, oy);
    if (cos_ >= row[PIECE_SPREAD] * d) return fabs(d - length);
    float start = lengthf(ox - row[PIECE_START_X], oy - row[PIECE_START_Y]);
    float end = lengthf(ox - row[PIECE_END_X], oy - row[PIECE_END_Y]);
    return minf(start, end);
}

// Whether the face of a piece hides a vertex from a circle in front of it: it is no higher than a slack over the face, between its ends, and not at the end that
// the circle is beyond. v: the vertex, as thick as its piece, against x and y of the piece that may cover it; free: whether it is no joint.
bool coversVertex(global const float *row, int shape, float ox, float oy, float side, float vx, float vy, float thickness, bool free, float r) {
    float slack = COVER * r;
    float rounded = ROUNDED * (fabs(row[PIECE_X]) + fabs(row[PIECE_Y]));
    float step = free ? slack : clampf(rounded, FLUSH * r, slack);
    float tx = row[PIECE_TX];
    float ty = row[PIECE_TY];
    float length = row[PIECE_LENGTH];
    if (formOf(shape) == PIECE_ARC) {
        float d = lengthf(vx, vy);
        float out = (shape & PIECE_SOLID_OUTSIDE) != 0 ? -1.0f : 1.0f;
        float far = lengthf(ox, oy);
        return ox * tx + oy * ty >= row[PIECE_SPREAD] * far && out * (far - length) >= 0.0f &&
               vx * tx + vy * ty >= row[PIECE_SPREAD] * d - slack && out * (d - length) + thickness <= step;
    }
    float t = vx * tx + vy * ty;
    float higher = (side * (vx * ty - vy * tx) - row[PIECE_THICKNESS]) + thickness;
    bool inFront = side * (ox * ty - oy * tx) >= 0.0f;
    if (!(t >= -slack && t <= length + slack && higher <= step && inFront)) return false;
    float at = ox * tx + oy * ty;
    bool before = at < 0.0f;
    if (!before && !(at > length)) return true;
    if ((before ? startJoint(shape) : endJoint(shape)) == PIECE_CONCAVE) return true;
    return before ? t > slack : t < length - slack;
}
#endif
