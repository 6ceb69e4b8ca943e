package io.github.circles2d.world.snapshots;

import io.github.circles2d.world.bodies.SavedRigids;
import io.github.circles2d.world.joints.JointLimits;
import io.github.circles2d.world.joints.JointTable;
import io.github.circles2d.world.joints.RigidEnds;
import io.github.circles2d.world.joints.SavedJointStates;
import io.github.circles2d.world.joints.SavedJoints;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointRules;
import io.github.circles2d.world.model.JointState;
import io.github.circles2d.world.model.Limits;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Joints in a snapshot: a section of {@link ParameterSections}, if there is or has been one.
 *
 * <pre>
 * section    int ids of joints; for each: byte flags; if the flags say so: varint generation; of a joint: varint form, byte colour, varint id
 *            of A; if the flags say so: varint id of B, varint body of the anchor, int reference angles of A and B; varint with a bit for
 *            each value of {@link SavedJoints} that differs from the initial one, float each of these; if the flags say so: byte with a bit for each
 *            number of {@link JointState} that is not 0, float each of these.
 *            Of a joint of bodies that are pushed: byte with a bit for A and one for B before the id of A, which is not there if A is a body; varint id,
 *            float x and y of the point of each body before the reference angles
 * </pre>
 */
final class JointSection {
    // flags
    private static final int LIVES = 1;
    private static final int HAS_GENERATION = 2;
    private static final int HAS_B = 4;
    private static final int HAS_BODY = 8;
    private static final int HAS_REFERENCES = 16;
    private static final int HAS_STATE = 32;
    private static final int HAS_RIGID = 64;

    // the ends that are bodies that are pushed
    private static final int IS_A = 1;
    private static final int IS_B = 2;

    /** Of a joint: flags, form, colour, A, values. */
    private static final int LEAST = 5;

    // of the square of the length of a direction, which few bits give where circles almost coincide
    private static final float LEAST_DIRECTION = 0.25f;
    private static final float GREATEST_DIRECTION = 2f;

    private JointSection() {}

    private static boolean isSame(float a, float b) {
        return Float.floatToRawIntBits(a) == Float.floatToRawIntBits(b);
    }

    // ---- writing

    private static int flags(SavedJoints j, int joint, int state) {
        int generation = j.generation[joint] == 0 ? 0 : HAS_GENERATION;
        if (!j.lives(joint)) {
            return generation;
        }
        return LIVES
                | generation
                | (j.b[joint] == JointRow.NONE ? 0 : HAS_B)
                | (j.body[joint] == 0 ? 0 : HAS_BODY)
                | ((j.referenceA[joint] | j.referenceB[joint]) == 0 ? 0 : HAS_REFERENCES)
                | (state == 0 ? 0 : HAS_STATE)
                | (j.holdsRigid(joint) ? HAS_RIGID : 0);
    }

    /** A bit for each value that is not the initial one. */
    private static int values(SavedJoints j, int joint) {
        int bits = 0;
        for (int k = 0; k < SavedJoints.VALUES; k++) {
            bits |= isSame(j.values[SavedJoints.VALUES * joint + k], SavedJoints.initial(k)) ? 0 : 1 << k;
        }
        return bits;
    }

    /** A bit for each number that is not 0. */
    private static int state(SavedState s, int joint) {
        int bits = 0;
        for (int k = 0; k < JointState.STRIDE; k++) {
            bits |= isSame(s.jointStates.rows[JointState.of(joint) + k], 0f) ? 0 : 1 << k;
        }
        return bits;
    }

    /** Writes the section behind its number. */
    static void write(SavedState s, ByteBuffer out) {
        out.putInt(s.joints.ids);
        for (int joint = 0; joint < s.joints.ids; joint++) {
            int state = state(s, joint);
            int flags = flags(s.joints, joint, state);
            out.put((byte) flags);
            if ((flags & HAS_GENERATION) != 0) {
                Varint.put(out, s.joints.generation[joint]);
            }
            if ((flags & LIVES) != 0) {
                writeJoint(s.joints, joint, flags, out);
                writeState(s.jointStates, joint, state, out);
            }
        }
    }

