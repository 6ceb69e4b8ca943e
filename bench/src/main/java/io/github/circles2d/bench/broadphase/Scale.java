package io.github.circles2d.bench.broadphase;

/** Whole numbers in place of coordinates, for sorting: a greater coordinate never has a smaller number. */
final class Scale {
    private final float min;
    private final float factor;
    private final int greatest;

    /** From min to max in as many numbers as some bits have. */
    Scale(float min, float max, int bits) {
        this.min = min;
        greatest = (1 << bits) - 1;
        factor = max > min ? greatest / (max - min) : 0;
    }

    int of(float coordinate) {
        return Math.max(0, Math.min(greatest, (int) ((coordinate - min) * factor)));
    }
}
