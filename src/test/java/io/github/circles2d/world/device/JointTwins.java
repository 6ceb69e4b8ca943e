package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.joints.BrokenJoints;
import io.github.circles2d.world.joints.SavedJointStates;
import io.github.circles2d.world.model.AnchorRow;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointState;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Random joints of every form, also of forms that calls do not make, on each of the pipelines that are to be compared. The circles of ids from 0 on
 * stay.
 */
final class JointTwins {
    private static final int SPRINGS = 6;
    private static final int ANCHORS = 4;
    private static final int SPLIT = JointStep.COLOURS;

    private static final int[] LINEAR = {
        0,
        JointRow.AXIAL | JointRow.RIGID,
        JointRow.AXIAL | JointRow.ELASTIC,
        JointRow.AXIAL | JointRow.UPPER,
        JointRow.AXIAL | JointRow.LOWER | JointRow.UPPER,
        JointRow.AXIAL | JointRow.ELASTIC | JointRow.LOWER | JointRow.UPPER,
        JointRow.POINT | JointRow.RIGID,
        JointRow.POINT | JointRow.ELASTIC,
        JointRow.DRAG,
        JointRow.AXIAL | JointRow.RIGID | JointRow.ACROSS,
    };

    private static final int[] ANGULAR = {0, JointRow.TURN_SPEED, JointRow.TURN_ANGLE, JointRow.TURN_RIGID};

    private final Bounds bounds;
    private final float radius;
    private final JointStep tables = new JointStep();
    private Pipeline[] pipelines;

    /** Whether joints turn circles; the world must turn then. */
    boolean turning;

    /** Whether some break under small forces. */
    boolean fragile;

    /** The most joints of a batch; of a component of a batch two thirds. The order of visits does not show it. */
    int batch = 12;

    private int serials;
    private float h;
    private int subSteps;
    private float[] frequencies = new float[SPRINGS];
    private float[] dampings = new float[SPRINGS];
    private int[] colour = new int[0];

    JointTwins(Bounds bounds, float radius) {
        this.bounds = bounds;
        this.radius = radius;
    }

    /** The same pipelines, in steps with these joints. */
    Pipeline[] on(Pipeline... all) {
        pipelines = all;
        return Pipelines.with(Features.JOINTS, this::prepare, all);
    }

    private void prepare(StepInput input) {
        if (h != input.constants.h || subSteps != input.constants.subSteps) {
            h = input.constants.h;
            subSteps = input.constants.subSteps;
            fillSprings();
            tables.anchors = Arrays.copyOf(tables.anchors, AnchorRow.of(ANCHORS, 0, subSteps));
        }
        input.constants.joints = tables.count > 0;
        JointStep to = input.joints;
        to.joints = tables.joints;
        to.rows = tables.rows;
        to.traits = tables.traits;
        to.version = tables.version;
        to.changedFrom = tables.changedFrom;
        to.changedTo = tables.changedTo;
        to.order = tables.order;
        to.count = tables.count;
        to.batches = tables.batches;
        to.starts = tables.starts;
        to.colours = tables.colours;
        to.splitStart = tables.splitStart;
        to.splitCircles = tables.splitCircles;
        to.splitIds = tables.splitIds;
        to.splitEnds = tables.splitEnds;
        to.orderVersion = tables.orderVersion;
        to.springs = tables.springs;
        to.springCount = tables.springCount;
        to.springsVersion = tables.springsVersion;
        to.anchors = tables.anchors;
        to.anchorCount = ANCHORS;
        to.anchorsVersion = tables.anchorsVersion;
        to.partnered = tables.partnered;
        to.partnerStart = tables.partnerStart;
        to.partners = tables.partners;
        to.partnersVersion = tables.partnersVersion;
        to.parts = tables.parts;
        to.breakable = true;
        to.turns = turning;
    }

    private void fillSprings() {
        tables.springs = new float[JointSpring.of(SPRINGS)];
        tables.springCount = SPRINGS;
        for (int spring = 1; spring < SPRINGS; spring++) {
            JointSpring.fill(tables.springs, spring, frequencies[spring], dampings[spring], h);
        }
        tables.springsVersion++;
    }

