package io.github.circles2d.world.jvm.solver;

import static io.github.circles2d.world.jvm.solver.ContactRow.INV_MASS_A;
import static io.github.circles2d.world.jvm.solver.ContactRow.INV_MASS_B;
import static io.github.circles2d.world.jvm.solver.ContactRow.RESTITUTION;
import static io.github.circles2d.world.jvm.solver.HeavyCircles.GAIN_SPIN;
import static io.github.circles2d.world.jvm.solver.HeavyCircles.GAIN_X;
import static io.github.circles2d.world.jvm.solver.HeavyCircles.GAIN_Y;
import static io.github.circles2d.world.jvm.solver.HeavyCircles.IMPULSE_SCALE;
import static io.github.circles2d.world.jvm.solver.HeavyCircles.SEEN_VX;
import static io.github.circles2d.world.jvm.solver.HeavyCircles.SEEN_VY;
import static io.github.circles2d.world.jvm.solver.HeavyCircles.SUM_IMPULSE_X;
import static io.github.circles2d.world.jvm.solver.HeavyCircles.SUM_IMPULSE_Y;
import static io.github.circles2d.world.jvm.solver.HeavyCircles.SUM_SPIN;
import static io.github.circles2d.world.jvm.solver.HeavyCircles.VELOCITY_SCALE;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_X;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_Y;
import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.SPIN_IMPULSE;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.CrossRule;

/**
 * The circles of contacts of different levels, a light and a heavy one. Visits see heavy circles as they were before the pass, and what
 * they give to them {@link HeavyCircles} sums up. {@link CrossRule} says why.
 *
 * <p>The side of a contact is 1 if its light circle is A, else -1. So side times normal points from the light circle to the heavy one.
 */
final class CrossBodies {
    private final State state;
    private final Contacts contacts;
    private final HeavyCircles heavyCircles;
    private final int worker;

    CrossBodies(State state, Contacts contacts, int worker) {
        this.state = state;
        this.contacts = contacts;
        this.worker = worker;
        heavyCircles = contacts.cross().heavyCircles;
    }

    /** As {@link LikeBodies#normalSpeed}. */
    float normalSpeed(int c, float nx, float ny) {
        float[] m = state.motion;
        float[] seen = heavyCircles.seen;
        int isB = contacts.isLightB(c);
        float side = side(isB);
        int light = contacts.pair[ContactRow.a(c) + isB];
        int heavy = HeavyCircles.row(contacts.heavy(c));
        return CircleMath.dot(
                side * nx, side * ny, seen[heavy + SEEN_VX] - m[light + VX], seen[heavy + SEEN_VY] - m[light + VY]);
    }

    /** As {@link LikeBodies#apply}. */
    void apply(int c, float nx, float ny, float impulse) {
        float[] m = state.motion;
        float[] q = contacts.contact;
        int isB = contacts.isLightB(c);
        int o = ContactRow.of(c);
        float x = side(isB) * nx;
        float y = side(isB) * ny;
        float ofLight = q[o + INV_MASS_A] * impulse;
        float ofHeavy = q[o + INV_MASS_B] * impulse;
        int light = contacts.pair[ContactRow.a(c) + isB];
        m[light + VX] -= x * ofLight;
        m[light + VY] -= y * ofLight;
        int heavy = contacts.heavy(c);
        float scale = heavyCircles.seen[HeavyCircles.row(heavy) + VELOCITY_SCALE];
        long[] sums = heavyCircles.sumsOf(worker);
        int sum = HeavyCircles.sum(heavy);
        sums[sum + GAIN_X] += CrossRule.toFixed(x * ofHeavy, scale);
        sums[sum + GAIN_Y] += CrossRule.toFixed(y * ofHeavy, scale);
    }

