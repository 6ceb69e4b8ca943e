package io.github.circles2d.world.jvm.joints;

import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.jvm.state.ImpulseCache;
import io.github.circles2d.world.jvm.state.JointStates;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointRules;
import io.github.circles2d.world.model.JointState;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/**
 * Joints in a world whose circles sleep. A joint rests if one of its circles sleeps and none that a step could move is awake: steps leave it
 * out, and it keeps its impulses. So a bridge at rest costs nothing.
 */
public final class RestingJoints {
    private static final int NONE = -1;

    private final State state;
    private final JointStates states;

    /** Those of the step. */
    private JointStep all;

    /** What the step is told of those that do not rest. */
    private final JointStep awake = new JointStep();

    // of what awake, the joints of circles and those that drive were found
    private int order = NONE;
    private int version = NONE;
    private int sleepers = NONE;

    /** By id of a circle, and one more: where its joints begin. */
    private int[] first = new int[1];

    private int[] joints = new int[0];

    /** Joints that drive what they hold. */
    private int[] driving = new int[0];

    private int drivingCount;

    /** Joints of a circle that sleeps and one that is awake. */
    private int[] bordering = new int[0];

    private int borderingCount;

    // as measured last, from A to B
    private float nx;
    private float ny;

    /** By id: whether a joint drives the circle, or has broken; for the end of a step. */
    private boolean[] driven = new boolean[0];

    /** Ids of circles whose joints have broken in the step. */
    private int[] torn = new int[0];

    private int tornCount;

    RestingJoints(State state, JointStates states) {
        this.state = state;
        this.states = states;
    }

    long bytes() {
        return 4L
                        * (first.length
                                + joints.length
                                + driving.length
                                + bordering.length
                                + torn.length
                                + awake.order.length)
                + 4L * (awake.starts.length + awake.splitEnds.length)
                + driven.length;
    }

    // ---- what a step is told

    /** The joints of a step that do not rest. */
    JointStep awake(JointStep step) {
        all = step;
        if (driven.length < state.slotOf.length) {
            driven = new boolean[state.slotOf.length];
        }
        boolean sameOrder = order == step.orderVersion;
        if (!sameOrder) {
            makeRoom();
            listByCircle();
        }
        if (!sameOrder || version != step.version) {
            listDriving();
        }
        if (!sameOrder || sleepers != state.sleepers.version) {
            listAwake();
        }
        order = step.orderVersion;
        version = step.version;
        sleepers = state.sleepers.version;
        awake.joints = all.joints;
        awake.rows = all.rows;
        awake.traits = all.traits;
        awake.springs = all.springs;
        awake.anchors = all.anchors;
        awake.breakable = all.breakable;
        return awake;
    }

    private void makeRoom() {
        int count = all.count;
        if (awake.order.length < count) {
            int room = count + (count >> 1) + 16;
            torn = new int[2 * room];
            awake.splitEnds = new int[2 * room];
            joints = new int[2 * room];
            driving = new int[room];
            bordering = new int[room];
            awake.order = new int[room];
        }
        if (awake.starts.length < all.starts.length) {
            awake.starts = new int[all.starts.length];
        }
        if (first.length <= state.slotOf.length) {
            first = new int[state.slotOf.length + 1];
        }
    }

    public int a(int joint) {
        return all.traits[JointRow.traits(joint) + JointRow.A];
    }

    /** {@link JointRow#NONE} if it holds a circle to no other. */
    public int b(int joint) {
        return all.traits[JointRow.traits(joint) + JointRow.B];
    }

    private void listByCircle() {
        Arrays.fill(first, 0);
        for (int n = 0; n < all.count; n++) {
            first[a(all.order[n])]++;
            if (b(all.order[n]) != JointRow.NONE) {
                first[b(all.order[n])]++;
            }
        }
        for (int id = 1; id < first.length; id++) {
            first[id] += first[id - 1]; // where its joints end
        }
        for (int n = 0; n < all.count; n++) {
            joints[--first[a(all.order[n])]] = all.order[n];
            if (b(all.order[n]) != JointRow.NONE) {
                joints[--first[b(all.order[n])]] = all.order[n];
            }
        }
    }

