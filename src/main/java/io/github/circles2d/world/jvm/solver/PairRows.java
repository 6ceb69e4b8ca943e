package io.github.circles2d.world.jvm.solver;

import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.RADIUS;

import io.github.circles2d.world.jvm.state.ImpulseCache;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.state.Turning;
import io.github.circles2d.world.model.Branchless;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.Surface;

/**
 * The rows behind the normal one of contacts of two circles: friction along the tangent, and rolling resistance, by {@link Surface}. {@link
 * ContactRows} numbers them. The tangent is the normal rotated 90 degrees anticlockwise.
 */
final class PairRows {
    // The numbers of a contact: by row its bound by the normal impulse, 0 if the row does nothing; by row its effective
    // mass; by row its accumulated impulse; the sum of the belt speeds.
    private static final int FRICTION = ContactRows.FRICTION;
    private static final int REACH = ContactRows.ROLLING; // rolling resistance by the greater radius
    private static final int TANGENT_MASS = ContactRows.COUNT + ContactRows.FRICTION;
    private static final int ROLLING_MASS = ContactRows.COUNT + ContactRows.ROLLING;
    private static final int IMPULSES = 2 * ContactRows.COUNT;
    private static final int FRICTION_IMPULSE = IMPULSES + ContactRows.FRICTION;
    private static final int ROLLING_IMPULSE = IMPULSES + ContactRows.ROLLING;
    private static final int BELT = 3 * ContactRows.COUNT;
    private static final int STRIDE = BELT + 1;

    private final State state;
    private final ImpulseCache impulseCache;

    private float[] values = new float[0];

    PairRows(State state, ImpulseCache impulseCache) {
        this.state = state;
        this.impulseCache = impulseCache;
    }

    private static int of(int contact) {
        return STRIDE * contact;
    }

    /** Memory of the array. */
    long bytes() {
        return 4L * values.length;
    }

    /** Whether there is room for contacts. */
    boolean hasRoom(int contacts) {
        return values.length >= of(contacts);
    }

    void ensure(int contacts) {
        values = new float[of(contacts)];
    }

    // ---- moved
    // ---------------------------------------------------------------------------------------------------------------------

    /** Starts a contact, filled before, with the impulses that an entry of the step before ended with, or -1. */
    void warmStart(int c, int entry, float scale) {
        float[] v = values;
        int o = of(c);
        for (int row = 0; row < ContactRows.COUNT; row++) {
            float impulse = impulseCache.rowImpulse(entry, row) * scale;
            v[o + IMPULSES + row] = v[o + row] > 0f ? impulse : 0f;
        }
    }

    /** Stores the impulses of a contact, whose normal impulse is stored too. */
    void store(int c) {
        impulseCache.storeRows(c, values, of(c) + IMPULSES);
    }

    /** Whether some row has acted, which a visit may have to take back: all bits or none, as good as random. */
    int hold(int c) {
        float[] v = values;
        int o = of(c) + IMPULSES;
        int hold = 0;
        for (int row = 0; row < ContactRows.COUNT; row++) {
            hold |= Branchless.isNotZero(v[o + row]);
        }
        return hold;
    }

    /** {@link ContactRows#actingImpulse}; rows: null if there are none. */
    static float acting(PairRows rows, int c, float normalImpulse) {
        return rows == null
                ? normalImpulse
                : ContactRows.actingImpulse(normalImpulse, rows.values, of(c) + IMPULSES, 1);
    }

    /** Whether some row does something. */
    boolean act(int c) {
        float[] v = values;
        int o = of(c);
        for (int row = 0; row < ContactRows.COUNT; row++) {
            if (v[o + row] > 0f) {
                return true;
            }
        }
        return false;
    }

    // ---- what rows do
    // ----------------------------------------------------------------------------------------------------------------

    /** Fills all but the impulses of a contact; share: of the second circle if it is heavy in a cross contact, else 1. */
    void fill(int c, int first, int second, float share) {
        int a = CircleRow.of(first);
        int b = CircleRow.of(second);
        Turning t = state.turning;
        float[] spin = t.spin;
        float[] traits = state.traits;
        float[] v = values;
        int o = of(c);
        float iA = spin[a + INVERSE_INERTIA];
        float iB = spin[b + INVERSE_INERTIA];
        float resistance = t.pairResistance;
        if (t.alike) { // which spares the reads, and a root
            v[o + FRICTION] = t.pairFriction;
            v[o + BELT] = t.pairBelts;
        } else {
            float[] surfaces = t.circleSurfaces;
            int ofA = KindSurface.of(first);
            int ofB = KindSurface.of(second);
            v[o + FRICTION] =
                    Surface.friction(surfaces[ofA + KindSurface.FRICTION], surfaces[ofB + KindSurface.FRICTION]);
            v[o + BELT] = surfaces[ofA + KindSurface.BELT] + surfaces[ofB + KindSurface.BELT];
            resistance = CircleMath.max(
                    surfaces[ofA + KindSurface.ROLLING_RESISTANCE], surfaces[ofB + KindSurface.ROLLING_RESISTANCE]);
        }
        v[o + TANGENT_MASS] = Surface.tangentMass(traits[a + INVERSE_MASS], iA, traits[b + INVERSE_MASS], iB, share);
        float reach = 0f;
        if (resistance > 0f) {
            float rA = state.circle[a + RADIUS];
            float rB = state.circle[b + RADIUS];
            reach = resistance * CircleMath.max(rA, rB);
            float mass = Surface.rollingMass(rA, iA, rB, iB, share);
            v[o + ROLLING_MASS] = mass;
            // if nothing rotates the circles, rolling resistance has nothing to do
            reach = mass <= Float.MAX_VALUE ? reach : 0f;
        }
        v[o + REACH] = reach;
    }

