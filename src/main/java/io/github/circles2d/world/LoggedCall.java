package io.github.circles2d.world;

import static java.lang.Float.intBitsToFloat;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.KindField;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.log.LogReader;

/**
 * The table of the calls of a log that are no {@link io.github.circles2d.world.circles.Commands}, one row each: what they are written
 * as, and what makes them again. Commands are in the log with their operations for numbers, and need no row.
 */
enum LoggedCall {
    /** Steps: length, how many. {@link LogPlayer} makes them one by one. */
    STEP(64, 2, null),

    /** The hash of the state as of now, as two halves. */
    HASH(65, 2, null),

    /** Gravity: x, y. */
    GRAVITY(66, 2, (s, w) -> s.setGravity(intBitsToFloat(w[0]), intBitsToFloat(w[1]))),

    /** Bounds: least x, least y, greatest x, greatest y. */
    BOUNDS(
            67,
            4,
            (s, w) -> s.setBounds(
                    intBitsToFloat(w[0]), intBitsToFloat(w[1]), intBitsToFloat(w[2]), intBitsToFloat(w[3]))),

    /** A field of a circle: the field's number, the circle's id, the value as two halves. */
    FIELD(68, 4, (s, w) -> s.circles().set(field(w[0]), LogPlayer.handle(s, w[1]), value(w[2], w[3]))),

    /** A static circle is to travel: the circle's id, x, y. */
    TRAVEL(69, 3, (s, w) -> s.circles().move(LogPlayer.handle(s, w[0]), intBitsToFloat(w[1]), intBitsToFloat(w[2]))),

    /** A force acts in the next step: the circle's id, x, y. */
    FORCE(70, 3, (s, w) -> s.circles()
            .applyForce(LogPlayer.handle(s, w[0]), intBitsToFloat(w[1]), intBitsToFloat(w[2]))),

    /** A field of a kind: the kind, the field's number, the value. */
    KIND(71, 3, (s, w) -> s.kinds().set(kindField(w[1]), s.kinds().check(w[0]), w[2])),

    /** What the matrix of kinds has of two of them: both, and that. */
    PAIR_OF_KINDS(72, 3, (s, w) -> s.kinds().setSetting(w[0], w[1], setting(w[2]))),

    /** A circle is to grow: the circle's id, the radius, steps. */
    GROW(73, 3, (s, w) -> s.growth().grow(LogPlayer.handle(s, w[0]), intBitsToFloat(w[1]), w[2])),

    /** All circles go. */
    CLEAR(74, 0, (s, w) -> s.clearing().clear());

    /** Makes a call again. */
    interface Repetition {
        void make(Simulation simulation, int[] words);
    }

    /** Numbers from here on are those of this table; lower ones are operations of commands. */
    static final int FIRST = 64;

    /** Most words of a call. */
    static final int MOST_WORDS = 16;

    private static final LoggedCall[] BY_NUMBER = new LoggedCall[256];

    static {
        for (LoggedCall call : values()) {
            BY_NUMBER[call.number] = call;
        }
    }

    final int number;
    final int words;
    final Repetition repetition;

    /**
     * A row.
     *
     * @param number what a log knows the call by, from {@link #FIRST} to 255; never changed, and never used again
     * @param words its ints
     * @param repetition makes it again; checks all values, since a log may come from anywhere
     */
    LoggedCall(int number, int words, Repetition repetition) {
        this.number = number;
        this.words = words;
        this.repetition = repetition;
    }

    /** The call of a number; null if there is none. */
    static LoggedCall of(int number) {
        return BY_NUMBER[number];
    }

    private static CircleField field(int number) {
        CircleField field = CircleField.ofNumber(number);
        if (field == null || !field.isOfSteps() && field != CircleField.TAG) {
            throw LogReader.refused("calls set no field with the number " + number);
        }
        return field;
    }

    private static KindField kindField(int number) {
        KindField field = KindField.ofNumber(number);
        if (field == null) {
            throw LogReader.refused("no field of a kind has the number " + number);
        }
        return field;
    }

    private static int setting(int number) {
        if (!KindTable.isSetting(number)) {
            throw LogReader.refused("kinds cannot have the response " + number);
        }
        return number;
    }

    static long value(int low, int high) {
        return low & 0xFFFFFFFFL | (long) high << Integer.SIZE;
    }
}
