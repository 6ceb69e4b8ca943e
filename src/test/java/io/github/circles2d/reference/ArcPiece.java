package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.dot;
import static io.github.circles2d.reference.Numbers.length;
import static io.github.circles2d.reference.Numbers.min;
import static io.github.circles2d.reference.Numbers.minus;

/** A part of a circle, which others touch from inside or from outside. */
final class ArcPiece extends Piece {
    /** In the frame of the body. */
    private final float[] centre;

    private final float[] toMiddle;
    private final float radius;

    /** Half the opening, in parts of a turn of which it has 2^32. */
    private final int half;

    private final boolean solidOutside;

    /** The cosine of half the opening; -2 of a circle. */
    private float spread;

    ArcPiece(
            int id,
            long handle,
            Body body,
            int kind,
            float[] centre,
            float[] toMiddle,
            float radius,
            int half,
            boolean solidOutside) {
        super(id, handle, body, kind);
        this.centre = centre;
        this.toMiddle = toMiddle;
        this.radius = radius;
        this.half = half;
        this.solidOutside = solidOutside;
    }

    /** The direction of the front from the centre: 1 away from it, -1 towards it. */
    private float out() {
        return solidOutside ? -1f : 1f;
    }

    @Override
    boolean isArc() {
        return true;
    }

    @Override
    boolean isHollow() {
        return solidOutside;
    }

    @Override
    boolean isCircle() {
        return half == Integer.MIN_VALUE;
    }

    @Override
    void placeForm(Arena arena) {
        double unit = 1 / Math.sqrt((double) toMiddle[0] * toMiddle[0] + (double) toMiddle[1] * toMiddle[1]);
        double[] turned = body.turned(new double[] {toMiddle[0], toMiddle[1]});
        double[] to = {turned[0] * unit, turned[1] * unit};
        double cos = Angles.cos(half);
        double sin = Angles.sin(half);
        double opening = isCircle() ? -2 : cos;
        double[] right = {radius * (to[0] * cos + to[1] * sin), radius * (to[1] * cos - to[0] * sin)};
        double[] left = {radius * (to[0] * cos - to[1] * sin), radius * (to[1] * cos + to[0] * sin)};
        double[] at = body.place(centre);
        size = radius;
        spread = (float) opening;
        for (int a = 0; a < 2; a++) {
            double first = solidOutside ? left[a] : right[a];
            double last = solidOutside ? right[a] : left[a];
            double open = opening - 1e-6;
            double least = -to[a] >= open ? -radius : Math.min(first, last);
            double greatest = to[a] >= open ? radius : Math.max(first, last);
            double mid = at[a] + 0.5 * (least + greatest);
            double laps = arena.laps(a, mid);
            origin[a] = (float) (at[a] - laps);
            t[a] = (float) to[a];
            start[a] = (float) first;
            end[a] = (float) last;
            middle[a] = (float) (mid - laps);
            halfExtent[a] = (float) (0.5 * ((at[a] + greatest) - (at[a] + least)));
            pivot[a] = (float) (body.place[a] - laps) - origin[a];
        }
    }

    @Override
    int shape() {
        return solidOutside ? 7 : 3;
    }

    @Override
    int half() {
        return half;
    }

    @Override
    float[] numbers() {
        return new float[] {centre[0], centre[1], toMiddle[0], toMiddle[1], radius};
    }

    @Override
    double[] startDirection() {
        return direction(-1);
    }

    @Override
    double[] endDirection() {
        return direction(1);
    }

    /** Of the end (1) or the start (-1): from the centre to it, turned anticlockwise, or clockwise if the arc goes so. */
    private double[] direction(int end) {
        int way = solidOutside ? -1 : 1;
        double cos = Angles.cos(half);
        double sin = way * end * Angles.sin(half);
        double x = toMiddle[0];
        double y = toMiddle[1];
        return new double[] {way * -(y * cos + x * sin), way * (x * cos - y * sin)};
    }

    @Override
    double farthest() {
        return Math.sqrt((double) centre[0] * centre[0] + (double) centre[1] * centre[1]) + radius;
    }

    private boolean isInside(float[] o, float slack) {
        return dot(o, t) >= spread * length(o) - slack;
    }

    @Override
    Stand measure(float[] o, float r, float side) {
        float out = out();
        float d = length(o);
        float[] central = {out * t[0], out * t[1]};
        if (isInside(o, 0f)) {
            float[] normal = d == 0f ? central : new float[] {out * (o[0] / d), out * (o[1] / d)};
            float height = out * (d - size);
            return new Stand(Feature.FACE, normal, height - r, d == 0f ? 0f : -out / d, height);
        }
        return atVertex(!isTowardsEnd(o), o, r, central, 0f);
    }

    private boolean isTowardsEnd(float[] o) {
        boolean left = t[0] * o[1] - t[1] * o[0] > 0f;
        return left != solidOutside;
    }

