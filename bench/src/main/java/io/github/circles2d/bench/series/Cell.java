package io.github.circles2d.bench.series;

import java.util.LinkedHashMap;
import java.util.Map;

/** One figure: who, on what, of which size. */
record Cell(Contender who, Series series, int n) {
    /** The columns of the table that name it. */
    Map<String, String> key() {
        Map<String, String> key = new LinkedHashMap<>();
        key.put("engine", who.engine());
        key.put("series", series.title);
        key.put("n", Integer.toString(n));
        key.put("threads", who.threads());
        return key;
    }

    @Override
    public String toString() {
        return series.title + " " + n + ", " + who;
    }
}
