// uses: world/shared/DeviceBarrier.cl world/stages/Scan.cl world/tiles/TileTouches.cl
// The phases of Events.cl in one launch: seven would take the host longer than they take the device.

#ifdef RECORDING
// Phase 4. Leaves eventTally all zeros. sums: by work-group, each of a part of the ids.
void startsOfEvents(const World *w, global int *sums, local int *cells) {
    const Reporting *r = &w->reporting;
    int count = r->ids + 1;
    int groups = (int) get_num_groups(0);
    int group = (int) get_group_id(0);
    int item = (int) get_local_id(0);
    int each = (count + groups - 1) / groups;
    int from = group * each;
    int to = min(from + each, count);
    int part = 0;
    for (int i = from + item; i < to; i += EVENT_GROUP) part += r->eventTally[i];
    int before, total;
    scanGroup(part, cells, &total);
    if (item == 0) sums[group] = total;
    deviceBarrier(w->status + ARRIVALS);
    part = 0;
    for (int i = item; i < group; i += EVENT_GROUP) part += sums[i];
    scanGroup(part, cells, &before);
    for (int first = from; first < to; first += EVENT_GROUP) {
        int i = first + item;
        int sum = scanGroup(i < to ? r->eventTally[i] : 0, cells, &total);
        if (i < to) {
            r->eventStart[i] = before + sum;
            r->eventTally[i] = 0;
        }
        before += total;
    }
}

// Index space: no more work-groups than run at once.
kernel __attribute__((reqd_work_group_size(EVENT_GROUP, 1, 1))) void events_decideByTile(
    WORLD_PARAMETERS RECORDING_PARAMETERS REPORTING_PARAMETERS, global int *sums) {
    World w = WORLD;
    RECORD_IN(w);
    REPORT_IN(w);
    local int cells[2 * EVENT_GROUP];
    volatile global int *arrivals = status + ARRIVALS;
    int first = (int) get_global_id(0);
    int each = (int) get_global_size(0);
    int groups = (int) get_num_groups(0);
    // The same for all work-groups: nobody writes it before the first barrier.
    if (!isMade(&w)) return;
    SET_TOUCH_NUMBERS(w);
    if (first == 0) startEvents(&w);
    deviceBarrier(arrivals);
    int tiles = levels->tileCount;
    for (int tile = (int) get_group_id(0); tile < tiles; tile += groups) tellOfTile(&w, tile);
    tellOfCrossContacts(&w, first, each);
    tellOfWalls(&w, first, each);
    deviceBarrier(arrivals);
    for (int place = first; place <= w.reporting.mask; place += each) tellOfEnds(&w, place);
    deviceBarrier(arrivals);
    startsOfEvents(&w, sums, cells);
    deviceBarrier(arrivals);
    if (lacksEventRoom(&w)) {
        if (first == 0) noteLackOfEventRoom(&w);
    } else {
        settleEvents(&w, first, each);
        deviceBarrier(arrivals);
        int drafts = status[DRAFTS];
        for (int k = first; k < drafts; k += each) writeEvent(&w, k);
        if (first == 0) writeHeader(&w);
    }
    leave(&w);
}
#endif