    private void listDriving() {
        drivingCount = 0;
        for (int n = 0; n < all.count; n++) {
            int row = JointRow.of(all.order[n]);
            int traits = JointRow.traits(all.order[n]);
            if (Sleep.drives(
                    all.traits[traits + JointRow.FORM] & JointRow.ANGULAR,
                    all.rows[row + JointRow.SPEED],
                    all.rows[row + JointRow.MAX_TORQUE],
                    all.traits[traits + JointRow.ANCHOR])) {
                driving[drivingCount++] = all.order[n];
            }
        }
    }

    private void listAwake() {
        borderingCount = 0;
        int count = 0;
        int starts = JointStep.BATCH_STRIDE * (all.batches + 1);
        for (int k = 0; k < starts; k++) {
            awake.starts[k] = count;
            // the last colour of a batch ends where the next batch begins
            int to = k + 1 < starts ? all.starts[k + 1] : all.starts[k];
            for (int n = all.starts[k]; n < to; n++) {
                if (isAwake(all.order[n])) {
                    awake.order[count++] = all.order[n];
                }
            }
        }
        awake.splitStart = count;
        for (int n = all.splitStart; n < all.count; n++) {
            if (isAwake(all.order[n])) {
                System.arraycopy(
                        all.splitEnds, 2 * (n - all.splitStart), awake.splitEnds, 2 * (count - awake.splitStart), 2);
                awake.order[count++] = all.order[n];
            }
        }
        awake.count = count;
        awake.batches = all.batches;
        awake.colours = all.colours;
        awake.splitCircles = all.splitCircles;
        awake.splitIds = all.splitIds;
    }

    /** Whether a joint does not rest. Lists it if one of its circles sleeps. */
    private boolean isAwake(int joint) {
        boolean sleeps = sleeps(joint);
        if (sleeps && rests(joint)) {
            return false;
        }
        if (sleeps) {
            bordering[borderingCount++] = joint;
        }
        return true;
    }

    private boolean sleeps(int joint) {
        return state.sleepers.isAsleep(a(joint)) || b(joint) != JointRow.NONE && state.sleepers.isAsleep(b(joint));
    }

    private boolean rests(int joint) {
        return sleeps(joint)
                && state.isStatic(state.slotOf[a(joint)])
                && (b(joint) == JointRow.NONE || state.isStatic(state.slotOf[b(joint)]));
    }

    /** Another length of steps takes other impulses, also of joints that rest. */
    void scale(float by) {
        if (by == 1f || awake.count == all.count) {
            return;
        }
        for (int n = 0; n < all.count; n++) {
            int joint = all.order[n];
            if (isThere(joint) && rests(joint)) {
                for (int k = JointState.of(joint); k < JointState.of(joint + 1); k++) {
                    states.rows[k] *= by;
                }
            }
        }
    }

    // ---- the joints of a circle

    /** The first entry of a circle; of the id behind it: the end. */
    public int first(int id) {
        return id < first.length ? first[id] : first[first.length - 1];
    }

    public int joint(int entry) {
        return joints[entry];
    }

    /** Whether a joint has begun, and has not broken. */
    public boolean isThere(int joint) {
        return states.serial[joint] == all.traits[JointRow.traits(joint) + JointRow.SERIAL];
    }

    public int bordering() {
        return borderingCount;
    }

    public int borderingAt(int k) {
        return bordering[k];
    }

    public int driving() {
        return drivingCount;
    }

    public int drivingAt(int k) {
        return driving[k];
    }

    /** What holds a circle: the id of another one, or {@link JointRow#NONE}. */
    public int other(int joint, int id) {
        return a(joint) == id ? b(joint) : a(joint);
    }

    public boolean isA(int joint, int id) {
        return a(joint) == id;
    }

    /** The circle that sleeps of a joint of another one that is awake. */
    public int sleeper(int joint) {
        return state.sleepers.isAsleep(a(joint)) ? a(joint) : b(joint);
    }

    /** The number of their order. */
    public int order() {
        return order;
    }

    public boolean has(int joint, int flag) {
        return (all.traits[JointRow.traits(joint) + JointRow.FORM] & flag) != 0;
    }

    /** A number of {@link JointRow}. */
    public float value(int joint, int which) {
        return all.rows[JointRow.of(joint) + which];
    }

    private boolean turns(int joint) {
        return JointRules.turns(all.traits[JointRow.traits(joint) + JointRow.FORM]);
    }

