package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.circles.KindField;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.shared.CallLog;
import io.github.circles2d.world.shared.Copies;
import io.github.circles2d.world.shared.Guard;
import io.github.circles2d.world.shared.LoggedCall;
import io.github.circles2d.world.shared.WorldSettings;

/** The calls on kinds of circles. A change acts from the next step on. */
public final class Kinds {
    private final Guard guard;
    private final KindTable table;
    private final CircleFields fields;
    private final CallLog log;
    private final Copies copies;
    private final WorldSettings settings;

    public Kinds(
            Guard guard, KindTable table, CircleFields fields, CallLog log, Copies copies, WorldSettings settings) {
        this.guard = guard;
        this.table = table;
        this.fields = fields;
        this.log = log;
        this.copies = copies;
        this.settings = settings;
    }

    public int check(int kind) {
        guard.check();
        return KindTable.check(kind);
    }

    public int get(KindField field, int kind) {
        guard.check();
        return table.get(field, kind);
    }

    public float getFloat(KindField field, int kind) {
        return Float.intBitsToFloat(get(field, kind));
    }

    public void set(KindField field, int kind, int value) {
        guard.enter();
        try {
            field.check(value);
            log.call(LoggedCall.KIND, kind, field.number(), value, 0);
            copies.forgetSaved();
            guard.changing = true;
            table.set(field, kind, value);
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
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
        guard.check();
        return table.setting(KindTable.check(a), KindTable.check(b));
    }

    /** Sets what the matrix has of two kinds. */
    public void setSetting(int a, int b, int setting) {
        guard.enter();
        try {
            KindTable.check(a);
            KindTable.check(b);
            log.call(LoggedCall.PAIR_OF_KINDS, a, b, setting, 0);
            copies.forgetSaved();
            guard.changing = true;
            table.setSetting(a, b, setting);
            guard.changing = false;
        } catch (RuntimeException | Error thrown) {
            throw guard.failed(thrown);
        } finally {
            guard.user = null;
        }
    }

    public float restitution(int kind, float otherwise) {
        return own(KindField.RESTITUTION, kind, otherwise);
    }

    /** The restitution of a new circle of a kind: that of the kind, else the world's. */
    float newRestitution(int kind) {
        return restitution(kind, settings.defaultRestitution());
    }

    /** The friction of circles of a kind that have none of their own: that of the kind, else the world's. */
    float friction(int kind) {
        return own(KindField.FRICTION, kind, settings.surfaces().friction);
    }

    /** Likewise. */
    float rollingResistance(int kind) {
        return own(KindField.ROLLING_RESISTANCE, kind, settings.surfaces().rollingResistance);
    }

    /** What a kind has of a field, unless it has none. */
    private float own(KindField field, int kind, float otherwise) {
        float own = Float.intBitsToFloat(table.get(field, kind));
        return Float.isNaN(own) ? otherwise : own;
    }

    /** The inverse inertia of the circles of a kind by their inverse mass. */
    float inertia(int kind) {
        return table.inertia(kind);
    }

    /** Whether some pair of circles may have to be filtered: a pair of kinds is not solid, or a circle has had a group. */
    public boolean filter() {
        return table.filters() || fields.isUsed(CircleField.GROUP);
    }
}
