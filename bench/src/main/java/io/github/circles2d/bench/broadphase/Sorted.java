package io.github.circles2d.bench.broadphase;

/** Circles in another order than that of their numbers, their data side by side, so that neighbours are read in a row. */
final class Sorted {
    float[] x = new float[0];
    float[] y = new float[0];
    float[] reach = new float[0];
    int[] number = new int[0];

    /** Makes room for some circles. */
    void ensure(int size) {
        if (number.length < size) {
            int room = size + (size >> 2);
            x = new float[room];
            y = new float[room];
            reach = new float[room];
            number = new int[room];
        }
    }

    /** Puts a circle into a place. */
    void put(int place, int circle, float cx, float cy, float cr) {
        x[place] = cx;
        y[place] = cy;
        reach[place] = cr;
        number[place] = circle;
    }

    /**
     * Tests a circle with those in some places, and adds the pairs.
     *
     * @return the number of tests
     */
    int pair(int place, int from, int to, PairList pairs) {
        return pair(x[place], y[place], reach[place], number[place], from, to, pairs);
    }

    /** The same with a circle from elsewhere. */
    int pair(float cx, float cy, float cr, int circle, int from, int to, PairList pairs) {
        float[] xs = x;
        float[] ys = y;
        float[] reaches = reach;
        for (int k = from; k < to; k++) {
            if (Circles.near(cx, cy, cr, xs[k], ys[k], reaches[k])) {
                pairs.add(circle, number[k]);
            }
        }
        return to - from;
    }
}
