package io.github.circles2d.reference;

import static io.github.circles2d.reference.Numbers.length;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;

/** A body, A, and what is near to it, B: another body of a higher id, a piece of terrain, a wall or a circle. */
final class RigidPair {
    /** How far beyond its cone a corner meets lines, in radians or nearly so. */
    private static final float TOLERANCE = 0.3f;

    /** The same against corners. */
    private static final float STRICT = -1e-6f;

    /** And of discs and bent corners. */
    private static final float NO_GAP = 1e-5f;

    // of lines that cross
    private static final float LEAST_SINE = 0.05f;
    private static final float GREATEST_SINE = 0.45f;

    /** How deep a body in front of a one-way piece may be in it, in half thicknesses. */
    private static final float ROUNDED = 1e-4f;

    final RigidThing a;
    final RigidThing b;

    /** From the place of B to that of A. */
    final float[] offset;

    final List<RigidContact> contacts = new ArrayList<>();
    int colour;
    private final float margin;
    private final StepParameters k;
    private List<RigidContact.Saved> known = List.of();

    RigidPair(RigidThing a, RigidThing b, float[] offset, StepParameters k) {
        this.a = a;
        this.b = b;
        this.offset = offset;
        this.k = k;
        float both = 2f * (a.near + b.near);
        margin = b.ownW == 0f && b.type != RigidThing.BODY ? both + 2f * Circle.MARGIN * a.thin : both;
    }

    boolean hasCircle() {
        return b.type == RigidThing.CIRCLE;
    }

    /** Where it stands among pairs that have not been coloured yet. */
    int hash() {
        int h = a.id * 0x9E3779B1 ^ (b.id + (b.type << 28)) * 0x85EBCA77;
        h ^= h >>> 15;
        h *= 0x2C1B3C6D;
        h ^= h >>> 12;
        h *= 0x297A2D39;
        return h ^ h >>> 15;
    }

    /** A contact of the step before, as it lies. */
    RigidContact measured(RigidContact.Saved saved) {
        int ofA = saved.first() & 0xFFFF;
        RigidContact c = saved.form() == RigidContact.SWAPPED
                ? new RigidContact(this, b, a, saved.second(), ofA, true, true, k)
                : new RigidContact(
                        this, a, b, ofA, saved.second(), saved.form() == RigidContact.CORNER_ON_LINE, false, k);
        c.measure();
        c.impulse = saved.impulse();
        c.grip = saved.grip();
        return c;
    }

    /** Finds contacts, with what the pair had in the step before. */
    void find(List<RigidContact.Saved> before, float warmScale) {
        known = before;
        float x = offset[0] + (a.way[0] - b.way[0]);
        float y = offset[1] + (a.way[1] - b.way[1]);
        if (known.isEmpty() && b.oneWay && !isInFront(x, y)) {
            return;
        }
        if (b.reach < Float.POSITIVE_INFINITY && length(x, y) > (a.reach + b.reach) + 1.125f * margin) {
            return;
        }
        cornersOnLines(a, b, x, y, false);
        cornersOnLines(b, a, -x, -y, true);
        cornersOnCorners(x, y);
        if ((contacts.isEmpty() || areOpposed()) && b.type == RigidThing.BODY) {
            leaveCrossed(x, y);
        }
        contacts.sort(Comparator.comparingInt((RigidContact c) -> c.first).thenComparingInt(c -> c.second));
        contacts.forEach(RigidContact::measure);
        takeImpulses(warmScale);
    }

    /** First those of the same features, then those of what has gone, and shared a feature. */
    private void takeImpulses(float warmScale) {
        List<RigidContact.Saved> left = new ArrayList<>(known);
        for (RigidContact c : contacts) {
            for (RigidContact.Saved saved : known) {
                if (saved.first() == c.first && saved.second() == c.second) {
                    take(c, saved, warmScale, left);
                }
            }
        }
        for (RigidContact c : contacts) {
            for (RigidContact.Saved saved : known) {
                if (c.impulse == 0f && left.contains(saved) && saved.impulse() > 0f && saved.sharesFeature(c)) {
                    take(c, saved, warmScale, left);
                }
            }
        }
    }

    private static void take(RigidContact c, RigidContact.Saved saved, float warmScale, List<RigidContact.Saved> left) {
        c.impulse = warmScale * saved.impulse();
        c.grip = warmScale * saved.grip();
        left.remove(saved);
    }

    /** Whether the body is wholly in front of the piece. */
    private boolean isInFront(float x, float y) {
        float slack = ROUNDED * a.thin;
        return a.corners.stream().allMatch(c -> front(c, x + c[0], y + c[1]) - c[2] >= -slack);
    }

