package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.Velocity;

/**
 * Visits of pairs whose contacts neither bounce nor resist rolling, while {@link RigidVisits#areFixed}. The velocities of both things are in local
 * variables as long as a pair is visited; contacts the other way round have their terms swapped, which
 * changes no bit then. Each pass has a loop: one for both took two percent more of a pyramid's step.
 */
final class RigidPairVisits {
    private final RigidContacts contacts;
    private final RigidRules rules;

    RigidPairVisits(RigidContacts contacts, RigidRules rules) {
        this.contacts = contacts;
        this.rules = rules;
    }

    /** Visits the contacts of a pair that neither bounces nor is hit. */
    void solve(RigidPair pair) {
        RigidContact[] all = contacts.all;
        RigidThing a = pair.a;
        RigidThing b = pair.b;
        float ax = a.vx;
        float ay = a.vy;
        float aSpin = a.omega;
        float bx = b.vx;
        float by = b.vy;
        float bSpin = b.omega;
        float aw = a.w;
        float ai = a.i;
        float bw = b.w;
        float bi = b.i;
        for (int n = pair.begin; n < pair.end; n++) {
            RigidContact c = all[n];
            boolean same = c.a == a;
            float side = same ? 1f : -1f;
            float nx = side * c.nx;
            float ny = side * c.ny;
            float armX = same ? c.ax : c.bx;
            float armY = same ? c.ay : c.by;
            float itsX = same ? c.bx : c.ax;
            float itsY = same ? c.by : c.ay;
            float vn =
                    ((ax - aSpin * armY) - (bx - bSpin * itsY)) * nx + ((ay + aSpin * armX) - (by + bSpin * itsX)) * ny;
            float gain = rules.solvedNormal(c, vn);
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
    void relax(RigidPair pair) {
        RigidContact[] all = contacts.all;
        RigidThing a = pair.a;
        RigidThing b = pair.b;
        float ax = a.vx;
        float ay = a.vy;
        float aSpin = a.omega;
        float bx = b.vx;
        float by = b.vy;
        float bSpin = b.omega;
        float aw = a.w;
        float ai = a.i;
        float bw = b.w;
        float bi = b.i;
        int begin = pair.begin;
        int normal = begin;
        int grip = begin - 1; // before the first: the normal
        while (normal < pair.end) {
            RigidContact c = all[grip < begin ? normal : grip];
            if (grip < begin ? !c.isIdle() : c.grips()) {
                boolean same = c.a == a;
                float side = same ? 1f : -1f;
                float nx = side * c.nx;
                float ny = side * c.ny;
                float armX = same ? c.ax : c.bx;
                float armY = same ? c.ay : c.by;
                float itsX = same ? c.bx : c.ax;
                float itsY = same ? c.by : c.ay;
                float ux = (ax - aSpin * armY) - (bx - bSpin * itsY);
                float uy = (ay + aSpin * armX) - (by + bSpin * itsX);
                float x;
                float y;
                float gain;
                if (grip < begin) {
                    float vn = ux * nx + uy * ny;
                    gain = rules.bouncesLater(c, vn) ? 0f : rules.relaxedNormal(c, c.normalMass, vn);
                    x = nx * gain;
                    y = ny * gain;
                } else {
                    gain = rules.gripped(c, c.tangentMass, uy * nx - ux * ny);
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
            if (++grip == pair.end) {
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

    private static void put(RigidThing t, float x, float y, float spin) {
        if (t.gives()) { // what does not may be in other pairs at the same time
            t.vx = x;
            t.vy = y;
            t.omega = spin;
        }
    }
}
