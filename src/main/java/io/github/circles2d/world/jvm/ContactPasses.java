package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.jvm.ContactRow.BOUNCE_SPEED;
import static io.github.circles2d.world.jvm.ContactRow.FLIGHT_THRESHOLD;
import static io.github.circles2d.world.jvm.ContactRow.INV_MASS_A;
import static io.github.circles2d.world.jvm.ContactRow.INV_MASS_B;
import static io.github.circles2d.world.jvm.ContactRow.MASS;
import static io.github.circles2d.world.jvm.ContactRow.NORMAL_IMPULSE;
import static io.github.circles2d.world.jvm.ContactRow.NORMAL_X;
import static io.github.circles2d.world.jvm.ContactRow.NORMAL_Y;
import static io.github.circles2d.world.jvm.ContactRow.RADII;
import static io.github.circles2d.world.jvm.ContactRow.RESTITUTION;
import static io.github.circles2d.world.jvm.ContactRow.RESTITUTION_THRESHOLD;
import static io.github.circles2d.world.jvm.ContactRow.SEPARATION;
import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.BEFORE_Y;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_X;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_Y;
import static io.github.circles2d.world.model.CircleRow.LOADED;
import static io.github.circles2d.world.model.CircleRow.LOADED_NEXT;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.Branchless;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.StepConstants;

/**
 * The contacts' part of stage Solver: the passes over a range of contacts, one after the other. {@link Constraints} has the formulas.
 */
final class ContactPasses extends RelaxingPass {
    /** What is told of impulses that contacts do not keep; null if nothing is recorded. */
    Touches touches;

    ContactPasses(State state, Contacts contacts) {
        super(state, contacts);
    }

    /** Measures contacts for the first sub-step, and adds their impulses to the sums of their circles. */
    void prepare(int from, int to) {
        for (int c = from; c < to; c++) {
            prepareContact(c);
        }
    }

    private void prepareContact(int c) {
        measure(c);
        float[] q = contacts.contact;
        int o = ContactRow.of(c);
        int a = contacts.pair[ContactRow.a(c)];
        int b = contacts.pair[ContactRow.b(c)];
        float nx = q[o + NORMAL_X];
        float ny = q[o + NORMAL_Y];
        float impulse = q[o + NORMAL_IMPULSE];
        float vn = normalVelocity(state.motion, a, b, nx, ny);
        int carries = Constraints.carries(impulse, q[o + SEPARATION], vn, q[o + RESTITUTION_THRESHOLD]);
        warmStart(a, b, nx, ny, impulse, carries);
    }

    private static float normalVelocity(float[] motion, int a, int b, float nx, float ny) {
        return CircleMath.dot(nx, ny, motion[b + VX] - motion[a + VX], motion[b + VY] - motion[a + VY]);
    }

    /** Adds a contact's impulse to the sums of its circles, and marks them as loaded if it carries. */
    private void warmStart(int a, int b, float nx, float ny, float impulse, int carries) {
        float[] load = state.load;
        load[a + IMPULSE_X] -= nx * impulse;
        load[a + IMPULSE_Y] -= ny * impulse;
        load[b + IMPULSE_X] += nx * impulse;
        load[b + IMPULSE_Y] += ny * impulse;
        load[a + LOADED_NEXT] = Branchless.choose(carries, 1f, load[a + LOADED_NEXT]);
        load[b + LOADED_NEXT] = Branchless.choose(carries, 1f, load[b + LOADED_NEXT]);
    }

    /** The biased pass: stops approaches, pushes overlaps out, bounces. */
    void solve(int from, int to, StepConstants k) {
        int c = solveUntilFlight(from, to, -1, k);
        while (c < to) {
            c = solveFlying(c, k) ? solveUntilFlight(c + 1, to, -1, k) : solveUntilFlight(c, to, c, k);
        }
    }

