package io.github.circles2d.world.joints;

import io.github.circles2d.world.circles.StateHash;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointRules;
import io.github.circles2d.world.model.JointState;

/**
 * The joints of a saved state, by id: what they are. {@link SavedJointStates} has what they keep from step to step. Arrays are reused, and may be
 * longer than their contents.
 */
public final class SavedJoints {
    // values: those of JointRow, with the anchor in the frame of its body; and its spring
    public static final int FREQUENCY = JointRow.STRIDE;
    public static final int DAMPING_RATIO = JointRow.STRIDE + 1;

    /** Floats of a joint. */
    public static final int VALUES = JointRow.STRIDE + 2;

    /** Ids in use so far. */
    public int ids;

    public int[] generation = new int[0];

    /** By id: the form, {@link JointRow#NO_JOINT} of a free id. */
    public int[] form = new int[0];

    /** By id: the colour, or {@link JointTable#SPLIT}. */
    public byte[] colour = new byte[0];

    /** By id: the id of the circle, or {@link JointRow#NONE} if a body that is pushed is there. */
    public int[] a = new int[0];

    /** By id: the id of the other circle, or {@link JointRow#NONE}. */
    public int[] b = new int[0];

    /** By id: the body of terrain that has the anchor; 0 is the ground, and the world. */
    public int[] body = new int[0];

    /** Two elements an id: the bodies that are pushed at A and B, or {@link JointRow#NONE}. */
    public int[] rigid = new int[0];

    /** Four elements an id: x and y of the points on these bodies. */
    public float[] rigidPoints = new float[0];

    /** By id: angles of A and B, in units. */
    public int[] referenceA = new int[0];

    public int[] referenceB = new int[0];

    /** By id: {@link #VALUES} floats. */
    public float[] values = new float[0];

    /** As it is at first. */
    public void clear() {
        ids = 0;
    }

    public boolean isAsAtFirst() {
        return ids == 0;
    }

    public boolean lives(int joint) {
        return form[joint] != JointRow.NO_JOINT;
    }

    /** The body that is pushed at an end of a joint, or {@link JointRow#NONE}. */
    public int rigid(int joint, int end) {
        return rigid[2 * joint + end];
    }

    /** Whether a joint holds a body that is pushed. */
    public boolean holdsRigid(int joint) {
        return rigid(joint, RigidEnds.A) != JointRow.NONE || rigid(joint, RigidEnds.B) != JointRow.NONE;
    }

    /** Sets an end of a joint: a body that is pushed, or {@link JointRow#NONE}, and the point on it. */
    public void setRigid(int joint, int end, int body, float x, float y) {
        rigid[2 * joint + end] = body;
        rigidPoints[4 * joint + 2 * end] = x;
        rigidPoints[4 * joint + 2 * end + 1] = y;
    }

    public float rigidX(int joint, int end) {
        return rigidPoints[4 * joint + 2 * end];
    }

    public float rigidY(int joint, int end) {
        return rigidPoints[4 * joint + 2 * end + 1];
    }

    /** Whether there are joints. */
    public boolean hasJoints() {
        for (int joint = 0; joint < ids; joint++) {
            if (lives(joint)) {
                return true;
            }
        }
        return false;
    }

    /** Whether any joint turns circles. */
    public boolean turn() {
        for (int joint = 0; joint < ids; joint++) {
            if (lives(joint) && JointRules.turns(form[joint])) {
                return true;
            }
        }
        return false;
    }

    /** The part of the joints in the hash of the state. */
    public long hash(SavedJointStates states) {
        long sum = 0;
        for (int joint = 0; joint < ids; joint++) {
            if (lives(joint)) {
                sum += hash(joint, states);
            }
        }
        return sum;
    }

    /** The number of a joint, with what it keeps from step to step; rows of free ids do not count. */
    private long hash(int joint, SavedJointStates states) {
        long h = StateHash.absorb(StateHash.absorb(StateHash.joint(), joint), form[joint]);
        h = StateHash.absorb(StateHash.absorb(StateHash.absorb(h, colour[joint]), a[joint]), b[joint]);
        h = StateHash.absorb(StateHash.absorb(h, body[joint]), referenceA[joint]);
        h = StateHash.absorb(h, referenceB[joint]);
        if (holdsRigid(joint)) {
            for (int end = RigidEnds.A; end <= RigidEnds.B; end++) {
                h = StateHash.absorb(h, rigid(joint, end));
                h = StateHash.absorb(StateHash.absorb(h, rigidX(joint, end)), rigidY(joint, end));
            }
        }
        for (int k = VALUES * joint; k < VALUES * (joint + 1); k++) {
            h = StateHash.absorb(h, values[k]);
        }
        for (int k = JointState.of(joint); k < JointState.of(joint + 1); k++) {
            h = StateHash.absorb(h, states.rows[k]);
        }
        return h;
    }

    /** Makes room, without the contents so far, and sets the number. */
    public void setIds(int joints) {
        if (values.length < VALUES * joints) {
            // The array that is compared grows last: a growth that fails is tried again.
            int room = values.length / VALUES;
            int c = Math.max(joints, room + (room >> 1));
            generation = new int[c];
            form = new int[c];
            colour = new byte[c];
            a = new int[c];
            b = new int[c];
            body = new int[c];
            rigid = new int[2 * c];
            rigidPoints = new float[4 * c];
            referenceA = new int[c];
            referenceB = new int[c];
            values = new float[VALUES * c];
        }
        ids = joints;
    }

    /** What a value is if it says nothing: what has no limit is infinite. */
    public static float initial(int value) {
        return switch (value) {
            case JointRow.MAX_LENGTH,
                    JointRow.MAX_FORCE,
                    JointRow.MAX_TORQUE,
                    JointRow.BREAK_FORCE,
                    JointRow.BREAK_TORQUE -> Float.POSITIVE_INFINITY;
            default -> 0f;
        };
    }
}
