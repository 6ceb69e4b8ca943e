// uses: world/stages/Touches.cl world/stages/CrossSolver.cl world/tiles/Tiles.cl
// Records contacts as Touches.cl does: each tile its own, by their numbers. Three arrays, so that a pass touches little memory:
// - of the sub-step: approach speed, negative (also -0) if the surfaces did not touch in the biased pass; impulse that is not kept;
// - of the step: approach speed, impulse;
// - where it touched, if it is fast: normal x, y (0: not known yet), point x, y.
// How fast surfaces slide lies behind all, as in Touches.cl.

#ifdef RECORDING
// Cross contacts lie behind all three, as Touches.cl has them.
#define SET_TOUCH_NUMBERS_OF_ONE_LEVEL(w) (w).recording.numbers = (w).contactRoom
#define SET_TOUCH_NUMBERS(w) (w).recording.numbers = hasOneLevel(&(w)) ? (w).contactRoom : likeContacts(&(w))

global float2 *touchNow(const World *w) { return (global float2 *) w->recording.touch; }
global float2 *touchSoFar(const World *w) { return touchNow(w) + w->recording.numbers; }
global float4 *touchPlace(const World *w) { return (global float4 *) (touchSoFar(w) + w->recording.numbers); }

void clearTouch(const World *w, int number) {
    touchSoFar(w)[number] = (float2)(NO_TOUCH, 0.0f);
    touchPlace(w)[number] = (float4)(0.0f);
    clearSlip(w, number);
}

// Of walls and pieces of terrain.
void clearWallTouch(const World *w, int slot) {
    IF_TERRAIN(beginPieceTouches(w, slot);)
    if (!w->recording.walls) return;
    w->recording.wallTouch[2 * slot] = (float4)(NO_TOUCH, 0.0f, 0.0f, 0.0f);
    w->recording.wallTouch[2 * slot + 1] = (float4)(NO_TOUCH, 0.0f, 0.0f, 0.0f);
}

// motion: as the pass has displacements.
void placeTouch(const World *w, int number, global const float4 *motion, float nx, float ny, float separation) {
    uint lower = w->ordered[number].x;
    float4 c = w->circle[lower];
    float4 m = motion[lower];
    touchPlace(w)[number] =
        (float4)(nx, ny, touchPoint(c.x, m.x, nx, c.z, separation), touchPoint(c.y, m.y, ny, c.z, separation));
}

// before: normal speed before any impulse; slid: how fast surfaces slide then. The step's numbers follow in the relaxing pass, but those of
// a fast contact, with its normal.
void noteSolved(const World *w, int number, float before, float nx, float ny, float separation, float radii,
                const Visited *visited AND_TURNING(float slid)) {
    float approach = approachSpeed(before);
    float notKept = visited->leaves || visited->solved ? 0.0f : visited->impulse;
    bool touching = visited->normalImpulse + notKept > 0.0f || separation <= 0.0f;
    touchNow(w)[number] = (float2)(touching ? approach : -approach, notKept);
    IF_TURNING(touchSlips(w)[number].x = slid;)
    if (touching && isFastApproach(approach, w->k.dt, radii) && approach > touchSoFar(w)[number].x) {
        touchSoFar(w)[number].x = approach;
        IF_TURNING(touchSlips(w)[number].y = slid;)
        placeTouch(w, number, w->motion, nx, ny, separation);
    }
}

// now, soFar: as noteSolved left them; normalImpulse, bounce: before the pass.
void noteRelaxed(const World *w, int number, float2 now, float2 soFar, float normalImpulse, float bounce, float nx, float ny,
                 float separation, float radii, const Visited *visited) {
    float approach = fabs(now.x);
    float bounced = bounce > 0.0f ? normalImpulse + visited->impulse : 0.0f;
    float notKept = visited->solved ? bounced : visited->leaves ? 0.0f : visited->impulse;
    float impulse = (now.y + notKept) + visited->normalImpulse;
    bool touched = as_int(now.x) >= 0;
    bool faster = (touched || impulse > 0.0f) && approach > soFar.x;
    touchSoFar(w)[number] = (float2)(faster ? approach : soFar.x, soFar.y + impulse);
    IF_TURNING(if (faster) touchSlips(w)[number].y = touchSlips(w)[number].x;)
    if (faster && !touched && isFastApproach(approach, w->k.dt, radii)) {
        placeTouch(w, number, sharesPasses(w) ? w->motion : w->solvedMotion, nx, ny, separation);
    }
}

// Once all tiles have made the step.
void tellOfTile(const World *w, int tile) {
    global int *record = recordOf(w, tile);
    int contacts = record[TILE_AT_CIRCLES] > 0 ? record[TILE_AT_STARTS + record[TILE_AT_PARTS]] : 0;
    int firstCopy = contacts > 0 ? record[TILE_AT_COPIES] : 0;
    global const int2 *placed = placedFrom(w, firstCopy);
    TILE_EACH(place, contacts) {
        int number = placed[place].x;
        if (number < 0) continue;
        int copy = firstCopy + place;
        float2 t = touchSoFar(w)[number];
        float4 at = touchPlace(w)[number];
        tellOfPair(w, w->ordered[number], w->contact[copy], w->shape[copy].x, t.x, t.y, at.xy, at.zw, slipOf(w, number));
    }
}

void tellOfCrossContacts(const World *w, int first, int each) {
    if (hasOneLevel(w)) return;
    World cross = crossWorld(*w);
    tellOfContacts(&cross, likeContacts(w) + first, each);
}

// Index space: a work-group a tile.
TILE_KERNEL touches_tellByTile(WORLD_PARAMETERS RECORDING_PARAMETERS REPORTING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    REPORT_IN(w);
    if (!isMade(&w)) return;
    SET_TOUCH_NUMBERS(w);
    tellOfTile(&w, (int) get_group_id(0));
    tellOfCrossContacts(&w, (int) get_global_id(0), (int) get_global_size(0));
    tellOfWalls(&w, (int) get_global_id(0), (int) get_global_size(0));
}
#else
#define SET_TOUCH_NUMBERS_OF_ONE_LEVEL(w)
#define SET_TOUCH_NUMBERS(w)
#endif
