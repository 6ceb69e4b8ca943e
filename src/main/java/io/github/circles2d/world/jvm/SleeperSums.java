package io.github.circles2d.world.jvm;

import io.github.circles2d.world.jvm.bodies.WakingByBodies;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/** What presses circles that sleep as a step begins, by id, in sums of whole numbers; and what it takes to push one. */
final class SleeperSums {
    /** Sums of a circle: of impulses x, y, of those that carry it, and of those along its surface. */
    static final int COUNT = 4;

    static final int X = 0;
    static final int Y = 1;
    static final int LOAD = 2;
    static final int SPIN = 3;

    private final State state;
    private long[] sums = new long[0];

    /** Within a step. */
    StepConstants k;

    SleeperSums(State state) {
        this.state = state;
    }

    /** Makes room for ids; all sums are lost. */
    void ensure(int ids) {
        if (sums.length < COUNT * ids) {
            sums = new long[COUNT * ids];
        }
    }

    void clear(int id) {
        Arrays.fill(sums, COUNT * id, COUNT * (id + 1), 0L);
    }

    private float radius(int slot) {
        return state.circle[CircleRow.of(slot) + CircleRow.RADIUS];
    }

    private float range(int slot) {
        return CrossRule.impulseRange(radius(slot), k.inverseH, state.ownInverseMass(slot));
    }

    /** Adds the impulses of a contact along its normal, towards the circle if the side is 1, else -1, and its tangent; load: how hard it acts. */
    void press(int slot, float side, float x, float y, float j, float load, float f, float rolling) {
        add(slot, side * (x * j - y * f), side * (y * j + x * f), load, -f + side * rolling / radius(slot));
    }

    /** The same of the contact with a body that is shown, whose impulses get a scale. */
    void press(int slot, WakingByBodies bodies, float scale) {
        float j = bodies.impulse() * scale;
        press(slot, bodies.side(), bodies.nx(), bodies.ny(), j, j, bodies.grip() * scale, 0f);
    }

    void add(int slot, float x, float y, float load, float spin) {
        float scale = CrossRule.scaleOf(range(slot));
        int at = COUNT * state.id[slot];
        sums[at + X] += CrossRule.toFixed(x, scale);
        sums[at + Y] += CrossRule.toFixed(y, scale);
        sums[at + LOAD] += CrossRule.toFixed(load, scale);
        sums[at + SPIN] += CrossRule.toFixed(spin, scale);
    }

    /** A sum as it is added up. */
    long fixed(int id, int which) {
        return sums[COUNT * id + which];
    }

    float sum(int slot, int which) {
        return CrossRule.fromFixed(fixed(state.id[slot], which), CrossRule.unitOf(range(slot)));
    }

    float gainX(int slot) {
        return state.gainX(slot, state.ownInverseMass(slot), k);
    }

    float gainY(int slot) {
        return state.gainY(slot, state.ownInverseMass(slot), k);
    }

    float gainOfStep(int slot) {
        return CircleMath.length(gainX(slot), gainY(slot)) * (float) k.subSteps;
    }

    long bytes() {
        return 8L * sums.length;
    }

    /** What one that comes at a circle is about to add to its speed, as {@link Sleep#hit} has it. */
    float hit(int slot, float itsInverseMass, float approach, float gap, float restitution, float j) {
        return Sleep.hit(
                approach,
                gap,
                state.ownInverseMass(slot),
                itsInverseMass,
                restitution,
                j,
                gainOfStep(slot),
                radius(slot),
                k.dt);
    }

    /** The same of the contact with a body that is shown. */
    float hit(int slot, WakingByBodies bodies) {
        return hit(slot, bodies.inverseMass(), bodies.approach(), bodies.gap(), bodies.restitution(), bodies.impulse());
    }

    /** What of the speed that woke another one reaches a circle that this presses with j, of all that loads it, or that is a gap away. */
    float passedOn(int slot, float itsSpeed, float j, float load, float gap, float itsInverseMass) {
        float own = state.ownInverseMass(slot);
        return j > 0f
                ? Sleep.passedOn(itsSpeed, j, load, own, itsInverseMass, gainOfStep(slot))
                : Sleep.passedFreely(itsSpeed, gap, own, itsInverseMass, gainOfStep(slot), k.dt);
    }
}
