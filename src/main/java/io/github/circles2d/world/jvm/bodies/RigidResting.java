package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.bodies.KeptContacts;
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

    /** Contacts of the step before as they are to stay. */
    final KeptContacts kept = new KeptContacts();

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
        int b = step.contacts.b(o);
        return step.isAsleep(step.contacts.a(o))
                && switch (step.contacts.type(o)) {
                    case RigidStep.BODY_BODY -> step.isAsleep(b);
                    case RigidStep.BODY_CIRCLE -> pairs.isStill(state.slotOf[b]);
                    default -> true;
                };
    }

    /** Whether all contacts of the step before are at rest. */
    boolean areAll(RigidStep step) {
        boolean all = true;
        for (int o = 0; all && o < step.contacts.count; o++) {
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
        KeptContacts contacts = step.contacts;
        if (next.length < 2 * contacts.count) {
            next = new int[3 * contacts.count];
        }
        Arrays.fill(ofBody, -1);
        Arrays.fill(ofCircle, -1);
        for (int o = 0; o < step.contacts.count; o++) {
            if (rests(step, o)) {
                next[2 * o] = ofBody[contacts.a(o)];
                ofBody[contacts.a(o)] = 2 * o;
                int[] ofOther = contacts.type(o) == RigidStep.BODY_BODY
                        ? ofBody
                        : contacts.type(o) == RigidStep.BODY_CIRCLE ? ofCircle : null;
                if (ofOther != null) {
                    next[2 * o + 1] = ofOther[contacts.b(o)];
                    ofOther[contacts.b(o)] = 2 * o + 1;
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
        kept.count = 0;
        kept.ensure(step.contacts.count);
        for (int o = 0; o < step.contacts.count; o++) {
            if (rests(step, o)) {
                kept.add(step.contacts, o);
            }
        }
        for (int i = 0; i < KeptContacts.IMPULSES * kept.count; i++) {
            kept.impulses[i] *= scale;
        }
    }

    /** Gives back what comes before a pair, from one on; returns the first that does not. */
    int keepBefore(RigidStep step, int from, int type, int a, int b) {
        int rest = from;
        while (rest < kept.count && kept.compare(rest, type, a, b) < 0) {
            step.contacts.add(kept, rest++);
        }
        return rest;
    }

    long bytes() {
        return kept.bytes() + 4L * (ofBody.length + ofCircle.length + next.length);
    }
}
