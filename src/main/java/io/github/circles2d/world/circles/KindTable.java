package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.PairTable;
import java.util.Arrays;

/**
 * What the kinds of circles are: the fields of each, by {@link KindField}, and a matrix of what the circles of two kinds do to each
 * other. From both follow the responses, which steps read.
 */
public final class KindTable implements KindField.Values {
    /** In the matrix: masks and sensors decide. */
    public static final int BY_MASK = 0;

    /** In the matrix: the number above this one is a response of {@link PairTable}. */
    public static final int RESPONSE = 1;

    /** By kind and field. */
    private final int[] values = new int[PairTable.KINDS * KindField.ALL.size()];

    private final int[] matrix = new int[PairTable.WORDS];
    private final int[] responses = new int[PairTable.WORDS];

    /** Kinds that are paired with some kind in a way that is not solid, counted once for each such pair. */
    private int notSolid;

    /** Values that make circles of a kind move in another way than others. */
    private int motions;

    /** Values by which circles of a kind grip or carry others. */
    private int surfaces;

    /** Pairs of which the matrix says something, counted likewise. */
    private int settings;

    private int version;

    /** Kinds as they are at first: all pairs are solid. */
    public KindTable() {
        setInitialValues();
        resolve(0, 0); // changes nothing, but loads the classes that a change needs while there is memory
    }

    private void setInitialValues() {
        for (int k = 0; k < values.length; k++) {
            values[k] = fieldAt(k).initial();
        }
    }

    private static int at(KindField field, int kind) {
        return KindField.ALL.size() * kind + field.ordinal();
    }

    /** The field of an element. By index: iterators over the fields would be garbage in every frame. */
    private static KindField fieldAt(int k) {
        return KindField.ALL.get(k % KindField.ALL.size());
    }

    /** Throws {@link IllegalArgumentException} if there is no such kind. */
    public static int check(int kind) {
        return Limits.within("the kind", kind, 0, PairTable.KINDS - 1);
    }

    @Override
    public int get(KindField field, int kind) {
        return values[at(field, kind)];
    }

    @Override
    public float getFloat(KindField field, int kind) {
        return Float.intBitsToFloat(get(field, kind));
    }

    /** Sets a field of a kind, to a value that has been checked. */
    public void set(KindField field, int kind, int value) {
        if (value != get(field, kind)) {
            int more = (value == field.initial() ? 0 : 1) - (get(field, kind) == field.initial() ? 0 : 1);
            if (field.grips()) {
                surfaces += more;
            } else if (field.moves()) {
                motions += more;
            }
            values[at(field, kind)] = value;
            for (int other = 0; other < PairTable.KINDS; other++) {
                resolve(kind, other);
            }
            version++;
        }
    }

    /** Whether a number may be in the matrix. */
    public static boolean isSetting(int number) {
        return number == BY_MASK || number >= RESPONSE && number <= RESPONSE + PairTable.SENSE;
    }

    /** What the matrix has of two kinds: {@link #BY_MASK}, or {@link #RESPONSE} and a response. */
    public int setting(int a, int b) {
        return PairTable.get(matrix, a, b);
    }

    /** Sets what the matrix has of two kinds. */
    public void setSetting(int a, int b, int setting) {
        if (setting != setting(a, b)) {
            settings += (setting == BY_MASK ? 0 : 1) - (setting(a, b) == BY_MASK ? 0 : 1);
            PairTable.set(matrix, a, b, setting);
            resolve(a, b);
            version++;
        }
    }

    private void resolve(int a, int b) {
        notSolid -= PairTable.get(responses, a, b) == PairTable.SOLID ? 0 : 1;
        PairTable.set(responses, a, b, response(a, b));
        notSolid += PairTable.get(responses, a, b) == PairTable.SOLID ? 0 : 1;
    }

    private int response(int a, int b) {
        int setting = setting(a, b);
        if (setting != BY_MASK) {
            return setting - RESPONSE;
        }
        boolean accepts = (get(KindField.MASK, a) & get(KindField.CATEGORY, b)) != 0;
        boolean isAccepted = (get(KindField.MASK, b) & get(KindField.CATEGORY, a)) != 0;
        if (!accepts || !isAccepted) {
            return PairTable.IGNORE;
        }
        int sensors = get(KindField.SENSOR, a) + get(KindField.SENSOR, b);
        return sensors == 0 ? PairTable.SOLID : sensors == 1 ? PairTable.SENSE : PairTable.IGNORE;
    }

    /** By pair of kinds: what their circles do to each other; valid until the next change. */
    public int[] responses() {
        return responses;
    }

    /** Whether some pair of kinds is not solid. */
    public boolean filters() {
        return notSolid > 0;
    }

    /** Whether circles of some kind move in another way than those of a kind as it is at first. */
    public boolean moves() {
        return motions > 0;
    }

    /** Whether circles of some kind may grip or carry others. */
    public boolean grips() {
        return surfaces > 0;
    }

    /** Counts the changes. */
    public int version() {
        return version;
    }

    public void copy(KindTable from) {
        System.arraycopy(from.values, 0, values, 0, values.length);
        System.arraycopy(from.matrix, 0, matrix, 0, matrix.length);
        System.arraycopy(from.responses, 0, responses, 0, responses.length);
        notSolid = from.notSolid;
        settings = from.settings;
        motions = from.motions;
        surfaces = from.surfaces;
        version++;
    }

    /** Makes all kinds what they are at first. */
    public void clear() {
        setInitialValues();
        Arrays.fill(matrix, 0);
        Arrays.fill(responses, 0);
        notSolid = 0;
        settings = 0;
        motions = 0;
        surfaces = 0;
        version++;
    }

    /** The part of the kinds in the hash of the state: one number for each value that is not the initial one. */
    public long hash() {
        long sum = 0;
        for (int k = 0; k < values.length; k++) {
            if (values[k] != fieldAt(k).initial()) {
                sum += StateHash.kind(fieldAt(k).number(), k / KindField.ALL.size(), values[k]);
            }
        }
        for (int a = 0; hasSettings() && a < PairTable.KINDS; a++) {
            for (int b = a; b < PairTable.KINDS; b++) {
                if (setting(a, b) != BY_MASK) {
                    sum += StateHash.response(a, b, setting(a, b));
                }
            }
        }
        return sum;
    }

    /** Whether the matrix says anything. */
    private boolean hasSettings() {
        return settings > 0;
    }

    /** Number of values that are not the initial ones. */
    public int used() {
        int count = 0;
        for (int k = 0; k < values.length; k++) {
            count += values[k] == fieldAt(k).initial() ? 0 : 1;
        }
        return count;
    }

    /** Number of pairs of kinds of which the matrix says something. */
    public int settings() {
        return settings;
    }
}
