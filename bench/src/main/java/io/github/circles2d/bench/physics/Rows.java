package io.github.circles2d.bench.physics;

import java.util.List;

/** The table. */
final class Rows {
    static final List<Row> ALL = List.of(
            Jams.boiling(),
            Jams.deep(),
            TimeSteps.changed(),
            Growth.sudden(),
            ElasticBalls.keepMoving(),
            StaticBounces.forEver(),
            Resting.soon(),
            Masses.poured(),
            Tubes.oneDiameter(),
            OverlappingPair.parts(),
            Masses.heavyOnLight());

    private Rows() {}
}
