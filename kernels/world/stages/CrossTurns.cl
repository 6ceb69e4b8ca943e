// uses: world/shared/Cross.cl world/stages/World.cl
// Nearly elastic circles in free flight that meet the same heavy circle bounce off it one after the other; the Java class CrossRule says why.

// Whether a light circle that is to bounce off a heavy one waits for its turn. In the biased pass it asks for one; in the relaxing pass it
// has one if none of a higher id has asked, and nobody asked to bounce off itself. separation: where the biased pass leads to, if relaxing
// is false. inverseMassOfHeavy: 0 if it is static.
bool waitsForTurn(const World *w, uint light, uint heavy, float restitution, float inverseMassOfHeavy, float separation,
                  bool relaxing) {
    if (!mayWait(restitution, inverseMassOfHeavy, separation, w->circle[light].RADIUS, w->circle[heavy].RADIUS)) return false;
    int asked = w->id[light] + 1;
    if (relaxing) return w->claim[heavy] != asked || w->claim[light] != 0;
    atomic_max(&w->claim[heavy], asked);
    return true;
}
