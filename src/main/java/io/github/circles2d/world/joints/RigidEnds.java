package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import java.util.Arrays;

/** By joint: the bodies that are pushed which it holds, and where. */
public final class RigidEnds {
    /** The ends of a joint. */
    public static final int A = 0;

    public static final int B = 1;

    private static final int BODIES = 2;
    private static final int COORDINATES = 4;

    private int[] body = new int[0];

    /** In the coordinates of the bodies. */
    private float[] point = new float[0];

    private int count;

    RigidEnds() {}

    void setRoom(int joints) {
        int[] newBody = Arrays.copyOf(body, BODIES * joints);
        float[] newPoint = Arrays.copyOf(point, COORDINATES * joints);
        body = newBody;
        point = newPoint;
    }

    /** How many joints hold bodies. */
    public int count() {
        return count;
    }

    /** The body at an end, or {@link JointRow#NONE}. */
    public int body(int joint, int end) {
        return body[BODIES * joint + end];
    }

    public float x(int joint, int end) {
        return point[COORDINATES * joint + 2 * end];
    }

    public float y(int joint, int end) {
        return point[COORDINATES * joint + 2 * end + 1];
    }

    /** Whether a joint holds a body. */
    public boolean has(int joint) {
        return body(joint, A) != JointRow.NONE || body(joint, B) != JointRow.NONE;
    }

    /** Whether it holds this one. */
    public boolean has(int joint, int itsBody) {
        return body(joint, A) == itsBody || body(joint, B) == itsBody;
    }

    /** A new joint, which holds none. */
    void begin(int joint) {
        for (int end = A; end <= B; end++) {
            body[BODIES * joint + end] = JointRow.NONE;
            setPoint(joint, end, 0f, 0f);
        }
    }

    /** The bodies of a new joint, of which one may be {@link JointRow#NONE}. */
    void enter(int joint, int bodyA, int bodyB) {
        body[BODIES * joint + A] = bodyA;
        body[BODIES * joint + B] = bodyB;
        count++;
    }

    void setPoint(int joint, int end, float x, float y) {
        point[COORDINATES * joint + 2 * end] = x + 0f;
        point[COORDINATES * joint + 2 * end + 1] = y + 0f;
    }

    /** A joint goes. */
    void leave(int joint) {
        if (has(joint)) {
            count--;
        }
    }

    /** No joints. */
    void clear() {
        count = 0;
    }

    /** Tells a step of the bodies and points. */
    void publish(JointStep step) {
        step.rigidBodies = body;
        step.rigidPoints = point;
    }

    long bytes() {
        return 4L * (body.length + point.length);
    }
}