    /**
     * Makes so many joints of the first circles in place of those before, of which some go on. Of hubs circles so many joints are that there
     * is no colour for all.
     */
    void make(int joints, int circles, int hubs, SplittableRandom random) {
        float[] rows = Arrays.copyOf(tables.rows, JointRow.of(joints));
        int[] traits = Arrays.copyOf(tables.traits, JointRow.traits(joints));
        for (int joint = 0; joint < joints; joint++) {
            if (joint >= tables.joints
                    || traits[JointRow.traits(joint) + JointRow.FORM] == 0
                    || random.nextInt(3) == 0) {
                makeJoint(rows, JointRow.of(joint), traits, JointRow.traits(joint), circles, hubs, random);
            }
        }
        tables.rows = rows;
        tables.traits = traits;
        tables.joints = joints;
        tables.changedFrom = 0;
        tables.changedTo = joints;
        tables.version++;
        for (int spring = 1; spring < SPRINGS; spring++) {
            frequencies[spring] = spring == 1 ? 60f : 0.5f + 8f * (float) random.nextDouble();
            dampings[spring] = 2f * (float) random.nextDouble();
        }
        h = 0f;
        arrange(circles);
    }

    private void makeJoint(float[] rows, int row, int[] traits, int t, int circles, int hubs, SplittableRandom random) {
        boolean hub = hubs > 0 && random.nextInt(3) == 0;
        int a = hub ? random.nextInt(hubs) : random.nextInt(circles);
        int b = random.nextInt(5) == 0 ? JointRow.NONE : (a + 1 + random.nextInt(Math.min(circles - 1, 12))) % circles;
        int form = LINEAR[random.nextInt(turning && b >= 0 ? LINEAR.length : LINEAR.length - 1)];
        form |= turning ? ANGULAR[random.nextInt(ANGULAR.length)] : 0;
        if (form == 0) {
            form = JointRow.AXIAL | JointRow.RIGID;
        }
        form |= random.nextInt(3) == 0 ? JointRow.COLLIDE : 0;
        form |= random.nextInt(3) == 0 ? JointRow.BREAKABLE : 0;
        if (random.nextBoolean()) {
            int other = a;
            a = b == JointRow.NONE ? a : b;
            b = b == JointRow.NONE ? b : other;
        }
        traits[t + JointRow.A] = a;
        traits[t + JointRow.B] = b;
        traits[t + JointRow.FORM] = form;
        traits[t + JointRow.SPRING] = 1 + random.nextInt(SPRINGS - 1);
        traits[t + JointRow.ANCHOR] = b == JointRow.NONE && random.nextBoolean() ? 1 + random.nextInt(ANCHORS - 1) : 0;
        traits[t + JointRow.SERIAL] = ++serials;
        traits[t + JointRow.REFERENCE_A] = random.nextInt();
        traits[t + JointRow.REFERENCE_B] = random.nextInt();
        rows[row + JointRow.ANCHOR_X] = between(random, bounds.minX(), bounds.maxX());
        rows[row + JointRow.ANCHOR_Y] = between(random, bounds.minY(), bounds.maxY());
        rows[row + JointRow.LENGTH] = random.nextInt(8) == 0 ? 0f : radius * between(random, 0f, 6f);
        rows[row + JointRow.MIN_LENGTH] = radius * between(random, 0f, 3f);
        rows[row + JointRow.MAX_LENGTH] = rows[row + JointRow.MIN_LENGTH] + radius * between(random, 0f, 3f);
        rows[row + JointRow.MAX_FORCE] = limit(random, 1f);
        rows[row + JointRow.MAX_TORQUE] = limit(random, radius);
        rows[row + JointRow.SPEED] = between(random, -10f, 10f);
        rows[row + JointRow.BREAK_FORCE] = fragile ? 1e-6f : limit(random, 20f);
        rows[row + JointRow.BREAK_TORQUE] = limit(random, 20f * radius);
        double angle = 2 * Math.PI * random.nextDouble();
        rows[row + JointRow.DIRECTION_X] = (float) Math.cos(angle);
        rows[row + JointRow.DIRECTION_Y] = (float) Math.sin(angle);
    }

    private static float limit(SplittableRandom random, float most) {
        return random.nextBoolean() ? Float.POSITIVE_INFINITY : between(random, 0f, most);
    }

    private static float between(SplittableRandom random, float from, float to) {
        return from + (to - from) * (float) random.nextDouble();
    }

    /** Moves anchors. */
    void moveAnchors(SplittableRandom random) {
        tables.anchors = new float[AnchorRow.of(ANCHORS, 0, subSteps)];
        for (int k = AnchorRow.of(1, 0, subSteps); k < tables.anchors.length; k++) {
            tables.anchors[k] = radius * between(random, -1f, 1f);
        }
        tables.anchorsVersion++;
    }

