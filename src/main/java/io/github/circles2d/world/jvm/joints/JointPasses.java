package io.github.circles2d.world.jvm.joints;

import io.github.circles2d.world.jvm.state.JointStates;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/**
 * The joints' part of stage Solver: passes between those over like and over cross contacts. {@link JointStep} has the order; each worker takes some of
 * the batches, and then its share of each colour of the joints that are in none. {@link JointWorker} treats them.
 */
public final class JointPasses {
    /** Joints of a colour from which on workers share them; fewer are not worth it. */
    private static final int LEAST_SHARE = 64;

    // what a pass does with a joint
    private static final int PREPARE = 0;
    private static final int SOLVE = 1;
    private static final int RELAX = 2;
    private static final int RELAX_LAST = 3;

    public final JointStates states = new JointStates();

    /** Of a world whose circles sleep. */
    public final RestingJoints resting;

    private final State state;
    private final Team team;
    private final JointWorker[] workers;
    private final SplitJoints split;
    private JointStep joints;
    private StepConstants k;
    private float[] work = new float[0];
    private int[] slots = new int[0];

    /** By slot: whether a joint holds the circle. */
    private boolean[] jointed = new boolean[0];

    private final Team.Work clear = this::clear;
    private final Team.Work begin = this::begin;
    private final Team.Work visitBatches = this::visitBatches;
    private final Team.Work visitShare = this::visitShare;

    // of the pass
    private int what;
    private int sub;

    // of the colour: its first joint and the one behind its last
    private int from;
    private int to;

    public JointPasses(State state, Team team) {
        this.state = state;
        this.team = team;
        split = new SplitJoints(state);
        resting = new RestingJoints(state, states);
        workers = new JointWorker[team.most()];
        for (int worker = 0; worker < workers.length; worker++) {
            workers[worker] = new JointWorker(state, states);
        }
    }

    public long bytes() {
        return states.bytes() + split.bytes() + resting.bytes() + 4L * (work.length + slots.length) + jointed.length;
    }

    /** Makes room for a step. */
    public void ensure(JointStep step, StepConstants constants) {
        states.ensure(step.joints);
        joints = state.sleepers == null ? step : resting.awake(step);
        k = constants;
        split.ensure(joints.splitCircles);
        if (JointWork.of(joints.count) > work.length) {
            int room = joints.count + (joints.count >> 1) + 16;
            slots = new int[JointWork.slots(room)];
            work = new float[JointWork.of(room)];
        }
        if (state.n > jointed.length) {
            jointed = new boolean[state.capacity()];
        }
        state.jointed = jointed;
        for (JointWorker each : workers) {
            each.ensure(joints, k, work, slots);
        }
    }

    /** Begins the joints of a step, once their circles have slots, and finds out which circles they hold. */
    public void begin() {
        if (state.sleepers != null) {
            resting.scale(k.warmScale);
        }
        team.all(clear);
        team.all(begin);
    }

    private void clear(int worker) {
        Arrays.fill(jointed, team.part(state.awake, worker), team.part(state.awake, worker + 1), false);
    }

    private void begin(int worker) {
        int end = team.part(joints.count, worker + 1);
        for (int place = team.part(joints.count, worker); place < end; place++) {
            if (workers[worker].begin(place)) {
                mark(slots[JointWork.slots(place) + JointWork.A]);
                mark(slots[JointWork.slots(place) + JointWork.B]);
            }
        }
    }

    /** Takes note of circles that joints hold to rigid bodies, which are none of these passes. Some may have broken. */
    public void beginRigid(JointStep all) {
        for (int n = 0; n < all.rigidCount; n++) {
            int joint = all.rigidOrder[n];
            int traits = JointRow.traits(joint);
            for (int end = JointRow.A; end <= JointRow.B; end++) {
                if (all.traits[traits + end] != JointRow.NONE && !states.hasBroken(joint, all)) {
                    mark(state.slotOf[all.traits[traits + end]]);
                }
            }
        }
    }

    private void mark(int slot) {
        if (slot >= 0) {
            jointed[slot] = true;
            if (slot >= state.awake) {
                beginResting(slot);
            }
        }
    }

    /** Makes a circle ready of which no other stage takes notice, as those in slots before it. Several workers may do it. */
    private void beginResting(int slot) {
        Arrays.fill(state.load, CircleRow.of(slot), CircleRow.of(slot + 1), 0f);
        if (k.turning) {
            state.turning.begin(slot, slot + 1);
        }
    }

    public void prepare() {
        pass(PREPARE, 0);
        if (joints.splits()) {
            split.prepare(joints, workers[0], work, k);
        }
    }

    public void solve(int subStep) {
        pass(SOLVE, subStep);
        if (joints.splits()) {
            split.solve(subStep);
        }
    }

    public void relax(int subStep) {
        boolean last = subStep == k.subSteps - 1;
        pass(last ? RELAX_LAST : RELAX, subStep);
        if (joints.splits()) {
            split.relax(subStep);
            split.end(last);
        }
    }

    /** Ends a step: joints break. Those of rigid bodies have broken before. */
    public void end() {
        if (joints.breakable) {
            breakJoints();
        }
        states.endStep();
    }

    /** A pass over the joints that have a colour. */
    private void pass(int kind, int subStep) {
        what = kind;
        sub = subStep;
        if (joints.batches > 0) {
            team.all(visitBatches);
        }
        int first = JointStep.BATCH_STRIDE * joints.batches;
        for (int colour = first; colour < first + joints.colours; colour++) {
            from = joints.starts[colour];
            to = joints.starts[colour + 1];
            if (to - from >= LEAST_SHARE) {
                team.all(visitShare);
            } else if (from < to) {
                visit(workers[0], from, to);
            }
        }
    }

    private void visitBatches(int worker) {
        int end = team.part(joints.batches, worker + 1);
        for (int batch = team.part(joints.batches, worker); batch < end; batch++) {
            int first = JointStep.BATCH_STRIDE * batch;
            visit(workers[worker], joints.starts[first], joints.starts[first + JointStep.COLOURS]);
        }
    }

    private void visitShare(int worker) {
        visit(workers[worker], from + team.part(to - from, worker), from + team.part(to - from, worker + 1));
    }

    private void visit(JointWorker own, int first, int end) {
        switch (what) {
            case PREPARE -> own.prepare(first, end);
            case SOLVE -> own.solve(first, end, sub);
            default -> own.relax(first, end, sub, what == RELAX_LAST);
        }
    }

    private void breakJoints() {
        for (int place = 0; place < joints.count; place++) {
            if (workers[0].acts(place) && workers[0].visits.breaks(place)) {
                states.breakJoint(joints.order[place]);
                if (state.sleepers != null) {
                    resting.tear(joints.order[place]);
                }
            }
        }
    }
}
