package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.jvm.GripRow.BELT;
import static io.github.circles2d.world.jvm.GripRow.FRICTION;
import static io.github.circles2d.world.jvm.GripRow.FRICTION_IMPULSE;
import static io.github.circles2d.world.jvm.GripRow.REACH;
import static io.github.circles2d.world.jvm.GripRow.ROLLING_IMPULSE;
import static io.github.circles2d.world.jvm.GripRow.ROLLING_MASS;
import static io.github.circles2d.world.jvm.GripRow.TANGENT_MASS;
import static io.github.circles2d.world.model.CircleRow.RADIUS;

import io.github.circles2d.world.model.Branchless;
import io.github.circles2d.world.model.Surface;

/** What surfaces do in the visit of a contact of two circles: friction and rolling resistance, by {@link Surface}. */
final class GripVisits {
    private final State state;
    private final Contacts contacts;
    private final LikeBodies like;

    /** Null if the contacts are of circles of one level. */
    private final CrossBodies cross;

    GripVisits(State state, Contacts contacts, LikeBodies like, CrossBodies cross) {
        this.state = state;
        this.contacts = contacts;
        this.like = like;
        this.cross = cross;
    }

    /** Whether friction or rolling resistance has acted, which a visit may have to take back: all bits or none, as good as random. */
    int holds(int c) {
        float[] g = contacts.grip;
        int o = GripRow.of(c);
        return Branchless.isNotZero(g[o + FRICTION_IMPULSE]) | Branchless.isNotZero(g[o + ROLLING_IMPULSE]);
    }

    boolean grips(int c) {
        float[] g = contacts.grip;
        int o = GripRow.of(c);
        return g[o + FRICTION] > 0f || g[o + REACH] > 0f;
    }

    /** The impulse of friction that is accumulated. */
    float friction(int c) {
        return contacts.grip[GripRow.of(c) + FRICTION_IMPULSE];
    }

    /** Adds what is accumulated to the sums of impulses on the surface speeds. */
    void addToSpinSums(int c, int a, int b) {
        float[] g = contacts.grip;
        int o = GripRow.of(c);
        float ofA = -g[o + FRICTION_IMPULSE];
        float ofB = ofA;
        if (g[o + REACH] > 0f) {
            float rolling = g[o + ROLLING_IMPULSE];
            ofA -= rolling / state.circle[a + RADIUS];
            ofB += rolling / state.circle[b + RADIUS];
        }
        if (cross == null) {
            like.addToSpinSums(a, b, ofA, ofB);
        } else {
            cross.addToSpinSums(c, ofA, ofB);
        }
    }

    /** A visit without bias; keep: whether what acts accumulates. */
    void visit(int c, int a, int b, float nx, float ny, float normalImpulse, boolean keep) {
        float[] g = contacts.grip;
        int o = GripRow.of(c);
        if (g[o + REACH] > 0f) {
            roll(c, o, a, b, normalImpulse, keep);
        }
        if (g[o + FRICTION] > 0f) {
            float along = cross == null ? like.normalSpeed(a, b, -ny, nx) : cross.normalSpeed(c, -ny, nx);
            float sA = cross == null ? like.surfaceSpeed(a) : cross.surfaceSpeed(c, 0);
            float sB = cross == null ? like.surfaceSpeed(b) : cross.surfaceSpeed(c, 1);
            float slip = Surface.slip(along, sA, sB, g[o + BELT]);
            float before = g[o + FRICTION_IMPULSE];
            float next = Surface.grip(before, g[o + TANGENT_MASS], slip, g[o + FRICTION] * normalImpulse);
            float impulse = next - before;
            g[o + FRICTION_IMPULSE] = keep ? next : 0f;
            if (cross == null) {
                like.apply(c, a, b, -ny, nx, impulse);
                like.turn(a, b, -impulse, -impulse);
            } else {
                cross.apply(c, -ny, nx, impulse);
                cross.turn(c, -impulse, -impulse);
            }
        }
    }

    private void roll(int c, int o, int a, int b, float normalImpulse, boolean keep) {
        float[] g = contacts.grip;
        float rA = state.circle[a + RADIUS];
        float rB = state.circle[b + RADIUS];
        float sA = cross == null ? like.surfaceSpeed(a) : cross.surfaceSpeed(c, 0);
        float sB = cross == null ? like.surfaceSpeed(b) : cross.surfaceSpeed(c, 1);
        float before = g[o + ROLLING_IMPULSE];
        float next = Surface.rolling(before, g[o + ROLLING_MASS], sB / rB - sA / rA, g[o + REACH] * normalImpulse);
        float impulse = next - before;
        g[o + ROLLING_IMPULSE] = keep ? next : 0f;
        if (cross == null) {
            like.turn(a, b, -impulse / rA, impulse / rB);
        } else {
            cross.turn(c, -impulse / rA, impulse / rB);
        }
    }

    /** Stores what is accumulated of a contact, whose normal impulse is stored too. */
    void store(int c) {
        float[] g = contacts.grip;
        int o = GripRow.of(c);
        contacts.impulseCache().storeGrips(c, g[o + FRICTION_IMPULSE], g[o + ROLLING_IMPULSE]);
    }
}
