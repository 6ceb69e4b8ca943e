package io.github.circles2d.reference;

import io.github.circles2d.Edge;
import java.util.Arrays;

/** The bounds, and what there is at their edges. Arrays hold a value for x and one for y. */
record Arena(float[] min, float[] max, Edge[] edges) {
    private static final float GREATEST_COORDINATE = 1e9f;
    private static final float NOWHERE = 4e9f;
    private static final long EDGES = 0x6564676573324432L;

    Arena at(float[] newMin, float[] newMax) {
        return new Arena(newMin, newMax, edges);
    }

    boolean isWrapped(int axis) {
        return edges[axis] == Edge.WRAP;
    }

    float period(int axis) {
        return max[axis] - min[axis];
    }

    /** The lower walls, of which an open axis has some at the end of coordinates. */
    float[] lowerWalls() {
        return walls(min, -1f);
    }

    float[] upperWalls() {
        return walls(max, 1f);
    }

    private float[] walls(float[] at, float side) {
        float[] walls = new float[2];
        for (int a = 0; a < 2; a++) {
            float none = edges[a] == Edge.OPEN ? GREATEST_COORDINATE : NOWHERE;
            walls[a] = edges[a] == Edge.WALL ? at[a] : side * none;
        }
        return walls;
    }

    /** From one place to another, the short way round. */
    float[] way(float[] from, float[] to) {
        float[] way = Numbers.minus(to, from);
        for (int a = 0; a < 2; a++) {
            if (isWrapped(a) && Math.abs(way[a]) > 0.5f * period(a)) {
                way[a] -= Math.copySign(period(a), way[a]);
            }
        }
        return way;
    }

    /** The short way of a difference of coordinates. */
    double shortWay(int axis, double d) {
        double half = 0.5 * period(axis);
        return isWrapped(axis) && d > half ? d - period(axis) : isWrapped(axis) && d < -half ? d + period(axis) : d;
    }

    /** The periods between the bounds and a coordinate, as a length. */
    double laps(int axis, double coordinate) {
        return isWrapped(axis) ? Math.floor((coordinate - min[axis]) / period(axis)) * period(axis) : 0;
    }

    /** The share of a path that leads no farther than an eighth of a period. */
    float share(float[] path) {
        float share = 1f;
        for (int a = 0; a < 2; a++) {
            float most = 0.125f * period(a);
            if (isWrapped(a) && Math.abs(path[a]) > most) {
                share = Numbers.min(share, most / Math.abs(path[a]));
            }
        }
        return share;
    }

    /** How many periods a coordinate is away from the first one. */
    float turns(int axis, float coordinate) {
        return isWrapped(axis) ? (float) Math.floor((coordinate - min[axis]) / period(axis)) : 0f;
    }

    float clamp(int axis, float coordinate) {
        return Numbers.clamp(coordinate, min[axis], Math.nextDown(max[axis]));
    }

    /** A coordinate of the first period. */
    float inside(int axis, float coordinate) {
        float turns = turns(axis, coordinate);
        return turns == 0f ? coordinate : clamp(axis, coordinate - turns * period(axis));
    }

    long hash() {
        if (Arrays.equals(edges, new Edge[] {Edge.WALL, Edge.WALL})) {
            return 0;
        }
        long h = ReferenceWorld.absorb(ReferenceWorld.absorb(EDGES, edges[0].ordinal()), edges[1].ordinal());
        return ReferenceWorld.absorb(h, min[0], min[1], max[0], max[1]);
    }
}
