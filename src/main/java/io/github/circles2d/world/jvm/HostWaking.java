package io.github.circles2d.world.jvm;

import io.github.circles2d.world.bodies.RigidExtras;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.jvm.bodies.WakingByBodies;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.StepConstants;
import java.nio.IntBuffer;
import java.util.Arrays;

/**
 * The begin of a step in which bodies wake, in a world whose circles are on a device, which does there what {@link Waking} does here. What bodies do to
 * circles that sleep the host tells the device, and from ring to ring each of both tells the other one whom it has woken. A step may be refused after
 * that: then bodies sleep as before.
 */
public final class HostWaking implements WakingByBodies.Circles {
    /** Words of a circle that sleeps, as bodies tell a device of it, and that of them: see the next ones. */
    public static final int SLEEPER_WORDS = 12;

    public static final int SLEEPER_SLOT = 0;

    /** The speed that wakes it, or reaches it in a ring. */
    public static final int SLEEPER_SPEED = 1;

    /** From the device: the speed that has woken it. */
    public static final int SLEEPER_WOKEN_BY = 2;

    /** From the device: negative if it has woken, else what loads it. */
    public static final int SLEEPER_PRESSING = 3;

    /** The four sums of what presses it, each the lower half first. */
    public static final int SLEEPER_SUMS = 4;

    private final State state;
    private final WakingByBodies bodies;
    private final SleeperSums sums;

    /** The circles that sleep and that bodies touch, by their slots. */
    private int[] slots = new int[0];

    private int count;

    /** By slot: where a circle is among them, and 1; or 0. */
    private int[] placeOf = new int[0];

    // by place: the speed that wakes a circle, or that reaches it in a ring; the speed that has woken it; the ring in
    // which it woke; what loads it
    private float[] speed = new float[0];
    private float[] woke = new float[0];
    private int[] ring = new int[0];
    private float[] load = new float[0];

    /** Bodies that sleep as the step begins, and how. */
    private int[] asleep = new int[0];

    private int[] rests = new int[0];
    private int asleepCount;
    private boolean begun;

    // within a step
    private RigidStep step;
    private StepConstants k;

    HostWaking(State state, WakingByBodies bodies) {
        this.state = state;
        this.bodies = bodies;
        sums = new SleeperSums(state);
    }

    /** Finds whom bodies press and are about to push, and which bodies wake first; contacts have been found. */
    void begin(RigidStep ofStep, StepConstants constants) {
        step = ofStep;
        k = constants;
        sums.k = constants;
        remember();
        ensure();
        Arrays.fill(placeOf, 0, state.n, 0);
        count = 0;
        bodies.begin(step, k);
        for (int c = bodies.first(); c < bodies.count(); c++) {
            bodies.show(c);
            int slot = state.slotOf[bodies.circle()];
            if (slot >= state.awake) {
                int at = look(slot);
                sums.press(slot, bodies, 1f);
                speed[at] = CircleMath.max(speed[at], sums.hit(slot, bodies));
            }
        }
        for (int slot = state.awake; slot < state.n; slot++) {
            pressByResting(slot);
        }
        bodies.findWoken();
    }

    private void ensure() {
        sums.ensure(state.slotOf.length);
        if (slots.length < state.n) {
            int n = state.capacity();
            slots = new int[n];
            placeOf = new int[n];
            speed = new float[n];
            woke = new float[n];
            ring = new int[n];
            load = new float[n];
        }
    }

    private int look(int slot) {
        if (placeOf[slot] == 0) {
            slots[count] = slot;
            speed[count] = 0f;
            ring[count] = -1;
            sums.clear(state.id[slot]);
            placeOf[slot] = ++count;
        }
        return placeOf[slot] - 1;
    }

    /** Adds the contacts that stay. */
    private void pressByResting(int slot) {
        for (int e = bodies.firstOf(state.id[slot]); e >= 0; e = bodies.next(e)) {
            look(slot);
            if (bodies.measure(e)) {
                sums.press(slot, bodies, k.warmScale);
            }
        }
    }

    /** How many circles the device is told of. */
    public int count() {
        return count;
    }

