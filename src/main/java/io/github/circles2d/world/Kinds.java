package io.github.circles2d.world;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.KindField;
import io.github.circles2d.world.circles.KindTable;

/** The calls on kinds of circles. A change acts from the next step on. */
public final class Kinds {
    private final Simulation simulation;
    private final Guard guard;
    private final KindTable table;

    Kinds(Simulation simulation) {
        this.simulation = simulation;
        guard = simulation.guard;
        table = simulation.kindTable;
    }

    /** Checks the number of a kind. */
    public int check(int kind) {
        guard.enter();
        try {
            return KindTable.check(kind);
        } finally {
            guard.user = null;
        }
    }

    /** A field of a kind. */
    public int get(KindField field, int kind) {
        guard.enter();
        try {
            return table.get(field, kind);
        } finally {
            guard.user = null;
        }
    }

    /** A field of a kind that is a float. */
    public float getFloat(KindField field, int kind) {
        return Float.intBitsToFloat(get(field, kind));
    }

    /** Sets a field of a kind. */
    public void set(KindField field, int kind, int value) {
        guard.enter();
        try {
            field.check(value);
            simulation.journal.call(LoggedCall.KIND, kind, field.number(), value, 0);
            simulation.snapshots().forget();
            guard.changing = true;
            table.set(field, kind, value);
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Sets a field of a kind that is a float. All numbers that are none are one. */
    public void set(KindField field, int kind, float value) {
        set(field, kind, Float.floatToIntBits(value));
    }

    /** What the matrix has of two kinds: {@link KindTable#BY_MASK}, or {@link KindTable#RESPONSE} and a response. */
    public int setting(int a, int b) {
        guard.enter();
        try {
            return table.setting(KindTable.check(a), KindTable.check(b));
        } finally {
            guard.user = null;
        }
    }

    /** Sets what the matrix has of two kinds. */
    public void setSetting(int a, int b, int setting) {
        guard.enter();
        try {
            KindTable.check(a);
            KindTable.check(b);
            simulation.journal.call(LoggedCall.PAIR_OF_KINDS, a, b, setting, 0);
            simulation.snapshots().forget();
            guard.changing = true;
            table.setSetting(a, b, setting);
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** The restitution that a circle gets with a kind, or else. */
    float restitution(int kind, float otherwise) {
        float own = Float.intBitsToFloat(table.get(KindField.RESTITUTION, kind));
        return Float.isNaN(own) ? otherwise : own;
    }

    /** Whether some pair of circles may have to be filtered: a pair of kinds is not solid, or a circle has had a group. */
    boolean filter() {
        return table.filters() || simulation.handles.fields().isUsed(CircleField.GROUP);
    }
}
