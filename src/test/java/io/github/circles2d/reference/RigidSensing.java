package io.github.circles2d.reference;

import io.github.circles2d.Response;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/**
 * What bodies that are pushed only sense, or what senses them, in a step. All numbers are in double precision. Shapes are lines and arcs around a
 * place; place and angle go evenly from where a step begins to where it ends.
 */
final class RigidSensing {
    private static final double SLACK = 0.005f;
    private static final double BEGINS = 0.1;
    private static final double SAME = 1e-10;
    private static final double COINCIDENT = 1e-9;
    private static final int LOOKS = 32;
    private static final double PARTS = 0x1p24;

    private final List<Rigid> bodies;
    private final float[][] bases;
    private final int[] angles;

    /** A step begins. */
    RigidSensing(List<Rigid> bodies) {
        this.bodies = bodies;
        bases = bodies.stream().map(body -> body.base.clone()).toArray(float[][]::new);
        angles = bodies.stream().mapToInt(body -> body.angle).toArray();
    }

    // ---- shapes

    /** A line, or an arc anticlockwise around a centre, which a line has not. */
    record Edge(double[] from, double[] to, double[] centre, double radius) {
        static Edge line(double[] from, double[] to) {
            return new Edge(from, to, null, 0);
        }

        boolean opens(double[] direction) {
            return cross(minus(from, centre), direction) >= 0 && cross(direction, minus(to, centre)) >= 0;
        }

        double[] nearest(double[] p) {
            if (centre == null) {
                double[] u = minus(to, from);
                double along = dot(u, u) > 0 ? dot(minus(p, from), u) / dot(u, u) : 0;
                return plus(from, u, Math.min(Math.max(along, 0), 1));
            }
            double[] d = minus(p, centre);
            if (length(d) > 0 && opens(d)) {
                return plus(centre, d, radius() / length(d));
            }
            return length(minus(p, from)) <= length(minus(p, to)) ? from : to;
        }
    }

    private static final class Shape {
        final List<Edge> own = new ArrayList<>();
        List<Edge> edges;
        double thickness;
        boolean solid;
        double reach;
        double[] place = new double[2];
        double[] path = new double[2];
        int angle;
        double turn;
        double[] now;

        /** Goes to a share of the step. */
        void go(double share) {
            int by = angle + (int) (long) Math.floor(share * turn + 0.5);
            double cos = Angles.cos(by);
            double sin = Angles.sin(by);
            now = plus(place, path, share);
            edges = own.stream()
                    .map(e -> new Edge(
                            at(e.from, cos, sin),
                            at(e.to, cos, sin),
                            e.centre == null ? null : at(e.centre, cos, sin),
                            e.radius))
                    .toList();
        }

        private double[] at(double[] p, double cos, double sin) {
            return new double[] {now[0] + (cos * p[0] - sin * p[1]), now[1] + (sin * p[0] + cos * p[1])};
        }

        double turning() {
            return turn == 0 ? 0 : Math.abs(turn) * Angles.UNIT * reach;
        }

        /** Counts how often the ends go around a point, and in how many segments of arcs it is. */
        boolean contains(double[] p) {
            int around = 0;
            for (Edge e : solid ? edges : List.<Edge>of()) {
                double[] from = minus(e.from, p);
                double[] to = minus(e.to, p);
                double side = cross(from, to);
                if (from[1] <= 0 && to[1] > 0 && side > 0) {
                    around++;
                }
                if (to[1] <= 0 && from[1] > 0 && side < 0) {
                    around--;
                }
                if (e.centre != null && side <= 0 && length(minus(p, e.centre)) <= e.radius()) {
                    around++;
                }
            }
            return around > 0;
        }
    }

    private static Shape shape(RigidOutline outline) {
        Shape shape = new Shape();
        shape.own.addAll(outline.edges);
        shape.solid = true;
        shape.reach = outline.reach;
        return shape;
    }

