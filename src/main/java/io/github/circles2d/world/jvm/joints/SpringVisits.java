package io.github.circles2d.world.jvm.joints;

import static io.github.circles2d.world.jvm.joints.JointWork.BASE_X;
import static io.github.circles2d.world.jvm.joints.JointWork.BASE_Y;
import static io.github.circles2d.world.jvm.joints.JointWork.BEGUN;
import static io.github.circles2d.world.jvm.joints.JointWork.INV_MASS_A;
import static io.github.circles2d.world.jvm.joints.JointWork.INV_MASS_B;
import static io.github.circles2d.world.jvm.joints.JointWork.LENGTH;
import static io.github.circles2d.world.jvm.joints.JointWork.MASS;
import static io.github.circles2d.world.jvm.joints.JointWork.NORMAL_X;
import static io.github.circles2d.world.jvm.joints.JointWork.NORMAL_Y;
import static io.github.circles2d.world.jvm.joints.JointWork.NOW;
import static io.github.circles2d.world.jvm.joints.JointWork.SUM_X;
import static io.github.circles2d.world.jvm.joints.JointWork.SUM_Y;
import static io.github.circles2d.world.jvm.joints.JointWork.WAY;
import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.BEFORE_Y;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.jvm.state.JointStates;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointState;
import io.github.circles2d.world.model.StepConstants;

/**
 * The visits of plain springs, {@link JointWork#PLAIN}, which soft bodies have by the thousands: what {@link JointVisits} does with them,
 * but all that a visit needs besides the circles lies side by side.
 */
final class SpringVisits {
    private final State state;
    private final JointStates states;

    SpringVisits(State state, JointStates states) {
        this.state = state;
        this.states = states;
    }

    /** Begins the step of the joint of a view, which has been measured for the first time. */
    void prepare(JointView view) {
        float[] work = view.work;
        int o = view.o;
        work[o + LENGTH] = view.joints.rows[view.row + JointRow.LENGTH];
        work[o + MASS] = JointMath.jointMass(work[o + INV_MASS_A] + work[o + INV_MASS_B]);
        work[o + NOW] = view.ofSpring(JointSpring.NOW);
        work[o + BEGUN] = view.ofSpring(JointSpring.BEGUN);
        work[o + WAY] = view.ofSpring(JointSpring.WAY);
        work[o + SUM_X] = 0f;
        work[o + SUM_Y] = 0f;
    }

    /** With bias; gives it to the velocities. */
    void visit(float[] w, int o, int a, int b, StepConstants k) {
        float[] m = state.motion;
        float[] load = state.load;
        float wA = w[o + INV_MASS_A];
        float wB = w[o + INV_MASS_B];
        float x = CircleMath.difference(w[o + BASE_X], m[a + DX], m[b + DX]);
        float y = CircleMath.difference(w[o + BASE_Y], m[a + DY], m[b + DY]);
        float d = CircleMath.length(x, y);
        float nx = w[o + NORMAL_X];
        float ny = w[o + NORMAL_Y];
        if (d > 0f) {
            nx = x / d;
            ny = y / d;
            w[o + NORMAL_X] = nx;
            w[o + NORMAL_Y] = ny;
        }
        boolean fallsA = wA != 0f;
        boolean fallsB = wB != 0f;
        float ofA = load[a + BEFORE_X] - (fallsA ? state.gainX(CircleRow.slot(a), k) : 0f);
        float begunX = load[b + BEFORE_X] - (fallsB ? state.gainX(CircleRow.slot(b), k) : 0f) - ofA;
        ofA = load[a + BEFORE_Y] - (fallsA ? state.gainY(CircleRow.slot(a), k) : 0f);
        float begunY = load[b + BEFORE_Y] - (fallsB ? state.gainY(CircleRow.slot(b), k) : 0f) - ofA;
        float v = CircleMath.dot(nx, ny, m[b + VX] - m[a + VX], m[b + VY] - m[a + VY]);
        float begun = CircleMath.dot(nx, ny, begunX, begunY);
        float push =
                JointMath.springImpulse(w[o + MASS], v, begun, d - w[o + LENGTH], w[o + NOW], w[o + BEGUN], w[o + WAY]);
        w[o + SUM_X] += nx * push;
        w[o + SUM_Y] += ny * push;
        float pushX = nx * (0f + push); // as a sum that begins with 0
        float pushY = ny * (0f + push);
        if (fallsA) {
            m[a + VX] -= wA * pushX;
            m[a + VY] -= wA * pushY;
        }
        if (fallsB) {
            m[b + VX] += wB * pushX;
            m[b + VY] += wB * pushY;
        }
    }

    /** Ends the step. */
    void end(float[] w, int o, int joint) {
        states.rows[JointState.of(joint) + JointState.SUM_X] = w[o + SUM_X];
        states.rows[JointState.of(joint) + JointState.SUM_Y] = w[o + SUM_Y];
    }
}
