package io.github.circles2d.world.jvm;

import io.github.circles2d.world.bodies.RigidStep;

/** What the contacts of rigid bodies, as a step has found them, do to circles that sleep: how they press them, and how fast bodies come. */
final class WakingByBodies {
    private final RigidContacts contacts;
    private final RigidPairs pairs;
    private final RigidThings things;
    private final RigidVisits visits;

    WakingByBodies(RigidContacts contacts, RigidPairs pairs, RigidVisits visits) {
        this.contacts = contacts;
        this.pairs = pairs;
        this.visits = visits;
        things = pairs.things;
    }

    /** The number of contacts; those with circles come last. */
    int count() {
        return contacts.count;
    }

    /** Where contacts with circles begin. */
    int first() {
        int p = contacts.pairCount;
        while (p > 0 && things.type[pairs.b[contacts.pair[p - 1]]] == RigidStep.BODY_CIRCLE) {
            p--;
        }
        return contacts.firstOf[p];
    }

    private boolean isA(int c) {
        return things.type[contacts.a[c]] == RigidStep.BODY_CIRCLE;
    }

    private int body(int c) {
        return isA(c) ? contacts.b[c] : contacts.a[c];
    }

    /** The id of the circle of a contact. */
    int circle(int c) {
        return things.id[isA(c) ? contacts.a[c] : contacts.b[c]];
    }

    /** 1 if the normal goes towards the circle, else -1. */
    float side(int c) {
        return isA(c) ? 1f : -1f;
    }

    float nx(int c) {
        return contacts.nx[c];
    }

    float ny(int c) {
        return contacts.ny[c];
    }

    float gap(int c) {
        return contacts.gap[c];
    }

    float impulse(int c) {
        return contacts.impulse[c];
    }

    float grip(int c) {
        return contacts.grip[c];
    }

    /** How fast the body comes at the point. */
    float approach(int c) {
        int t = body(c);
        float armX = isA(c) ? contacts.bx[c] : contacts.ax[c];
        float armY = isA(c) ? contacts.by[c] : contacts.ay[c];
        float x = things.vx[t] - things.omega[t] * armY;
        float y = things.vy[t] + things.omega[t] * armX;
        return side(c) * (x * contacts.nx[c] + y * contacts.ny[c]);
    }

    /** One over the effective mass of the body alone. */
    float inverseMass(int c) {
        return isA(c) ? visits.massOfB(c) : visits.massOfA(c);
    }

    float restitution(int c) {
        return Math.max(things.restitution[contacts.a[c]], things.restitution[contacts.b[c]]);
    }
}