    private static Shape shape(Piece piece) {
        Shape shape = new Shape();
        shape.thickness = piece.thickness();
        double[] pivot = piece.body.motion == null ? new double[2] : doubles(piece.pivot);
        double[] centre = {0 - pivot[0], 0 - pivot[1]};
        double[] start = minus(doubles(piece.start), pivot);
        double[] end = minus(doubles(piece.end), pivot);
        double r = piece.size;
        if (!piece.isArc()) {
            shape.own.add(Edge.line(start, end));
            shape.reach = Math.sqrt(Math.max(dot(start, start), dot(end, end)));
            return shape;
        }
        shape.reach = r + length(centre);
        if (piece.isCircle()) {
            double[] right = {centre[0] + r, centre[1]};
            double[] left = {centre[0] - r, centre[1]};
            shape.own.add(new Edge(right, left, centre, r));
            shape.own.add(new Edge(left, right, centre, r));
        } else {
            double[] middle = plus(centre, doubles(piece.t), r);
            shape.own.add(new Edge(piece.isHollow() ? end : start, middle, centre, r));
            shape.own.add(new Edge(middle, piece.isHollow() ? start : end, centre, r));
        }
        return shape;
    }

    // ---- two shapes

    /** The least distance so far, without thickness, and where. */
    private static final class Gap {
        final Shape a;
        final Shape b;
        final double radii;
        boolean apart;
        double least = Double.POSITIVE_INFINITY;
        double[] ofA;
        double[] ofB;

        Gap(Shape a, Shape b, double radii) {
            this.a = a;
            this.b = b;
            this.radii = radii;
            apart = !b.contains(a.edges.get(0).from) && !a.contains(b.edges.get(0).from);
            for (Edge e : a.edges) {
                for (Edge f : b.edges) {
                    if (apart) {
                        look(e, f);
                    }
                }
            }
        }

        double gap() {
            return apart ? least - (a.thickness + b.thickness) : 0;
        }

        private void look(Edge e, Edge f) {
            if (cross(e, f)) {
                apart = false;
                return;
            }
            offer(e.from, f.nearest(e.from));
            offer(e.to, f.nearest(e.to));
            offer(e.nearest(f.from), f.from);
            offer(e.nearest(f.to), f.to);
            if (f.centre != null) {
                double[] p = e.nearest(f.centre);
                offer(p, f.nearest(p));
            }
            if (e.centre != null) {
                double[] p = f.nearest(e.centre);
                offer(e.nearest(p), p);
            }
            if (e.centre != null && f.centre != null) {
                double[] d = minus(e.centre, f.centre);
                double[] back = minus(f.centre, e.centre);
                if (length(d) > 0 && e.opens(d)) {
                    double[] p = plus(e.centre, d, e.radius() / length(d));
                    offer(p, f.nearest(p));
                }
                if (length(d) > 0 && f.opens(back)) {
                    double[] p = plus(f.centre, back, f.radius() / length(d));
                    offer(e.nearest(p), p);
                }
            }
        }

        void offer(double[] p, double[] q) {
            double d = length(minus(q, p));
            if (d < least - SAME * radii) {
                least = d;
                ofA = p;
                ofB = q;
            }
        }

        private static boolean cross(Edge e, Edge f) {
            if (e.centre == null && f.centre == null) {
                return divides(e, f) && divides(f, e);
            }
            if (e.centre != null && f.centre != null) {
                return arcsCross(e, f);
            }
            return e.centre == null ? crossesArc(e, f) : crossesArc(f, e);
        }

        private static boolean divides(Edge line, Edge other) {
            double[] u = minus(line.to, line.from);
            double from = RigidSensing.cross(u, minus(other.from, line.from));
            double to = RigidSensing.cross(u, minus(other.to, line.from));
            return from < 0 && to > 0 || from > 0 && to < 0;
        }

        private static boolean crossesArc(Edge line, Edge arc) {
            double[] u = minus(line.to, line.from);
            double[] o = minus(line.from, arc.centre);
            double half = dot(o, u);
            double disc = half * half - dot(u, u) * (dot(o, o) - arc.radius() * arc.radius());
            if (!(disc >= 0) || !(dot(u, u) > 0)) {
                return false;
            }
            for (int side = -1; side <= 1; side += 2) {
                double share = (side * Math.sqrt(disc) - half) / dot(u, u);
                if (share >= 0 && share <= 1 && arc.opens(plus(o, u, share))) {
                    return true;
                }
            }
            return false;
        }

