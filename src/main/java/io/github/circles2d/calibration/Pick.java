package io.github.circles2d.calibration;

import java.util.Map;
import java.util.function.Function;

/**
 * What is the fastest for a crowd in a World, and the times that say so.
 *
 * @param taken the candidate that takes the least time
 * @param reason the times of all, in words
 * @param <T> a candidate
 */
public record Pick<T>(T taken, String reason) {
    /**
     * Picks, as {@link Timings#fastest} does, by the ratios of radii at which all candidates were measured.
     *
     * @param candidates their times, the preferred ones first; not empty
     * @param crowd the circles
     * @param name how to call a candidate
     * @param <T> a candidate
     * @return one of them; by the times of like radii if there are no others, which the reason says then
     */
    public static <T> Pick<T> among(Map<T, CurvesByRatio> candidates, Crowd crowd, Function<T, String> name) {
        Map<T, Curve> curves = CurvesByRatio.at(crowd.ratio(), candidates);
        boolean byLikeRadii =
                crowd.isMixed() && CurvesByRatio.common(candidates.values()).size() == 1;
        Crowd measured = byLikeRadii ? Crowd.like(crowd.circles()) : crowd;
        String reason = Timings.words(curves, measured, name)
                + (byLikeRadii ? "; mixed radii are not calibrated: Calibration.run() would measure them" : "");
        return new Pick<>(Timings.fastest(curves, crowd.circles()), reason);
    }
}