    // ---- colours, batches, split joints and partners

    private boolean exists(int joint) {
        return tables.traits[JointRow.traits(joint) + JointRow.FORM] != 0;
    }

    private int end(int joint, int which) {
        return tables.traits[JointRow.traits(joint) + which];
    }

    private void arrange(int circles) {
        colour = new int[tables.joints];
        int[] used = new int[circles];
        for (int joint = 0; joint < tables.joints; joint++) {
            if (exists(joint)) {
                int b = end(joint, JointRow.B);
                int taken = used[end(joint, JointRow.A)] | (b < 0 ? 0 : used[b]);
                colour[joint] = Math.min(SPLIT, Integer.numberOfTrailingZeros(~taken));
                if (colour[joint] < SPLIT) {
                    used[end(joint, JointRow.A)] |= 1 << colour[joint];
                    if (b >= 0) {
                        used[b] |= 1 << colour[joint];
                    }
                }
            }
        }
        order(components(circles), circles);
        splitCircles(circles);
        partners(circles);
        tables.orderVersion++;
    }

    /** By circle: the least circle that coloured joints connect it to. */
    private int[] components(int circles) {
        int[] component = new int[circles];
        Arrays.setAll(component, k -> k);
        for (boolean changed = true; changed; ) {
            changed = false;
            for (int joint = 0; joint < tables.joints; joint++) {
                int b = exists(joint) && colour[joint] < SPLIT ? end(joint, JointRow.B) : -1;
                if (b >= 0) {
                    int a = end(joint, JointRow.A);
                    int least = Math.min(component[a], component[b]);
                    changed |= component[a] != least || component[b] != least;
                    component[a] = least;
                    component[b] = least;
                }
            }
        }
        return component;
    }

    private void order(int[] component, int circles) {
        int[] batchOf = new int[circles];
        int[] size = new int[circles];
        for (int joint = 0; joint < tables.joints; joint++) {
            if (exists(joint) && colour[joint] < SPLIT) {
                size[component[end(joint, JointRow.A)]]++;
            }
        }
        int batches = 0;
        int filled = batch;
        for (int c = 0; c < circles; c++) {
            if (size[c] > 0 && 3 * size[c] <= 2 * batch) {
                if (filled + size[c] > batch) {
                    batches++;
                    filled = 0;
                }
                filled += size[c];
                batchOf[c] = batches - 1;
            }
        }
        for (int c = 0; c < circles; c++) {
            batchOf[c] = 3 * size[c] > 2 * batch ? batches : batchOf[c];
        }
        tables.batches = batches;
        tables.order = new int[tables.joints];
        tables.starts = new int[JointStep.BATCH_STRIDE * (batches + 1)];
        tables.colours = 0;
        int place = 0;
        for (int k = 0; k <= batches; k++) {
            for (int c = 0; c <= JointStep.COLOURS; c++) {
                tables.starts[JointStep.BATCH_STRIDE * k + c] = place;
                for (int joint = 0; joint < tables.joints && c < SPLIT; joint++) {
                    if (exists(joint) && colour[joint] == c && batchOf[component[end(joint, JointRow.A)]] == k) {
                        tables.order[place++] = joint;
                        tables.colours = Math.max(tables.colours, c + 1);
                    }
                }
            }
        }
        tables.splitStart = place;
        for (int joint = 0; joint < tables.joints; joint++) {
            if (exists(joint) && colour[joint] == SPLIT) {
                tables.order[place++] = joint;
            }
        }
        tables.count = place;
    }

    private void splitCircles(int circles) {
        boolean[] split = new boolean[circles];
        for (int place = tables.splitStart; place < tables.count; place++) {
            split[end(tables.order[place], JointRow.A)] = true;
            if (end(tables.order[place], JointRow.B) >= 0) {
                split[end(tables.order[place], JointRow.B)] = true;
            }
        }
        int[] number = new int[circles];
        tables.splitIds = new int[circles];
        tables.splitCircles = 0;
        for (int c = 0; c < circles; c++) {
            if (split[c]) {
                number[c] = tables.splitCircles;
                tables.splitIds[tables.splitCircles++] = c;
            }
        }
        tables.splitEnds = new int[2 * (tables.count - tables.splitStart)];
        for (int place = tables.splitStart; place < tables.count; place++) {
            int k = 2 * (place - tables.splitStart);
            int b = end(tables.order[place], JointRow.B);
            tables.splitEnds[k] = number[end(tables.order[place], JointRow.A)];
            tables.splitEnds[k + 1] = b < 0 ? -1 : number[b];
        }
    }

