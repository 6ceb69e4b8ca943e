package io.github.circles2d.bench.physics;

import io.github.circles2d.bench.results.Statistics;
import java.util.ArrayList;
import java.util.List;

/** What was measured: the figure of each seed. */
record Figure(Row row, Case scene, Measure measure, double[] values) {
    /** Runs a case as often as the effort says. */
    static List<Figure> of(Row row, Case scene, Physics physics, Effort effort) {
        int runs = scene.random() ? effort.seeds() : 1;
        int measures = scene.measures().size();
        double[][] values = new double[measures][runs];
        for (int run = 0; run < runs; run++) {
            double[] figures = scene.run().figures(physics, run + 1, effort);
            if (figures.length != measures) {
                throw new IllegalStateException(scene.name() + " has " + measures + " measures, not " + figures.length);
            }
            for (int m = 0; m < measures; m++) {
                values[m][run] = figures[m];
            }
        }
        List<Figure> all = new ArrayList<>();
        for (int m = 0; m < measures; m++) {
            all.add(new Figure(row, scene, scene.measures().get(m), values[m]));
        }
        return all;
    }

    double median() {
        return Statistics.of(values).median();
    }

    boolean met() {
        return measure.bound().met(median());
    }
}
