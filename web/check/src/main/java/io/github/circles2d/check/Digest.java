package io.github.circles2d.check;

/** A number that tells apart what was put in, in order. */
final class Digest {
    private long value = 1;

    Digest add(long v) {
        value = (value ^ v) * 0x9E3779B97F4A7C15L;
        value ^= value >>> 29;
        return this;
    }

    Digest add(float v) {
        return add(Float.floatToRawIntBits(v));
    }

    Digest add(float[] values) {
        for (float v : values) {
            add(v);
        }
        return this;
    }

    Digest add(long[] values) {
        for (long v : values) {
            add(v);
        }
        return this;
    }

    Digest add(byte[] values) {
        for (byte v : values) {
            add(v);
        }
        return this;
    }

    Digest add(String text) {
        for (int i = 0; i < text.length(); i++) {
            add(text.charAt(i));
        }
        return this;
    }

    @Override
    public String toString() {
        return Long.toHexString(value);
    }
}
