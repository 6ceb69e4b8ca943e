package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.dot;
import static io.github.circles2d.reference.Numbers.max;
import static io.github.circles2d.reference.Numbers.minus;

/** A segment, or a line of a chain. The front is on its right. */
final class LinePiece extends Piece {
    private static final float CORNER = 0.5f;

    /** The ends, in the frame of the body. */
    private final float[] from;

    private final float[] to;

    private final boolean twoSided;
    private final float thickness;

    LinePiece(int id, long handle, Body body, int kind, float[] from, float[] to, boolean twoSided, float thickness) {
        super(id, handle, body, kind);
        this.from = from;
        this.to = to;
        this.twoSided = twoSided;
        this.thickness = thickness;
    }

    @Override
    float thickness() {
        return thickness;
    }

    @Override
    boolean hasTwoSides() {
        return twoSided;
    }

    private double[] way() {
        return new double[] {(double) to[0] - from[0], (double) to[1] - from[1]};
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1]);
    }

    @Override
    void placeForm(Arena arena) {
        double[] way = way();
        double[] turned = body.turned(way);
        double[] first = body.place(from);
        double[] last = body.place(to);
        size = (float) length(way);
        for (int a = 0; a < 2; a++) {
            double mid = 0.5 * (first[a] + last[a]);
            double laps = arena.laps(a, mid);
            origin[a] = (float) (first[a] - laps);
            t[a] = (float) (turned[a] / length(way));
            start[a] = 0f;
            end[a] = (float) (last[a] - laps - origin[a]);
            middle[a] = (float) (mid - laps);
            halfExtent[a] = (float) (0.5 * Math.abs(last[a] - first[a]) + thickness);
            pivot[a] = (float) (body.place[a] - laps) - origin[a];
        }
    }

    @Override
    int shape() {
        return twoSided ? 1 : 2;
    }

    @Override
    int half() {
        return 0;
    }

    @Override
    float[] numbers() {
        return new float[] {from[0], from[1], to[0], to[1], thickness};
    }

    @Override
    double[] startDirection() {
        double[] way = way();
        return new double[] {way[0] / length(way), way[1] / length(way)};
    }

    @Override
    double[] endDirection() {
        return startDirection();
    }

    @Override
    double farthest() {
        double[] a = {from[0], from[1]};
        double[] b = {to[0], to[1]};
        return Math.max(length(a), length(b)) + thickness;
    }

    /** Over the front. */
    private float height(float[] o) {
        return o[0] * t[1] - o[1] * t[0];
    }

    @Override
    Stand measure(float[] o, float r, float side) {
        float along = dot(o, t);
        boolean beforeStart = along < 0f;
        boolean beyond = beforeStart || along > size;
        float[] normal = {side * t[1], side * -t[0]};
        if (beyond && joint(beforeStart) != Joint.CONCAVE) {
            return atVertex(beforeStart, o, r + thickness, normal, height(o));
        }
        Feature feature = goesOn(along, r) ? Feature.FACE : Feature.NONE;
        return new Stand(feature, normal, side * height(o) - (r + thickness), 0f, height(o));
    }

    /** As far as it reaches beyond concave joints. */
    private boolean goesOn(float along, float r) {
        float more = CORNER * r;
        return along >= -more && along <= size + more;
    }

    @Override
    boolean isInFrontOfFace(float[] o) {
        return height(o) >= 0f;
    }

    @Override
    boolean isBeyondEnd(float[] o) {
        return dot(o, t) > size;
    }

    @Override
    float distance(float[] o) {
        float along = Numbers.clamp(dot(o, t), 0f, size);
        return Numbers.length(minus(o, new float[] {along * t[0], along * t[1]})) - thickness;
    }

    @Override
    boolean covers(float[] o, float side, float[] vertex, float thicknessOfVertex, float slack, float step) {
        float place = dot(vertex, t);
        float above = side * height(vertex) - thickness;
        boolean flush = place >= -slack && place <= size + slack && above + thicknessOfVertex <= step;
        float along = dot(o, t);
        boolean beyond = along < 0f || along > size;
        boolean covered = flush && side * height(o) >= 0f;
        if (!covered || !beyond || joint(along < 0f) == Joint.CONCAVE) {
            return covered;
        }
        return along < 0f ? place > slack : place < size - slack;
    }

    @Override
    float timeOfNoticedFace(float[] o, float[] u, float r) {
        float side = height(o) >= 0f ? 1f : -1f;
        float sinks = -(side * height(u));
        float gap = side * height(o) - (r + thickness);
        if (!(sinks > 0f) || !(gap > 0f)) {
            return 2f;
        }
        float time = gap / sinks;
        float along = dot(o, t) + time * dot(u, t);
        return along >= 0f && along <= size ? time : 2f;
    }

    @Override
    float timeOfFace(float[] o, float[] u, float r, float side) {
        float reach = r + thickness;
        float above = side * height(o);
        float sinks = -(side * height(u));
        if (!(sinks > 0f) || !(above - (reach - GRAZE * reach) < sinks)) {
            return 2f;
        }
        float time = max((above - reach) / sinks, 0f);
        float along = dot(o, t) + time * dot(u, t);
        boolean meets = (along >= 0f || startJoint == Joint.CONCAVE) && (along <= size || endJoint == Joint.CONCAVE);
        return meets && goesOn(along, r) ? time : 2f;
    }

    @Override
    void addTo(RigidThing thing, float[] around) {
        float[] normal = {t[1], -t[0]};
        float[] first = minus(start, around);
        float[] last = minus(end, around);
        thing.addLine(first[0], first[1], normal[0], normal[1], size, thickness);
        if (twoSided && !thing.oneWay) {
            thing.addLine(last[0], last[1], -normal[0], -normal[1], size, thickness);
        }
        addEnd(thing, true, around, thickness, normal);
        addEnd(thing, false, around, thickness, normal);
    }
}
