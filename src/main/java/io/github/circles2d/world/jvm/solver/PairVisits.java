package io.github.circles2d.world.jvm.solver;

import static io.github.circles2d.world.jvm.solver.ContactRow.BASE_X;
import static io.github.circles2d.world.jvm.solver.ContactRow.BASE_Y;
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
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.LOADED;
import static io.github.circles2d.world.model.CircleRow.LOADED_NEXT;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Tuning;

/**
 * The visits of contacts of two circles: the passes over a range of contacts, one after the other. {@link Constraints} has the formulas.
 * {@link LikeBodies} and {@link CrossBodies} know how a pass sees the velocities of the circles, and what becomes of the impulses.
 *
 * <p>A is the circle of the lower id, B the other; the normal points from A to B. a and b are where their rows begin.
 */
final class PairVisits {
    /** Contacts that the relaxing pass works on at a time, by what is still to do with them. */
    private static final class Block {
        private static final int SIZE = 256;

        /** Those to visit; once they are, those of them that carry, unless the visits have done all. */
        private final int[] listed = new int[SIZE];

        /** Number of those that carry. */
        private int carrying;

        /** Those that got an impulse and do not keep it: {@link Touches} takes it. */
        private final int[] unkept = new int[SIZE];

        private int unkeptCount;

        private void begin() {
            carrying = 0;
            unkeptCount = 0;
        }

        private void addUnkept(int c) {
            unkept[unkeptCount++] = c;
        }
    }

    private final State state;
    private final Contacts contacts;

    /** What is told of impulses that contacts do not keep; null if nothing is recorded. */
    Touches touches;

    /** The rows behind the normal one; null if circles cannot rotate. */
    private PairRows rows;

    private final Block block = new Block();

    private final LikeBodies like;

    /** Null if the contacts are of circles of one level. */
    private final CrossBodies cross;

    private PairVisits(State state, Contacts contacts, CrossBodies cross) {
        this.state = state;
        this.contacts = contacts;
        like = new LikeBodies(state, contacts);
        this.cross = cross;
    }

    /** For the steps to come; turning: whether circles can rotate. */
    void turn(boolean turning) {
        rows = turning ? contacts.rows : null;
    }

    /** Visits contacts of circles of one level. */
    static PairVisits ofLike(State state, Contacts contacts) {
        return new PairVisits(state, contacts, null);
    }

    /** Visits contacts of circles of different levels. */
    static PairVisits ofCross(State state, Contacts contacts, int worker) {
        return new PairVisits(state, contacts, new CrossBodies(state, contacts, worker));
    }

    // ---- which bodies
    // -------------------------------------------------------------------------------------------------------------

    // A branch on what a loop keeps in a local variable: the compiler takes it out of the loop, and a virtual call not.

    private float normalSpeed(CrossBodies cross, int c, int a, int b, float nx, float ny) {
        return cross == null ? like.normalSpeed(a, b, nx, ny) : cross.normalSpeed(c, nx, ny);
    }

    /** The speed of B relative to A along the tangent. */
    private float along(CrossBodies cross, int c, int a, int b, float nx, float ny) {
        return normalSpeed(cross, c, a, b, -ny, nx);
    }

    private void apply(CrossBodies cross, int c, int a, int b, float nx, float ny, float impulse) {
        if (cross == null) {
            like.apply(c, a, b, nx, ny, impulse);
        } else {
            cross.apply(c, nx, ny, impulse);
        }
    }

    /** Adds the impulses of a contact to the sums of its circles for the next sub-step. */
    private void addToSums(CrossBodies cross, PairRows rows, int c, int a, int b, float nx, float ny, float impulse) {
        float x = nx * impulse;
        float y = ny * impulse;
        if (rows != null && rows.act(c)) {
            x += rows.impulseX(c, nx, ny);
            y += rows.impulseY(c, nx, ny);
            rows.addToSpinSums(like, cross, c, a, b);
        }
        if (cross == null) {
            like.addToSums(a, b, x, y);
        } else {
            cross.addToSums(c, x, y);
        }
    }

    // ---- measured
    // ------------------------------------------------------------------------------------------------------------------