    /** How far the core of a corner at a place is in front of the piece. */
    private float front(float[] corner, float x, float y) {
        if (b.lines.isEmpty()) {
            float[] disc = b.corners.get(0);
            return fromCentre(corner, x - disc[0], y - disc[1], -1f) - disc[2];
        }
        float[] line = b.lines.get(0);
        float rx = x - line[0];
        float ry = y - line[1];
        if (RigidThing.isHollow(line)) {
            return -line[4] - fromCentre(corner, rx, ry, 1f);
        }
        float[] bend = RigidThing.farthest(corner, -line[2], -line[3]);
        return (rx + bend[0]) * line[2] + (ry + bend[1]) * line[3] - line[5];
    }

    /** How far the core of a corner, (x, y) from a centre, is from that at most; with a side of -1 at least. */
    private static float fromCentre(float[] corner, float x, float y, float side) {
        float d = length(x, y);
        if (d == 0f) {
            return d;
        }
        float[] bend = RigidThing.farthest(corner, side * (x / d), side * (y / d));
        return length(x + bend[0], y + bend[1]);
    }

    private void add(RigidThing t, RigidThing o, int corner, int feature, boolean onLine, boolean swapped) {
        contacts.add(new RigidContact(this, t, o, corner, feature, onLine, swapped, k));
    }

    /** Corners of t with lines of o, from which t is (x, y) away. */
    private void cornersOnLines(RigidThing t, RigidThing o, float x, float y, boolean swapped) {
        float tolerance = TOLERANCE + Math.abs(t.omega - o.omega) * k.dt();
        boolean fast = margin > (t.ownW > 0f ? t.thin : o.thin);
        for (int c = 0; c < t.corners.size(); c++) {
            float[] corner = t.corners.get(c);
            float px = x + corner[0];
            float py = y + corner[1];
            float ux = t.velocity[0] - t.omega * corner[1] - o.velocity[0] + o.omega * py;
            float uy = t.velocity[1] + t.omega * corner[0] - o.velocity[1] - o.omega * px;
            int before = contacts.size();
            int deepest = -1;
            float deepestHeight = Float.NEGATIVE_INFINITY;
            float[] deepestBend = {0f, 0f};
            for (int l = 0; l < o.lines.size(); l++) {
                float[] line = o.lines.get(l);
                float rx = px - line[0];
                float ry = py - line[1];
                if (RigidThing.isHollow(line)) {
                    if (isInHollow(corner, line, rx, ry, tolerance)) {
                        add(t, o, c, l, true, swapped);
                    }
                    continue;
                }
                float[] bend = RigidThing.farthest(corner, -line[2], -line[3]);
                rx += bend[0];
                ry += bend[1];
                float height = rx * line[2] + ry * line[3];
                float apart = height - (corner[2] + line[5]);
                boolean faces = fast && apart > 0f || RigidThing.isInCone(corner, -line[2], -line[3], tolerance);
                if (apart > margin
                        || !faces
                        || t.isOfArc(c, -line[2], -line[3])
                        || !isOver(line, rx, ry, ux, uy, apart)) {
                    continue;
                }
                if (height >= 0f) {
                    add(t, o, c, l, true, swapped);
                } else if (height > deepestHeight) {
                    deepestHeight = height;
                    deepestBend = bend;
                    deepest = l;
                }
            }
            if (contacts.size() == before && deepest >= 0) {
                float[] line = o.lines.get(deepest);
                boolean holds = o.type == RigidThing.BODY
                        ? deepestHeight > -(corner[2] + line[5]) || o.isInside(px + deepestBend[0], py + deepestBend[1])
                        : o.type == RigidThing.WALL
                                || wasThere(c, deepest, swapped)
                                || (x - line[0]) * line[2] + (y - line[1]) * line[3] > 0f;
                if (holds) {
                    add(t, o, c, deepest, true, swapped);
                }
            }
        }
    }

    /** Whether a place is between the ends of a line, or will be as it meets it. */
    private boolean isOver(float[] line, float rx, float ry, float ux, float uy, float apart) {
        float along = ry * line[2] - rx * line[3];
        if (along >= 0f && along <= line[4]) {
            return true;
        }
        float un = ux * line[2] + uy * line[3];
        boolean meets = apart > 0f && -un * k.dt() >= apart;
        float then = meets ? along + (uy * line[2] - ux * line[3]) * (apart / -un) : along;
        return then >= 0f && then <= line[4];
    }

    private boolean wasThere(int corner, int line, boolean swapped) {
        int first = swapped ? RigidContact.SWAPPED << 16 | line : corner;
        int second = swapped ? corner : line;
        return known.stream().anyMatch(saved -> saved.first() == first && saved.second() == second);
    }

