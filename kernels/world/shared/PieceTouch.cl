// uses: world/shared/Piece.cl world/shared/TouchRule.cl
// Records what pieces of terrain do to circles. The Java class PieceTouches is the same; Touches.cl tells of it.
//
// By piece contact two float4, behind those of contacts: approach speed, impulse, normal x, y; point x, y, how fast the surfaces slid, how fast
// the piece came along the normal. Of a piece that senses: the centre as the step begins, in the place of the normal.

#if defined(TERRAIN) && defined(RECORDING)
global float4 *pieceTouch(const World *w, int k) { return w->recording.touch + 2 * ((size_t) w->contactRoom + k); }

void clearPieceTouch(const World *w, int k) {
    pieceTouch(w, k)[0] = (float4)(NO_TOUCH, 0.0f, 0.0f, 0.0f);
    pieceTouch(w, k)[1] = (float4)(0.0f);
}

// Half-way between the surfaces. d: displacement; g: as measured.
float2 placeOfTouch(float4 c, float2 d, float4 g) {
    return (float2)(touchPoint(c.x, d.x, -g.MEASURED_X, c.RADIUS, g.MEASURED_GAP),
                    touchPoint(c.y, d.y, -g.MEASURED_Y, c.RADIUS, g.MEASURED_GAP));
}

// A visit, before its effect. vn: normal speed of the approach; impulse: what it gives along the normal; slid: how fast surfaces slide;
// surface: velocity of the piece.
void notePieceVisit(const World *w, int k, float4 c, float2 d, float4 g, float vn, float impulse, float slid, float2 surface) {
    global float4 *t = pieceTouch(w, k);
    t[0].y += impulse;
    float approach = approachSpeed(vn);
    if ((impulse > 0.0f || g.MEASURED_GAP <= 0.0f) && approach > t[0].x) {
        float2 place = placeOfTouch(c, d, g);
        t[0].x = approach;
        t[0].zw = (float2)(g.MEASURED_X, g.MEASURED_Y);
        t[1] = (float4)(place.x, place.y, slid, g.MEASURED_X * surface.x + g.MEASURED_Y * surface.y);
    }
}

// As the step begins.
void noteSensedStart(const World *w, int k) {
    if (w->piece[k].TOUCHED_RESPONSE == PAIR_SENSE) pieceTouch(w, k)[0].zw = w->standing[k].STANDING_PLACE;
}
#endif