        private static boolean arcsCross(Edge e, Edge f) {
            double[] way = minus(f.centre, e.centre);
            double d = length(way);
            if (!(d > 0) || d > e.radius() + f.radius() || d < Math.abs(e.radius() - f.radius())) {
                return false;
            }
            double along = (d * d + e.radius() * e.radius() - f.radius() * f.radius()) / (2 * d);
            double across = Math.sqrt(Math.max(e.radius() * e.radius() - along * along, 0));
            for (int side = -1; side <= 1; side += 2) {
                double[] p = {
                    along * way[0] / d - side * across * way[1] / d, along * way[1] / d + side * across * way[0] / d
                };
                if (e.opens(p) && f.opens(minus(p, way))) {
                    return true;
                }
            }
            return false;
        }
    }

    /** The gap at the first share of the step at which it is so small; null if there is none. */
    private static Gap touch(Shape a, Shape b, double tolerance, double radii) {
        double ways = length(minus(a.path, b.path)) + a.turning() + b.turning();
        double share = 0;
        for (int look = 0; look < LOOKS && share <= 1; look++) {
            a.go(share);
            b.go(share);
            Gap gap = new Gap(a, b, radii);
            if (gap.gap() <= tolerance) {
                return gap;
            }
            share += Math.max(Math.floor((gap.gap() - 0.5 * tolerance) / ways * PARTS), 1) / PARTS;
        }
        return null;
    }

    // ---- pairs

    /** The step has ended: finds the pairs that touched in it. */
    List<RigidTouch> touches(
            List<Circle> circles,
            ReferenceTerrain terrain,
            StepParameters k,
            Kinds kinds,
            Predicate<RigidTouch.Key> touched) {
        List<RigidTouch> found = new ArrayList<>();
        for (int n = 0; n < bodies.size(); n++) {
            Rigid body = bodies.get(n);
            for (int m = 0; m < bodies.size(); m++) {
                Rigid other = bodies.get(m);
                if (other.id > body.id
                        && kinds.response(body.kind, other.kind) == Response.SENSE
                        && (body.group == 0 || body.group != other.group)) {
                    Shape b = shape(other.outline);
                    b.place = doubles(k.arena().way(bases[n], bases[m]));
                    b.path = doubles(k.arena().way(bases[m], other.base));
                    b.angle = angles[m];
                    b.turn = other.angle - angles[m];
                    double radii = (double) body.outline.halfThickness + other.outline.halfThickness;
                    add(found, new RigidTouch.Key(true, RigidThing.BODY, body.id, other.id), n, b, radii, k, touched);
                }
            }
        }
        for (int n = 0; n < bodies.size(); n++) {
            for (Piece piece : terrain.pieces()) {
                if (kinds.response(bodies.get(n).kind, piece.kind) == Response.SENSE) {
                    boolean twoSided = piece.hasTwoSides() && kinds.get(piece.kind, Kinds.ONE_WAY) == 0;
                    add(found, n, piece, twoSided, k, touched);
                }
            }
        }
        for (int n = 0; n < bodies.size(); n++) {
            Rigid body = bodies.get(n);
            for (Circle c : circles) {
                if (kinds.response(body.kind, c.kind) == Response.SENSE && (body.group == 0 || body.group != c.group)) {
                    Shape b = new Shape();
                    b.own.add(Edge.line(new double[2], new double[2]));
                    b.thickness = c.radius;
                    b.reach = c.radius;
                    b.place = doubles(k.arena().way(bases[n], c.start));
                    b.path = doubles(k.arena().way(c.start, c.base));
                    double radii = (double) body.outline.halfThickness + c.radius;
                    add(found, new RigidTouch.Key(true, RigidThing.CIRCLE, body.id, c.id), n, b, radii, k, touched);
                }
            }
        }
        return found;
    }

    private Shape body(int n, StepParameters k) {
        Rigid body = bodies.get(n);
        Shape a = shape(body.outline);
        a.path = doubles(k.arena().way(bases[n], body.base));
        a.angle = angles[n];
        a.turn = body.angle - angles[n];
        return a;
    }