    private void partners(int circles) {
        List<int[]> pairs = new ArrayList<>();
        for (int joint = 0; joint < tables.joints; joint++) {
            int form = tables.traits[JointRow.traits(joint) + JointRow.FORM];
            int b = end(joint, JointRow.B);
            if (form != 0 && b >= 0 && (form & JointRow.COLLIDE) == 0) {
                pairs.add(new int[] {end(joint, JointRow.A), b, joint});
                pairs.add(new int[] {b, end(joint, JointRow.A), joint});
            }
        }
        pairs.sort((p, q) -> Integer.compare(p[0], q[0]));
        // A circle of a greater id has no partner that the table knows.
        tables.partnered = circles;
        tables.partnerStart = new int[circles + 1];
        tables.partners = new int[2 * pairs.size()];
        int k = 0;
        for (int c = 0; c < circles; c++) {
            tables.partnerStart[c] = k;
            for (; k < pairs.size() && pairs.get(k)[0] == c; k++) {
                tables.partners[2 * k] = pairs.get(k)[1];
                tables.partners[2 * k + 1] = pairs.get(k)[2];
            }
        }
        tables.partnerStart[circles] = k;
        tables.parts = !pairs.isEmpty();
        tables.partnersVersion++;
    }

    int split() {
        return tables.count - tables.splitStart;
    }

    int batches() {
        return tables.batches;
    }

    int inNoBatch() {
        return tables.splitStart - tables.starts[JointStep.BATCH_STRIDE * tables.batches];
    }

    // ---- what joints keep, and which break

    /** Compares what joints keep; returns how many push. */
    int assertSameStates(String when) {
        List<String> expected = states(pipelines[0]);
        int pushing = 0;
        for (String state : expected) {
            pushing += state.contains(" 0.0 0.0 0.0 sums") ? 0 : 1;
        }
        for (Pipeline pipeline : pipelines) {
            assertThat(states(pipeline)).as(when + " on " + pipeline.device()).isEqualTo(expected);
        }
        return pushing;
    }

    private List<String> states(Pipeline pipeline) {
        SavedJointStates saved = new SavedState().jointStates;
        pipeline.saveJoints(saved);
        List<String> states = new ArrayList<>();
        for (int place = 0; place < tables.count; place++) {
            int joint = tables.order[place];
            int serial = tables.traits[JointRow.traits(joint) + JointRow.SERIAL];
            if (joint < saved.joints && (saved.serial[joint] == serial || saved.serial[joint] == ~serial)) {
                StringBuilder text = new StringBuilder(joint + " " + saved.serial[joint]);
                int at = JointState.of(joint);
                for (int k = JointState.SUM_X; k < JointState.STRIDE; k++) {
                    text.append(" " + saved.rows[at + k]);
                }
                text.append(" sums");
                for (int k = 0; k < JointState.STRIDE; k++) {
                    text.append(" " + Float.floatToRawIntBits(saved.rows[at + k]));
                }
                states.add(text.toString());
            }
        }
        return states;
    }

    /** Compares which joints have broken since the last time, and removes them. Returns their number. */
    int assertSameBroken(String when, int circles) {
        BrokenJoints expected = broken(pipelines[0]);
        for (int k = 1; k < pipelines.length; k++) {
            BrokenJoints broken = broken(pipelines[k]);
            assertThat(Arrays.copyOf(broken.joint, broken.count))
                    .as(when + " on " + pipelines[k].device())
                    .isEqualTo(Arrays.copyOf(expected.joint, expected.count));
        }
        if (expected.count > 0) {
            tables.traits = tables.traits.clone();
            for (int k = 0; k < expected.count; k++) {
                tables.traits[JointRow.traits(expected.id(k)) + JointRow.FORM] = JointRow.NO_JOINT;
            }
            tables.changedFrom = expected.id(0);
            tables.changedTo = expected.id(0) + 1;
            for (int k = 0; k < expected.count; k++) {
                tables.changedFrom = Math.min(tables.changedFrom, expected.id(k));
                tables.changedTo = Math.max(tables.changedTo, expected.id(k) + 1);
            }
            tables.version++;
            arrange(circles);
        }
        return expected.count;
    }

    private static BrokenJoints broken(Pipeline pipeline) {
        BrokenJoints broken = new BrokenJoints();
        pipeline.takeBroken(broken);
        return broken;
    }
}