    /** Whether a joint turns a circle. */
    public boolean turn(int id) {
        boolean turn = false;
        for (int entry = first(id); entry < first(id + 1); entry++) {
            turn |= isThere(joints[entry]) && turns(joints[entry]);
        }
        return turn;
    }

    // ---- what a joint did in the last step, as this one goes on from it

    public float sumX(int joint, StepConstants k) {
        return sum(joint, JointState.SUM_X, k);
    }

    public float sumY(int joint, StepConstants k) {
        return sum(joint, JointState.SUM_Y, k);
    }

    public float twist(int joint, StepConstants k) {
        return sum(joint, JointState.SUM_ANGULAR, k);
    }

    private float sum(int joint, int which, StepConstants k) {
        return Sleep.ofSubStep(states.rows[JointState.of(joint) + which], k.warmScale, k.subSteps);
    }

    public float load(int joint, StepConstants k) {
        return Sleep.loadOfJoint(sumX(joint, k), sumY(joint, k), has(joint, JointRow.ELASTIC));
    }

    /** An angular impulse on both circles. */
    public float both(int joint, StepConstants k) {
        if (!has(joint, JointRow.ACROSS)) {
            return 0f;
        }
        return -0.5f * measure(joint) * (states.rows[JointState.of(joint) + JointState.ACROSS] * k.warmScale);
    }

    /** Finds the normal from A to B of a joint of two circles; returns how far they are apart. */
    public float measure(int joint) {
        int slotA = state.slotOf[a(joint)];
        int slotB = state.slotOf[b(joint)];
        float[] m = state.motion;
        float x = CircleMath.difference(
                state.differenceX(slotA, slotB), m[CircleRow.of(slotA) + DX], m[CircleRow.of(slotB) + DX]);
        float y = CircleMath.difference(
                state.differenceY(slotA, slotB), m[CircleRow.of(slotA) + DY], m[CircleRow.of(slotB) + DY]);
        float distance = CircleMath.length(x, y);
        nx = distance > 0f ? x / distance : 0f;
        ny = distance > 0f ? y / distance : 0f;
        return distance;
    }

    public float nx() {
        return nx;
    }

    public float ny() {
        return ny;
    }

    // ---- the end of a step

    void tear(int joint) {
        torn[tornCount++] = a(joint);
        if (b(joint) != JointRow.NONE) {
            torn[tornCount++] = b(joint);
        }
    }

    /** Finds out which circles joints drive. */
    public boolean[] findDriven() {
        markDriven(true);
        return driven;
    }

    /** Circles whose joints have broken wake. Returns whether one of them was asleep. */
    public void end(ImpulseCache cache) {
        markDriven(false);
        for (int k = 0; k < tornCount; k++) {
            if (state.sleepers.isAsleep(torn[k])) {
                cache.ensure(cache.filled() + state.sleepers.impulses());
                state.sleepers.restart(state.wake(state.slotOf[torn[k]]));
            }
        }
        tornCount = 0;
    }

    private void markDriven(boolean as) {
        for (int k = 0; k < tornCount; k++) {
            driven[torn[k]] = as;
        }
        for (int n = 0; n < all.rigidCount; n++) {
            if (!as || isThere(all.rigidOrder[n])) {
                mark(a(all.rigidOrder[n]), as);
                mark(b(all.rigidOrder[n]), as);
            }
        }
        for (int k = 0; k < drivingCount; k++) {
            if (!as || isThere(driving[k])) {
                mark(a(driving[k]), as);
                mark(b(driving[k]), as);
            }
        }
        for (int slot = 0; slot < state.awake; slot++) {
            if (state.isStatic(slot)) {
                int id = state.id[slot];
                for (int entry = first(id); entry < first(id + 1); entry++) {
                    if (!as || isThere(joints[entry]) && movesAlong(slot, joints[entry])) {
                        mark(other(joints[entry], id), as);
                    }
                }
            }
        }
    }

    private void mark(int id, boolean as) {
        if (id != JointRow.NONE) {
            driven[id] = as;
        }
    }

    /** Whether a static circle moves so that a joint takes along what it holds. */
    public boolean movesAlong(int slot, int joint) {
        int s = CircleRow.of(slot);
        return state.ownInverseMass(slot) == 0f
                && (state.motion[s + VX] != 0f
                        || state.motion[s + VY] != 0f
                        || state.turning != null && state.turning.angularVelocity[slot] != 0f && turns(joint));
    }
}
