package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import java.util.Arrays;

/** The numbers and traits of joints ({@link JointRow}), and which of them a step has not been told of. */
final class JointRows {
    private float[] rows = new float[0];
    private int[] traits = new int[0];
    private int lastSerial;

    /** Those that have changed since the step was told of them: from the first one to before the last one. */
    private int changedFrom = Integer.MAX_VALUE;

    private int changedTo;

    void setRoom(int joints) {
        float[] newRows = Arrays.copyOf(rows, JointRow.of(joints));
        int[] newTraits = Arrays.copyOf(traits, JointRow.traits(joints));
        rows = newRows;
        traits = newTraits;
    }

    float value(int joint, int which) {
        return rows[JointRow.of(joint) + which];
    }

    int trait(int joint, int which) {
        return traits[JointRow.traits(joint) + which];
    }

    /** A new joint, at rest. */
    void put(int joint, JointForm form, int spring, int a, int b) {
        System.arraycopy(form.row, 0, rows, JointRow.of(joint), JointRow.STRIDE);
        int at = JointRow.traits(joint);
        traits[at + JointRow.A] = a;
        traits[at + JointRow.B] = b;
        traits[at + JointRow.FORM] = form.traits;
        traits[at + JointRow.SPRING] = spring;
        traits[at + JointRow.ANCHOR] = 0;
        traits[at + JointRow.REFERENCE_A] = form.angle;
        traits[at + JointRow.REFERENCE_B] = 0;
        renew(joint);
    }

    /** Its impulses so far do not count. */
    void renew(int joint) {
        lastSerial = lastSerial == Integer.MAX_VALUE ? 1 : lastSerial + 1;
        setTrait(joint, JointRow.SERIAL, lastSerial);
    }

    void setTrait(int joint, int which, int to) {
        traits[JointRow.traits(joint) + which] = to;
        changed(joint);
    }

    void setValue(int joint, int which, float to) {
        rows[JointRow.of(joint) + which] = to;
        changed(joint);
    }

    /** The numbers that a setting has. */
    void write(int joint, JointSetting setting, float a, float b) {
        setting.write(rows, JointRow.of(joint), a, b);
        changed(joint);
    }

    /** Where an anchor is in the world. */
    void setAnchor(int joint, float x, float y) {
        setValue(joint, JointRow.ANCHOR_X, x);
        setValue(joint, JointRow.ANCHOR_Y, y);
    }

    /** The row of its anchor in the step. */
    void setAnchorRow(int joint, int row) {
        if (trait(joint, JointRow.ANCHOR) != row) {
            setTrait(joint, JointRow.ANCHOR, row);
        }
    }

    /** The angles, in units, at which both circles are as they should be. */
    void setReferences(int joint, int angleA, int angleB) {
        setTrait(joint, JointRow.REFERENCE_A, angleA);
        setTrait(joint, JointRow.REFERENCE_B, angleB);
    }

    /** Saved joints, so many, take the place of all: what has changed of others is of nobody's any more. */
    void load(int joints) {
        for (int joint = 0; joint < joints; joint++) {
            setTrait(joint, JointRow.FORM, JointRow.NO_JOINT);
        }
        changedFrom = 0;
        changedTo = joints;
    }

    private void changed(int joint) {
        changedFrom = Math.min(changedFrom, joint);
        changedTo = Math.max(changedTo, joint + 1);
    }

    /** Tells a step of what has changed. */
    void publish(JointStep step) {
        step.rows = rows;
        step.traits = traits;
        if (changedTo > 0) {
            step.changedFrom = changedFrom;
            step.changedTo = changedTo;
            step.version++;
            changedFrom = Integer.MAX_VALUE;
            changedTo = 0;
        }
    }

    long bytes() {
        return 4L * (rows.length + traits.length);
    }
}
