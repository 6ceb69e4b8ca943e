package io.github.circles2d.world.jvm.joints;

import static io.github.circles2d.world.jvm.joints.JointWork.INV_INERTIA_A;
import static io.github.circles2d.world.jvm.joints.JointWork.INV_INERTIA_B;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_X;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_Y;
import static io.github.circles2d.world.model.CircleRow.LOADED_NEXT;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.SPIN_IMPULSE;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.JointMath;

/** What a visit gives to the two circles of a joint. */
final class JointPush {
    private final State state;
    private final JointView view;

    /** An impulse on B. */
    float x;

    float y;

    /** An angular impulse on A; B gets the opposite. */
    float twist;

    /** An angular impulse on each. */
    float both;

    JointPush(State state, JointView view) {
        this.state = state;
        this.view = view;
    }

    void clear() {
        x = 0f;
        y = 0f;
        twist = 0f;
        both = 0f;
    }

    /** Impulses along the surfaces. */
    float spinOfA() {
        return (twist + both) / view.radius(view.a);
    }

    float spinOfB() {
        return (both - twist) / view.radius(view.b);
    }

    /** Gives it to the velocities. */
    void give() {
        float[] m = state.motion;
        int a = view.a;
        int b = view.b;
        float wA = view.givenMassA();
        float wB = view.givenMassB();
        if (wA != 0f) {
            m[a + VX] -= wA * x;
            m[a + VY] -= wA * y;
        }
        if (wB != 0f) {
            m[b + VX] += wB * x;
            m[b + VY] += wB * y;
        }
        if (view.turns()) {
            if (wA != 0f) {
                state.turning.spin[a + SURFACE_SPEED] += view.work[view.o + INV_INERTIA_A] * spinOfA();
            }
            if (wB != 0f) {
                state.turning.spin[b + SURFACE_SPEED] += view.work[view.o + INV_INERTIA_B] * spinOfB();
            }
        }
    }

    /** Gives it to the sums that the circles begin the next sub-step with. */
    void giveToSums() {
        float[] load = state.load;
        int a = view.a;
        int b = view.b;
        if (view.givenMassA() != 0f) {
            load[a + IMPULSE_X] -= x;
            load[a + IMPULSE_Y] -= y;
            if (view.turns()) {
                state.turning.spin[a + SPIN_IMPULSE] += spinOfA();
            }
        }
        if (view.givenMassB() != 0f) {
            load[b + IMPULSE_X] += x;
            load[b + IMPULSE_Y] += y;
            if (view.turns()) {
                state.turning.spin[b + SPIN_IMPULSE] += spinOfB();
            }
        }
    }

    /**
     * Marks circles that the joint cannot bring to where they should be as loaded in the next sub-step: its impulses throw them at what holds them, and
     * off that they must not bounce.
     */
    void loadCircles() {
        float strain = view.strain();
        if (view.givenMassA() != 0f && JointMath.jointLoads(strain, state.circle[view.a + RADIUS])) {
            state.load[view.a + LOADED_NEXT] = 1f;
        }
        if (view.givenMassB() != 0f && JointMath.jointLoads(strain, state.circle[view.b + RADIUS])) {
            state.load[view.b + LOADED_NEXT] = 1f;
        }
    }
}
