package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.Velocity;

/**
 * Visits of pairs whose contacts neither bounce nor resist rolling, while {@link RigidVisits#areFixed}. The velocities of both things are in local
 * variables as long as a pair is visited, those of A and B of its first contact; contacts the other way round have their terms swapped, which
 * changes no bit then. Each pass has a loop: one for both took two percent more of a pyramid's step.
 */
final class RigidPairVisits {
    /** Floats from the arm of A to that of B. */
    private static final int SWAP = RigidRow.BX - RigidRow.AX;

    private final RigidContacts contacts;
    private final RigidThings things;
    private final RigidRules rules;

    RigidPairVisits(RigidContacts contacts, RigidThings things, RigidRules rules) {
        this.contacts = contacts;
        this.things = things;
        this.rules = rules;
    }

    /** Whether no contact of a pair resists rolling. */
    boolean has(int begin, int end) {
        boolean plain = true;
        for (int c = begin; c < end; c++) {
            plain &= !(things.rolling[contacts.a[c]] > 0f || things.rolling[contacts.b[c]] > 0f);
        }
        return plain;
    }

    /** Visits the contacts of a pair that neither bounces nor is hit. */
    void solve(int begin, int end) {
        float[] rows = contacts.rows;
        int a = contacts.a[begin];
        int b = contacts.b[begin];
        float ax = things.vx[a];
        float ay = things.vy[a];
        float aSpin = things.omega[a];
        float bx = things.vx[b];
        float by = things.vy[b];
        float bSpin = things.omega[b];
        float aw = things.w[a];
        float ai = things.i[a];
        float bw = things.w[b];
        float bi = things.i[b];
        for (int c = begin; c < end; c++) {
            int row = RigidRow.of(c);
            int swap = contacts.a[c] == a ? 0 : SWAP;
            float side = swap == 0 ? 1f : -1f;
            float nx = side * rows[row + RigidRow.NX];
            float ny = side * rows[row + RigidRow.NY];
            float armX = rows[row + RigidRow.AX + swap];
            float armY = rows[row + RigidRow.AY + swap];
            float itsX = rows[row + RigidRow.BX - swap];
            float itsY = rows[row + RigidRow.BY - swap];
            float vn =
                    ((ax - aSpin * armY) - (bx - bSpin * itsY)) * nx + ((ay + aSpin * armX) - (by + bSpin * itsX)) * ny;
            float gain = rules.solvedNormal(row, vn);
            float x = nx * gain;
            float y = ny * gain;
            ax += aw * x;
            ay += aw * y;
            aSpin += ai * (armX * y - armY * x);
            bx += bw * -x;
            by += bw * -y;
            bSpin += bi * (itsX * -y - itsY * -x);
            if (mayBeFast(ax, ay, aSpin, bx, by, bSpin)) {
                ax = Velocity.limitSpeed(ax);
                ay = Velocity.limitSpeed(ay);
                aSpin = Velocity.limitSpeed(aSpin);
                bx = Velocity.limitSpeed(bx);
                by = Velocity.limitSpeed(by);
                bSpin = Velocity.limitSpeed(bSpin);
            }
        }
        put(a, ax, ay, aSpin);
        put(b, bx, by, bSpin);
    }

    /** Behind each normal all frictions of the pair. */
    void relax(int begin, int end) {
        float[] rows = contacts.rows;
        int a = contacts.a[begin];
        int b = contacts.b[begin];
        float ax = things.vx[a];
        float ay = things.vy[a];
        float aSpin = things.omega[a];
        float bx = things.vx[b];
        float by = things.vy[b];
        float bSpin = things.omega[b];
        float aw = things.w[a];
        float ai = things.i[a];
        float bw = things.w[b];
        float bi = things.i[b];
        int normal = begin;
        int grip = begin - 1; // before the first: the normal
        while (normal < end) {
            int c = grip < begin ? normal : grip;
            int row = RigidRow.of(c);
            if (grip < begin ? !rules.isIdle(row) : rules.grips(row)) {
                int swap = contacts.a[c] == a ? 0 : SWAP;
                float side = swap == 0 ? 1f : -1f;
                float nx = side * rows[row + RigidRow.NX];
                float ny = side * rows[row + RigidRow.NY];
                float armX = rows[row + RigidRow.AX + swap];
                float armY = rows[row + RigidRow.AY + swap];
                float itsX = rows[row + RigidRow.BX - swap];
                float itsY = rows[row + RigidRow.BY - swap];
                float ux = (ax - aSpin * armY) - (bx - bSpin * itsY);
                float uy = (ay + aSpin * armX) - (by + bSpin * itsX);
                float x;
                float y;
                float gain;
                if (grip < begin) {
                    float vn = ux * nx + uy * ny;
                    gain = rules.bouncesLater(c, vn)
                            ? 0f
                            : rules.relaxedNormal(row, rows[row + RigidRow.NORMAL_MASS], vn);
                    x = nx * gain;
                    y = ny * gain;
                } else {
                    gain = rules.gripped(row, rows[row + RigidRow.TANGENT_MASS], uy * nx - ux * ny);
                    x = -ny * gain;
                    y = nx * gain;
                }
                ax += aw * x;
                ay += aw * y;
                aSpin += ai * (armX * y - armY * x);
                bx += bw * -x;
                by += bw * -y;
                bSpin += bi * (itsX * -y - itsY * -x);
                if (mayBeFast(ax, ay, aSpin, bx, by, bSpin)) {
                    ax = Velocity.limitSpeed(ax);
                    ay = Velocity.limitSpeed(ay);
                    aSpin = Velocity.limitSpeed(aSpin);
                    bx = Velocity.limitSpeed(bx);
                    by = Velocity.limitSpeed(by);
                    bSpin = Velocity.limitSpeed(bSpin);
                }
            }
            if (++grip == end) {
                grip = begin - 1;
                normal++;
            }
        }
        put(a, ax, ay, aSpin);
        put(b, bx, by, bSpin);
    }

    /** Whether one of some speeds may have to be limited: one look at all is enough nearly always. */
    private static boolean mayBeFast(float a, float b, float c, float d, float e, float f) {
        return !(Math.abs(a) + Math.abs(b) + Math.abs(c) + Math.abs(d) + Math.abs(e) + Math.abs(f)
                <= Tuning.GREATEST_SPEED);
    }

    private void put(int t, float x, float y, float spin) {
        if (things.gives(t)) { // what does not may be in other pairs at the same time
            things.vx[t] = x;
            things.vy[t] = y;
            things.omega[t] = spin;
        }
    }
}
