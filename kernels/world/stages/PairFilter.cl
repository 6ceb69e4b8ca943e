// uses: world/stages/World.cl
// The rule that decides, of two circles that are near, whether they may meet: whether they become a contact, and whether
// continuous collision looks at them. All that finds pairs asks it. The Java class PairFilter is the same.

// Whether two circles are of one group and so ignore each other.
bool areOfOneGroup(CircleFields a, CircleFields b) {
    return a.group != 0 && a.group == b.group;
}

// What two circles do to each other: those of one group nothing, others what their kinds say.
int responseOf(const World *w, int id, int otherId) {
    CircleFields a = w->fields[id];
    CircleFields b = w->fields[otherId];
    if (areOfOneGroup(a, b)) return PAIR_IGNORE;
    return (w->responses[a.kind << 4 | b.kind >> 4] >> 2 * (b.kind & 15)) & 3;
}

// Whether the circles of two working slots may meet: of two static ones neither moves, and kinds and groups may keep others apart.
// The caller has their inverse masses.
bool mayMeet(const World *w, int slot, float invMassA, int other, float invMassB) {
    if (invMassA == 0.0f && invMassB == 0.0f) return false;
    // Pairs that are only sensed end here, too: Sensing.cl finds them.
    return w->k.filtering == 0 || responseOf(w, w->id[slot], w->id[other]) == PAIR_SOLID;
}