    /** How fast the surfaces slide, if they have friction; along: the speed of B against A along the tangent; sA, sB: surface speeds. */
    float slip(int c, float along, float sA, float sB) {
        int o = of(c);
        return Surface.hitSlip(values[o + FRICTION], along, sA, sB, values[o + BELT]);
    }

    /** The impulse along x that the rows of a contact give to B. */
    float impulseX(int c, float nx, float ny) {
        return -ny * ContactRows.tangentImpulse(values, of(c) + IMPULSES, 1);
    }

    /** The same along y. */
    float impulseY(int c, float nx, float ny) {
        return nx * ContactRows.tangentImpulse(values, of(c) + IMPULSES, 1);
    }

    /** Adds the impulses of a contact to the sums of its circles' surface speeds; cross: null if the circles are of one level. */
    void addToSpinSums(LikeBodies like, CrossBodies cross, int c, int a, int b) {
        float[] v = values;
        int o = of(c);
        float ofA = -ContactRows.tangentImpulse(v, o + IMPULSES, 1);
        float ofB = ofA;
        if (v[o + REACH] > 0f) {
            float rolling = ContactRows.angularImpulse(v, o + IMPULSES, 1);
            ofA -= rolling / state.circle[a + RADIUS];
            ofB += rolling / state.circle[b + RADIUS];
        }
        if (cross == null) {
            like.addToSpinSums(a, b, ofA, ofB);
        } else {
            cross.addToSpinSums(c, ofA, ofB);
        }
    }

    /**
     * Visits the rows of a contact behind its normal impulse; cross: null if the circles are of one level; along: see {@link #slip}, from before
     * the normal impulse, so that neither waits for the other; keep: whether impulses accumulate.
     */
    void visit(
            LikeBodies like,
            CrossBodies cross,
            int c,
            int a,
            int b,
            float nx,
            float ny,
            float along,
            float normalImpulse,
            boolean keep) {
        if (values[of(c) + REACH] > 0f) {
            roll(like, cross, c, a, b, normalImpulse, keep);
        }
        if (grip(c)) {
            float sA = cross == null ? like.surfaceSpeed(a) : cross.surfaceSpeed(c, 0);
            float sB = cross == null ? like.surfaceSpeed(b) : cross.surfaceSpeed(c, 1);
            float impulse = friction(c, along, sA, sB, normalImpulse, keep);
            if (cross == null) {
                like.apply(c, a, b, -ny, nx, impulse);
                like.turn(a, b, -impulse, -impulse);
            } else {
                cross.apply(c, -ny, nx, impulse);
                cross.turn(c, -impulse, -impulse);
            }
        }
    }

    /** As {@link #visit}, of rolling resistance alone, and of circles of one level. */
    void rollLike(LikeBodies like, int c, int a, int b, float normalImpulse, boolean keep) {
        if (values[of(c) + REACH] > 0f) {
            roll(like, null, c, a, b, normalImpulse, keep);
        }
    }

    /** Whether a contact has friction. */
    boolean grip(int c) {
        return values[of(c) + FRICTION] > 0f;
    }

    /** Visits the friction of a contact that has some, and returns the impulse along the tangent. */
    float friction(int c, float along, float sA, float sB, float normalImpulse, boolean keep) {
        float[] v = values;
        int o = of(c);
        float slip = Surface.slip(along, sA, sB, v[o + BELT]);
        float before = v[o + FRICTION_IMPULSE];
        float next = Surface.grip(before, v[o + TANGENT_MASS], slip, v[o + FRICTION] * normalImpulse);
        v[o + FRICTION_IMPULSE] = keep ? next : 0f;
        return next - before;
    }

    private void roll(LikeBodies like, CrossBodies cross, int c, int a, int b, float normalImpulse, boolean keep) {
        float[] v = values;
        int o = of(c);
        float rA = state.circle[a + RADIUS];
        float rB = state.circle[b + RADIUS];
        float sA = cross == null ? like.surfaceSpeed(a) : cross.surfaceSpeed(c, 0);
        float sB = cross == null ? like.surfaceSpeed(b) : cross.surfaceSpeed(c, 1);
        float before = v[o + ROLLING_IMPULSE];
        float next = Surface.rolling(before, v[o + ROLLING_MASS], sB / rB - sA / rA, v[o + REACH] * normalImpulse);
        float impulse = next - before;
        v[o + ROLLING_IMPULSE] = keep ? next : 0f;
        if (cross == null) {
            like.turn(a, b, -impulse / rA, impulse / rB);
        } else {
            cross.turn(c, -impulse / rA, impulse / rB);
        }
    }
}
