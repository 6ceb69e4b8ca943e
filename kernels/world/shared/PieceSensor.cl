// uses: world/shared/PieceSweep.cl
// When a circle that moves evenly touches a piece of terrain that only senses it. The Java class PieceSensor documents these formulas.

#if defined(TERRAIN) && defined(RECORDING)
float timeAtLine(global const float *row, float ox, float oy, float ux, float uy, float reach) {
    float tx = row[PIECE_TX];
    float ty = row[PIECE_TY];
    float height = ox * ty - oy * tx;
    float side = height >= 0.0f ? 1.0f : -1.0f;
    float sinks = -(side * (ux * ty - uy * tx));
    float gap = side * height - reach;
    if (!(sinks > 0.0f) || !(gap > 0.0f)) return NEVER_TOUCHES; // beyond an end, perhaps
    float t = gap / sinks;
    float along = (ox * tx + oy * ty) + t * (ux * tx + uy * ty);
    return along >= 0.0f && along <= row[PIECE_LENGTH] ? t : NEVER_TOUCHES;
}

// When a point leaves a circle around 0, perhaps after it has come into it.
float timeOfLeaving(float ox, float oy, float ux, float uy, float radius) {
    float a = ux * ux + uy * uy;
    float b = ox * ux + oy * uy;
    float c = radius * radius - (ox * ox + oy * oy);
    float disc = b * b + a * c;
    if (!(radius > 0.0f) || !(disc >= 0.0f) || !(a > 0.0f) || (!(c > 0.0f) && !(b < 0.0f))) return NEVER_TOUCHES;
    // The root that loses no digits.
    float root = sqrt(disc);
    return b > 0.0f ? c / (b + root) : (root - b) / a;
}

// On its outer side from outside, or on its inner side from within.
float timeAtArc(global const float *row, float ox, float oy, float ux, float uy, float r) {
    float length = row[PIECE_LENGTH];
    bool outside = isLonger(ox, oy, length + r);
    float outer = outside ? timeOfTouch(-ox, -oy, ux, uy, length + r) : NEVER_TOUCHES;
    float inner = timeOfLeaving(ox, oy, ux, uy, length - r);
    float t = isInOpening(row, ox + outer * ux, oy + outer * uy) ? outer : NEVER_TOUCHES;
    return inner < t && isInOpening(row, ox + inner * ux, oy + inner * uy) ? inner : t;
}

// As a share of a motion u; more than 1 if it does not touch.
float timeOfSensing(global const float *row, int shape, float ox, float oy, float ux, float uy, float r) {
    if (distanceOfPiece(row, shape, ox, oy) <= r) return 0.0f;
    float reach = r + row[PIECE_THICKNESS];
    bool isArc = formOf(shape) == PIECE_ARC;
    float t = isArc ? timeAtArc(row, ox, oy, ux, uy, r) : timeAtLine(row, ox, oy, ux, uy, reach);
    if (isArc && row[PIECE_SPREAD] == PIECE_ALL_AROUND) return t;
    float atStart = timeOfTouch(row[PIECE_START_X] - ox, row[PIECE_START_Y] - oy, ux, uy, reach);
    float atEnd = timeOfTouch(row[PIECE_END_X] - ox, row[PIECE_END_Y] - oy, ux, uy, reach);
    return minf(minf(atStart, atEnd), t);
}

// Of a circle that comes from behind a piece with a front: right through a bowl it comes to the front within its motion.
float timeOfReturn(global const float *row, int shape, float ox, float oy, float ux, float uy, float r) {
    if (formOf(shape) != PIECE_ARC || (shape & PIECE_SOLID_OUTSIDE) == 0) return NEVER_TOUCHES;
    float t = timeOfLeaving(ox, oy, ux, uy, row[PIECE_LENGTH] - r);
    return isInOpening(row, ox + t * ux, oy + t * uy) ? t : NEVER_TOUCHES;
}
#endif
