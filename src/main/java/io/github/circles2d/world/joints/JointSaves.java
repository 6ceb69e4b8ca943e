package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.JointRow;

/** Saves joints, and takes saved ones over. */
public final class JointSaves {
    private final JointTable table;

    /** That of the joint that is taken over. */
    private final JointForm form = new JointForm(JointRow.NO_JOINT);

    JointSaves(JointTable table) {
        this.table = table;
    }

    public void save(SavedJoints to) {
        to.setIds(table.ids.end());
        table.ids.save(to.generation);
        for (int joint = 0; joint < to.ids; joint++) {
            to.form[joint] = table.ids.lives(joint) ? table.form(joint) : JointRow.NO_JOINT;
            if (table.ids.lives(joint)) {
                save(joint, to);
            }
        }
    }

    private void save(int joint, SavedJoints to) {
        to.colour[joint] = (byte) table.colour(joint);
        to.a[joint] = table.a(joint);
        to.b[joint] = table.b(joint);
        to.body[joint] = table.places.body(joint);
        for (int end = RigidEnds.A; end <= RigidEnds.B; end++) {
            to.setRigid(joint, end, table.rigid.body(joint, end), table.rigid.x(joint, end), table.rigid.y(joint, end));
        }
        to.referenceA[joint] = table.trait(joint, JointRow.REFERENCE_A);
        to.referenceB[joint] = table.trait(joint, JointRow.REFERENCE_B);
        for (int k = 0; k < SavedJoints.VALUES; k++) {
            to.values[SavedJoints.VALUES * joint + k] = value(joint, k);
        }
    }

    /** A value of {@link SavedJoints}. */
    private float value(int joint, int k) {
        boolean onBody = table.places.body(joint) != AnchorPlaces.WORLD;
        return switch (k) {
            case SavedJoints.FREQUENCY -> table.frequency(joint);
            case SavedJoints.DAMPING_RATIO -> table.dampingRatio(joint);
            case JointRow.ANCHOR_X -> onBody ? table.places.x(joint) : table.value(joint, k);
            case JointRow.ANCHOR_Y -> onBody ? table.places.y(joint) : table.value(joint, k);
            default -> table.value(joint, k);
        };
    }

    /** Leaves what joints of now keep; others have no impulses. */
    public void keepPresent(SavedJointStates states) {
        states.extend(table.ids.end());
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (!table.ids.lives(joint) || states.serial[joint] != table.serial(joint)) {
                states.clear(joint);
            }
        }
    }

    /** Takes over saved joints, whose circles and bodies are there; what they keep gets the serials of now. There is room. */
    void load(SavedJoints from, SavedJointStates states) {
        if (!areThose(from)) {
            table.load(from.generation, from.ids);
            for (int joint = 0; joint < from.ids; joint++) {
                if (from.lives(joint)) {
                    load(joint, from);
                }
            }
        }
        for (int joint = 0; joint < from.ids; joint++) {
            states.serial[joint] = table.ids.lives(joint) ? table.serial(joint) : 0;
        }
    }

    /** Whether the saved joints are those that are there, by their bits, as in each rollback: their order stays. */
    private boolean areThose(SavedJoints from) {
        boolean same = from.ids == table.ids.end();
        for (int joint = 0; same && joint < from.ids; joint++) {
            same = table.ids.isSame(joint, from.lives(joint), from.generation[joint])
                    && (!table.ids.lives(joint) || isThat(from, joint));
        }
        return same;
    }

    private boolean isThat(SavedJoints from, int joint) {
        boolean same = from.form[joint] == table.form(joint)
                && from.colour[joint] == table.colour(joint)
                && from.a[joint] == table.a(joint)
                && from.b[joint] == table.b(joint)
                && from.body[joint] == table.places.body(joint)
                && from.referenceA[joint] == table.trait(joint, JointRow.REFERENCE_A)
                && from.referenceB[joint] == table.trait(joint, JointRow.REFERENCE_B);
        for (int end = RigidEnds.A; same && end <= RigidEnds.B; end++) {
            same = from.rigid(joint, end) == table.rigid.body(joint, end)
                    && isSame(from.rigidX(joint, end), table.rigid.x(joint, end))
                    && isSame(from.rigidY(joint, end), table.rigid.y(joint, end));
        }
        for (int k = 0; same && k < SavedJoints.VALUES; k++) {
            same = isSame(from.values[SavedJoints.VALUES * joint + k], value(joint, k));
        }
        return same;
    }

    private static boolean isSame(float a, float b) {
        return Float.floatToRawIntBits(a) == Float.floatToRawIntBits(b);
    }

    private void load(int joint, SavedJoints from) {
        int values = SavedJoints.VALUES * joint;
        form.traits = from.form[joint];
        System.arraycopy(from.values, values, form.row, 0, JointRow.STRIDE);
        form.frequency = from.values[values + SavedJoints.FREQUENCY];
        form.dampingRatio = from.values[values + SavedJoints.DAMPING_RATIO];
        table.revive(joint, form, from.a[joint], from.b[joint]);
        table.setReferences(joint, from.referenceA[joint], from.referenceB[joint]);
        if (from.holdsRigid(joint)) {
            table.rigid.enter(joint, from.rigid(joint, RigidEnds.A), from.rigid(joint, RigidEnds.B));
            table.rigid.setPoint(joint, RigidEnds.A, from.rigidX(joint, RigidEnds.A), from.rigidY(joint, RigidEnds.A));
            table.rigid.setPoint(joint, RigidEnds.B, from.rigidX(joint, RigidEnds.B), from.rigidY(joint, RigidEnds.B));
        }
        table.ofCircles.setColour(joint, from.colour[joint]);
        table.link(joint);
        if (from.body[joint] != AnchorPlaces.WORLD) {
            table.places.enter(joint, from.body[joint]);
            table.places.set(joint, from.values[values + JointRow.ANCHOR_X], from.values[values + JointRow.ANCHOR_Y]);
        }
    }
}