    private static void writeJoint(SavedJoints j, int joint, int flags, ByteBuffer out) {
        Varint.put(out, j.form[joint]);
        out.put(j.colour[joint]);
        if ((flags & HAS_RIGID) != 0) {
            out.put((byte) rigidEnds(j, joint));
        }
        if (j.a[joint] != JointRow.NONE) {
            Varint.put(out, j.a[joint]);
        }
        if ((flags & HAS_B) != 0) {
            Varint.put(out, j.b[joint]);
        }
        if ((flags & HAS_BODY) != 0) {
            Varint.put(out, j.body[joint]);
        }
        if ((flags & HAS_RIGID) != 0) {
            writeRigid(j, joint, out);
        }
        if ((flags & HAS_REFERENCES) != 0) {
            out.putInt(j.referenceA[joint]).putInt(j.referenceB[joint]);
        }
        int values = values(j, joint);
        Varint.put(out, values);
        for (int k = 0; k < SavedJoints.VALUES; k++) {
            if ((values & 1 << k) != 0) {
                out.putFloat(j.values[SavedJoints.VALUES * joint + k]);
            }
        }
    }

    private static void writeRigid(SavedJoints j, int joint, ByteBuffer out) {
        for (int end = RigidEnds.A; end <= RigidEnds.B; end++) {
            if (j.rigid(joint, end) != JointRow.NONE) {
                Varint.put(out, j.rigid(joint, end));
                out.putFloat(j.rigidX(joint, end)).putFloat(j.rigidY(joint, end));
            }
        }
    }

    private static int rigidEnds(SavedJoints j, int joint) {
        return (j.rigid(joint, RigidEnds.A) == JointRow.NONE ? 0 : IS_A)
                | (j.rigid(joint, RigidEnds.B) == JointRow.NONE ? 0 : IS_B);
    }

    private static void writeState(SavedJointStates states, int joint, int state, ByteBuffer out) {
        if (state != 0) {
            out.put((byte) state);
            for (int k = 0; k < JointState.STRIDE; k++) {
                if ((state & 1 << k) != 0) {
                    out.putFloat(states.rows[JointState.of(joint) + k]);
                }
            }
        }
    }

    // ---- reading

    /** Reads the section behind its number, and checks all but the colours and bodies that are pushed; circles and terrain have been read. */
    static void read(ByteBuffer in, SavedState s) {
        int ids = in.getInt();
        if (!(ids > 0 && ids <= JointRules.JOINTS && ids <= in.remaining())) {
            throw SnapshotCodec.refused("it cannot hold " + ids + " joints");
        }
        s.joints.setIds(ids);
        s.jointStates.begin(ids);
        for (int joint = 0; joint < ids; joint++) {
            int flags = SnapshotCodec.getByte(in);
            boolean lives = (flags & LIVES) != 0;
            SnapshotCodec.require(
                    flags < 2 * HAS_RIGID && (lives || (flags & ~HAS_GENERATION) == 0), "a joint has no such flags");
            s.joints.generation[joint] = SnapshotCodec.getGeneration(in, (flags & HAS_GENERATION) != 0);
            s.joints.form[joint] = JointRow.NO_JOINT;
            Arrays.fill(s.jointStates.rows, JointState.of(joint), JointState.of(joint + 1), 0f);
            if (lives) {
                readJoint(in, s, joint, flags);
            }
        }
    }

