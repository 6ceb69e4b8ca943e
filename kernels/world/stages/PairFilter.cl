// uses: world/stages/World.cl
// Whether two circles that are near may meet. All that finds pairs asks it. The Java class PairFilter is the same.

// Whether two circles are of one group and so ignore each other.
bool areOfOneGroup(CircleFields a, CircleFields b) {
    return a.group != 0 && a.group == b.group;
}

int responseOfKinds(const World *w, int a, int b) { return (w->responses[a << 4 | b >> 4] >> 2 * (b & 15)) & 3; }

// Of one group: nothing; else as their kinds say.
int responseOf(const World *w, int id, int otherId) {
    CircleFields a = w->fields[id];
    CircleFields b = w->fields[otherId];
    if (areOfOneGroup(a, b)) return PAIR_IGNORE;
    return responseOfKinds(w, a.kind, b.kind);
}

#ifdef JOINTS
// Whether a joint that has not broken keeps two circles from colliding.
bool areParted(const World *w, int id, int otherId) {
    global const JointHead *j = w->joints;
    if (id >= j->partnered || otherId >= j->partnered) return false;
    global const int *tables = (global const int *) j;
    global const int *starts = tables + j->partnerStarts + id;
    global const int2 *partners = (global const int2 *) (tables + j->partners);
    for (int k = starts[0]; k < starts[1]; k++) {
        if (partners[k].x != otherId) continue;
        int joint = partners[k].y;
        const int4 traits[2] = {((global const int4 *) (tables + j->traits))[2 * joint], ((global const int4 *) (tables + j->traits))[2 * joint + 1]};
        if ((tables + j->serial)[joint] != ~HOLD_SERIAL) return true;
    }
    return false;
}
#endif

// Of two static circles neither moves.
bool mayMeet(const World *w, int slot, float invMassA, int other, float invMassB) {
    if (invMassA == 0.0f && invMassB == 0.0f) return false;
    IF_JOINTS(if (areParted(w, w->id[slot], w->id[other])) return false;)
    // Sensing.cl finds pairs that are only sensed.
    return w->k.filtering == 0 || responseOf(w, w->id[slot], w->id[other]) == PAIR_SOLID;
}
