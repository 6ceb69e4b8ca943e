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
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.StepConstants;

/**
 * An end of a joint that holds rigid bodies: a body, a circle, or an anchor or nothing, which do not give way. All are alike: a place on an arm from a
 * centre, and how it moves.
 */
final class RigidJointEnd {
    private static final int NONE = -1;

    private final State state;
    private final RigidPairs pairs;

    /** 0 of A, 1 of B. */
    private final int side;

    /** Null of what is no body. */
    private RigidThing thing;

    /** Row of a circle, or {@link #NONE}. */
    private int circle;

    /** Row of {@link AnchorRow}. */
    private int anchor;

    // the arm, as it lies and as it has turned
    private float localX;
    private float localY;
    float armX;
    float armY;

    // inverse mass and inertia
    private float w;
    private float i;

    // the same, also of a body that sleeps, which is pulled as if it would give way
    float ownW;
    float ownI;

    // within a step
    private int joint;
    private JointStep joints;
    private StepConstants k;

    RigidJointEnd(State state, RigidPairs pairs, int side) {
        this.state = state;
        this.pairs = pairs;
        this.side = side;
    }

    /** Finds what is at the end of a joint in a step. */
    void begin(int itsJoint, JointStep step, StepConstants constants) {
        joint = itsJoint;
        joints = step;
        k = constants;
        int body = joints.rigidBodies[2 * joint + side];
        int id = joints.traits[JointRow.traits(joint) + (side == 0 ? JointRow.A : JointRow.B)];
        thing = body == JointRow.NONE ? null : pairs.bodyThing(body);
        circle = NONE;
        anchor = joints.traits[JointRow.traits(joint) + JointRow.ANCHOR];
        setMasses(0f, 0f);
        if (thing != null) {
            w = thing.w;
            i = thing.i;
            ownW = thing.ownW;
            ownI = thing.ownI;
            localX = joints.rigidPoints[4 * joint + 2 * side];
            localY = joints.rigidPoints[4 * joint + 2 * side + 1];
        } else if (id != JointRow.NONE) {
            circle = CircleRow.of(state.slotOf[id]);
            float r = state.circle[circle + RADIUS];
            float inverseMass = state.traits[circle + INVERSE_MASS];
            boolean turns = k.turning && inverseMass > 0f;
            setMasses(inverseMass, turns ? state.turning.spin[circle + INVERSE_INERTIA] / (r * r) : 0f);
        }
        turn();
    }

    private void setMasses(float inverseMass, float inverseInertia) {
        w = inverseMass;
        i = inverseInertia;
        ownW = inverseMass;
        ownI = inverseInertia;
    }

    /** Turns the arm with its body. */
    void turn() {
        armX = thing == null ? 0f : thing.cos * localX - thing.sin * localY;
        armY = thing == null ? 0f : thing.sin * localX + thing.cos * localY;
    }

    /**
     * Both ends of a joint get the same place, which is the middle, or the centre of a circle: so impulses keep the angular momentum exactly. Takes how far
     * this one is from the other.
     */
    void meet(RigidJointEnd other, float wayX, float wayY) {
        if (thing != null && (other.thing != null || other.circle != NONE)) {
            float share = other.thing != null ? 0.5f : 1f;
            armX -= share * wayX;
            armY -= share * wayY;
        }
    }

    /** Where the centre is as the step begins, or an anchor; of a joint that has no place at B without meaning. */
    float baseX() {
        return thing != null
                ? thing.x
                : circle != NONE ? state.circle[circle + X] : joints.rows[JointRow.of(joint) + JointRow.ANCHOR_X];
    }

    float baseY() {
        return thing != null
                ? thing.y
                : circle != NONE ? state.circle[circle + Y] : joints.rows[JointRow.of(joint) + JointRow.ANCHOR_Y];
    }

    /** How far the place is from its base, at a boundary of sub-steps. */
    float wayX(int boundary) {
        return thing != null ? thing.dx + armX : ofOthers(boundary, DX, AnchorRow.DX);
    }

