package io.github.circles2d.reference;

import java.util.ArrayList;
import java.util.List;

/**
 * What the outline of a body that is pushed is to a step: lines and corners around its centroid, anticlockwise, in double precision until they
 * are done.
 */
final class RigidOutline {
    private static final double ROUNDING = 0.05;
    private static final double OF_EDGE = 0.25;
    private static final double TOLERANCE = 1e-3;

    /** A sine: pieces that meet at less are smooth. */
    private static final double SMOOTH = 1e-4;

    /** Radians by which parts of an arc go on into each other. */
    private static final double OVERLAP = 1e-4;

    /** Share of a line: it is left out if no more is left of it. */
    private static final double GONE = 1e-6;

    // by the least width: the greatest radius of a round end, and how deep the core of another arc lies
    private static final double ROUND_END = 0.505;
    private static final double DEPTH = 0.25;

    /** A piece of the drawing: from a point, to a point, around a centre if it turns. */
    private record Way(float[] from, float[] to, float[] centre, long turn) {
        boolean isLine() {
            return turn == 0;
        }

        double radius() {
            return Math.sqrt(square((double) from[0] - centre[0]) + square((double) from[1] - centre[1]));
        }
    }

    /**
     * A line or an arc of what is rounded.
     *
     * @param place the middle of an arc; where the core of a line begins, without what it is longer by
     * @param r the radius, or how thick a line is
     * @param bend the radius of the core of an arc
     * @param a the normal where it begins
     * @param b the normal where it ends
     * @param before how much longer the core of a line is where it begins
     * @param after and where it ends
     */
    private record Element(
            boolean isLine,
            double[] place,
            double r,
            double bend,
            double[] a,
            double[] b,
            double span,
            double before,
            double after) {
        /** The length of a line, the opening of an arc. */
        double extent() {
            return isLine ? span : angle(a[0] * b[0] + a[1] * b[1], Math.max(0, a[0] * b[1] - a[1] * b[0]));
        }

        double[] point(double at) {
            if (isLine) {
                return new double[] {place[0] + r * a[0] - at * a[1], place[1] + r * a[1] + at * a[0]};
            }
            int units = (int) Angles.units(at);
            double cos = Angles.cos(units);
            double sin = Angles.sin(units);
            double x = at == 0 ? a[0] : cos * a[0] - sin * a[1];
            double y = at == 0 ? a[1] : sin * a[0] + cos * a[1];
            return new double[] {place[0] + r * x, place[1] + r * y};
        }
    }

    private final List<Way> ways = new ArrayList<>();
    private final List<Element> elements = new ArrayList<>();
    private final double leastWidth;
    private final float rounding;

    // by way: the unit tangents at both ends, and how far the ends of cores lie before its start, in roundings
    private final double[][] start;
    private final double[][] end;
    private final double[] back;

    // the sums of the mass
    private double area;
    private double momentX;
    private double momentY;
    private double second;

    /** Of a mass of 1. */
    final float inertia;

    final float reach;

    /** What lengths of contacts are measured by. */
    final float halfThickness;

    /** Place, radius, both ends of the cone of normals, and bend: the core is an arc of this radius around the place. */
    final List<float[]> corners = new ArrayList<>();

    /** Where the core begins, normal, length and thickness. */
    final List<float[]> lines = new ArrayList<>();

    /** What the surface goes along, in double precision: lines and arcs, each up to where the next one begins. */
    final List<RigidSensing.Edge> edges = new ArrayList<>();

    /** Points of a polygon; what lies in it is inside. */
    final List<float[]> core = new ArrayList<>();

    RigidOutline(BodyOutline drawn) {
        draw(drawn.chain());
        int n = ways.size();
        start = new double[n][];
        end = new double[n][];
        back = new double[n];
        findTangents();
        leastWidth = leastWidth();
        rounding = Float.isNaN(drawn.rounding())
                ? (float) Math.min(ROUNDING * leastWidth, OF_EDGE * mostRounding())
                : drawn.rounding();
        round();
        double[] centroid = weigh();
        inertia = (float) (second / area);
        elements.forEach(element -> (element.isLine ? lines : corners)
                .add(element.isLine ? line(element, centroid) : corner(element, centroid)));
        elements.stream()
                .filter(element -> element.isLine || element.r != rounding)
                .forEach(element -> addToCore(element, centroid));
        addEdges(centroid);
        float far = 0f;
        for (float[] c : corners) {
            far = Math.max(far, farthest(c) + c[2]);
        }
        reach = far;
        halfThickness = (float) Math.min(Math.sqrt(area) / 2, area / (2 * (double) reach));
    }

