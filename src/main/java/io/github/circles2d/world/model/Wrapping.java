package io.github.circles2d.world.model;

/** A period is infinite if its axis does not wrap; then nothing changes. */
public final class Wrapping {
    private Wrapping() {}

    public static float shortWay(float d, float period) {
        float half = 0.5f * period;
        return d > half ? d - period : d < -half ? d + period : d;
    }

    /** Whole periods between min and a coordinate. */
    public static float laps(float x, float min, float period) {
        return (float) Math.floor((x - min) / period); // the floor of a float is exact
    }

    /** Of a path: at most an eighth, so circles meet the short way alone. */
    public static float shareOfPeriod(float p, float period) {
        float most = 0.125f * period;
        float way = Math.abs(p);
        return way > most ? most / way : 1f;
    }
}
