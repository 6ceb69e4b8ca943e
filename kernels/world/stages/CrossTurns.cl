// uses: world/shared/CrossRule.cl world/stages/World.cl
// Nearly elastic circles in free flight bounce off the same heavy one in turn: the Java class CrossRule says why.

// In the biased pass a light circle asks for a turn; in the relaxing pass it has one if none of a higher id asked, and nobody asked to
// bounce off itself. separation: in the biased pass, where it leads to.
bool waitsForTurn(const World *w, uint light, uint heavy, float restitution, float inverseMassOfHeavy, float separation, bool relaxing) {
    if (!mayWait(restitution, inverseMassOfHeavy, separation, w->circle[light].RADIUS, w->circle[heavy].RADIUS)) return false;
    int asked = w->id[light] + 1;
    if (relaxing) return w->claim[heavy] != asked || w->claim[light] != 0;
    atomic_max(&w->claim[heavy], asked);
    return true;
}