    /** The words of which the hash has each. */
    List<Integer> words() {
        List<Integer> words = new ArrayList<>();
        words.add(Float.floatToRawIntBits(rounding));
        words.add(ways.size());
        words.add(Float.floatToRawIntBits(ways.get(0).from[0]));
        words.add(Float.floatToRawIntBits(ways.get(0).from[1]));
        for (Way way : ways) {
            float[] at = way.isLine() ? way.to : way.centre;
            words.add(Float.floatToRawIntBits(at[0]));
            words.add(Float.floatToRawIntBits(at[1]));
            words.add((int) way.turn);
            words.add((int) (way.turn >> 32));
        }
        return words;
    }

    /** How far the core of a corner is from the centroid at most. */
    private static float farthest(float[] c) {
        boolean inCone = c[3] * c[1] - c[4] * c[0] >= 0f && c[5] * c[1] - c[6] * c[0] <= 0f;
        if (c[7] == 0f || inCone) {
            return length(c[0], c[1]) + c[7];
        }
        return Math.max(length(c[0] + c[7] * c[3], c[1] + c[7] * c[4]), length(c[0] + c[7] * c[5], c[1] + c[7] * c[6]));
    }

    private static float length(float x, float y) {
        return (float) Math.sqrt(x * x + y * y);
    }

    private static double square(double a) {
        return a * a;
    }