    private static double tolerance(boolean touched, double radii) {
        return (touched ? 1 : BEGINS) * SLACK * radii;
    }

    private void add(
            List<RigidTouch> found,
            RigidTouch.Key key,
            int n,
            Shape b,
            double radii,
            StepParameters k,
            Predicate<RigidTouch.Key> touched) {
        Shape a = body(n, k);
        Gap gap = touch(a, b, tolerance(touched.test(key), radii), radii);
        if (gap != null) {
            found.add(touched(key, n, gap, k));
        }
    }

    private void add(
            List<RigidTouch> found,
            int n,
            Piece piece,
            boolean twoSided,
            StepParameters k,
            Predicate<RigidTouch.Key> touched) {
        RigidTouch.Key key = new RigidTouch.Key(true, RigidThing.PIECE, bodies.get(n).id, piece.id);
        double radii = bodies.get(n).outline.halfThickness;
        Shape b = shape(piece);
        float[] o = Numbers.minus(bases[n], piece.origin);
        if (k.arena().isWrapped(0) || k.arena().isWrapped(1)) {
            float[] fromMiddle = k.arena().way(piece.middle, bases[n]);
            o = new float[] {
                fromMiddle[0] + (piece.middle[0] - piece.origin[0]), fromMiddle[1] + (piece.middle[1] - piece.origin[1])
            };
        }
        Body.Motion motion = piece.body.motion;
        b.place = minus(motion == null ? new double[2] : doubles(piece.pivot), doubles(o));
        if (motion != null) {
            b.path = doubles(motion.ways()[k.subSteps()]);
            b.turn = (double) motion.omega() * k.dt() / Angles.UNIT;
        }
        if (!twoSided && !touched.test(key)) {
            Shape a = body(n, k);
            a.go(0);
            b.go(0);
            boolean beside = new Gap(a, b, radii).gap() > tolerance(false, radii);
            Edge first = b.edges.get(0);
            double front = piece.isArc()
                    ? (length(first.centre) - piece.size) * (piece.isHollow() ? -1 : 1)
                    : first.from[1] * piece.t[0] - first.from[0] * piece.t[1];
            if (!beside || !(front > 0)) {
                return;
            }
        }
        add(found, key, n, b, radii, k, touched);
    }

    private RigidTouch touched(RigidTouch.Key key, int n, Gap gap, StepParameters k) {
        Shape a = gap.a;
        Shape b = gap.b;
        boolean known = gap.apart && gap.least > COINCIDENT * gap.radii;
        if (!known) {
            gap.least = Double.POSITIVE_INFINITY;
            b.edges.forEach(f -> gap.offer(a.now, f.nearest(a.now)));
        }
        double[] way = minus(gap.ofB, gap.ofA);
        double[] normal = length(way) > COINCIDENT * gap.radii
                ? new double[] {way[0] / length(way), way[1] / length(way)}
                : new double[] {0, 1};
        double[] point = known ? gap.ofA : a.reach < b.reach ? a.now : gap.ofB;
        double speed = (dot(velocity(a, point), normal) - dot(velocity(b, point), normal)) / k.dt();
        return new RigidTouch(
                key,
                new float[] {(float) (bases[n][0] + point[0]), (float) (bases[n][1] + point[1])},
                new float[] {(float) normal[0] + 0f, (float) normal[1] + 0f},
                0f,
                (float) Math.max(speed, 0) + 0f);
    }

    /** Of a point, times the length of the step. */
    private static double[] velocity(Shape of, double[] point) {
        double spin = of.turn * Angles.UNIT;
        double[] arm = minus(point, of.now);
        return new double[] {of.path[0] - spin * arm[1], of.path[1] + spin * arm[0]};
    }

    // ---- vectors

    private static double[] doubles(float[] v) {
        return new double[] {v[0], v[1]};
    }

    private static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1]};
    }

    private static double[] plus(double[] a, double[] b, double times) {
        return new double[] {a[0] + times * b[0], a[1] + times * b[1]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1];
    }

    private static double cross(double[] a, double[] b) {
        return a[0] * b[1] - a[1] * b[0];
    }

    private static double length(double[] a) {
        return Math.sqrt(a[0] * a[0] + a[1] * a[1]);
    }
}
