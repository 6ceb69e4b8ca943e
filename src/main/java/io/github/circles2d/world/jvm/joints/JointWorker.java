package io.github.circles2d.world.jvm.joints;

import static io.github.circles2d.world.jvm.joints.JointWork.ALONE;
import static io.github.circles2d.world.jvm.joints.JointWork.BOTH;
import static io.github.circles2d.world.jvm.joints.JointWork.PLAIN;

import io.github.circles2d.world.jvm.state.JointStates;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepConstants;

/** What a worker does with joints: it begins them, and visits some of them one after the other in each pass. */
final class JointWorker {
    private final State state;
    private final JointStates states;
    private final JointView view;
    private final SpringVisits springs;
    private JointStep joints;
    private StepConstants k;
    private float[] work;
    private int[] slots;

    final JointPush push;
    final JointVisits visits;

    JointWorker(State state, JointStates states) {
        this.state = state;
        this.states = states;
        view = new JointView(state);
        push = new JointPush(state, view);
        visits = new JointVisits(states, view, push);
        springs = new SpringVisits(state, states);
    }

    void ensure(JointStep step, StepConstants constants, float[] itsWork, int[] itsSlots) {
        joints = step;
        k = constants;
        work = itsWork;
        slots = itsSlots;
        view.begin(step, states, constants, itsWork, itsSlots);
    }

    /**
     * Begins the step of a joint: it scales the impulses of the step before. False if the joint has broken. A step begins its joints once, even if it
     * lists its contacts twice.
     */
    boolean begin(int place) {
        int joint = joints.order[place];
        int at = JointWork.slots(place);
        if (!states.begin(joint, joints)) {
            slots[at + JointWork.A] = JointWork.NONE;
            return false;
        }
        int traits = JointRow.traits(joint);
        slots[at + JointWork.A] = state.slotOf[joints.traits[traits + JointRow.A]];
        int idB = joints.traits[traits + JointRow.B];
        slots[at + JointWork.B] = idB == JointRow.NONE ? JointWork.NONE : state.slotOf[idB];
        slots[at + JointWork.STILL] =
                still(slots[at + JointWork.A], JointWork.STILL_A) | still(slots[at + JointWork.B], JointWork.STILL_B);
        view.take(place);
        slots[at + JointWork.KIND] = kind(place);
        work[JointWork.of(place) + JointWork.SHARE_A] = 1f;
        work[JointWork.of(place) + JointWork.SHARE_B] = 1f;
        boolean exact = view.isLinearExact();
        view.scale(exact, exact && view.linear() == JointRow.POINT, view.isAngularExact());
        return true;
    }

    private int still(int slot, int bit) {
        return state.sleepers != null && slot >= 0 && state.sleepers.isAsleep(state.id[slot]) ? bit : 0;
    }

    private int kind(int place) {
        if (view.relaxes()) {
            return BOTH;
        }
        boolean plain = view.linear() == JointRow.AXIAL
                && view.has(JointRow.ELASTIC)
                && view.angular() == 0
                && view.hasB()
                && slots[JointWork.slots(place) + JointWork.STILL] == 0
                && place < joints.splitStart;
        return plain ? PLAIN : ALONE;
    }

    /** Whether the joint of a place does something in this step. */
    boolean acts(int place) {
        return slots[JointWork.slots(place) + JointWork.A] >= 0;
    }

    /** As those of {@link JointView}, of the joint of the last visit. */
    float givenMassA() {
        return view.givenMassA();
    }

    float givenMassB() {
        return view.givenMassB();
    }

    /** Whether it does something without bias, too, and keeps impulses. */
    boolean relaxes(int place) {
        return slots[JointWork.slots(place) + JointWork.KIND] == BOTH;
    }

    void prepare(int from, int to) {
        for (int place = from; place < to; place++) {
            if (acts(place)) {
                prepare(place);
            }
        }
    }

    private void prepare(int place) {
        visits.prepare(place);
        if (relaxes(place)) {
            push.loadCircles();
            push.giveToSums();
        } else if (isPlain(place)) {
            springs.prepare(view);
        }
    }

    private boolean isPlain(int place) {
        return slots[JointWork.slots(place) + JointWork.KIND] == PLAIN;
    }

    void solve(int from, int to, int sub) {
        for (int place = from; place < to; place++) {
            if (!acts(place)) {
                continue;
            }
            if (isPlain(place)) {
                int at = JointWork.slots(place);
                int a = CircleRow.of(slots[at + JointWork.A]);
                springs.visit(work, JointWork.of(place), a, CircleRow.of(slots[at + JointWork.B]), k);
            } else {
                visits.solve(place, sub);
                push.give();
            }
        }
    }

    void relax(int from, int to, int sub, boolean last) {
        for (int place = from; place < to; place++) {
            if (acts(place) && relaxes(place)) {
                visits.relax(place, sub);
                push.give();
                visits.end(place);
                push.loadCircles();
                if (!last) {
                    push.giveToSums();
                }
            } else if (last && acts(place) && isPlain(place)) {
                springs.end(work, JointWork.of(place), joints.order[place]);
            }
        }
    }
}
