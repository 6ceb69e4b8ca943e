package io.github.circles2d.world.model;

/** Formulas of axes that wrap. A period is infinite if its axis does not, and then they change nothing. */
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

    /** The share of a path of at most an eighth of the period, so two circles can meet in a step the short way round alone. */
    public static float shareOfPeriod(float p, float period) {
        float most = 0.125f * period;
        float way = Math.abs(p);
        return way > most ? most / way : 1f;
    }
}
