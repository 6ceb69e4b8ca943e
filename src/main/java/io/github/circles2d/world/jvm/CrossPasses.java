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
import static io.github.circles2d.world.jvm.HeavyCircles.GAIN_X;
import static io.github.circles2d.world.jvm.HeavyCircles.GAIN_Y;
import static io.github.circles2d.world.jvm.HeavyCircles.IMPULSE_SCALE;
import static io.github.circles2d.world.jvm.HeavyCircles.SEEN_VX;
import static io.github.circles2d.world.jvm.HeavyCircles.SEEN_VY;
import static io.github.circles2d.world.jvm.HeavyCircles.SUM_IMPULSE_X;
import static io.github.circles2d.world.jvm.HeavyCircles.SUM_IMPULSE_Y;
import static io.github.circles2d.world.jvm.HeavyCircles.VELOCITY_SCALE;
import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.BEFORE_Y;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_X;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_Y;
import static io.github.circles2d.world.model.CircleRow.LOADED;
import static io.github.circles2d.world.model.CircleRow.LOADED_NEXT;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.StepConstants;

/**
 * The cross contacts' part of stage Solver: each light circle visits its contacts, and gives the heavy ones what {@link HeavyCircles}
 * sums up. Heavy circles are seen as they were before the pass. {@link CrossRule} says why, {@link Constraints} has the formulas.
 *
 * <p>A normal points from the circle of the lower id to the other. Times the side of its contact, which is 1 or -1, it points from the
 * light circle to the heavy one.
 */
final class CrossPasses extends RelaxingPass {
    private final HeavyCircles heavyCircles;
    private final int worker;

    /** What is told of impulses that contacts do not keep; null if nothing is recorded. */
    Touches touches;

    CrossPasses(State state, Contacts contacts, int worker) {
        super(state, contacts);
        this.worker = worker;
        heavyCircles = contacts.cross().heavyCircles;
    }

    /** Measures contacts for the first sub-step, and adds their impulses to the sums of their circles. */
    void prepare(int from, int to) {
        float[] q = contacts.contact;
        float[] m = state.motion;
        for (int c = from; c < to; c++) {
            measure(c);
            int o = ContactRow.of(c);
            int a = contacts.pair[ContactRow.a(c)];
            int b = contacts.pair[ContactRow.b(c)];
            float vn = CircleMath.dot(q[o + NORMAL_X], q[o + NORMAL_Y], m[b + VX] - m[a + VX], m[b + VY] - m[a + VY]);
            float impulse = q[o + NORMAL_IMPULSE];
            addImpulse(c, impulse);
            if (Constraints.carries(impulse, q[o + SEPARATION], vn, q[o + RESTITUTION_THRESHOLD]) != 0) {
                load(c);
            }
        }
    }

    /** Adds a contact's impulse to the sums of its circles. */
    private void addImpulse(int c, float impulse) {
        float[] q = contacts.contact;
        int o = ContactRow.of(c);
        int heavy = contacts.heavy(c);
        float side = contacts.side(c);
        float x = side * q[o + NORMAL_X] * impulse;
        float y = side * q[o + NORMAL_Y] * impulse;
        int light = contacts.light(c);
        state.load[light + IMPULSE_X] -= x;
        state.load[light + IMPULSE_Y] -= y;
        float scale = heavyCircles.seen[HeavyCircles.row(heavy) + IMPULSE_SCALE];
        long[] sums = heavyCircles.sumsOf(worker);
        sums[HeavyCircles.sum(heavy) + SUM_IMPULSE_X] += CrossRule.toFixed(x, scale);
        sums[HeavyCircles.sum(heavy) + SUM_IMPULSE_Y] += CrossRule.toFixed(y, scale);
    }

    /** Marks the circles of a contact as loaded. Other workers may mark the heavy one too; none takes a mark away. */
    private void load(int c) {
        state.load[contacts.pair[ContactRow.a(c)] + LOADED_NEXT] = 1f;
        state.load[contacts.pair[ContactRow.b(c)] + LOADED_NEXT] = 1f;
    }