    @Override
    boolean isInFrontOfFace(float[] o) {
        float height = length(o) - size;
        if (!isInside(o, 0f)) {
            float[] e = isTowardsEnd(o) ? end : start;
            height = dot(e, minus(o, e));
        }
        return solidOutside ? height <= 0f : height >= 0f;
    }

    @Override
    boolean isBeyondEnd(float[] o) {
        return !isInside(o, 0f) && isTowardsEnd(o);
    }

    @Override
    float distance(float[] o) {
        if (isInside(o, 0f)) {
            return Math.abs(length(o) - size);
        }
        return min(length(minus(o, start)), length(minus(o, end)));
    }

    @Override
    boolean covers(float[] o, float side, float[] vertex, float thicknessOfVertex, float slack, float step) {
        boolean flush = isInside(vertex, slack) && out() * (length(vertex) - size) + thicknessOfVertex <= step;
        return flush && isInside(o, 0f) && out() * (length(o) - size) >= 0f;
    }

    @Override
    float timeOfFace(float[] o, float[] u, float r, float side) {
        float time = solidOutside
                ? timeFromInside(o, u, size - r, GRAZE * r)
                : ContinuousCollision.timeOfImpact(minus(new float[] {0f, 0f}, o), u, size + r);
        if (!(time < 1f) || isInside(at(o, u, time), 0f)) {
            return time < 1f ? time : 2f;
        }
        if (!solidOutside || !isInside(Numbers.plus(o, u), 0f)) {
            return 2f;
        }
        return min(timeBeside(end, o, u, time), timeBeside(start, o, u, time));
    }

    @Override
    float timeOfNoticedFace(float[] o, float[] u, float r) {
        boolean outside = dot(o, o) > (size + r) * (size + r);
        float[] toCentre = minus(new float[] {0f, 0f}, o);
        float outer = outside ? ContinuousCollision.timeOfTouch(toCentre, u, size + r) : 2f;
        float time = isInside(at(o, u, outer), 0f) ? outer : 2f;
        float inner = timeOfLeaving(o, u, size - r);
        return inner < time && isInside(at(o, u, inner), 0f) ? inner : time;
    }

    @Override
    float timeOfReturn(float[] o, float[] u, float r) {
        float time = timeOfLeaving(o, u, size - r);
        return solidOutside && isInside(at(o, u, time), 0f) ? time : 2f;
    }

    /** When a point leaves a circle around 0, perhaps after it has come into it. */
    private static float timeOfLeaving(float[] o, float[] u, float within) {
        float b = dot(o, u);
        float left = within * within - dot(o, o);
        float discriminant = b * b + dot(u, u) * left;
        boolean leaves = within > 0f && discriminant >= 0f && dot(u, u) > 0f && (left > 0f || b < 0f);
        if (!leaves) {
            return 2f;
        }
        float root = Numbers.sqrt(discriminant);
        return b > 0f ? left / (b + root) : (root - b) / dot(u, u);
    }

    private static float[] at(float[] o, float[] u, float time) {
        return new float[] {o[0] + time * u[0], o[1] + time * u[1]};
    }

    /** When a point comes from beside the arc to the radius of an end, in front of the arc; 2 if it does not, or not after a time. */
    private float timeBeside(float[] e, float[] o, float[] u, float after) {
        float time = (e[1] * o[0] - e[0] * o[1]) / (e[0] * u[1] - e[1] * u[0]);
        if (!(time >= after && time < 1f)) {
            return 2f;
        }
        float[] place = at(o, u, time);
        return dot(place, e) > 0f && !(dot(place, place) > size * size) ? time : 2f;
    }

    /** When a point that moves by u leaves a circle around 0; 2 if it gets no farther than a graze. */
    private static float timeFromInside(float[] o, float[] u, float within, float graze) {
        float[] last = Numbers.plus(o, u);
        float most = within + graze;
        if (!(dot(last, last) > most * most) || !(within > 0f)) {
            return 2f;
        }
        float b = dot(o, u);
        float left = within * within - dot(o, o);
        if (b > 0f) {
            return left > 0f ? left / (b + Numbers.sqrt(b * b + dot(u, u) * left)) : 0f;
        }
        return (Numbers.sqrt(Numbers.max(b * b + dot(u, u) * left, 0f)) - b) / dot(u, u);
    }

    /** An outer arc is two corners, or a disc; an inner one a hollow. The corners of its ends have no radius. */
    @Override
    void addTo(RigidThing thing, float[] around) {
        float x = -around[0];
        float y = -around[1];
        float side = out();
        if (solidOutside) {
            thing.addLine(x, y, t[0], t[1], -size, spread);
        } else if (isCircle()) {
            thing.addDisc(x, y, size);
        } else {
            thing.addCorner(x, y, size, start[0] / size, start[1] / size, t[0], t[1]);
            thing.addCorner(x, y, size, t[0], t[1], end[0] / size, end[1] / size);
        }
        if (!isCircle()) {
            addEnd(thing, true, around, 0f, new float[] {side * start[0] / size, side * start[1] / size});
            addEnd(thing, false, around, 0f, new float[] {side * end[0] / size, side * end[1] / size});
        }
    }
}
