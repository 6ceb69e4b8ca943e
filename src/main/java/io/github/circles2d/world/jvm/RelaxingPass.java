package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.jvm.ContactRow.BASE_X;
import static io.github.circles2d.world.jvm.ContactRow.BASE_Y;
import static io.github.circles2d.world.jvm.ContactRow.BOUNCE_SPEED;
import static io.github.circles2d.world.jvm.ContactRow.NORMAL_IMPULSE;
import static io.github.circles2d.world.jvm.ContactRow.NORMAL_X;
import static io.github.circles2d.world.jvm.ContactRow.NORMAL_Y;
import static io.github.circles2d.world.jvm.ContactRow.RADII;
import static io.github.circles2d.world.jvm.ContactRow.SEPARATION;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;

import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.Constraints;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Tuning;

/**
 * The frame of the relaxing pass, which both kinds of contacts share: measure all, visit those that have something to do, and hand the
 * impulses of those that carry over to the next sub-step or to the next step.
 */
abstract class RelaxingPass {
    /** Contacts that the pass works on at a time. */
    private static final int BLOCK = 256;

    final State state;
    final Contacts contacts;

    /** Contacts of a block that are still to do something with. */
    final int[] listed = new int[BLOCK];

    RelaxingPass(State state, Contacts contacts) {
        this.state = state;
        this.contacts = contacts;
    }

    /** Visits the contacts that are listed, and lists those of them that carry; returns their number. */
    abstract int relaxOpen(int open, StepConstants k);

    /** Adds the impulses of the contacts that carry, which are listed, to the sums of their circles, and marks these as loaded. */
    abstract void warmStart(int carrying);

    /** Stores a contact's impulse for the step to come. */
    abstract void store(int c, float normalImpulse);

    /** The relaxing pass: measures the contacts anew, takes the push-out speed away again, and sums up for what follows. */
    final void relax(int from, int to, StepConstants k, boolean last) {
        for (int block = from; block < to; block += BLOCK) {
            int open = measureAll(block, Math.min(to, block + BLOCK));
            int carrying = relaxOpen(open, k);
            if (last) {
                storeImpulses(carrying);
            } else {
                warmStart(carrying);
            }
        }
    }

    /** Measures contacts, and lists those that the relaxing pass has to do with; returns their number. */
    private int measureAll(int from, int to) {
        float[] q = contacts.contact;
        int open = 0;
        for (int c = from; c < to; c++) {
            measure(c);
            int o = ContactRow.of(c);
            listed[open] = c;
            open += 1 + Constraints.isIdle(q[o + SEPARATION], q[o + NORMAL_IMPULSE], q[o + BOUNCE_SPEED]);
        }
        return open;
    }

    /** Measures a contact: separation, and the normal where there is a direction. */
    final void measure(int c) {
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

    /** Stores the impulses of the contacts that carry for the step to come; one at rest may have none. */
    private void storeImpulses(int carrying) {
        for (int n = 0; n < carrying; n++) {
            float impulse = contacts.contact[ContactRow.of(listed[n]) + NORMAL_IMPULSE];
            if (impulse > 0f) {
                store(listed[n], impulse);
            }
        }
    }
}