    /** (atX, atY): from the centre to the corner. */
    private boolean isInHollow(float[] corner, float[] hollow, float atX, float atY, float tolerance) {
        float far = length(atX, atY);
        if (far == 0f) {
            return false;
        }
        float[] bend = RigidThing.farthest(corner, atX / far, atY / far);
        float x = atX + bend[0];
        float y = atY + bend[1];
        float d = length(x, y);
        float radius = -hollow[4];
        return d > 0f
                && (radius - d) - corner[2] <= margin
                && d < radius + corner[2] + margin
                && x * hollow[2] + y * hollow[3] >= hollow[5] * d
                && RigidThing.isInCone(corner, x / d, y / d, tolerance);
    }

    /** A contact by which two bodies leave each other whose lines cross. */
    private void leaveCrossed(float x, float y) {
        float greatestSine = contacts.isEmpty() ? 2f : GREATEST_SINE;
        RigidContact best = null;
        float shallowest = Float.NEGATIVE_INFINITY;
        for (boolean swapped : new boolean[] {false, true}) {
            RigidThing t = swapped ? b : a;
            RigidThing o = swapped ? a : b;
            float tx = swapped ? -x : x;
            float ty = swapped ? -y : y;
            for (int l = 0; l < o.lines.size(); l++) {
                float[] line = o.lines.get(l);
                if (t.lines.stream().noneMatch(other -> cross(line, other, tx, ty, greatestSine))) {
                    continue;
                }
                int deepest = -1;
                float depth = Float.POSITIVE_INFINITY;
                for (int c = 0; c < t.corners.size(); c++) {
                    float[] corner = t.corners.get(c);
                    float[] bend = RigidThing.farthest(corner, -line[2], -line[3]);
                    float height = (tx + corner[0] - line[0] + bend[0]) * line[2]
                            + (ty + corner[1] - line[1] + bend[1]) * line[3];
                    if (height - (corner[2] + line[5]) < depth) {
                        depth = height - (corner[2] + line[5]);
                        deepest = c;
                    }
                }
                if (depth > shallowest) {
                    shallowest = depth;
                    best = new RigidContact(this, t, o, deepest, l, true, swapped, k);
                }
            }
        }
        if (best != null) {
            contacts.clear();
            contacts.add(best);
        }
    }

    /** Whether one of the contacts on lines pushes the other way than the first one. */
    private boolean areOpposed() {
        List<float[]> normals = contacts.stream()
                .map(RigidContact::lineNormal)
                .filter(Objects::nonNull)
                .toList();
        return normals.stream().anyMatch(n -> n[0] * normals.get(0)[0] + n[1] * normals.get(0)[1] < 0f);
    }

    /** Whether each of two lines has its ends on both sides of the other one; (x, y): from the place of the first to that of the second. */
    private static boolean cross(float[] first, float[] second, float x, float y, float greatestSine) {
        float sine = Math.abs(first[2] * second[3] - first[3] * second[2]);
        if (RigidThing.isHollow(first) || RigidThing.isHollow(second) || sine < LEAST_SINE || sine > greatestSine) {
            return false;
        }
        float dx = x + second[0] - first[0];
        float dy = y + second[1] - first[1];
        return areBeside(first, dx, dy, dx - second[4] * second[3], dy + second[4] * second[2])
                && areBeside(second, -dx, -dy, -dx - first[4] * first[3], -dy + first[4] * first[2]);
    }

    /** Whether of two points, against the start of a line, one is in front of it and one is not. */
    private static boolean areBeside(float[] line, float x, float y, float otherX, float otherY) {
        return x * line[2] + y * line[3] > 0f != otherX * line[2] + otherY * line[3] > 0f;
    }

    private void cornersOnCorners(float x, float y) {
        for (int c = 0; c < a.corners.size(); c++) {
            for (int o = 0; o < b.corners.size(); o++) {
                float[] p = a.corners.get(c);
                float[] q = b.corners.get(o);
                float rx = x + p[0] - q[0];
                float ry = y + p[1] - q[1];
                float d = length(rx, ry);
                float bends = p[7] + q[7];
                boolean noGap = RigidThing.isDisc(p) || RigidThing.isDisc(q) || bends > 0f;
                float tolerance = noGap ? NO_GAP : STRICT;
                if (d <= bends + (p[2] + q[2]) + margin
                        && d > bends
                        && RigidThing.isInCone(q, rx / d, ry / d, tolerance)
                        && RigidThing.isInCone(p, -rx / d, -ry / d, tolerance)) {
                    add(a, b, c, o, false, false);
                }
            }
        }
    }
}
