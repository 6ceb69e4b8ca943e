// uses: world/shared/Visit.cl world/stages/Neighbours.cl world/shared/PairRows.cl
// Stage Contacts by colours: orders the contacts of a group, measures them, and starts them warm.

// g: see loadAlong.
void gatherLoad(const World *w, uint2 p, float2 g, bool carrying) {
    float4 la = w->load[p.LOWER];
    float4 lb = w->load[p.HIGHER];
    la.IMPULSES -= g;
    lb.IMPULSES += g;
    if (carrying) la.LOADED_NEXT = lb.LOADED_NEXT = 1.0f;
    w->load[p.LOWER] = la;
    w->load[p.HIGHER] = lb;
}

#ifdef TURNING
// Adds the impulses of rows to the sums of impulses on surface speeds.
void gatherSpin(const World *w, int c, uint2 p) {
    PairSurface s = surfaceAt(w, c);
    if (!rowsAct(&s)) return;
    float2 of = spinImpulses(w, p, &s, w->rowImpulses[c]);
    w->spinImpulse[p.LOWER] += of.x;
    w->spinImpulse[p.HIGHER] += of.y;
}
#endif

// Measures a contact, whose rows are filled, for the first sub-step; returns it.
float4 fillContact(const World *w, int c, bool *carrying) {
    uint2 p = w->pair[c];
    float4 b = baseOfPair(w, p);
    float4 n = newContact(w, p, w->key[c], b, rowsAt(w, c), carrying);
    float invMassA = w->traits[p.LOWER].INVERSE_MASS;
    float invMassB = w->traits[p.HIGHER].INVERSE_MASS;
    float mass = massOfPair(w, p, invMassA, invMassB);
    w->base[c] = b;
    w->masses[c] = (float4)(invMassA, invMassB, mass, 0.0f);
    w->contact[c] = n;
    return n;
}

// Nobody else has the same circles now. Returns the greater count, with contacts found in coarser levels.
float countCandidate(const World *w, uint2 p) {
    float lo = w->load[p.LOWER].CANDIDATES += 1.0f;
    float hi = w->load[p.HIGHER].CANDIDATES += 1.0f;
    return hasOneLevel(w) ? maxf(lo, hi) : maxf(lo + (float) w->coarser[p.LOWER], hi + (float) w->coarser[p.HIGHER]);
}

// Index space: a group of the colour. Cost: its contacts.
kernel void contacts_fill(WORLD_PARAMETERS, int colour) {
    World w = WORLD;
    int2 contacts = outOfRoom(&w) || tooFast(&w) ? (int2)(0) : contactsOfItem(&w, colour);
    if (contacts.x == contacts.y) return;
    sortContacts(w.key + contacts.x, w.pair + contacts.x, contacts.y - contacts.x);
    float most = 0.0f;
    for (int c = contacts.x; c < contacts.y; c++) {
#ifdef TURNING
        uint2 p = w.pair[c];
        fillRows(&w, c, p, (int) w.key[c], p.LOWER, p.HIGHER, 1.0f);
        gatherSpin(&w, c, w.pair[c]);
#endif
        bool carrying;
        float4 n = fillContact(&w, c, &carrying);
        gatherLoad(&w, w.pair[c], loadOf(&w, c, n.NORMAL, n.NORMAL_IMPULSE), carrying);
        if (w.k.thinning == 0) most = maxf(most, countCandidate(&w, w.pair[c]));
    }
    if (most > (float) CROWD) status[CROWDED] = 1;
}

// How many each circle had in the last step. Index space: a contact.
kernel void contacts_degrees(global const uint2 *pair, int contacts, global int *degree) {
    int c = (int) get_global_id(0);
    if (c >= contacts) return;
    atomic_inc(&degree[pair[c].LOWER]);
    atomic_inc(&degree[pair[c].HIGHER]);
}