    private static void readJoint(ByteBuffer in, SavedState s, int joint, int flags) {
        SavedJoints j = s.joints;
        int form = Varint.get(in);
        int colour = SnapshotCodec.getByte(in);
        SnapshotCodec.require(colour <= JointTable.SPLIT, "a joint has no such colour");
        boolean hasRigid = (flags & HAS_RIGID) != 0;
        j.form[joint] = form;
        j.colour[joint] = (byte) colour;
        j.setRigid(joint, RigidEnds.A, JointRow.NONE, 0f, 0f);
        j.setRigid(joint, RigidEnds.B, JointRow.NONE, 0f, 0f);
        SnapshotCodec.require(!hasRigid || colour == JointTable.SPLIT, "a joint of a body has a colour");
        int ends = hasRigid ? rigidEnds(in) : 0;
        j.a[joint] = (ends & IS_A) == 0 ? circle(in, s) : JointRow.NONE;
        boolean hasCircle = (flags & HAS_B) != 0;
        SnapshotCodec.require(!hasCircle || (ends & IS_B) == 0, "a joint has two other ends");
        j.b[joint] = hasCircle ? circle(in, s) : JointRow.NONE;
        SnapshotCodec.require(hasRigid || j.a[joint] != j.b[joint], "a joint holds a circle to itself");
        boolean hasB = hasCircle || (ends & IS_B) != 0;
        SnapshotCodec.require(
                JointRules.isForm(form) && takesEnd(form, hasB, hasRigid), "a joint has a form that makes no sense");
        boolean hasAnchor = !hasB && JointRules.takesAnchor(form);
        j.body[joint] = (flags & HAS_BODY) != 0 ? body(in, s, hasAnchor) : 0;
        readRigid(in, j, joint, ends);
        j.referenceA[joint] = 0;
        j.referenceB[joint] = 0;
        if ((flags & HAS_REFERENCES) != 0) {
            j.referenceA[joint] = in.getInt();
            j.referenceB[joint] = in.getInt();
            SnapshotCodec.require(
                    turns(form)
                            && (j.referenceA[joint] | j.referenceB[joint]) != 0
                            && (hasB || j.referenceB[joint] == 0),
                    "a joint has no such angles");
        }
        readValues(in, j, joint, hasAnchor, s.parameters().bounds());
        if ((flags & HAS_STATE) != 0) {
            readState(in, s, joint);
        }
    }

    private static boolean takesEnd(int form, boolean hasB, boolean hasRigid) {
        return hasB
                ? JointRules.takesCircles(form) || hasRigid && !JointRules.takesNothing(form)
                : JointRules.takesAnchor(form) || JointRules.takesNothing(form);
    }

    /** Which ends are bodies that are pushed. */
    private static int rigidEnds(ByteBuffer in) {
        int ends = SnapshotCodec.getByte(in);
        SnapshotCodec.require(ends > 0 && ends <= (IS_A | IS_B), "a joint has no such ends");
        return ends;
    }

    private static void readRigid(ByteBuffer in, SavedJoints j, int joint, int ends) {
        for (int end = RigidEnds.A; end <= RigidEnds.B; end++) {
            if ((ends & (end == RigidEnds.A ? IS_A : IS_B)) != 0) {
                int body = Varint.get(in);
                SnapshotCodec.require(body >= 0, "a joint lacks a body");
                j.setRigid(joint, end, body, in.getFloat(), in.getFloat());
            }
        }
    }

    /** Checks the bodies that are pushed that joints hold, which have been read. */
    static void checkRigids(SavedState s) {
        SavedJoints j = s.joints;
        for (int joint = 0; joint < j.ids; joint++) {
            if (j.lives(joint) && j.holdsRigid(joint)) {
                checkRigid(s, joint, RigidEnds.A);
                checkRigid(s, joint, RigidEnds.B);
                SnapshotCodec.require(
                        j.rigid(joint, RigidEnds.A) != j.rigid(joint, RigidEnds.B), "a joint holds a body to itself");
            }
        }
    }

    private static void checkRigid(SavedState s, int joint, int end) {
        SavedRigids r = s.rigids;
        int body = s.joints.rigid(joint, end);
        if (body != JointRow.NONE) {
            SnapshotCodec.require(body >= 0 && body < r.ids && r.lives(body), "a joint lacks a body");
            JointLimits.point(s.joints.rigidX(joint, end), s.joints.rigidY(joint, end), r.outlines[r.outline[body]]);
        }
    }

    /** Whether a joint turns circles by their angles. */
    private static boolean turns(int form) {
        int angular = form & JointRow.ANGULAR;
        return angular == JointRow.TURN_ANGLE || angular == JointRow.TURN_RIGID;
    }

    private static int circle(ByteBuffer in, SavedState s) {
        int id = Varint.get(in);
        SnapshotCodec.require(
                id >= 0 && id < s.ids && Arrays.binarySearch(s.id, 0, s.circles, id) >= 0, "a joint lacks a circle");
        return id;
    }

