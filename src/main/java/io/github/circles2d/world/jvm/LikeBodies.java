package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.jvm.ContactRow.INV_MASS_A;
import static io.github.circles2d.world.jvm.ContactRow.INV_MASS_B;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_X;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_Y;
import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.SPIN_IMPULSE;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.model.CircleMath;

/** The circles of contacts of one level: no other worker has a circle of theirs, so each visit sees what those before it did. */
final class LikeBodies {
    private final State state;
    private final Contacts contacts;

    LikeBodies(State state, Contacts contacts) {
        this.state = state;
        this.contacts = contacts;
    }

    /** The normal speed of B relative to A. */
    float normalSpeed(int a, int b, float nx, float ny) {
        float[] m = state.motion;
        return CircleMath.dot(nx, ny, m[b + VX] - m[a + VX], m[b + VY] - m[a + VY]);
    }

    /** Takes an impulse from A and gives it to B. */
    void apply(int c, int a, int b, float nx, float ny, float impulse) {
        float[] m = state.motion;
        float[] q = contacts.contact;
        int o = ContactRow.of(c);
        float invMassA = q[o + INV_MASS_A];
        float invMassB = q[o + INV_MASS_B];
        m[a + VX] -= nx * (invMassA * impulse);
        m[a + VY] -= ny * (invMassA * impulse);
        m[b + VX] += nx * (invMassB * impulse);
        m[b + VY] += ny * (invMassB * impulse);
    }

    float surfaceSpeed(int row) {
        return state.turning.spin[row + SURFACE_SPEED];
    }

    /** Gives impulses to the surface speeds of A and B. */
    void turn(int a, int b, float ofA, float ofB) {
        float[] spin = state.turning.spin;
        spin[a + SURFACE_SPEED] += spin[a + INVERSE_INERTIA] * ofA;
        spin[b + SURFACE_SPEED] += spin[b + INVERSE_INERTIA] * ofB;
    }

    /** Adds impulses on surface speeds to the sums for the next sub-step. */
    void addToSpinSums(int a, int b, float ofA, float ofB) {
        float[] spin = state.turning.spin;
        spin[a + SPIN_IMPULSE] += ofA;
        spin[b + SPIN_IMPULSE] += ofB;
    }

    /** Takes an impulse from A's sum for the next sub-step and adds it to B's. */
    void addToSums(int a, int b, float x, float y) {
        float[] load = state.load;
        load[a + IMPULSE_X] -= x;
        load[a + IMPULSE_Y] -= y;
        load[b + IMPULSE_X] += x;
        load[b + IMPULSE_Y] += y;
    }
}
