// uses: world/stages/Touches.cl world/tiles/Tiles.cl
// Records what contacts do in a step, as Touches.cl does, if events are reported: each tile for its own contacts, by their numbers.
// Three arrays lie one behind the other, so that a pass touches no more memory than it needs:
// - of the sub-step, the approach speed, negative (also -0) if the surfaces did not touch in the biased pass; the impulse that the
//   contact does not keep;
// - of the step, the approach speed and the impulse;
// - where it touched, which is noted only if it is fast: normal x, y (0: not known yet), point x, y.

#ifdef RECORDING

global float2 *touchNow(const World *w) { return (global float2 *) w->recording.touch; }

global float2 *touchSoFar(const World *w) { return touchNow(w) + w->contactRoom; }

global float4 *touchPlace(const World *w) { return (global float4 *) (touchSoFar(w) + w->contactRoom); }

// Begins a step for a contact.
void clearTouch(const World *w, int number) {
    touchSoFar(w)[number] = (float2)(NO_TOUCH, 0.0f);
    touchPlace(w)[number] = (float4)(0.0f);
}

// Begins a step for the walls of a circle.
void clearWallTouch(const World *w, int slot) {
    if (!w->recording.walls) return;
    w->recording.wallTouch[2 * slot] = (float4)(NO_TOUCH, 0.0f, 0.0f, 0.0f);
    w->recording.wallTouch[2 * slot + 1] = (float4)(NO_TOUCH, 0.0f, 0.0f, 0.0f);
}

// Notes where a contact touches. motion: of the circles, as the pass has their displacements. Not inlined: few contacts are fast.
void placeTouch(const World *w, int number, global const float4 *motion, float nx, float ny, float separation) {
    uint lower = w->ordered[number].x;
    float4 c = w->circle[lower];
    float4 m = motion[lower];
    touchPlace(w)[number] =
        (float4)(nx, ny, touchPoint(c.x, m.x, nx, c.z, separation), touchPoint(c.y, m.y, ny, c.z, separation));
}

// Looks at a contact after its biased pass. before: normal speed before any impulse. The step's numbers follow in the relaxing pass,
// but if it is fast: then the normal is noted with them.
void noteSolved(const World *w, int number, float before, float nx, float ny, float separation, float radii,
                const Visited *visited) {
    float approach = approachSpeed(before);
    float notKept = visited->leaves || visited->solved ? 0.0f : visited->impulse;
    bool touching = visited->normalImpulse + notKept > 0.0f || separation <= 0.0f;
    touchNow(w)[number] = (float2)(touching ? approach : -approach, notKept);
    if (touching && isFastApproach(approach, w->k.dt, radii) && approach > touchSoFar(w)[number].x) {
        touchSoFar(w)[number].x = approach;
        placeTouch(w, number, w->motion, nx, ny, separation);
    }
}

// Looks at a contact after its relaxing pass. now, soFar: as noteSolved left them; normalImpulse, bounce: before the pass.
void noteRelaxed(const World *w, int number, float2 now, float2 soFar, float normalImpulse, float bounce, float nx, float ny,
                 float separation, float radii, const Visited *visited) {
    float approach = fabs(now.x);
    float bounced = bounce > 0.0f ? normalImpulse + visited->impulse : 0.0f;
    float notKept = visited->solved ? bounced : visited->leaves ? 0.0f : visited->impulse;
    float impulse = (now.y + notKept) + visited->normalImpulse;
    bool touched = as_int(now.x) >= 0;
    bool faster = (touched || impulse > 0.0f) && approach > soFar.x;
    touchSoFar(w)[number] = (float2)(faster ? approach : soFar.x, soFar.y + impulse);
    if (faster && !touched && isFastApproach(approach, w->k.dt, radii)) {
        placeTouch(w, number, w->solvedMotion, nx, ny, separation);
    }
}

// Records the contacts of a tile that are in touch after the step. Once all tiles have made it.
void recordTile(const World *w, int tile) {
    global int *record = recordOf(w, tile);
    global const int2 *placed = contactsOf(record);
    int contacts = record[RECORD_CIRCLES] > 0 ? record[RECORD_STARTS + record[RECORD_PARTS]] : 0;
    TILE_EACH(place, contacts) {
        int number = placed[place].x;
        if (number < 0) continue;
        int copy = record[RECORD_COPIES] + place;
        float4 n = w->contact[copy];
        float radii = w->shape[copy].x;
        float2 t = touchSoFar(w)[number];
        if (!staysInTouch(t.x, n.z, radii)) continue;
        float4 at = touchPlace(w)[number];
        uint2 pr = w->ordered[number];
        ulong ids = (ulong) (uint) w->id[pr.x] << 32 | (uint) w->id[pr.y];
        recordPair(w, w->recording.records, w->recording.room, ids, pr, n, radii, t.x, t.y, at.xy, at.zw);
    }
}

// Records the walls that circles are in touch with. first, step: which circles.
void recordWallsOfSlots(const World *w, int first, int step) {
    int circles = w->recording.walls ? w->circles : 0;
    for (int slot = first; slot < circles; slot += step) {
        recordWalls(w, w->recording.wallTouch, w->recording.records, w->recording.room, slot);
    }
}

// Index space: a work-group a tile.
TILE_KERNEL touches_recordTile(WORLD_PARAMETERS RECORDING_PARAMETERS) {
    World w = WORLD;
    RECORD_IN(w);
    if (refused(&w)) return;
    recordTile(&w, (int) get_group_id(0));
    recordWallsOfSlots(&w, (int) get_global_id(0), (int) get_global_size(0));
}
#endif
