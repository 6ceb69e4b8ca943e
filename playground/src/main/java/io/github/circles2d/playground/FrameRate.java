package io.github.circles2d.playground;

/** Frames a second, over the last half second. */
final class FrameRate {
    private static final long SPAN = 500_000_000;

    private long start;
    private int frames;
    private double perSecond;

    void tick(long nanos) {
        if (start == 0) {
            start = nanos;
        } else {
            frames++;
            if (nanos - start >= SPAN) {
                perSecond = frames * 1e9 / (nanos - start);
                start = nanos;
                frames = 0;
            }
        }
    }

    double perSecond() {
        return perSecond;
    }
}
