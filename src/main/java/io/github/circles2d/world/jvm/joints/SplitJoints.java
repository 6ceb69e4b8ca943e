package io.github.circles2d.world.jvm.joints;

import static io.github.circles2d.world.model.CircleRow.IMPULSE_X;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_Y;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.SPIN_IMPULSE;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/**
 * Joints of a circle that has many. All of them see the circles as before the pass, and circles take the sums of what they get:
 * whole numbers, which need no order, as those of {@link CrossRule}. Each circle counts as lighter by how many of its joints are split.
 */
final class SplitJoints {
    private static final int SUMS = 3;
    private static final int ENDS = 2;

    private final State state;

    private JointStep joints;
    private JointWorker worker;
    private float[] work;
    private StepConstants k;

    /** By number of a circle: what it gets along x and y, and along its surface; 0 between the passes. */
    private long[] sums = new long[0];

    /** By number of a circle: how many of its split joints act. */
    private int[] shares = new int[0];

    SplitJoints(State state) {
        this.state = state;
    }

    long bytes() {
        return 8L * sums.length + 4L * shares.length;
    }

    void ensure(int circles) {
        if (circles > shares.length) {
            sums = new long[SUMS * 2 * circles];
            shares = new int[2 * circles];
        }
    }

    /** Makes the joints ready that begin has begun, and gives their impulses. */
    void prepare(JointStep step, JointWorker itsWorker, float[] itsWork, StepConstants constants) {
        joints = step;
        worker = itsWorker;
        work = itsWork;
        k = constants;
        Arrays.fill(shares, 0, joints.splitCircles, 0);
        for (int place = joints.splitStart; place < joints.count; place++) {
            if (worker.acts(place)) {
                count(end(place, JointWork.A));
                count(end(place, JointWork.B));
            }
        }
        for (int place = joints.splitStart; place < joints.count; place++) {
            if (worker.acts(place)) {
                work[JointWork.of(place) + JointWork.SHARE_A] = share(end(place, JointWork.A));
                work[JointWork.of(place) + JointWork.SHARE_B] = share(end(place, JointWork.B));
                worker.visits.prepare(place);
                if (worker.relaxes(place)) {
                    worker.push.loadCircles();
                    add(place, false);
                }
            }
        }
        takeAll(false);
    }

    /** The number of the circle at an end of a joint, or -1. */
    private int end(int place, int which) {
        return joints.splitEnds[ENDS * (place - joints.splitStart) + which];
    }

    private void count(int circle) {
        if (circle >= 0) {
            shares[circle]++;
        }
    }

    private float share(int circle) {
        return circle < 0 ? 1f : (float) shares[circle];
    }

    void solve(int sub) {
        for (int place = joints.splitStart; place < joints.count; place++) {
            if (worker.acts(place)) {
                worker.visits.solve(place, sub);
                add(place, true);
            }
        }
        takeAll(true);
    }

    void relax(int sub) {
        for (int place = joints.splitStart; place < joints.count; place++) {
            if (worker.acts(place) && worker.relaxes(place)) {
                worker.visits.relax(place, sub);
                add(place, true);
            }
        }
        takeAll(true);
    }

    /** Behind the relaxing pass. */
    void end(boolean last) {
        for (int place = joints.splitStart; place < joints.count; place++) {
            if (worker.acts(place) && worker.relaxes(place)) {
                worker.visits.end(place);
                worker.push.loadCircles();
                if (!last) {
                    add(place, false);
                }
            }
        }
        if (!last) {
            takeAll(false);
        }
    }

    /** Adds what a visit gives to the sums: impulses, or the speeds that they make. */
    private void add(int place, boolean speeds) {
        int o = JointWork.of(place);
        int a = end(place, JointWork.A);
        int b = end(place, JointWork.B);
        float wA = worker.givenMassA();
        float wB = worker.givenMassB();
        if (wA != 0f) {
            float by = speeds ? wA : 1f;
            float bySpin = speeds ? work[o + JointWork.INV_INERTIA_A] : 1f;
            add(a, speeds, -1f * (by * worker.push.x), -1f * (by * worker.push.y), bySpin * worker.push.spinOfA());
        }
        if (b >= 0 && wB != 0f) {
            float by = speeds ? wB : 1f;
            float bySpin = speeds ? work[o + JointWork.INV_INERTIA_B] : 1f;
            add(b, speeds, by * worker.push.x, by * worker.push.y, bySpin * worker.push.spinOfB());
        }
    }

    private void add(int circle, boolean speeds, float x, float y, float spin) {
        float scale = CrossRule.scaleOf(range(row(circle), speeds));
        sums[SUMS * circle] += CrossRule.toFixed(x, scale);
        sums[SUMS * circle + 1] += CrossRule.toFixed(y, scale);
        sums[SUMS * circle + 2] += CrossRule.toFixed(spin, scale);
    }

    private int row(int circle) {
        return CircleRow.of(state.slotOf[joints.splitIds[circle]]);
    }

    private float range(int s, boolean speeds) {
        float r = state.circle[s + RADIUS];
        return speeds
                ? CrossRule.velocityRange(r, k.inverseH)
                : CrossRule.impulseRange(r, k.inverseH, state.traits[s + INVERSE_MASS]);
    }

    /** Circles take the sums: as velocities, or as impulses of the next sub-step. */
    private void takeAll(boolean speeds) {
        for (int circle = 0; circle < joints.splitCircles; circle++) {
            if (shares[circle] == 0) {
                continue;
            }
            int s = row(circle);
            if (state.traits[s + INVERSE_MASS] != 0f) {
                float unit = CrossRule.unitOf(range(s, speeds));
                float x = CrossRule.fromFixed(sums[SUMS * circle], unit);
                float y = CrossRule.fromFixed(sums[SUMS * circle + 1], unit);
                float spin = CrossRule.fromFixed(sums[SUMS * circle + 2], unit);
                float[] to = speeds ? state.motion : state.load;
                to[s + (speeds ? VX : IMPULSE_X)] += x;
                to[s + (speeds ? VY : IMPULSE_Y)] += y;
                if (state.turning != null && k.turning) {
                    state.turning.spin[s + (speeds ? SURFACE_SPEED : SPIN_IMPULSE)] += spin;
                }
            }
            Arrays.fill(sums, SUMS * circle, SUMS * (circle + 1), 0L);
        }
    }
}