    /** Puts what presses them and is about to push them, in rows of words as {@link #SLEEPER_WORDS}. */
    void put(IntBuffer to, int at, int[] deviceSlot) {
        for (int n = 0; n < count; n++) {
            int row = at + SLEEPER_WORDS * n;
            to.put(row + SLEEPER_SLOT, deviceSlot[slots[n]]);
            to.put(row + SLEEPER_SPEED, Float.floatToRawIntBits(speed[n]));
            for (int which = 0; which < SleeperSums.COUNT; which++) {
                long sum = sums.fixed(state.id[slots[n]], which);
                to.put(row + SLEEPER_SUMS + 2 * which, (int) sum);
                to.put(row + SLEEPER_SUMS + 2 * which + 1, (int) (sum >> Integer.SIZE));
            }
        }
    }

    // ---- rings

    /** Takes which circles the device has woken in a ring, the first of which is 0. */
    public void take(IntBuffer from, int at, int inRing) {
        for (int n = 0; n < count; n++) {
            int row = at + SLEEPER_WORDS * n;
            int pressing = from.get(row + SLEEPER_PRESSING);
            speed[n] = 0f;
            if (pressing >= 0) {
                load[n] = Float.intBitsToFloat(pressing);
            } else if (ring[n] < 0) {
                ring[n] = inRing;
                woke[n] = Float.intBitsToFloat(from.get(row + SLEEPER_WOKEN_BY));
            }
        }
    }

    /** Whether bodies have woken in the ring before. */
    public boolean hasRing() {
        return bodies.hasRing();
    }

    /** What has woken bodies, and circles among these, in the ring before reaches others. */
    public void passOn(int inRing) {
        bodies.beginRing();
        bodies.passOn(this);
        for (int n = 0; n < count; n++) {
            if (ring[n] == inRing - 1) {
                bodies.passOnFrom(state.id[slots[n]], woke[n]);
            }
        }
        bodies.endRing();
    }

    /** Makes all rings if no circle sleeps at bodies. */
    public void passOnAlone() {
        for (int inRing = 1; inRing < Sleep.RINGS && hasRing(); inRing++) {
            passOn(inRing);
        }
    }

    @Override
    public void reachFromBody(int id, float itsSpeed, float j, float gap, float itsInverseMass) {
        int slot = state.slotOf[id];
        int n = slot >= state.awake ? placeOf[slot] - 1 : -1;
        if (n >= 0 && ring[n] < 0) {
            speed[n] = CircleMath.max(speed[n], sums.passedOn(slot, itsSpeed, j, load[n], gap, itsInverseMass));
        }
    }

    /** Puts what reaches circles in a ring. */
    public void putReached(IntBuffer to, int at) {
        for (int n = 0; n < count; n++) {
            to.put(at + SLEEPER_WORDS * n + SLEEPER_SPEED, Float.floatToRawIntBits(speed[n]));
        }
    }

    /** Wakes all bodies that are to wake; returns whether there are any. */
    public boolean end() {
        return bodies.end();
    }

    // ---- steps that are refused

    private void remember() {
        begun = true;
        asleepCount = 0;
        if (asleep.length < step.end) {
            asleep = new int[step.room()];
            rests = new int[RigidExtras.RESTS * asleep.length];
        }
        for (int body = 0; body < step.end; body++) {
            if (step.outline[body] != null && step.isAsleep(body)) {
                int at = RigidExtras.RESTS * asleepCount;
                step.extras.save(body, RigidExtras.REST, RigidExtras.RESTS, rests, at);
                asleep[asleepCount++] = body;
            }
        }
    }

    /** The step goes on: nobody refuses it any more. */
    void keep() {
        begun = false;
    }

    /** The step is refused: if bodies have begun to wake, nothing has happened. */
    public void undo() {
        if (!begun) {
            return;
        }
        begun = false;
        for (int n = 0; n < asleepCount; n++) {
            int at = RigidExtras.RESTS * n;
            step.extras.load(asleep[n], RigidExtras.REST, RigidExtras.RESTS, rests, at);
        }
        bodies.lookAtAll();
    }

    long bytes() {
        return 4L * (6L * slots.length + asleep.length + rests.length) + sums.bytes();
    }
}