    /** Measures contacts for the first sub-step, and adds their impulses to the sums of their circles. */
    void prepare(int from, int to) {
        PairRows rows = this.rows;
        CrossBodies cross = this.cross;
        for (int c = from; c < to; c++) {
            measure(c);
            float[] q = contacts.contact;
            float[] m = state.motion;
            int o = ContactRow.of(c);
            int a = contacts.pair[ContactRow.a(c)];
            int b = contacts.pair[ContactRow.b(c)];
            float vn = CircleMath.dot(q[o + NORMAL_X], q[o + NORMAL_Y], m[b + VX] - m[a + VX], m[b + VY] - m[a + VY]);
            float impulse = q[o + NORMAL_IMPULSE];
            addToSums(cross, rows, c, a, b, q[o + NORMAL_X], q[o + NORMAL_Y], impulse);
            float acting = PairRows.acting(rows, c, impulse);
            if (Constraints.carries(acting, q[o + SEPARATION], vn, q[o + RESTITUTION_THRESHOLD]) != 0) {
                load(a, b);
            }
        }
    }

    /** Measures a contact: separation, and the normal where there is a direction. */
    private void measure(int c) {
        float[] q = contacts.contact;
        float[] m = state.motion;
        int o = ContactRow.of(c);
        int a = contacts.pair[ContactRow.a(c)];
        int b = contacts.pair[ContactRow.b(c)];
        float dx = CircleMath.difference(q[o + BASE_X], m[a + DX], m[b + DX]);
        float dy = CircleMath.difference(q[o + BASE_Y], m[a + DY], m[b + DY]);
        float d = CircleMath.length(dx, dy);
        float radii = q[o + RADII];
        if (d > Tuning.COINCIDENT * radii) {
            q[o + NORMAL_X] = dx / d;
            q[o + NORMAL_Y] = dy / d;
        }
        q[o + SEPARATION] = d - radii;
    }

    /** Marks circles as loaded. Other workers may mark a heavy one too; none takes a mark away. */
    private void load(int a, int b) {
        state.load[a + LOADED_NEXT] = 1f;
        state.load[b + LOADED_NEXT] = 1f;
    }

