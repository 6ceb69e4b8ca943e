package io.github.circles2d.world.changes;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.CircleFields;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;

/** The calls on kinds of circles. A change acts from the next step on. */
public final class Kinds implements Calls.Effects {
    private final WorldParts world;
    private final CircleFields fields;

    /** How a kind responded to each one before a change. */
    private final int[] before = new int[PairTable.KINDS];

    public Kinds(WorldParts world) {
        this.world = world;
        fields = world.handles.fields();
        world.calls.define(this, Call.KIND, Call.PAIR_OF_KINDS);
    }

    public int check(int kind) {
        world.guard.check();
        return KindTable.check(kind);
    }

    public int get(KindField field, int kind) {
        world.guard.check();
        return world.kinds.get(field, kind);
    }

    public float getFloat(KindField field, int kind) {
        return Float.intBitsToFloat(get(field, kind));
    }

    public void set(KindField field, int kind, int value) {
        world.calls.make(Call.KIND, kind, field.number(), value, 0);
    }

    /** Sets a field of a kind that is a float. All numbers that are none are one. */
    public void set(KindField field, int kind, float value) {
        set(field, kind, Float.floatToIntBits(value));
    }

    /** What the matrix has of two kinds: {@link KindTable#BY_MASK}, or {@link KindTable#RESPONSE} and a response. */
    public int setting(int a, int b) {
        world.guard.check();
        return world.kinds.setting(KindTable.check(a), KindTable.check(b));
    }

    /** Sets what the matrix has of two kinds. */
    public void setSetting(int a, int b, int setting) {
        world.calls.make(Call.PAIR_OF_KINDS, a, b, setting, 0);
    }

    /** Makes a kind what another one is: its fields, and what it does to all kinds. */
    public void copy(int from, int to) {
        world.guard.check();
        for (int k = 0; k < KindField.ALL.size(); k++) {
            KindField field = KindField.ALL.get(k);
            if (get(field, from) != get(field, to)) {
                set(field, to, get(field, from));
            }
        }
        int itself = setting(from, from);
        for (int other = 0; other < PairTable.KINDS; other++) {
            if (other != to && setting(from, other) != setting(to, other)) {
                setSetting(to, other, setting(from, other));
            }
        }
        if (itself != setting(to, to)) {
            setSetting(to, to, itself);
        }
    }

    @Override
    public long make(Call call, int[] words) {
        world.calls.begin(call, words);
        if (call == Call.KIND) {
            change(KindField.ofNumber(words[1]), words[0], words[2]);
        } else {
            if (world.settings.sleeps() && world.kinds.setting(words[0], words[1]) != words[2]) {
                world.commands.wakeKind(words[0]);
                world.commands.wakeKind(words[1]);
            }
            world.kinds.setSetting(words[0], words[1], words[2]);
        }
        return 0;
    }

    /**
     * Sets a field of a kind. Its circles wake, and those that meet them in another way from now on. Others notice by their balance what its
     * circles do, but not if these are static, nor what is new about pieces of terrain.
     */
    private void change(KindField field, int kind, int value) {
        boolean wakes = world.settings.sleeps() && world.kinds.get(field, kind) != value;
        for (int other = 0; wakes && other < PairTable.KINDS; other++) {
            before[other] = response(kind, other);
        }
        world.kinds.set(field, kind, value);
        boolean stays = wakes && isOfWhatStays(kind);
        for (int other = 0; wakes && other < PairTable.KINDS; other++) {
            int response = response(kind, other);
            if (other == kind || response != before[other] || stays && response != PairTable.IGNORE) {
                world.commands.wakeKind(other);
            }
        }
    }

    private int response(int kind, int other) {
        return PairTable.get(world.kinds.responses(), kind, other);
    }

    /** Whether a static circle or a piece of terrain has a kind. */
    private boolean isOfWhatStays(int kind) {
        return world.handles.hasStatics(kind) || world.terrain.pieces.has(kind);
    }

    public float restitution(int kind, float otherwise) {
        return own(KindField.RESTITUTION, kind, otherwise);
    }

    /** The restitution of a new circle of a kind: that of the kind, else the world's. */
    float newRestitution(int kind) {
        return restitution(kind, world.settings.defaultRestitution());
    }

    /** What circles of a kind have that have nothing of their own: the kind's value, else the world's. */
    float ofCircles(KindField field, int kind) {
        float ofWorld =
                switch (field) {
                    case FRICTION -> world.settings.surfaces().friction;
                    case ROLLING_RESISTANCE -> world.settings.surfaces().rollingResistance;
                    default -> Float.NaN; // kinds have a value
                };
        return own(field, kind, ofWorld);
    }

    /** What a kind has of a field, unless it has none. */
    private float own(KindField field, int kind, float otherwise) {
        float own = Float.intBitsToFloat(world.kinds.get(field, kind));
        return Float.isNaN(own) ? otherwise : own;
    }

    /** The inverse inertia of the circles of a kind by their inverse mass. */
    float inertia(int kind) {
        return KindSurface.inertia(world.kinds, kind);
    }

    /** Whether some pair of circles may have to be filtered: a pair of kinds is not solid, or a circle has had a group. */
    public boolean filter() {
        return world.kinds.filters() || fields.isUsed(CircleField.GROUP);
    }
}
