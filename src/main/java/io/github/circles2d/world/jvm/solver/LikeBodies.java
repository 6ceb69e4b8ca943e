package io.github.circles2d.world.jvm.solver;

import static io.github.circles2d.world.jvm.solver.ContactRow.BOUNCE_SPEED;
import static io.github.circles2d.world.jvm.solver.ContactRow.FLIGHT_THRESHOLD;
import static io.github.circles2d.world.jvm.solver.ContactRow.INV_MASS_A;
import static io.github.circles2d.world.jvm.solver.ContactRow.INV_MASS_B;
import static io.github.circles2d.world.jvm.solver.ContactRow.MASS;
import static io.github.circles2d.world.jvm.solver.ContactRow.NORMAL_IMPULSE;
import static io.github.circles2d.world.jvm.solver.ContactRow.NORMAL_X;
import static io.github.circles2d.world.jvm.solver.ContactRow.NORMAL_Y;
import static io.github.circles2d.world.jvm.solver.ContactRow.RADII;
import static io.github.circles2d.world.jvm.solver.ContactRow.RESTITUTION;
import static io.github.circles2d.world.jvm.solver.ContactRow.RESTITUTION_THRESHOLD;
import static io.github.circles2d.world.jvm.solver.ContactRow.SEPARATION;
import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.BEFORE_Y;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_X;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_Y;
import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.LOADED;
import static io.github.circles2d.world.model.CircleRow.SPIN_IMPULSE;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.StepConstants;

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

    // ---- loops of passes: within a visit, velocities stay in local variables

    /** The biased pass, see {@link PairVisits#solve}. */
    int solveUntilFlight(int from, int to, int asked, StepConstants k) {
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        float[] m = state.motion;
        float[] load = state.load;
        for (int c = from; c < to; c++) {
            int o = ContactRow.of(c);
            int a = pair[ContactRow.a(c)];
            int b = pair[ContactRow.b(c)];
            float nx = q[o + NORMAL_X];
            float ny = q[o + NORMAL_Y];
            float separation = q[o + SEPARATION];
            float restitution = q[o + RESTITUTION];
            float impulse = q[o + NORMAL_IMPULSE];
            float pushSpeed = k.pushRate * q[o + RADII];
            float ax = m[a + VX];
            float ay = m[a + VY];
            float bx = m[b + VX];
            float by = m[b + VY];
            float vn = CircleMath.dot(nx, ny, bx - ax, by - ay);
            float bounce = 0f;
            // without restitution it stays so, and none flies: this only spares the reads
            if (restitution > 0f) {
                float loaded = load[a + LOADED] + load[b + LOADED];
                if (Constraints.flies(loaded, impulse, vn, q[o + FLIGHT_THRESHOLD]) != 0 && c != asked) {
                    return c;
                }
                float before = CircleMath.dot(
                        nx, ny, load[b + BEFORE_X] - load[a + BEFORE_X], load[b + BEFORE_Y] - load[a + BEFORE_Y]);
                float threshold = q[o + RESTITUTION_THRESHOLD];
                bounce = Constraints.bounceSpeed(restitution, loaded, before, separation, k.h, threshold, pushSpeed);
            }
            q[o + BOUNCE_SPEED] = bounce;
            float next =
                    Constraints.solve(impulse, q[o + MASS], vn, separation, bounce, pushSpeed, k.contactSoftness, k);
            q[o + NORMAL_IMPULSE] = next;
            float ofA = q[o + INV_MASS_A] * (next - impulse);
            float ofB = q[o + INV_MASS_B] * (next - impulse);
            m[a + VX] = ax - nx * ofA;
            m[a + VY] = ay - ny * ofA;
            m[b + VX] = bx + nx * ofB;
            m[b + VY] = by + ny * ofB;
        }
        return to;
    }
}
