// uses: world/shared/Piece.cl world/shared/TimeOfImpact.cl
// When a circle that moves evenly touches a piece of terrain. The Java class PieceSweep documents these formulas.
// row: of the piece; o: the centre against its x and y, in the frame of the start of the step; u: its motion.

#ifdef TERRAIN
#define NEVER_TOUCHES 2.0f

float timeOfLine(global const float *row, int shape, float ox, float oy, float ux, float uy, float r, float reach, float side) {
    float tx = row[PIECE_TX];
    float ty = row[PIECE_TY];
    float height = side * (ox * ty - oy * tx);
    float sinks = -(side * (ux * ty - uy * tx));
    float deep = height - (reach - GRAZE * reach);
    if (!(sinks > 0.0f) || !(deep < sinks)) return NEVER_TOUCHES;
    float t = maxf((height - reach) / sinks, 0.0f);
    float along = (ox * tx + oy * ty) + t * (ux * tx + uy * ty);
    float length = row[PIECE_LENGTH];
    bool meets = (along >= 0.0f || startJoint(shape) == PIECE_CONCAVE) &&
                 (along <= length || endJoint(shape) == PIECE_CONCAVE) && goesOn(along, length, r);
    return meets ? t : NEVER_TOUCHES;
}

// When a point leaves a circle around 0, unless it gets no farther than a graze.
float timeFromInside(float ox, float oy, float ux, float uy, float radius, float graze) {
    float b = ox * ux + oy * uy;
    float a = ux * ux + uy * uy;
    float c = radius * radius - (ox * ox + oy * oy);
    if (!isLonger(ox + ux, oy + uy, radius + graze) || !(radius > 0.0f)) return NEVER_TOUCHES;
    // The root that loses no digits.
    if (b > 0.0f) return c > 0.0f ? c / (b + sqrt(b * b + a * c)) : 0.0f;
    // A chord, also of a point that starts a little outside; one that never comes in stops where it is nearest.
    return (sqrt(maxf(b * b + a * c, 0.0f)) - b) / a;
}

bool isInOpening(global const float *row, float x, float y) {
    return x * row[PIECE_TX] + y * row[PIECE_TY] >= row[PIECE_SPREAD] * lengthf(x, y);
}

// When a point comes, after a share of its motion, from beside an arc to the radius of its end e, in front of the arc.
float timeOfEnd(float ex, float ey, float ox, float oy, float ux, float uy, float after, float length) {
    float t = (ey * ox - ex * oy) / (ex * uy - ey * ux);
    if (!(t >= after && t < 1.0f)) return NEVER_TOUCHES;
    float x = ox + t * ux;
    float y = oy + t * uy;
    return x * ex + y * ey > 0.0f && !isLonger(x, y, length) ? t : NEVER_TOUCHES;
}

float timeOfArc(global const float *row, int shape, float ox, float oy, float ux, float uy, float r) {
    float length = row[PIECE_LENGTH];
    bool inner = (shape & PIECE_SOLID_OUTSIDE) != 0;
    float t = inner ? timeFromInside(ox, oy, ux, uy, length - r, GRAZE * r)
                    : timeOfImpact(-ox, -oy, ux, uy, length + r);
    if (!(t < 1.0f)) return NEVER_TOUCHES;
    if (isInOpening(row, ox + t * ux, oy + t * uy)) return t;
    if (!inner || !isInOpening(row, ox + ux, oy + uy)) return NEVER_TOUCHES;
    // It has left the whole circle beside the arc: along a line that is joined to the arc, say.
    float start = timeOfEnd(row[PIECE_START_X], row[PIECE_START_Y], ox, oy, ux, uy, t, length);
    float end = timeOfEnd(row[PIECE_END_X], row[PIECE_END_Y], ox, oy, ux, uy, t, length);
    return minf(end, start);
}

// As a share of a motion u; more than 1 if it does not touch, or gets no deeper than a graze.
float timeOfFace(global const float *row, int shape, float ox, float oy, float ux, float uy, float r, float side) {
    float reach = r + row[PIECE_THICKNESS];
    return formOf(shape) == PIECE_ARC ? timeOfArc(row, shape, ox, oy, ux, uy, r)
                                     : timeOfLine(row, shape, ox, oy, ux, uy, r, reach, side);
}

// Of an end that is not concave.
float timeOfVertex(global const float *row, int shape, bool start, float ox, float oy, float ux, float uy, float r) {
    if ((start ? startJoint(shape) : endJoint(shape)) == PIECE_CONCAVE) return NEVER_TOUCHES;
    float dx = row[start ? PIECE_START_X : PIECE_END_X] - ox;
    float dy = row[start ? PIECE_START_Y : PIECE_END_Y] - oy;
    return timeOfImpact(dx, dy, ux, uy, r + row[PIECE_THICKNESS]);
}
#endif