    private static double[] minus(float[] a, float[] b) {
        return new double[] {(double) a[0] - b[0], (double) a[1] - b[1]};
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1]);
    }

    // ---- the drawing

    private void draw(ChainShape shape) {
        float[] at = {shape.x(), shape.y()};
        for (float[] way : shape.ways()) {
            at = add(at, way, way.length == 2 ? 0 : ReferenceTerrain.opening(way[2]));
        }
        close();
        if (areaOfDrawing() < 0) {
            List<Way> forwards = List.copyOf(ways);
            ways.clear();
            float[] from = forwards.get(forwards.size() - 1).to;
            for (int k = forwards.size() - 1; k >= 0; k--) {
                Way way = forwards.get(k);
                from = add(from, way.isLine() ? way.from : way.centre, -way.turn);
            }
            close();
        }
    }

    /** Adds a line to a point, or an arc around one; returns where it ends. */
    private float[] add(float[] from, float[] at, long turn) {
        float[] to = turn == 0 ? at : turned(from, at, (int) turn);
        ways.add(new Way(from, to, at, turn));
        return to;
    }

    private static float[] turned(float[] from, float[] centre, int by) {
        double[] d = minus(from, centre);
        double cos = Angles.cos(by);
        double sin = Angles.sin(by);
        return new float[] {
            (float) (centre[0] + (cos * d[0] - sin * d[1])), (float) (centre[1] + (sin * d[0] + cos * d[1]))
        };
    }

    private void close() {
        float[] first = ways.get(0).from;
        float[] last = ways.get(ways.size() - 1).to;
        if (!ReferenceTerrain.isTooShort(last, first)) {
            add(last, first, 0);
        }
    }

    /** Points along the drawing, the first and the last among them, between which lines are so near to it. */
    private List<float[]> points(float tolerance) {
        List<float[]> points = new ArrayList<>();
        for (Way way : ways) {
            double angle = Math.abs(way.turn) * Angles.UNIT;
            double parts = way.isLine() ? 1 : Math.ceil(angle * Math.sqrt(way.radius() / (8.0 * tolerance)));
            int n = (int) Math.max(1, Math.min(1024, parts));
            points.add(way.from);
            for (int k = 1; k < n; k++) {
                points.add(turned(way.from, way.centre, (int) Math.round((double) way.turn * k / n)));
            }
        }
        points.add(ways.get(ways.size() - 1).to);
        return points;
    }

    private List<float[]> polygon() {
        List<float[]> ends = points(Float.POSITIVE_INFINITY);
        ways.stream().filter(way -> !way.isLine()).forEach(way -> ends.add(way.centre));
        double[] diagonal = new double[2];
        for (int a = 0; a < 2; a++) {
            int axis = a;
            diagonal[a] = ends.stream().mapToDouble(p -> p[axis]).max().orElseThrow()
                    - ends.stream().mapToDouble(p -> p[axis]).min().orElseThrow();
        }
        return points(Math.max((float) (TOLERANCE * length(diagonal)), Float.MIN_NORMAL));
    }

    private double areaOfDrawing() {
        List<float[]> p = polygon();
        double sum = 0;
        for (int k = 0; k + 1 < p.size(); k++) {
            double[] a = minus(p.get(k), p.get(0));
            double[] b = minus(p.get(k + 1), p.get(0));
            sum += a[0] * b[1] - a[1] * b[0];
        }
        return sum / 2;
    }

    /** The least width of its hull. */
    private double leastWidth() {
        List<float[]> p = polygon();
        p.remove(p.size() - 1);
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < p.size(); k++) {
            for (int to = k + 1; to < p.size(); to++) {
                double[] d = minus(p.get(to), p.get(k));
                if (length(d) > 0 && isOnHull(p, p.get(k), d)) {
                    least = Math.min(least, width(p, d[1] / length(d), -d[0] / length(d)));
                }
            }
        }
        return least;
    }

    private static boolean isOnHull(List<float[]> points, float[] from, double[] d) {
        double least = 0;
        double greatest = 0;
        for (float[] p : points) {
            double[] q = minus(p, from);
            least = Math.min(least, d[0] * q[1] - d[1] * q[0]);
            greatest = Math.max(greatest, d[0] * q[1] - d[1] * q[0]);
        }
        return least == 0 || greatest == 0;
    }

    private static double width(List<float[]> points, double nx, double ny) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (float[] p : points) {
            double[] q = minus(p, points.get(0));
            low = Math.min(low, nx * q[0] + ny * q[1]);
            high = Math.max(high, nx * q[0] + ny * q[1]);
        }
        return high - low;
    }

    // ---- lines and corners

    private Way before(int k) {
        return ways.get(Math.floorMod(k - 1, ways.size()));
    }

    private double[] along(int k) {
        return minus(ways.get((k + 1) % ways.size()).from, ways.get(k).from);
    }

    private void findTangents() {
        for (int k = 0; k < ways.size(); k++) {
            Way way = ways.get(k);
            if (way.isLine()) {
                double[] d = along(k);
                start[k] = new double[] {d[0] / length(d), d[1] / length(d)};
                end[k] = start[k];
            } else {
                double[] d = minus(way.from, way.centre);
                double cos = Angles.cos((int) way.turn);
                double sin = Angles.sin((int) way.turn);
                start[k] = new double[] {-d[1] / way.radius(), d[0] / way.radius()};
                end[k] = new double[] {cos * start[k][0] - sin * start[k][1], sin * start[k][0] + cos * start[k][1]};
            }
        }
        for (int k = 0; k < ways.size(); k++) {
            if (ways.get(k).isLine() && before(k).isLine()) {
                double[] last = end[Math.floorMod(k - 1, ways.size())];
                back[k] = sine(k) / (1 + (last[0] * start[k][0] + last[1] * start[k][1]));
            }
        }
    }

    /** Of the angle between a way and the one before. */
    private double sine(int k) {
        double[] last = end[Math.floorMod(k - 1, ways.size())];
        return last[0] * start[k][1] - last[1] * start[k][0];
    }

    /** At which the first of the cores of lines has no length. */
    private double mostRounding() {
        double most = Double.POSITIVE_INFINITY;
        for (int k = 0; k < ways.size(); k++) {
            double lost = back[k] + back[(k + 1) % ways.size()];
            if (ways.get(k).isLine() && lost > 0) {
                most = Math.min(most, length(along(k)) / lost);
            }
        }
        return most;
    }

    private void round() {
        for (int k = 0; k < ways.size(); k++) {
            Way way = ways.get(k);
            if (sine(k) > SMOOTH) {
                addJoint(k, way.isLine() && before(k).isLine() ? rounding : 0);
            }
            if (way.isLine()) {
                addLine(k);
            } else {
                addArc(k);
            }
        }
    }

    private static double[] normal(double[] tangent) {
        return new double[] {tangent[1], -tangent[0]};
    }

    private void addJoint(int k, double inset) {
        double[] s = start[k];
        float[] from = ways.get(k).from;
        double[] place = {from[0] + inset * (s[0] * back[k] - s[1]), from[1] + inset * (s[1] * back[k] + s[0])};
        double[] last = end[Math.floorMod(k - 1, ways.size())];
        elements.add(new Element(false, place, inset, 0, normal(last), normal(s), 0, 0, 0));
    }

    private void addLine(int k) {
        double r = rounding;
        double next = back[(k + 1) % ways.size()];
        double length = length(along(k)) - r * (back[k] + next);
        if (Math.abs(length) <= GONE * length(along(k))) {
            return;
        }
        double before = r * Math.max(0, -back[k]);
        double after = r * Math.max(0, -next);
        double at = r * back[k] + before;
        double[] s = start[k];
        float[] from = ways.get(k).from;
        double[] place = {from[0] + (at * s[0] - r * s[1]), from[1] + (at * s[1] + r * s[0])};
        elements.add(new Element(true, place, r, 0, normal(s), normal(s), length - before - after, before, after));
    }

    /** In parts of a quarter of a turn at most. */
    private void addArc(int k) {
        Way way = ways.get(k);
        int parts = (int) Math.max(1, Math.ceil(way.turn * Angles.UNIT / (Math.PI / 2) - 1e-9));
        double[] centre = {way.centre[0], way.centre[1]};
        double bend = isRoundEnd(k) ? 0 : Math.max(0, way.radius() - DEPTH * leastWidth);
        double[] s = start[k];
        double[] from = normal(s);
        for (int part = 1; part <= parts; part++) {
            int units = (int) (way.turn * part / parts);
            double cos = Angles.cos(units);
            double sin = Angles.sin(units);
            double[] to =
                    part == parts ? normal(end[k]) : new double[] {cos * s[1] + sin * s[0], sin * s[1] - cos * s[0]};
            elements.add(new Element(false, centre, way.radius(), bend, from, to, 0, 0, 0));
            from = to;
        }
    }

    /** Whether an arc is small and meets both neighbours smoothly. */
    private boolean isRoundEnd(int k) {
        boolean smooth = Math.abs(sine(k)) <= SMOOTH && Math.abs(sine((k + 1) % ways.size())) <= SMOOTH;
        return smooth && ways.get(k).radius() <= ROUND_END * leastWidth;
    }

    // ---- mass

    /** Adds up the mass, against the place of the first element; returns the centroid. */
    private double[] weigh() {
        double[] origin = elements.get(0).place;
        List<double[]> ends = new ArrayList<>();
        for (Element element : elements) {
            double[] place = {element.place[0] - origin[0], element.place[1] - origin[1]};
            Element at = new Element(
                    element.isLine,
                    place,
                    element.r,
                    element.bend,
                    element.a,
                    element.b,
                    element.span,
                    element.before,
                    element.after);
            double extent = at.extent();
            ends.add(at.point(0));
            if (ends.size() > 1) {
                edge(ends.get(ends.size() - 2), ends.get(ends.size() - 1));
            }
            ends.add(at.point(extent));
            edge(ends.get(ends.size() - 2), ends.get(ends.size() - 1));
            if (!at.isLine && at.r > 0) {
                segment(at, extent);
            }
        }
        edge(ends.get(ends.size() - 1), ends.get(0));
        second = second - (momentX * momentX + momentY * momentY) / area;
        return new double[] {origin[0] + momentX / area, origin[1] + momentY / area};
    }

    private void edge(double[] p, double[] q) {
        double cross = p[0] * q[1] - p[1] * q[0];
        area += cross / 2;
        momentX += cross * (p[0] + q[0]) / 6;
        momentY += cross * (p[1] + q[1]) / 6;
        second += cross * (p[0] * p[0] + p[0] * q[0] + q[0] * q[0] + p[1] * p[1] + p[1] * q[1] + q[1] * q[1]) / 12;
    }

    /** Between an arc and its chord. */
    private void segment(Element arc, double opening) {
        double r = arc.r;
        double cos = arc.a[0] * arc.b[0] + arc.a[1] * arc.b[1];
        double f = opening / 2;
        double cosF = Math.sqrt(Math.max(0, (1 + cos) / 2));
        double sinF = Math.sqrt(Math.max(0, (1 - cos) / 2));
        double lens = f < 0.01 ? f * f * f * (2.0 / 3 - f * f * (2.0 / 15)) : f - sinF * cosF;
        double s = r * r * lens;
        if (!(s > 0)) {
            return;
        }
        double d = 2 * r * sinF * sinF * sinF / (3 * lens);
        double[] chord = {arc.b[0] - arc.a[0], arc.b[1] - arc.a[1]};
        double x = arc.place[0] + d * (chord[1] / length(chord));
        double y = arc.place[1] - d * (chord[0] / length(chord));
        double b = 2 * r * sinF;
        double h = r * cosF;
        double aboutCentre = r * r * r * r * f / 2 - b * h / 2 * (h * h / 2 + b * b / 24);
        area += s;
        momentX += s * x;
        momentY += s * y;
        second += aboutCentre - s * d * d + s * (x * x + y * y);
    }

    /** From its cosine and its sine, from 0 to pi: the greatest whole number of units that is not more, and what is left. */
    private static double angle(double cos, double sin) {
        int low = 0;
        for (int bit = 1 << 30; bit > 0; bit /= 2) {
            int next = low + bit;
            if (next > 0 && sin * Angles.cos(next) - cos * Angles.sin(next) >= 0) {
                low = next;
            }
        }
        return low * Angles.UNIT + (sin * Angles.cos(low) - cos * Angles.sin(low));
    }

    // ---- what a step has

    private float[] corner(Element e, double[] centroid) {
        Element last = elements.get(Math.floorMod(elements.indexOf(e) - 1, elements.size()));
        boolean goesOn = last != e && !last.isLine && last.place[0] == e.place[0] && last.place[1] == e.place[1];
        double overlap = goesOn && e.bend == 0 ? OVERLAP : 0;
        return new float[] {
            (float) (e.place[0] - centroid[0]),
            (float) (e.place[1] - centroid[1]),
            (float) (e.r - e.bend),
            (float) (e.a[0] + overlap * e.a[1]),
            (float) (e.a[1] - overlap * e.a[0]),
            (float) e.b[0],
            (float) e.b[1],
            (float) e.bend
        };
    }

    private static float[] line(Element e, double[] centroid) {
        return new float[] {
            (float) (e.place[0] + e.before * e.a[1] - centroid[0]),
            (float) (e.place[1] - e.before * e.a[0] - centroid[1]),
            (float) e.a[0],
            (float) e.a[1],
            (float) (e.before + e.span + e.after),
            (float) e.r
        };
    }

    /** Both ends of the core of a line; ends and the middle of an arc. */
    private void addEdges(double[] centroid) {
        List<Element> wide = elements.stream().filter(e -> e.isLine || e.r > 0).toList();
        for (int k = 0; k < wide.size(); k++) {
            Element e = wide.get(k);
            double[] from = e.point(0);
            double[] to = wide.get((k + 1) % wide.size()).point(0);
            double[] centre = e.isLine ? null : new double[] {e.place[0] - centroid[0], e.place[1] - centroid[1]};
            double[] begin = {from[0] - centroid[0], from[1] - centroid[1]};
            double[] end = {to[0] - centroid[0], to[1] - centroid[1]};
            if (begin[0] != end[0] || begin[1] != end[1]) {
                edges.add(new RigidSensing.Edge(begin, end, centre, e.isLine ? 0 : e.r));
            }
        }
    }

    private void addToCore(Element e, double[] centroid) {
        double x = e.place[0] - centroid[0];
        double y = e.place[1] - centroid[1];
        if (e.isLine) {
            double to = e.span + e.after;
            addToCore(x + e.before * e.a[1], y - e.before * e.a[0]);
            addToCore(x - to * e.a[1], y + to * e.a[0]);
            return;
        }
        double inner = Math.max(0, e.r - rounding);
        double[] middle = {e.a[0] + e.b[0], e.a[1] + e.b[1]};
        addToCore(x + inner * e.a[0], y + inner * e.a[1]);
        addToCore(x + inner * middle[0] / length(middle), y + inner * middle[1] / length(middle));
        addToCore(x + inner * e.b[0], y + inner * e.b[1]);
    }

    private void addToCore(double x, double y) {
        core.add(new float[] {(float) x, (float) y});
    }
}
