package io.github.circles2d.bench.broadphase;

/** The test that decides about a pair. */
final class Circles {
    private Circles() {}

    /** Whether two circles overlap. It gives the same for (a, b) and (b, a). */
    static boolean near(float ax, float ay, float ar, float bx, float by, float br) {
        float dx = ax - bx;
        float dy = ay - by;
        float sum = ar + br;
        return dx * dx + dy * dy < sum * sum;
    }
}
