package io.github.circles2d.world.jvm;

import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/**
 * The joints' part of stage Solver: passes between those over like and over cross contacts. {@link JointStep} has the order; each worker takes some of
 * the batches, and then its share of each colour of the joints that are in none. {@link JointWorker} treats them.
 */
final class JointPasses {
    /** Joints of a colour from which on workers share them; fewer are not worth it. */
    private static final int LEAST_SHARE = 64;

    // what a pass does with a joint
    private static final int PREPARE = 0;
    private static final int SOLVE = 1;
    private static final int RELAX = 2;
    private static final int RELAX_LAST = 3;

    final JointStates states = new JointStates();
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

    JointPasses(State state, Team team) {
        this.state = state;
        this.team = team;
        split = new SplitJoints(state);
        workers = new JointWorker[team.most()];
        for (int worker = 0; worker < workers.length; worker++) {
            workers[worker] = new JointWorker(state, states);
        }
    }

    long bytes() {
        return states.bytes() + split.bytes() + 4L * (work.length + slots.length) + jointed.length;
    }

    /** Makes room for a step; one worker does it for all. */
    void ensure(JointStep step, StepConstants constants) {
        joints = step;
        k = constants;
        states.ensure(joints.joints);
        split.ensure(joints.splitCircles);
        if (JointWork.of(joints.count) > work.length) {
            int room = joints.count + (joints.count >> 1) + 16;
            int[] newSlots = new int[JointWork.slots(room)];
            float[] newWork = new float[JointWork.of(room)];
            slots = newSlots;
            work = newWork;
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
    void begin(int worker) {
        Arrays.fill(jointed, team.part(state.awake, worker), team.part(state.awake, worker + 1), false);
        team.sync(worker);
        int to = team.part(joints.count, worker + 1);
        for (int place = team.part(joints.count, worker); place < to; place++) {
            if (workers[worker].begin(place)) {
                mark(slots[JointWork.slots(place) + JointWork.A]);
                mark(slots[JointWork.slots(place) + JointWork.B]);
            }
        }
        team.sync(worker);
    }

    private void mark(int slot) {
        if (slot >= 0) {
            jointed[slot] = true;
        }
    }

    void prepare(int worker) {
        pass(worker, PREPARE, 0);
        if (joints.splits()) {
            if (worker == 0) {
                split.prepare(joints, workers[0], work, k);
            }
            team.sync(worker);
        }
    }

    void solve(int worker, int sub) {
        pass(worker, SOLVE, sub);
        if (joints.splits()) {
            if (worker == 0) {
                split.solve(sub);
            }
            team.sync(worker);
        }
    }

    void relax(int worker, int sub) {
        boolean last = sub == k.subSteps - 1;
        pass(worker, last ? RELAX_LAST : RELAX, sub);
        if (joints.splits()) {
            if (worker == 0) {
                split.relax(sub);
                split.end(last);
            }
            team.sync(worker);
        }
        if (last && worker == 0) {
            if (joints.breakable) {
                breakJoints();
            }
            states.endStep();
        }
    }

    /** A pass over the joints that have a colour. */
    private void pass(int worker, int what, int sub) {
        JointWorker own = workers[worker];
        int to = team.part(joints.batches, worker + 1);
        for (int batch = team.part(joints.batches, worker); batch < to; batch++) {
            int first = JointStep.BATCH_STRIDE * batch;
            visit(own, what, sub, joints.starts[first], joints.starts[first + JointStep.COLOURS]);
        }
        team.sync(worker);
        int first = JointStep.BATCH_STRIDE * joints.batches;
        for (int colour = first; colour < first + joints.colours; colour++) {
            visitShare(worker, own, what, sub, joints.starts[colour], joints.starts[colour + 1]);
        }
    }

    private void visitShare(int worker, JointWorker own, int what, int sub, int from, int to) {
        int joints = to - from;
        if (joints == 0) {
            return;
        }
        if (joints >= LEAST_SHARE) {
            visit(own, what, sub, from + team.part(joints, worker), from + team.part(joints, worker + 1));
        } else if (worker == 0) {
            visit(own, what, sub, from, to);
        }
        team.sync(worker);
    }

    private static void visit(JointWorker own, int what, int sub, int from, int to) {
        switch (what) {
            case PREPARE -> own.prepare(from, to);
            case SOLVE -> own.solve(from, to, sub);
            default -> own.relax(from, to, sub, what == RELAX_LAST);
        }
    }

    private void breakJoints() {
        for (int place = 0; place < joints.count; place++) {
            if (workers[0].acts(place) && workers[0].visits.breaks(place)) {
                states.breakJoint(joints.order[place]);
            }
        }
    }
}