    /** The number of a body that moves the anchor; 0 has no flag. */
    private static int body(ByteBuffer in, SavedState s, boolean hasAnchor) {
        int body = Varint.get(in);
        SnapshotCodec.require(
                hasAnchor && body > 0 && body < s.terrain.bodyIds && s.terrain.bodyLives[body],
                "a joint has no body of terrain");
        return body;
    }

    private static void readValues(ByteBuffer in, SavedJoints j, int joint, boolean hasAnchor, Bounds bounds) {
        int values = Varint.get(in);
        int form = j.form[joint];
        SnapshotCodec.require((values & ~valuesOf(form, hasAnchor)) == 0, "a joint has no such values");
        for (int k = 0; k < SavedJoints.VALUES; k++) {
            float value = SavedJoints.initial(k);
            if ((values & 1 << k) != 0) {
                value = in.getFloat();
                SnapshotCodec.require(
                        !isSame(value, SavedJoints.initial(k)) && (!isSame(value, -0f) || isDirection(k)),
                        "it has an initial value of a joint");
                check(k, value);
            }
            j.values[SavedJoints.VALUES * joint + k] = value;
        }
        int at = SavedJoints.VALUES * joint;
        if (hasAnchor && j.body[joint] == 0) {
            anchor(j.values[at + JointRow.ANCHOR_X], bounds.minX(), bounds.maxX(), bounds.periodX());
            anchor(j.values[at + JointRow.ANCHOR_Y], bounds.minY(), bounds.maxY(), bounds.periodY());
        }
        checkLengths(form, j.values[at + JointRow.MIN_LENGTH], j.values[at + JointRow.MAX_LENGTH]);
        boolean breaks = j.values[at + JointRow.BREAK_FORCE] != Float.POSITIVE_INFINITY
                || j.values[at + JointRow.BREAK_TORQUE] != Float.POSITIVE_INFINITY;
        SnapshotCodec.require(breaks == ((form & JointRow.BREAKABLE) != 0), "a joint breaks by no force");
        if ((form & JointRow.ACROSS) != 0) {
            float x = j.values[at + JointRow.DIRECTION_X];
            float y = j.values[at + JointRow.DIRECTION_Y];
            float square = x * x + y * y;
            SnapshotCodec.require(
                    square >= LEAST_DIRECTION && square <= GREATEST_DIRECTION, "the direction of a joint is none");
        }
    }

    private static void checkLengths(int form, float least, float greatest) {
        SnapshotCodec.require(
                least > 0f == ((form & JointRow.LOWER) != 0)
                        && greatest < Float.POSITIVE_INFINITY == ((form & JointRow.UPPER) != 0)
                        && least <= greatest,
                "the lengths of a joint are out of order");
    }

    private static boolean isDirection(int k) {
        return k == JointRow.DIRECTION_X || k == JointRow.DIRECTION_Y;
    }

    /** A bit for each value that a form has. */
    private static int valuesOf(int form, boolean hasAnchor) {
        int linear = form & JointRow.LINEAR;
        int angular = form & JointRow.ANGULAR;
        boolean axial = linear == JointRow.AXIAL;
        return (hasAnchor ? 1 << JointRow.ANCHOR_X | 1 << JointRow.ANCHOR_Y : 0)
                | (axial && (form & (JointRow.RIGID | JointRow.ELASTIC)) != 0 ? 1 << JointRow.LENGTH : 0)
                | ((form & JointRow.LOWER) != 0 ? 1 << JointRow.MIN_LENGTH : 0)
                | ((form & JointRow.UPPER) != 0 ? 1 << JointRow.MAX_LENGTH : 0)
                | (linear != 0 && !axial ? 1 << JointRow.MAX_FORCE : 0)
                | (angular != 0 ? 1 << JointRow.MAX_TORQUE : 0)
                | (angular == JointRow.TURN_SPEED ? 1 << JointRow.SPEED : 0)
                | ((form & JointRow.BREAKABLE) != 0 ? 1 << JointRow.BREAK_FORCE | 1 << JointRow.BREAK_TORQUE : 0)
                | ((form & JointRow.ACROSS) != 0 ? 1 << JointRow.DIRECTION_X | 1 << JointRow.DIRECTION_Y : 0)
                | ((form & JointRow.ELASTIC) != 0 ? 1 << SavedJoints.FREQUENCY | 1 << SavedJoints.DAMPING_RATIO : 0);
    }

