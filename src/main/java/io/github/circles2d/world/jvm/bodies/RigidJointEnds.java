package io.github.circles2d.world.jvm.bodies;

import static io.github.circles2d.world.model.CircleRow.BEFORE_X;
import static io.github.circles2d.world.model.CircleRow.BEFORE_Y;
import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_X;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_Y;
import static io.github.circles2d.world.model.CircleRow.INVERSE_INERTIA;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.LOADED_NEXT;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.SPIN_IMPULSE;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.TURNED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.AnchorRow;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Velocity;
import java.util.Arrays;

/**
 * The ends of joints that hold rigid bodies, two a joint: bodies, circles, and anchors or nothing, which do not give way. All are alike: a place on an
 * arm from a centre, and how it moves.
 */
final class RigidJointEnds {
    private static final int NONE = -1;

    private final State state;
    private final RigidPairs pairs;
    private final RigidThings things;

    // by end
    private int[] thing = new int[0];

    /** Row of a circle, or {@link #NONE}. */
    private int[] circle = new int[0];

    /** Row of {@link AnchorRow}. */
    private int[] anchor = new int[0];

    private float[] localX = new float[0];
    private float[] localY = new float[0];
    final float[][] arm = {new float[0], new float[0]};

    /** Inverse mass and inertia. */
    float[] w = new float[0];

    float[] i = new float[0];

    /** The same, also of a body that sleeps, which is pulled as if it would give way. */
    float[] ownW = new float[0];

    float[] ownI = new float[0];

    // within a step
    private JointStep joints;
    private StepConstants k;

    RigidJointEnds(State state, RigidPairs pairs) {
        this.state = state;
        this.pairs = pairs;
        things = pairs.things;
    }

    void begin(JointStep step, StepConstants constants) {
        joints = step;
        k = constants;
        int n = 2 * step.rigidCount;
        if (w.length < n) {
            int c = n + (n >> 1);
            thing = Arrays.copyOf(thing, c);
            circle = Arrays.copyOf(circle, c);
            anchor = Arrays.copyOf(anchor, c);
            localX = Arrays.copyOf(localX, c);
            localY = Arrays.copyOf(localY, c);
            arm[0] = Arrays.copyOf(arm[0], c);
            arm[1] = Arrays.copyOf(arm[1], c);
            i = Arrays.copyOf(i, c);
            w = Arrays.copyOf(w, c);
            ownW = Arrays.copyOf(ownW, c);
            ownI = Arrays.copyOf(ownI, c);
        }
    }

    /** Finds what is at an end of a joint. */
    void find(int e, int joint, int side) {
        int body = joints.rigidBodies[2 * joint + side];
        int id = joints.traits[JointRow.traits(joint) + (side == 0 ? JointRow.A : JointRow.B)];
        thing[e] = NONE;
        circle[e] = NONE;
        anchor[e] = joints.traits[JointRow.traits(joint) + JointRow.ANCHOR];
        w[e] = 0f;
        i[e] = 0f;
        localX[e] = 0f;
        localY[e] = 0f;
        if (body != JointRow.NONE) {
            thing[e] = pairs.bodyThing(body);
            w[e] = things.w[thing[e]];
            i[e] = things.i[thing[e]];
            ownW[e] = things.ownW[thing[e]];
            ownI[e] = things.ownI[thing[e]];
            localX[e] = joints.rigidPoints[4 * joint + 2 * side];
            localY[e] = joints.rigidPoints[4 * joint + 2 * side + 1];
        } else if (id != JointRow.NONE) {
            int slot = state.slotOf[id];
            circle[e] = CircleRow.of(slot);
            w[e] = state.traits[circle[e] + INVERSE_MASS];
            if (k.turning && w[e] > 0f) {
                float r = state.circle[circle[e] + RADIUS];
                i[e] = state.turning.spin[circle[e] + INVERSE_INERTIA] / (r * r);
            }
        }
        if (thing[e] == NONE) {
            ownW[e] = w[e];
            ownI[e] = i[e];
        }
        turn(e);
    }

    /** Turns the arm with its body. */
    void turn(int e) {
        int t = thing[e];
        arm[0][e] = t == NONE ? 0f : things.cos[t] * localX[e] - things.sin[t] * localY[e];
        arm[1][e] = t == NONE ? 0f : things.sin[t] * localX[e] + things.cos[t] * localY[e];
    }

    /**
     * Both ends of a joint get the same place, which is the middle, or the centre of a circle: so impulses keep the angular momentum exactly. Takes how far
     * B is from A.
     */
    void meet(int e, float wayX, float wayY) {
        boolean hasBody = thing[e] != NONE;
        boolean hasOther = thing[e + 1] != NONE;
        if (hasBody && (hasOther || circle[e + 1] != NONE)) {
            float share = hasOther ? 0.5f : 1f;
            arm[0][e] += share * wayX;
            arm[1][e] += share * wayY;
        }
        if (hasOther) {
            float share = hasBody ? 0.5f : 1f;
            arm[0][e + 1] -= share * wayX;
            arm[1][e + 1] -= share * wayY;
        }
    }

    /** How far the base of B is from that of A; of a joint that has no place at B without meaning. */
    float baseX(int e, int joint) {
        float way = base(e + 1, joint, things.x, X, JointRow.ANCHOR_X) - base(e, joint, things.x, X, JointRow.ANCHOR_X);
        return state.wraps ? CircleMath.shortWay(way, state.periodX) : way;
    }

    float baseY(int e, int joint) {
        float way = base(e + 1, joint, things.y, Y, JointRow.ANCHOR_Y) - base(e, joint, things.y, Y, JointRow.ANCHOR_Y);
        return state.wraps ? CircleMath.shortWay(way, state.periodY) : way;
    }

