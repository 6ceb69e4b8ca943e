package io.github.circles2d.calibration;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.IntFunction;

/**
 * A row of a calibration while it is measured: the times of loops on one device by one indexing, by the number of circles. What is not clean is
 * measured again, and refused if it does not become so: by it, {@code AUTO} would pick the slower one for good.
 *
 * <p>Times are clean if the frames of a size take about as long as each other, and if the time grows with the number of circles, and
 * not much more than the work does. The bounds leave room for crowds that settle, for caches and for plans that change between two
 * sizes; other programs on all processors go beyond them.
 */
public final class MeasuredRow {
    /** Upper end of the middle half of the frames over its lower end. */
    static final double MOST_SPREAD = 2;

    /** Time over that of fewer circles, in units of what the work grows by. */
    static final double MOST_GROWTH = 3;

    /** Time over that of fewer circles. */
    static final double LEAST_GROWTH = 1 / 1.5;

    /** How often a row is looked at before it is refused. Other programs may be done in the meantime. */
    private static final int ATTEMPTS = 4;

    private final String name;
    private final IntFunction<FrameTimes> meter;
    private final NavigableMap<Integer, FrameTimes> times = new TreeMap<>();

    /** What is not clean: the sizes to measure again, and the figures in words. */
    private record Blemish(Set<Integer> sizes, String words) {}

    /** Begins a row, which refusals call by its name; the meter times loops of so many circles. */
    public MeasuredRow(String name, IntFunction<FrameTimes> meter) {
        this.name = name;
        this.meter = meter;
    }

    /** Whether no size has been measured. */
    public boolean isEmpty() {
        return times.isEmpty();
    }

    /**
     * Measures a size, more circles than those before, and again what is not clean then. Throws IllegalStateException
     * with the name and the figures if the row does not become clean.
     */
    public void measure(int circles) {
        times.put(circles, meter.apply(circles));
        List<Blemish> blemishes = blemishes();
        for (int attempt = 1; !blemishes.isEmpty(); attempt++) {
            if (attempt == ATTEMPTS) {
                throw new IllegalStateException("the times of " + name + " are not clean after " + ATTEMPTS
                        + " attempts: " + blemishes.get(0).words
                        + ". Other programs seem to use the machine: calibrate when they have ended");
            }
            Set<Integer> again = new TreeSet<>();
            blemishes.forEach(blemish -> again.addAll(blemish.sizes));
            again.forEach(size -> times.merge(size, meter.apply(size), MeasuredRow::better));
            blemishes = blemishes();
        }
    }

    /** The cleaner one of two; of two clean ones the shorter one, since other programs only add time. */
    private static FrameTimes better(FrameTimes one, FrameTimes other) {
        boolean wide = one.spread() > MOST_SPREAD || other.spread() > MOST_SPREAD;
        boolean first = wide ? one.spread() <= other.spread() : one.median() <= other.median();
        return first ? one : other;
    }

    private List<Blemish> blemishes() {
        return times.keySet().stream()
                .map(this::blemish)
                .filter(blemish -> !blemish.words.isEmpty())
                .toList();
    }

    private Blemish blemish(int circles) {
        FrameTimes here = times.get(circles);
        if (here.spread() > MOST_SPREAD) {
            String words =
                    "the middle half of the frames of %,d circles took %.3g to %.3g ms, more than %.3g times apart";
            return new Blemish(Set.of(circles), format(words, circles, here.lower(), here.upper(), MOST_SPREAD));
        }
        Map.Entry<Integer, FrameTimes> before = times.lowerEntry(circles);
        if (before == null) {
            return new Blemish(Set.of(), "");
        }
        double growth = here.median() / before.getValue().median();
        double work = Math.pow((double) circles / before.getKey(), Curve.GROWTH);
        if (growth <= MOST_GROWTH * work && growth >= LEAST_GROWTH) {
            return new Blemish(Set.of(), "");
        }
        String words = format(
                "%,d circles took %.3g ms and %,d took %.3g, %.3g times as long instead of %.3g to %.3g",
                before.getKey(),
                before.getValue().median(),
                circles,
                here.median(),
                growth,
                LEAST_GROWTH,
                MOST_GROWTH * work);
        return new Blemish(Set.of(before.getKey(), circles), words);
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }

    /** The medians by number of circles; at least one size must have been measured. */
    public Curve curve() {
        Map<Integer, Double> medians = new TreeMap<>();
        times.forEach((circles, frames) -> medians.put(circles, frames.median()));
        return new Curve(medians);
    }
}
