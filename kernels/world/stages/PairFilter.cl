// uses: world/stages/World.cl
// The rule that decides, of two circles that are near, whether they may meet: whether they become a contact, and whether
// continuous collision looks at them. All that finds pairs asks it. The Java class PairFilter is the same.

// Whether the circles of two working slots may meet: of two static ones neither moves. The caller has their inverse masses.
bool mayMeet(const World *w, int slot, float invMassA, int other, float invMassB) {
    return invMassA != 0.0f || invMassB != 0.0f;
}