    /**
     * The biased pass up to the first contact of circles that fly free of each other, which it returns. Few contacts of a pile do, and
     * in this loop they would slow down all others.
     *
     * @param asked a contact that is to be solved even if its circles fly
     */
    private int solveUntilFlight(int from, int to, int asked, StepConstants k) {
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
            float threshold = q[o + RESTITUTION_THRESHOLD];
            float pushSpeed = k.pushRate * q[o + RADII];
            float mass = q[o + MASS];
            float vn = normalVelocity(m, a, b, nx, ny);
            float bounce = 0f;
            // without restitution it stays so, and none flies: this only spares the reads
            if (restitution > 0f) {
                float loaded = load[a + LOADED] + load[b + LOADED];
                if (Constraints.flies(loaded, impulse, vn, q[o + FLIGHT_THRESHOLD]) != 0 && c != asked) {
                    return c;
                }
                float before = CircleMath.dot(
                        nx, ny, load[b + BEFORE_X] - load[a + BEFORE_X], load[b + BEFORE_Y] - load[a + BEFORE_Y]);
                bounce = Constraints.bounceSpeed(restitution, loaded, before, separation, k.h, threshold, pushSpeed);
            }
            q[o + BOUNCE_SPEED] = bounce;
            float next = Constraints.solve(
                    impulse,
                    mass,
                    vn,
                    separation,
                    bounce,
                    pushSpeed,
                    k.deepRate,
                    k.inverseH,
                    k.biasRate,
                    k.massScale,
                    k.impulseScale);
            q[o + NORMAL_IMPULSE] = next;
            apply(a, b, nx, ny, q[o + INV_MASS_A], q[o + INV_MASS_B], next - impulse);
        }
        return to;
    }

    /** Visits a contact of circles that fly free of each other with bias; returns false if it is to be solved as others are. */
    private boolean solveFlying(int c, StepConstants k) {
        float[] q = contacts.contact;
        float[] load = state.load;
        int o = ContactRow.of(c);
        int a = contacts.pair[ContactRow.a(c)];
        int b = contacts.pair[ContactRow.b(c)];
        float separation = q[o + SEPARATION];
        float beforeX = load[b + BEFORE_X] - load[a + BEFORE_X];
        float beforeY = load[b + BEFORE_Y] - load[a + BEFORE_Y];
        int lingers = Constraints.lingers(separation, beforeX * beforeX + beforeY * beforeY);
        float nx = q[o + NORMAL_X];
        float ny = q[o + NORMAL_Y];
        float vn = normalVelocity(state.motion, a, b, nx, ny);
        int meets = Constraints.meets(separation, vn, k.inverseH);
        q[o + BOUNCE_SPEED] = 0f;
        return fly(c, vn, lingers, meets, contacts.halfFall(c, q[o + INV_MASS_A], q[o + INV_MASS_B], k));
    }

    /** Leaves a contact of circles that fly free of each other alone, or lets them bounce; returns false if it is to be solved. */
    private boolean fly(int c, float vn, int lingers, int meets, float halfFall) {
        float[] q = contacts.contact;
        int o = ContactRow.of(c);
        float restitution = q[o + RESTITUTION];
        int visit = Constraints.visitOf(restitution, 0f, lingers, 0f, vn, meets, q[o + FLIGHT_THRESHOLD]);
        if (visit == Constraints.BOUNCE) {
            float impulse = Bounce.freeBounce(restitution, vn - halfFall, q[o + MASS]);
            int a = contacts.pair[ContactRow.a(c)];
            int b = contacts.pair[ContactRow.b(c)];
            apply(a, b, q[o + NORMAL_X], q[o + NORMAL_Y], q[o + INV_MASS_A], q[o + INV_MASS_B], impulse);
            if (touches != null) {
                touches.add(c, impulse);
            }
        }
        return visit != Constraints.SOLVE;
    }

    private void apply(int a, int b, float nx, float ny, float invMassA, float invMassB, float impulse) {
        float[] m = state.motion;
        m[a + VX] -= nx * (invMassA * impulse);
        m[a + VY] -= ny * (invMassA * impulse);
        m[b + VX] += nx * (invMassB * impulse);
        m[b + VY] += ny * (invMassB * impulse);
    }

    @Override
    int relaxOpen(int open, StepConstants k) {
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        float[] m = state.motion;
        float[] load = state.load;
        int carrying = 0;
        for (int n = 0; n < open; n++) {
            int c = listed[n];
            int o = ContactRow.of(c);
            int a = pair[ContactRow.a(c)];
            int b = pair[ContactRow.b(c)];
            float separation = q[o + SEPARATION];
            float bounce = q[o + BOUNCE_SPEED];
            float impulse = q[o + NORMAL_IMPULSE];
            float nx = q[o + NORMAL_X];
            float ny = q[o + NORMAL_Y];
            float restitution = q[o + RESTITUTION];
            float threshold = q[o + RESTITUTION_THRESHOLD];
            float invMassA = q[o + INV_MASS_A];
            float invMassB = q[o + INV_MASS_B];
            float mass = q[o + MASS];
            float vn = normalVelocity(m, a, b, nx, ny);
            if (restitution > 0f && impulse == 0f) {
                float loaded = load[a + LOADED] + load[b + LOADED];
                if (Constraints.flies(loaded, impulse, vn, q[o + FLIGHT_THRESHOLD]) != 0
                        && fly(c, vn, 0, Constraints.ALWAYS, 0f)) {
                    continue;
                }
            }
            float next = Constraints.relax(impulse, mass, vn, separation, bounce, k.inverseH);
            float applied = next - impulse;
            apply(a, b, nx, ny, invMassA, invMassB, applied);
            if (bounce > 0f) {
                next = 0f;
                if (touches != null) {
                    touches.add(c, impulse + applied);
                }
            }
            q[o + NORMAL_IMPULSE] = next;
            float after = vn + applied * (invMassA + invMassB);
            listed[carrying] = c;
            carrying -= Constraints.carries(next, separation, after, threshold);
        }
        return carrying;
    }

    @Override
    void warmStart(int carrying) {
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        for (int n = 0; n < carrying; n++) {
            int c = listed[n];
            int o = ContactRow.of(c);
            float impulse = q[o + NORMAL_IMPULSE];
            warmStart(pair[ContactRow.a(c)], pair[ContactRow.b(c)], q[o + NORMAL_X], q[o + NORMAL_Y], impulse, -1);
        }
    }

    @Override
    void store(int c, float normalImpulse) {
        contacts.storeImpulse(c, normalImpulse);
    }
}
