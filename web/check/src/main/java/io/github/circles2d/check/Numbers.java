package io.github.circles2d.check;

/**
 * Operations on numbers whose results differ where floats are not rounded, brackets get lost, or conversions are not those of Java. The remainder of
 * floats is not among them: in WebAssembly it is not Java's, and World does not use it.
 */
final class Numbers {
    private static final float[] FLOATS = {
        0,
        -0f,
        1,
        -1,
        0.1f,
        0.3f,
        1 / 3f,
        16_777_217,
        1e9f,
        -1e9f,
        2_147_483_520f,
        2_147_483_648f,
        -2_147_483_648f,
        4e9f,
        -4e9f,
        9.2e18f,
        1e19f,
        -1e19f,
        3e38f,
        1e-45f,
        Float.MIN_NORMAL,
        Float.NaN,
        Float.POSITIVE_INFINITY,
        Float.NEGATIVE_INFINITY
    };

    private static final long[] LONGS = {
        0,
        1,
        -1,
        16_777_217,
        33_554_433,
        Integer.MAX_VALUE,
        Integer.MIN_VALUE,
        Long.MAX_VALUE,
        Long.MIN_VALUE,
        // Half-way between two floats, and a little more: a double in between would lose the little.
        (1L << 60) + (1L << 36),
        (1L << 60) + (1L << 36) + 1,
        (1L << 60) + (1L << 36) - 1,
        (1L << 60) + (3L << 36),
        -(1L << 60) - (1L << 36) - 1,
        (1L << 62) + (1L << 38) + 1
    };

    private static final int RANDOM = 2_000;

    private Numbers() {}

    /** A line for each kind of operation: of all pairs of the numbers above, and of random ones. */
    static String lines() {
        StringBuilder lines = new StringBuilder();
        line("float + - * /", Numbers::arithmetic, lines);
        line("double + - * / in brackets", Numbers::brackets, lines);
        line("constants and sqrt", Numbers::constants, lines);
        line("double to float", Numbers::fromDouble, lines);
        line("float to int", Numbers::toInt, lines);
        line("float to long", Numbers::toLong, lines);
        line("double to int and long", Numbers::fromDoubleToWhole, lines);
        line("float to short, byte and char", Numbers::toNarrow, lines);
        line("int to float", Numbers::fromInt, lines);
        line("long to float", Numbers::fromLong, lines);
        return lines.toString();
    }

    private interface Operation {
        /** Puts what it gives for some numbers into a digest. */
        void run(float a, float b, long v, Digest digest);
    }

    private static void line(String name, Operation operation, StringBuilder lines) {
        Digest digest = new Digest();
        for (float a : FLOATS) {
            for (float b : FLOATS) {
                operation.run(a, b, 0, digest);
            }
        }
        for (long v : LONGS) {
            operation.run(0, 0, v, digest);
        }
        long random = 6;
        for (int k = 0; k < RANDOM; k++) {
            random = next(random);
            float a = Float.intBitsToFloat((int) random);
            float b = Float.intBitsToFloat((int) (random >> 32));
            operation.run(a, b, random >> k, digest);
            operation.run((random & 0xFFFF) * 0x1p-8f, (random >> 48) * 0x1p-8f, k, digest);
        }
        lines.append(name).append(' ').append(digest).append('\n');
    }

    /** By Marsaglia's xorshift: java.util.Random differs between platforms. */
    private static long next(long random) {
        long next = random ^ random << 13;
        next ^= next >>> 7;
        return next ^ next << 17;
    }

    /** A NaN has many bits, and platforms differ in them. */
    private static void add(float v, Digest digest) {
        digest.add(Float.isNaN(v) ? 0x7fc00000 : Float.floatToRawIntBits(v));
    }

    private static void arithmetic(float a, float b, long v, Digest digest) {
        add(a + b, digest);
        add(a - b, digest);
        add(a * b, digest);
        add(a / b, digest);
        add(a * b + a / b - b, digest);
    }

    private static void brackets(float a, float b, long v, Digest digest) {
        double c = 1.0 / 3;
        add((float) (((a + (b - c)) - a) - b), digest);
        add((float) (((a - (b + c)) - a) + b), digest);
        add((float) (((a + (b + c)) - a) - b), digest);
        addDouble(a * (b * c), digest);
        addDouble(a * (b / c), digest);
        addDouble(a / (b * c), digest);
        addDouble(a / (b / c), digest);
        addDouble(sum(a, sum(b, c)), digest);
    }

    private static double sum(double a, double b) {
        return a + b;
    }

    private static void addDouble(double v, Digest digest) {
        digest.add(Double.isNaN(v) ? 0x7ff8000000000000L : Double.doubleToRawLongBits(v));
    }

    private static void constants(float a, float b, long v, Digest digest) {
        add(a * 0.1f + b * 0.7f, digest);
        add((float) Math.sqrt(a) + b, digest);
    }

    private static void fromDouble(float a, float b, long v, Digest digest) {
        add((float) ((double) a * b), digest);
        add((float) (double) v, digest);
    }

    private static void toInt(float a, float b, long v, Digest digest) {
        digest.add((int) a).add((int) (a * 2));
    }

    private static void toLong(float a, float b, long v, Digest digest) {
        digest.add((long) a).add((long) (b * 3));
    }

    private static void fromDoubleToWhole(float a, float b, long v, Digest digest) {
        double exact = (double) a * 1.5;
        digest.add((int) exact).add((long) exact);
    }

    private static void toNarrow(float a, float b, long v, Digest digest) {
        digest.add((short) a).add((byte) a).add((char) a);
    }

    private static void fromInt(float a, float b, long v, Digest digest) {
        add((float) (int) v, digest);
    }

    private static void fromLong(float a, float b, long v, Digest digest) {
        add((float) v, digest);
    }
}