    /** As {@link LikeBodies#addToSums}. */
    void addToSums(int c, float ofPairX, float ofPairY) {
        float[] load = state.load;
        int isB = contacts.isLightB(c);
        float x = side(isB) * ofPairX;
        float y = side(isB) * ofPairY;
        int light = contacts.pair[ContactRow.a(c) + isB];
        load[light + IMPULSE_X] -= x;
        load[light + IMPULSE_Y] -= y;
        int heavy = contacts.heavy(c);
        float scale = heavyCircles.seen[HeavyCircles.row(heavy) + IMPULSE_SCALE];
        long[] sums = heavyCircles.sumsOf(worker);
        int sum = HeavyCircles.sum(heavy);
        sums[sum + SUM_IMPULSE_X] += CrossRule.toFixed(x, scale);
        sums[sum + SUM_IMPULSE_Y] += CrossRule.toFixed(y, scale);
    }

    /** Of A, 0, or B, 1. */
    float surfaceSpeed(int c, int which) {
        int isB = contacts.isLightB(c);
        return which == isB
                ? state.turning.spin[contacts.pair[ContactRow.a(c) + isB] + SURFACE_SPEED]
                : heavyCircles.seenSurfaceSpeed[contacts.heavy(c)];
    }

    /** As {@link LikeBodies#turn}. */
    void turn(int c, float ofA, float ofB) {
        float[] spin = state.turning.spin;
        int isB = contacts.isLightB(c);
        int light = contacts.pair[ContactRow.a(c) + isB];
        int heavyRow = contacts.pair[ContactRow.b(c) - isB];
        spin[light + SURFACE_SPEED] += spin[light + INVERSE_INERTIA] * (isB == 0 ? ofA : ofB);
        float gain = spin[heavyRow + INVERSE_INERTIA] * (isB == 0 ? ofB : ofA);
        int heavy = contacts.heavy(c);
        float scale = heavyCircles.seen[HeavyCircles.row(heavy) + VELOCITY_SCALE];
        heavyCircles.spinSumsOf(worker)[HeavyCircles.spinSum(heavy) + GAIN_SPIN] += CrossRule.toFixed(gain, scale);
    }

    /** As {@link LikeBodies#addToSpinSums}. */
    void addToSpinSums(int c, float ofA, float ofB) {
        int isB = contacts.isLightB(c);
        int light = contacts.pair[ContactRow.a(c) + isB];
        state.turning.spin[light + SPIN_IMPULSE] += isB == 0 ? ofA : ofB;
        int heavy = contacts.heavy(c);
        float scale = heavyCircles.seen[HeavyCircles.row(heavy) + IMPULSE_SCALE];
        heavyCircles.spinSumsOf(worker)[HeavyCircles.spinSum(heavy) + SUM_SPIN] +=
                CrossRule.toFixed(isB == 0 ? ofB : ofA, scale);
    }

    /**
     * Whether circles that are to bounce freely have to wait for others of the heavy circle. With bias, those that may wait claim it;
     * without, the light circle that has claimed it bounces.
     */
    boolean waits(int c, int a, int b, float separation, boolean relaxing) {
        int o = ContactRow.of(c);
        float restitution = contacts.contact[o + RESTITUTION];
        float invMassOfHeavy = contacts.contact[o + INV_MASS_B];
        float[] circle = state.circle;
        if (!CrossRule.mayWait(restitution, invMassOfHeavy, separation, circle[a + RADIUS], circle[b + RADIUS])) {
            return false;
        }
        int light = CircleRow.slot(contacts.pair[ContactRow.a(c) + contacts.isLightB(c)]);
        int heavy = contacts.heavy(c);
        if (!relaxing) {
            heavyCircles.claim(heavy, state.id[light]);
            return true;
        }
        boolean hasClaimed = heavyCircles.isClaimedBy(heavy, state.id[light])
                && !heavyCircles.isClaimed(contacts.cross().numberOf(light));
        return !hasClaimed;
    }

    private static float side(int isLightB) {
        return 1 - 2 * isLightB;
    }
}
