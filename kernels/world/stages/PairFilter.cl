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

// Of two static circles neither moves.
bool mayMeet(const World *w, int slot, float invMassA, int other, float invMassB) {
    if (invMassA == 0.0f && invMassB == 0.0f) return false;
    // Sensing.cl finds pairs that are only sensed.
    return w->k.filtering == 0 || responseOf(w, w->id[slot], w->id[other]) == PAIR_SOLID;
}