    float wayY(int boundary) {
        return thing != null ? thing.dy + armY : ofOthers(boundary, DY, AnchorRow.DY);
    }

    /** How a circle moves, or an anchor. */
    private float ofOthers(int boundary, int ofCircle, int ofAnchor) {
        return circle != NONE ? state.motion[circle + ofCircle] : ofAnchor(boundary, ofAnchor);
    }

    private float ofAnchor(int boundary, int which) {
        return joints.anchors[AnchorRow.of(anchor, boundary, k.subSteps) + which];
    }

    // ---- how it moves

    float vx(int boundary) {
        return thing != null ? thing.vx - thing.omega * armY : ofOthers(boundary, VX, AnchorRow.VX);
    }

    float vy(int boundary) {
        return thing != null ? thing.vy + thing.omega * armX : ofOthers(boundary, VY, AnchorRow.VY);
    }

    /** The velocity as the sub-step began: without gravity and all impulses. */
    float begunX(int boundary) {
        if (thing != null) {
            return (thing.beforeX - thing.takenX()) - (thing.beforeOmega - thing.takenOmega()) * armY;
        }
        return circle != NONE
                ? state.load[circle + BEFORE_X] - state.fallX(CircleRow.slot(circle), k)
                : ofAnchor(boundary, AnchorRow.VX);
    }

    float begunY(int boundary) {
        if (thing != null) {
            return (thing.beforeY - thing.takenY()) + (thing.beforeOmega - thing.takenOmega()) * armX;
        }
        return circle != NONE
                ? state.load[circle + BEFORE_Y] - state.fallY(CircleRow.slot(circle), k)
                : ofAnchor(boundary, AnchorRow.VY);
    }

    private boolean isTurningCircle() {
        return circle != NONE && k.turning;
    }

    float omega() {
        if (thing != null) {
            return thing.omega;
        }
        return isTurningCircle() ? state.turning.spin[circle + SURFACE_SPEED] / state.circle[circle + RADIUS] : 0f;
    }

    /** In units, as the step began. */
    int angle() {
        if (thing != null) {
            return thing.angle;
        }
        return isTurningCircle() ? state.turning.angle[CircleRow.slot(circle)] : 0;
    }

    /** By how much it has turned in the step, in radians. */
    float turned() {
        if (thing != null) {
            return thing.turned;
        }
        return isTurningCircle() ? state.turning.spin[circle + TURNED] * k.h / state.circle[circle + RADIUS] : 0f;
    }

    /** Push-outs are measured by it; infinite of what does not give way. */
    float size() {
        if (ownW == 0f && ownI == 0f) {
            return Float.POSITIVE_INFINITY;
        }
        return thing != null ? thing.reach : state.circle[circle + RADIUS];
    }

    // ---- what it gets

    /** An impulse at the place, and an angular one. */
    void push(float x, float y, float twist) {
        pushBody(x, y, twist);
        if (circle != NONE && w > 0f) {
            state.motion[circle + VX] += w * x;
            state.motion[circle + VY] += w * y;
            if (k.turning) {
                state.turning.spin[circle + SURFACE_SPEED] += i * (state.circle[circle + RADIUS] * twist);
            }
        }
    }

    /** The same, if a body is there. */
    void pushBody(float x, float y, float twist) {
        if (thing != null) {
            thing.add(w * x, w * y, i * ((armX * y - armY * x) + twist));
        }
    }

    /** An impulse with which a circle begins its next sub-step; if it is strained, the circle does not bounce then. */
    void pushNext(float x, float y, float twist, float strain) {
        if (circle != NONE && w > 0f) {
            state.load[circle + IMPULSE_X] += x;
            state.load[circle + IMPULSE_Y] += y;
            if (k.turning) {
                state.turning.spin[circle + SPIN_IMPULSE] += twist / state.circle[circle + RADIUS];
            }
            if (JointMath.jointLoads(strain, state.circle[circle + RADIUS])) {
                state.load[circle + LOADED_NEXT] = 1f;
            }
        }
    }
}
