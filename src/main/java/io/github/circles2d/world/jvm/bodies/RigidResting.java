package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.jvm.state.State;
import java.util.Arrays;

/**
 * The contacts of bodies that sleep with what does not move: with others that sleep, with pieces, walls and static circles. A step neither finds nor
 * visits them; they stay as they are.
 */
final class RigidResting {
    private final State state;
    private final RigidPairs pairs;

    /** Contacts of the step before, in their order, as they are to stay. */
    int count;

    private int[] keys = new int[0];
    private float[] impulses = new float[0];

    /** By body and by circle: one of its contacts, as twice a number and the side; -1 if it has none. */
    private int[] ofBody = new int[0];

    private int[] ofCircle = new int[0];

    /** The next one of a thing. */
    private int[] next = new int[0];

    private boolean listed;

    RigidResting(State state, RigidPairs pairs) {
        this.state = state;
        this.pairs = pairs;
    }

    /** A step begins, or others sleep. */
    void begin() {
        listed = false;
    }

    /** Whether both things of a contact of the step before rest. */
    private boolean rests(RigidStep step, int o) {
        int at = RigidStep.KEYS * o;
        int b = step.contactKeys[at + RigidStep.B];
        return step.isAsleep(step.contactKeys[at + RigidStep.A])
                && switch (step.contactKeys[at + RigidStep.TYPE]) {
                    case RigidStep.BODY_BODY -> step.isAsleep(b);
                    case RigidStep.BODY_CIRCLE -> pairs.isStill(state.slotOf[b]);
                    default -> true;
                };
    }

    /** Whether all contacts of the step before are at rest. */
    boolean areAll(RigidStep step) {
        boolean all = true;
        for (int o = 0; all && o < step.contacts; o++) {
            all = rests(step, o);
        }
        return all;
    }

    // ---- of a thing

    /** Lists the contacts by their things. */
    private void list(RigidStep step) {
        if (listed) {
            return;
        }
        listed = true;
        if (ofBody.length < step.room()) {
            ofBody = new int[step.room()];
        }
        if (ofCircle.length < state.slotOf.length) {
            ofCircle = new int[state.slotOf.length];
        }
        if (next.length < 2 * step.contacts) {
            next = new int[3 * step.contacts];
        }
        Arrays.fill(ofBody, -1);
        Arrays.fill(ofCircle, -1);
        for (int o = 0; o < step.contacts; o++) {
            if (rests(step, o)) {
                int at = RigidStep.KEYS * o;
                int a = step.contactKeys[at + RigidStep.A];
                int b = step.contactKeys[at + RigidStep.B];
                next[2 * o] = ofBody[a];
                ofBody[a] = 2 * o;
                if (step.contactKeys[at + RigidStep.TYPE] == RigidStep.BODY_BODY) {
                    next[2 * o + 1] = ofBody[b];
                    ofBody[b] = 2 * o + 1;
                } else if (step.contactKeys[at + RigidStep.TYPE] == RigidStep.BODY_CIRCLE) {
                    next[2 * o + 1] = ofCircle[b];
                    ofCircle[b] = 2 * o + 1;
                }
            }
        }
    }

    /** The first entry of a body; half of it is the number of a contact of the step before, odd if the body is the second one. */
    int firstOfBody(RigidStep step, int body) {
        list(step);
        return ofBody[body];
    }

    /** The same of a circle. */
    int firstOfCircle(RigidStep step, int circle) {
        list(step);
        return ofCircle[circle];
    }

    int next(int entry) {
        return next[entry];
    }

    // ---- what stays

    /** Takes what is to stay, since the step writes over it; it gets another scale if the length of steps does. */
    void take(RigidStep step, float scale) {
        count = 0;
        if (keys.length < RigidStep.KEYS * step.contacts) {
            keys = new int[step.contactKeys.length];
            impulses = new float[step.contactImpulses.length];
        }
        for (int o = 0; o < step.contacts; o++) {
            if (rests(step, o)) {
                System.arraycopy(step.contactKeys, RigidStep.KEYS * o, keys, RigidStep.KEYS * count, RigidStep.KEYS);
                for (int i = 0; i < RigidStep.IMPULSES; i++) {
                    impulses[RigidStep.IMPULSES * count + i] = scale * step.contactImpulses[RigidStep.IMPULSES * o + i];
                }
                count++;
            }
        }
    }

    /** Gives back what comes before a pair, from one on; returns the first that does not. */
    int keepBefore(RigidStep step, int from, int type, int a, int b) {
        int rest = from;
        while (rest < count && RigidStep.compare(keys, RigidStep.KEYS * rest, type, a, b) < 0) {
            System.arraycopy(
                    keys, RigidStep.KEYS * rest, step.contactKeys, RigidStep.KEYS * step.contacts, RigidStep.KEYS);
            System.arraycopy(
                    impulses,
                    RigidStep.IMPULSES * rest,
                    step.contactImpulses,
                    RigidStep.IMPULSES * step.contacts,
                    RigidStep.IMPULSES);
            step.contacts++;
            rest++;
        }
        return rest;
    }

    /** Tells a step of the pairs. */
    void publish(RigidStep step) {
        if (step.restingKeys.length < RigidStep.TOUCH_KEYS * count) {
            step.restingKeys = new int[RigidStep.TOUCH_KEYS * Math.max(64, 2 * count)];
        }
        step.resting = count;
        for (int rest = 0; rest < count; rest++) {
            System.arraycopy(
                    keys, RigidStep.KEYS * rest, step.restingKeys, RigidStep.TOUCH_KEYS * rest, RigidStep.TOUCH_KEYS);
        }
    }

    long bytes() {
        return 4L * (keys.length + impulses.length + ofBody.length + ofCircle.length + next.length);
    }
}
