package io.github.circles2d.bench.physics;

import java.util.List;

/** The table. */
final class Rows {
    static final List<Row> ALL = List.of(
            Jams.boiling(),
            Jams.deep(),
            TimeSteps.changed(),
            Encounters.meet(),
            Pebbles.swallowed(),
            Gases.temperatures(),
            Growth.sudden(),
            ElasticBalls.keepMoving(),
            StaticBounces.forEver(),
            Resting.soon(),
            Fences.fine(),
            Fences.narrow(),
            Paddles.pushed(),
            Masses.poured(),
            Tubes.oneDiameter(),
            OverlappingPair.parts(),
            Masses.heavyOnLight(),
            Kept.today());

    private Rows() {}
}