    /** The biased pass: stops approaches, pushes overlaps out, bounces. */
    void solve(int from, int to, StepConstants k) {
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        int[] heavyAndSide = contacts.heavyAndSide;
        int firstCross = contacts.firstCross;
        float[] m = state.motion;
        float[] load = state.load;
        float[] seen = heavyCircles.seen;
        long[] sums = heavyCircles.sumsOf(worker);
        for (int c = from; c < to; c++) {
            int o = ContactRow.of(c);
            int code = heavyAndSide[c - firstCross];
            int light = pair[ContactRow.a(c) + (code & 1)];
            int heavy = HeavyCircles.row(code >> 1);
            float side = 1 - 2 * (code & 1);
            float nx = side * q[o + NORMAL_X];
            float ny = side * q[o + NORMAL_Y];
            float separation = q[o + SEPARATION];
            float restitution = q[o + RESTITUTION];
            float impulse = q[o + NORMAL_IMPULSE];
            float pushSpeed = k.pushRate * q[o + RADII];
            float vn = CircleMath.dot(
                    nx, ny, seen[heavy + SEEN_VX] - m[light + VX], seen[heavy + SEEN_VY] - m[light + VY]);
            float bounce = 0f;
            // without restitution it stays so, and none flies: this only spares the reads
            if (restitution > 0f) {
                int a = pair[ContactRow.a(c)];
                int b = pair[ContactRow.b(c)];
                float loaded = load[a + LOADED] + load[b + LOADED];
                if (Constraints.flies(loaded, impulse, vn, q[o + FLIGHT_THRESHOLD]) != 0 && solveFlying(c, vn, k)) {
                    q[o + BOUNCE_SPEED] = 0f;
                    continue;
                }
                float before = CircleMath.dot(
                        q[o + NORMAL_X],
                        q[o + NORMAL_Y],
                        load[b + BEFORE_X] - load[a + BEFORE_X],
                        load[b + BEFORE_Y] - load[a + BEFORE_Y]);
                float threshold = q[o + RESTITUTION_THRESHOLD];
                bounce = Constraints.bounceSpeed(restitution, loaded, before, separation, k.h, threshold, pushSpeed);
            }
            q[o + BOUNCE_SPEED] = bounce;
            float next = Constraints.solve(
                    impulse,
                    q[o + MASS],
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
            float applied = next - impulse;
            float ofLight = q[o + INV_MASS_A] * applied;
            float ofHeavy = q[o + INV_MASS_B] * applied;
            m[light + VX] -= nx * ofLight;
            m[light + VY] -= ny * ofLight;
            float scale = seen[heavy + VELOCITY_SCALE];
            int sum = HeavyCircles.sum(code >> 1);
            sums[sum + GAIN_X] += CrossRule.toFixed(nx * ofHeavy, scale);
            sums[sum + GAIN_Y] += CrossRule.toFixed(ny * ofHeavy, scale);
        }
    }

    /** Visits a contact of circles that fly free of each other with bias; returns false if it is to be solved as others are. */
    private boolean solveFlying(int c, float vn, StepConstants k) {
        float[] q = contacts.contact;
        float[] load = state.load;
        int o = ContactRow.of(c);
        int a = contacts.pair[ContactRow.a(c)];
        int b = contacts.pair[ContactRow.b(c)];
        float separation = q[o + SEPARATION];
        float beforeX = load[b + BEFORE_X] - load[a + BEFORE_X];
        float beforeY = load[b + BEFORE_Y] - load[a + BEFORE_Y];
        int lingers = Constraints.lingers(separation, beforeX * beforeX + beforeY * beforeY);
        int visit = visitOf(c, vn, lingers, Constraints.meets(separation, vn, k.inverseH));
        if (visit == Constraints.BOUNCE) {
            if (mayWait(c, separation + vn * k.h)) {
                heavyCircles.claim(contacts.heavy(c), state.id[CircleRow.slot(contacts.light(c))]);
            } else {
                boolean isLightLower = a == contacts.light(c);
                float invMassA = q[o + (isLightLower ? INV_MASS_A : INV_MASS_B)];
                float invMassB = q[o + (isLightLower ? INV_MASS_B : INV_MASS_A)];
                bounce(c, vn - contacts.halfFall(c, invMassA, invMassB, k));
            }
        }
        return visit != Constraints.SOLVE;
    }

    /** As {@link #solveFlying} without bias: of those that waited, the one that has claimed the heavy circle bounces. */
    private boolean relaxFlying(int c, float vn) {
        int visit = visitOf(c, vn, 0, Constraints.ALWAYS);
        if (visit == Constraints.BOUNCE
                && (!mayWait(c, contacts.contact[ContactRow.of(c) + SEPARATION]) || hasClaimed(c))) {
            bounce(c, vn);
        }
        return visit != Constraints.SOLVE;
    }

    private int visitOf(int c, float vn, int lingers, int meets) {
        float[] q = contacts.contact;
        int o = ContactRow.of(c);
        return Constraints.visitOf(q[o + RESTITUTION], 0f, lingers, 0f, vn, meets, q[o + FLIGHT_THRESHOLD]);
    }

    private boolean mayWait(int c, float separation) {
        int a = contacts.pair[ContactRow.a(c)];
        int b = contacts.pair[ContactRow.b(c)];
        int o = ContactRow.of(c);
        return CrossRule.mayWait(
                contacts.contact[o + RESTITUTION],
                contacts.contact[o + INV_MASS_B],
                separation,
                state.circle[a + RADIUS],
                state.circle[b + RADIUS]);
    }

    private boolean hasClaimed(int c) {
        int light = CircleRow.slot(contacts.light(c));
        return heavyCircles.isClaimedBy(contacts.heavy(c), state.id[light])
                && !heavyCircles.isClaimed(contacts.cross().numberOf(light));
    }

    /** Lets the circles of a contact bounce. */
    private void bounce(int c, float vn) {
        float[] q = contacts.contact;
        int o = ContactRow.of(c);
        // it is no pile that pushes the heavy circle, so its mass is not split
        float impulse = Bounce.freeBounce(q[o + RESTITUTION], vn, 1f / (q[o + INV_MASS_A] + q[o + INV_MASS_B]));
        apply(c, impulse);
        if (touches != null) {
            touches.add(c, impulse);
        }
    }

    /** Applies an impulse to the light circle, and gives it to the heavy one. */
    private void apply(int c, float impulse) {
        float[] q = contacts.contact;
        float[] m = state.motion;
        int o = ContactRow.of(c);
        int light = contacts.light(c);
        int heavy = contacts.heavy(c);
        float side = contacts.side(c);
        float nx = side * q[o + NORMAL_X];
        float ny = side * q[o + NORMAL_Y];
        float ofLight = q[o + INV_MASS_A] * impulse;
        float ofHeavy = q[o + INV_MASS_B] * impulse;
        m[light + VX] -= nx * ofLight;
        m[light + VY] -= ny * ofLight;
        float scale = heavyCircles.seen[HeavyCircles.row(heavy) + VELOCITY_SCALE];
        long[] sums = heavyCircles.sumsOf(worker);
        sums[HeavyCircles.sum(heavy) + GAIN_X] += CrossRule.toFixed(nx * ofHeavy, scale);
        sums[HeavyCircles.sum(heavy) + GAIN_Y] += CrossRule.toFixed(ny * ofHeavy, scale);
    }

    @Override
    int relaxOpen(int open, StepConstants k) {
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        int[] heavyAndSide = contacts.heavyAndSide;
        int firstCross = contacts.firstCross;
        float[] m = state.motion;
        float[] load = state.load;
        float[] seen = heavyCircles.seen;
        long[] sums = heavyCircles.sumsOf(worker);
        int carrying = 0;
        for (int n = 0; n < open; n++) {
            int c = listed[n];
            int o = ContactRow.of(c);
            int code = heavyAndSide[c - firstCross];
            int light = pair[ContactRow.a(c) + (code & 1)];
            int heavy = HeavyCircles.row(code >> 1);
            float side = 1 - 2 * (code & 1);
            float nx = side * q[o + NORMAL_X];
            float ny = side * q[o + NORMAL_Y];
            float separation = q[o + SEPARATION];
            float bounce = q[o + BOUNCE_SPEED];
            float impulse = q[o + NORMAL_IMPULSE];
            float invMassOfLight = q[o + INV_MASS_A];
            float invMassOfHeavy = q[o + INV_MASS_B];
            float vn = CircleMath.dot(
                    nx, ny, seen[heavy + SEEN_VX] - m[light + VX], seen[heavy + SEEN_VY] - m[light + VY]);
            if (q[o + RESTITUTION] > 0f && impulse == 0f) {
                float loaded = load[pair[ContactRow.a(c)] + LOADED] + load[pair[ContactRow.b(c)] + LOADED];
                if (Constraints.flies(loaded, impulse, vn, q[o + FLIGHT_THRESHOLD]) != 0 && relaxFlying(c, vn)) {
                    continue;
                }
            }
            float next = Constraints.relax(impulse, q[o + MASS], vn, separation, bounce, k.inverseH);
            float applied = next - impulse;
            float ofLight = invMassOfLight * applied;
            float ofHeavy = invMassOfHeavy * applied;
            m[light + VX] -= nx * ofLight;
            m[light + VY] -= ny * ofLight;
            float scale = seen[heavy + VELOCITY_SCALE];
            int sum = HeavyCircles.sum(code >> 1);
            sums[sum + GAIN_X] += CrossRule.toFixed(nx * ofHeavy, scale);
            sums[sum + GAIN_Y] += CrossRule.toFixed(ny * ofHeavy, scale);
            if (bounce > 0f) {
                next = 0f;
                if (touches != null) {
                    touches.add(c, impulse + applied);
                }
            }
            q[o + NORMAL_IMPULSE] = next;
            float after = vn + applied * (invMassOfLight + invMassOfHeavy);
            listed[carrying] = c;
            carrying -= Constraints.carries(next, separation, after, q[o + RESTITUTION_THRESHOLD]);
        }
        return carrying;
    }

    @Override
    void warmStart(int carrying) {
        for (int n = 0; n < carrying; n++) {
            addImpulse(listed[n], contacts.contact[ContactRow.of(listed[n]) + NORMAL_IMPULSE]);
            load(listed[n]);
        }
    }

    @Override
    void store(int c, float normalImpulse) {
        contacts.storeCrossImpulse(c, normalImpulse);
    }
}
