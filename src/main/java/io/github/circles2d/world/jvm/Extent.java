package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleRow;

/** The box around the centres of all circles that do not rest. */
final class Extent {
    /** Floats from what one worker has found to what the next one has, so that they lie in different cache lines. */
    private static final int APART = 32;

    private final State state;
    private final Team team;
    private final Team.Work measure = this::measure;

    /** By worker: the least and the greatest x, and y. */
    private final float[] found;

    float width;
    float height;

    Extent(State state, Team team) {
        this.state = state;
        this.team = team;
        found = new float[APART * team.most()];
    }

    void measure() {
        team.all(measure);
        float minX = Float.POSITIVE_INFINITY;
        float maxX = Float.NEGATIVE_INFINITY;
        float minY = Float.POSITIVE_INFINITY;
        float maxY = Float.NEGATIVE_INFINITY;
        for (int at = 0; at < APART * team.size(); at += APART) {
            minX = Math.min(minX, found[at]);
            maxX = Math.max(maxX, found[at + 1]);
            minY = Math.min(minY, found[at + 2]);
            maxY = Math.max(maxY, found[at + 3]);
        }
        width = Math.max(0f, maxX - minX);
        height = Math.max(0f, maxY - minY);
    }

    private void measure(int worker) {
        float[] circle = state.circle;
        float minX = Float.POSITIVE_INFINITY;
        float maxX = Float.NEGATIVE_INFINITY;
        float minY = Float.POSITIVE_INFINITY;
        float maxY = Float.NEGATIVE_INFINITY;
        int to = CircleRow.of(team.part(state.awake, worker + 1));
        for (int s = CircleRow.of(team.part(state.awake, worker)); s < to; s += CircleRow.STRIDE) {
            minX = Math.min(minX, circle[s + X]);
            maxX = Math.max(maxX, circle[s + X]);
            minY = Math.min(minY, circle[s + Y]);
            maxY = Math.max(maxY, circle[s + Y]);
        }
        int at = APART * worker;
        found[at] = minX;
        found[at + 1] = maxX;
        found[at + 2] = minY;
        found[at + 3] = maxY;
    }
}