    // ---- the biased pass
    // -----------------------------------------------------------------------------------------------------------

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
        return cross == null
                ? like.solveUntilFlight(from, to, asked, k)
                : solveCrossUntilFlight(cross, from, to, asked, k);
    }

    private int solveCrossUntilFlight(CrossBodies cross, int from, int to, int asked, StepConstants k) {
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
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
            float vn = cross.normalSpeed(c, nx, ny);
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
            cross.apply(c, nx, ny, next - impulse);
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
        float vn = normalSpeed(cross, c, a, b, q[o + NORMAL_X], q[o + NORMAL_Y]);
        int meets = Constraints.meets(separation, vn, k.inverseH);
        q[o + BOUNCE_SPEED] = 0f;
        int visit = visitOf(c, vn, lingers, meets);
        if (visit == Constraints.BOUNCE && !(cross != null && cross.waits(c, a, b, separation + vn * k.h, false))) {
            bounce(c, a, b, vn - contacts.halfFall(c, k));
            if (touches != null) {
                touches.noteUnkept(c);
            }
        }
        return visit != Constraints.SOLVE;
    }

    private int visitOf(int c, float vn, int lingers, int meets) {
        float[] q = contacts.contact;
        int o = ContactRow.of(c);
        return Constraints.visitOf(q[o + RESTITUTION], 0f, lingers, 0f, vn, meets, q[o + FLIGHT_THRESHOLD]);
    }

    /** Lets the circles of a contact bounce freely. No pile pushes them, so the mass of a heavy one is not split. */
    private void bounce(int c, int a, int b, float vn) {
        float[] q = contacts.contact;
        int o = ContactRow.of(c);
        float mass = 1f / (q[o + INV_MASS_A] + q[o + INV_MASS_B]);
        float impulse = Bounce.freeBounce(q[o + RESTITUTION], vn, mass);
        float along = rows == null ? 0f : along(cross, c, a, b, q[o + NORMAL_X], q[o + NORMAL_Y]);
        apply(cross, c, a, b, q[o + NORMAL_X], q[o + NORMAL_Y], impulse);
        if (rows != null) {
            rows.visit(like, cross, c, a, b, q[o + NORMAL_X], q[o + NORMAL_Y], along, impulse, false);
        }
        if (touches != null) {
            touches.add(c, impulse);
        }
    }

    // ---- the relaxing pass
    // ---------------------------------------------------------------------------------------------------------

    /** The relaxing pass: measures the contacts anew, takes the push-out speed away again, and sums up for what follows. */
    void relax(int from, int to, StepConstants k, boolean last) {
        boolean sums = cross == null && touches == null && !last;
        for (int begin = from; begin < to; begin += Block.SIZE) {
            int end = Math.min(to, begin + Block.SIZE);
            int open = measureAll(begin, end);
            block.begin();
            if (cross == null) {
                relaxLike(open, sums, k);
            } else {
                relaxCross(cross, open, k);
            }
            if (sums) {
                continue;
            }
            if (touches != null) {
                touches.afterRelax(block.listed, block.carrying, block.unkept, block.unkeptCount, begin, end, k.dt);
            }
            if (last) {
                storeImpulses();
            } else {
                warmStart();
            }
        }
    }

    /** Measures contacts, and lists those that the relaxing pass has to do with; returns their number. */
    private int measureAll(int from, int to) {
        PairRows rows = this.rows;
        int[] listed = block.listed;
        float[] q = contacts.contact;
        int open = 0;
        for (int c = from; c < to; c++) {
            measure(c);
            int o = ContactRow.of(c);
            listed[open] = c;
            int idle = Constraints.isIdle(q[o + SEPARATION], q[o + NORMAL_IMPULSE], q[o + BOUNCE_SPEED]);
            open += 1 + (rows == null ? idle : idle & ~rows.hold(c));
        }
        return open;
    }

    /**
     * Visits the contacts that are listed, of circles of one level: within a visit, velocities stay in local variables.
     *
     * @param sums whether the impulses of contacts that carry go to the sums of their circles; else these contacts are listed
     */
    private void relaxLike(int open, boolean sums, StepConstants k) {
        LikeBodies like = this.like;
        PairRows rows = this.rows;
        Touches touches = this.touches;
        int[] listed = block.listed;
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
            float ax = m[a + VX];
            float ay = m[a + VY];
            float bx = m[b + VX];
            float by = m[b + VY];
            float vn = CircleMath.dot(nx, ny, bx - ax, by - ay);
            if (q[o + RESTITUTION] > 0f && impulse == 0f) {
                float loaded = load[a + LOADED] + load[b + LOADED];
                if (Constraints.flies(loaded, impulse, vn, q[o + FLIGHT_THRESHOLD]) != 0 && relaxFlying(c, a, b, vn)) {
                    continue;
                }
            }
            float next = Constraints.relax(impulse, q[o + MASS], vn, separation, bounce, k.inverseH);
            float applied = next - impulse;
            float invMassA = q[o + INV_MASS_A];
            float invMassB = q[o + INV_MASS_B];
            float after = vn + applied * (invMassA + invMassB);
            float along = CircleMath.dot(-ny, nx, bx - ax, by - ay);
            ax -= nx * (invMassA * applied);
            ay -= ny * (invMassA * applied);
            bx += nx * (invMassB * applied);
            by += ny * (invMassB * applied);
            if (rows != null) {
                boolean keep = !(bounce > 0f);
                rows.rollLike(like, c, a, b, next, keep);
                if (rows.grip(c)) {
                    float grip = rows.friction(c, along, like.surfaceSpeed(a), like.surfaceSpeed(b), next, keep);
                    ax -= -ny * (invMassA * grip);
                    ay -= nx * (invMassA * grip);
                    bx += -ny * (invMassB * grip);
                    by += nx * (invMassB * grip);
                    like.turn(a, b, -grip, -grip);
                }
            }
            m[a + VX] = ax;
            m[a + VY] = ay;
            m[b + VX] = bx;
            m[b + VY] = by;
            if (bounce > 0f) {
                if (touches != null) {
                    touches.add(c, impulse + applied);
                    block.addUnkept(c);
                }
                next = 0f;
            }
            q[o + NORMAL_IMPULSE] = next;
            float acting = PairRows.acting(rows, c, next);
            int carries = Constraints.carries(acting, separation, after, q[o + RESTITUTION_THRESHOLD]);
            if (!sums) {
                listed[carrying] = c;
                carrying -= carries;
            } else if (carries != 0) {
                addToSums(null, rows, c, a, b, nx, ny, next);
                load(a, b);
            }
        }
        block.carrying = carrying;
    }

    /** Visits the contacts that are listed, and lists those of them that carry. */
    private void relaxCross(CrossBodies cross, int open, StepConstants k) {
        PairRows rows = this.rows;
        int[] listed = block.listed;
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
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
            float threshold = q[o + RESTITUTION_THRESHOLD];
            float vn = cross.normalSpeed(c, nx, ny);
            if (q[o + RESTITUTION] > 0f && impulse == 0f) {
                float loaded = load[a + LOADED] + load[b + LOADED];
                if (Constraints.flies(loaded, impulse, vn, q[o + FLIGHT_THRESHOLD]) != 0 && relaxFlying(c, a, b, vn)) {
                    continue;
                }
            }
            float next = Constraints.relax(impulse, q[o + MASS], vn, separation, bounce, k.inverseH);
            float applied = next - impulse;
            float after = vn + applied * (q[o + INV_MASS_A] + q[o + INV_MASS_B]);
            float along = rows == null ? 0f : cross.normalSpeed(c, -ny, nx);
            cross.apply(c, nx, ny, applied);
            if (rows != null) {
                rows.visit(like, cross, c, a, b, nx, ny, along, next, !(bounce > 0f));
            }
            if (bounce > 0f) {
                next = 0f;
                if (touches != null) {
                    touches.add(c, impulse + applied);
                    block.addUnkept(c);
                }
            }
            q[o + NORMAL_IMPULSE] = next;
            listed[carrying] = c;
            carrying -= Constraints.carries(PairRows.acting(rows, c, next), separation, after, threshold);
        }
        block.carrying = carrying;
    }

    /** As {@link #solveFlying} without bias. */
    private boolean relaxFlying(int c, int a, int b, float vn) {
        int visit = visitOf(c, vn, 0, Constraints.ALWAYS);
        if (visit == Constraints.BOUNCE
                && !(cross != null && cross.waits(c, a, b, contacts.contact[ContactRow.of(c) + SEPARATION], true))) {
            bounce(c, a, b, vn);
            block.addUnkept(c);
        } else if (rows != null && visit != Constraints.SOLVE) {
            float[] q = contacts.contact;
            int o = ContactRow.of(c);
            float along = along(cross, c, a, b, q[o + NORMAL_X], q[o + NORMAL_Y]);
            rows.visit(like, cross, c, a, b, q[o + NORMAL_X], q[o + NORMAL_Y], along, 0f, false);
        }
        return visit != Constraints.SOLVE;
    }

    /** Adds the impulses of the contacts that carry, which are listed, to the sums of their circles, and marks these as loaded. */
    private void warmStart() {
        PairRows rows = this.rows;
        CrossBodies cross = this.cross;
        float[] q = contacts.contact;
        int[] pair = contacts.pair;
        for (int n = 0; n < block.carrying; n++) {
            int c = block.listed[n];
            int o = ContactRow.of(c);
            int a = pair[ContactRow.a(c)];
            int b = pair[ContactRow.b(c)];
            addToSums(cross, rows, c, a, b, q[o + NORMAL_X], q[o + NORMAL_Y], q[o + NORMAL_IMPULSE]);
            load(a, b);
        }
    }

    /** Stores the impulses of the contacts that carry for the step to come; one at rest may have none. */
    private void storeImpulses() {
        for (int n = 0; n < block.carrying; n++) {
            int c = block.listed[n];
            float impulse = contacts.contact[ContactRow.of(c) + NORMAL_IMPULSE];
            if (PairRows.acting(rows, c, impulse) > 0f) {
                contacts.storeImpulse(c, impulse);
                if (rows != null) {
                    rows.store(c);
                }
            }
        }
    }
}