    private float base(int e, int joint, float[] ofThings, int ofCircle, int ofAnchor) {
        if (thing[e] != NONE) {
            return ofThings[thing[e]];
        }
        return circle[e] != NONE ? state.circle[circle[e] + ofCircle] : joints.rows[JointRow.of(joint) + ofAnchor];
    }

    /** How far the place is from its base, at a boundary of sub-steps. */
    float wayX(int e, int boundary) {
        return thing[e] != NONE ? things.dx[thing[e]] + arm[0][e] : ofOthers(e, boundary, DX, AnchorRow.DX);
    }

    float wayY(int e, int boundary) {
        return thing[e] != NONE ? things.dy[thing[e]] + arm[1][e] : ofOthers(e, boundary, DY, AnchorRow.DY);
    }

    /** How a circle moves, or an anchor. */
    private float ofOthers(int e, int boundary, int ofCircle, int ofAnchor) {
        return circle[e] != NONE ? state.motion[circle[e] + ofCircle] : joints.anchors[anchor(e, boundary) + ofAnchor];
    }

    private int anchor(int e, int boundary) {
        return AnchorRow.of(anchor[e], boundary, k.subSteps);
    }

    // ---- how they move

    float vx(int e, int boundary) {
        int t = thing[e];
        return t != NONE ? things.vx[t] - things.omega[t] * arm[1][e] : ofOthers(e, boundary, VX, AnchorRow.VX);
    }

    float vy(int e, int boundary) {
        int t = thing[e];
        return t != NONE ? things.vy[t] + things.omega[t] * arm[0][e] : ofOthers(e, boundary, VY, AnchorRow.VY);
    }

    /** The velocity as the sub-step began: without gravity and all impulses. */
    float begunX(int e, int boundary) {
        int t = thing[e];
        if (t != NONE) {
            return (things.beforeX[t] - things.gainX(t)) - (things.beforeOmega[t] - things.gainOmega(t)) * arm[1][e];
        }
        int c = circle[e];
        return c != NONE
                ? state.load[c + BEFORE_X] - state.fallX(CircleRow.slot(c), k)
                : joints.anchors[anchor(e, boundary) + AnchorRow.VX];
    }

    float begunY(int e, int boundary) {
        int t = thing[e];
        if (t != NONE) {
            return (things.beforeY[t] - things.gainY(t)) + (things.beforeOmega[t] - things.gainOmega(t)) * arm[0][e];
        }
        int c = circle[e];
        return c != NONE
                ? state.load[c + BEFORE_Y] - state.fallY(CircleRow.slot(c), k)
                : joints.anchors[anchor(e, boundary) + AnchorRow.VY];
    }

    float omega(int e) {
        if (thing[e] != NONE) {
            return things.omega[thing[e]];
        }
        return circle[e] != NONE && k.turning
                ? state.turning.spin[circle[e] + SURFACE_SPEED] / state.circle[circle[e] + RADIUS]
                : 0f;
    }

    /** In units, as the step began. */
    int angle(int e) {
        if (thing[e] != NONE) {
            return things.angle[thing[e]];
        }
        return circle[e] != NONE && k.turning ? state.turning.angle[CircleRow.slot(circle[e])] : 0;
    }

    /** By how much it has turned in the step, in radians. */
    float turned(int e) {
        if (thing[e] != NONE) {
            return things.turned[thing[e]];
        }
        return circle[e] != NONE && k.turning
                ? state.turning.spin[circle[e] + TURNED] * k.h / state.circle[circle[e] + RADIUS]
                : 0f;
    }

    /** Push-outs are measured by it; infinite of what does not give way. */
    float size(int e) {
        if (ownW[e] == 0f && ownI[e] == 0f) {
            return Float.POSITIVE_INFINITY;
        }
        return thing[e] != NONE ? things.reach[thing[e]] : state.circle[circle[e] + RADIUS];
    }

    // ---- what they get

    /** An impulse at the place, and an angular one. */
    void push(int e, float x, float y, float twist) {
        pushBody(e, x, y, twist);
        int c = circle[e];
        if (c != NONE && w[e] > 0f) {
            state.motion[c + VX] += w[e] * x;
            state.motion[c + VY] += w[e] * y;
            if (k.turning) {
                state.turning.spin[c + SURFACE_SPEED] += i[e] * (state.circle[c + RADIUS] * twist);
            }
        }
    }

    /** The same, if a body is there. */
    void pushBody(int e, float x, float y, float twist) {
        int t = thing[e];
        if (t != NONE) {
            things.vx[t] = Velocity.limitSpeed(things.vx[t] + w[e] * x);
            things.vy[t] = Velocity.limitSpeed(things.vy[t] + w[e] * y);
            things.omega[t] = Velocity.limitSpeed(things.omega[t] + i[e] * ((arm[0][e] * y - arm[1][e] * x) + twist));
        }
    }

    /** An impulse with which a circle begins its next sub-step; if it is strained, the circle does not bounce then. */
    void pushNext(int e, float x, float y, float twist, float strain) {
        int c = circle[e];
        if (c != NONE && w[e] > 0f) {
            state.load[c + IMPULSE_X] += x;
            state.load[c + IMPULSE_Y] += y;
            if (k.turning) {
                state.turning.spin[c + SPIN_IMPULSE] += twist / state.circle[c + RADIUS];
            }
            if (JointMath.jointLoads(strain, state.circle[c + RADIUS])) {
                state.load[c + LOADED_NEXT] = 1f;
            }
        }
    }

    long bytes() {
        return 44L * w.length;
    }
}
