package io.github.circles2d.bench.physics;

import java.util.List;

/**
 * A line of the table.
 *
 * @param scene the scene in a sentence
 * @param box2d whether it is run on Box2D, too
 */
record Row(int number, String scene, boolean box2d, List<Case> cases) {
    static Row of(int number, String scene, Case... cases) {
        return new Row(number, scene, false, List.of(cases));
    }

    static Row withBox2d(int number, String scene, Case... cases) {
        return new Row(number, scene, true, List.of(cases));
    }
}
