package io.github.circles2d.bench.broadphase;

/** The unit of engines whose boxes are wider than circles by a fixed length: the mean reach is half a metre. */
final class Metres {
    private static final double MEAN_REACH = 0.5;

    private Metres() {}

    /** Metres per unit of length. */
    static double factor(float[] reach) {
        double sum = 0;
        for (float r : reach) {
            sum += r;
        }
        return MEAN_REACH * reach.length / sum;
    }
}
