package io.github.circles2d.fuzz;

import java.nio.FloatBuffer;
import java.nio.LongBuffer;
import java.util.function.Function;
import java.util.function.ToIntFunction;

/**
 * How a parameter gets its values.
 *
 * @param type the type of the parameter
 * @param draw draws a value
 */
record Drawn(Class<?> type, Function<Draw, Value> draw) {
    private static final int MOST_HANDLES = 14;

    /** A number that is drawn so. */
    static Drawn real(Function<Draw, Float> draw) {
        return new Drawn(float.class, from -> new Values.Constant(draw.apply(from)));
    }

    static Drawn real(float low, float high) {
        return real(draw -> draw.between(low, high));
    }

    static Drawn whole(Function<Draw, Integer> draw) {
        return new Drawn(int.class, from -> new Values.Constant(draw.apply(from)));
    }

    static Drawn number() {
        return new Drawn(long.class, draw -> new Values.Constant(draw.random.nextLong() >> draw.below(64)));
    }

    static Drawn flag() {
        return new Drawn(boolean.class, draw -> new Values.Constant(draw.random.nextBoolean()));
    }

    static <E extends Enum<E>> Drawn one(Class<E> type) {
        return new Drawn(type, draw -> new Values.Constant(draw.of(type.getEnumConstants())));
    }

    static Drawn x() {
        return real(Draw::x);
    }

    static Drawn y() {
        return real(Draw::y);
    }

    static Drawn length() {
        return real(Draw::length);
    }

    static Drawn offset() {
        return real(Draw::offset);
    }

    static Drawn radius() {
        return real(Draw::radius);
    }

    static Drawn mass() {
        return real(Draw::mass);
    }

    static Drawn speed() {
        return real(Draw::speed);
    }

    static Drawn angle() {
        return real(Draw::angle);
    }

    static Drawn turning() {
        return real(Draw::angularVelocity);
    }

    static Drawn force() {
        return real(Draw::force);
    }

    static Drawn coefficient() {
        return real(Draw::coefficient);
    }

    static Drawn kind() {
        return whole(Draw::kind);
    }

    /** The handle of what is there, mostly. */
    static Drawn handle(Ref.Of of) {
        return new Drawn(long.class, draw -> handle(draw, of));
    }

    static Value handle(Draw draw, Ref.Of of) {
        return new Ref.Handle(draw.oneOf(30) ? Ref.Of.STALE : of, draw.below(1 << 20));
    }

    static Value body(Draw draw) {
        return new Ref.Body(handle(draw, Ref.Of.BODY));
    }

    /** Handles for a call that has as many other values; {@link Entry} makes their numbers equal. */
    static Drawn handles(Ref.Of of) {
        return new Drawn(long[].class, draw -> handles(draw, of, draw.below(MOST_HANDLES)));
    }

    /** Handles that often follow each other, or are all the same. */
    static Value handles(Draw draw, Ref.Of of, int n) {
        int[] numbers = new int[n];
        int form = draw.below(3);
        int first = draw.below(1 << 20);
        for (int k = 0; k < n; k++) {
            numbers[k] = form == 0 ? draw.below(1 << 20) : 31 * first + k * form % 30;
        }
        return new Ref.Handles(of, numbers);
    }

    static Drawn floats(Function<Draw, float[]> draw) {
        return new Drawn(float[].class, from -> new Values.Constant(draw.apply(from)));
    }

    /** An array that the call fills; it is rarely too short. */
    static Drawn filled(Class<?> type, String length, ToIntFunction<Player> lengths) {
        return new Drawn(type, draw -> {
            boolean isShort = draw.setting.hostile && draw.oneOf(60);
            return isShort
                    ? new Values.Filled(type, length + " - 1", player -> Math.max(0, lengths.applyAsInt(player) - 1))
                    : new Values.Filled(type, length, lengths);
        });
    }

    /** As {@link #filled}, or null. */
    static Drawn optional(Class<?> type, String length, ToIntFunction<Player> lengths) {
        Drawn filled = filled(type, length, lengths);
        return new Drawn(type, draw -> draw.oneOf(3) ? new Values.Constant(null) : filled.draw.apply(draw));
    }

    /** An array of a random length that the call fills as far as it goes. */
    static Drawn room(Class<?> type) {
        return new Drawn(type, draw -> {
            int n = draw.below(20);
            return new Values.Filled(type, "" + n, player -> n);
        });
    }

    /** By id, some elements each. */
    static Drawn byId(Class<?> type, int each) {
        return filled(type, each + " * world.idLimit()", player -> each * player.world.idLimit());
    }

    /** A bit for each id, or null. */
    static Drawn living() {
        return optional(long[].class, "words(world.idLimit())", player -> player.world.idLimit() / 64 + 1);
    }

    /** By circle, some elements each. */
    static Drawn byCircle(Class<?> type, int each) {
        boolean isBuffer = type == FloatBuffer.class || type == LongBuffer.class;
        return isBuffer
                ? new Drawn(type, draw -> new Values.Filled(type, each + " * world.size()", p -> each * p.world.size()))
                : filled(type, each + " * world.size()", player -> each * player.world.size());
    }
}