    private static void check(int k, float value) {
        switch (k) {
            case JointRow.ANCHOR_X, JointRow.ANCHOR_Y ->
                Limits.within("an anchor", value, -Limits.COORDINATE, Limits.COORDINATE);
            case JointRow.LENGTH, JointRow.MIN_LENGTH -> Limits.within("a length", value, 0f, JointRules.LENGTH);
            case JointRow.SPEED ->
                Limits.within("the speed of a joint", value, -Limits.ANGULAR_VELOCITY, Limits.ANGULAR_VELOCITY);
            case JointRow.DIRECTION_X, JointRow.DIRECTION_Y -> Limits.within("a direction", value, -2f, 2f);
            case SavedJoints.FREQUENCY -> Limits.within("the frequency", value, 0f, JointRules.FREQUENCY);
            case SavedJoints.DAMPING_RATIO -> Limits.within("the damping ratio", value, 0f, JointRules.DAMPING_RATIO);
            default -> Limits.within("a value of a joint", value, 0f, Float.POSITIVE_INFINITY);
        }
    }

    /** An anchor of the world is inside an axis that wraps. */
    private static void anchor(float at, float min, float max, float period) {
        SnapshotCodec.require(
                period == Float.POSITIVE_INFINITY || at >= min && at <= max, "an anchor of a joint is out of range");
    }

    private static void readState(ByteBuffer in, SavedState s, int joint) {
        int state = SnapshotCodec.getByte(in);
        SnapshotCodec.require(
                state != 0 && (state & ~impulses(s.joints.form[joint])) == 0, "a joint has no such impulses");
        for (int k = 0; k < JointState.STRIDE; k++) {
            if ((state & 1 << k) != 0) {
                float value = in.getFloat();
                float most = k < JointState.SUM_X ? JointMath.GREATEST_IMPULSE : Limits.CACHED_IMPULSE;
                float least = k == JointState.LOWER || k == JointState.UPPER ? 0f : -most;
                SnapshotCodec.require(!isSame(value, 0f), "it has a 0 of an impulse of a joint");
                s.jointStates.rows[JointState.of(joint) + k] =
                        Limits.within("an impulse of a joint", value, least, most);
            }
        }
    }

    /** A bit for each number of its state that a form has. */
    private static int impulses(int form) {
        int linear = form & JointRow.LINEAR;
        boolean point = linear == JointRow.POINT || linear == JointRow.DRAG;
        boolean angular = (form & JointRow.ANGULAR) != 0;
        boolean along = point || (form & (JointRow.RIGID | JointRow.ELASTIC)) != 0;
        boolean across = point || (form & JointRow.ACROSS) != 0;
        return (along ? 1 << JointState.AXIAL : 0)
                | (across ? 1 << JointState.ACROSS : 0)
                | ((form & JointRow.LOWER) != 0 ? 1 << JointState.LOWER : 0)
                | ((form & JointRow.UPPER) != 0 ? 1 << JointState.UPPER : 0)
                | (angular ? 1 << JointState.ANGULAR | 1 << JointState.SUM_ANGULAR : 0)
                | (linear != 0 ? 1 << JointState.SUM_X | 1 << JointState.SUM_Y : 0);
    }

    /** No two joints of a circle have one colour, unless they are split. */
    static void checkColours(SavedState s) {
        SavedJoints j = s.joints;
        int[] taken = new int[j.ids > 0 ? s.ids : 0];
        for (int joint = 0; joint < j.ids; joint++) {
            if (j.lives(joint) && j.colour[joint] != JointTable.SPLIT) {
                take(taken, j.a[joint], j.colour[joint]);
                if (j.b[joint] != JointRow.NONE) {
                    take(taken, j.b[joint], j.colour[joint]);
                }
            }
        }
    }

    private static void take(int[] taken, int circle, int colour) {
        SnapshotCodec.require((taken[circle] & 1 << colour) == 0, "two joints of a circle have one colour");
        taken[circle] |= 1 << colour;
    }
}
