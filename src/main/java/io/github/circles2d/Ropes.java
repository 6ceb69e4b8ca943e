package io.github.circles2d;

import io.github.circles2d.world.changes.Net;
import io.github.circles2d.world.model.Limits;

/**
 * Makes ropes and bridges: rows of equal circles, each joined to the next.
 *
 * <pre>{@code
 * long hook = world.add(50, 60, 1, 20);
 * JointedCircles rope = Ropes.rope(world, Ropes.at(50, 90), Ropes.circle(hook), 28, 0.3f, 0.1f, 0);
 * Ropes.bridge(world, Ropes.at(10, 20), Ropes.at(40, 20), 25, 0.5f, 1, 0.05f);
 * }</pre>
 *
 * <p><b>Ends:</b> a rope goes from the centre of a circle ({@link #circle}), or from a place ({@link #at}, {@link #on}), to another of these. The circles of
 * the ends must be there already; the rope does not add them. Behind a circle of an end the rope begins at its edge: the link there may be
 * longer than the others.
 *
 * <p><b>Shape:</b> without slack a rope is straight. A slack of 0.1 makes it a tenth longer than the ends are apart, and it is laid out as an arc, to the
 * side where gravity pulls. All links then have their lengths, and nothing jumps. Along an axis that wraps, a rope takes the way without wrapping.
 *
 * <p><b>Stretch:</b> steps alone hold a long row of rigid joints with a heavy end not tight enough: 100 links stretch by a fifth. So {@link #rope} adds a joint
 * from the first end to the last, which lets them come no farther apart than the rope is long. It costs one joint, and keeps ropes tight.
 *
 * <p><b>Rest:</b> ropes and bridges swing for minutes, and do not sleep, unless their kind has a {@linkplain Kind#setDamping damping}, such as 1.
 *
 * <p>The calls add all or nothing.
 */
public final class Ropes {
    /** Greatest number of circles of a rope. */
    private static final int MOST = 100_000;

    /** Of the length of a rope: more would be a heap. */
    private static final float GREATEST_SLACK = 1f;

    /** Halvings of the interval of a curvature: to the last bit of a double. */
    private static final int HALVINGS = 60;

    private Ropes() {}

    /** An end of a rope; {@link #circle}, {@link #at} and {@link #on} make one. */
    public static final class End {
        private final long circle;
        private final TerrainBody body;
        private final float x;
        private final float y;

        private End(long circle, TerrainBody body, float x, float y) {
            this.circle = circle;
            this.body = body;
            this.x = x;
            this.y = y;
        }

        private boolean isCircle() {
            return circle != 0;
        }

        private double x(World world) {
            if (isCircle()) {
                return world.x(circle);
            }
            return body == null ? x : body.x() + (StrictMath.cos(body.angle()) * x - StrictMath.sin(body.angle()) * y);
        }

        private double y(World world) {
            if (isCircle()) {
                return world.y(circle);
            }
            return body == null ? y : body.y() + (StrictMath.sin(body.angle()) * x + StrictMath.cos(body.angle()) * y);
        }

        /** How far a rope goes until a circle of it is outside. */
        private double clearance(World world, float radius) {
            return isCircle() ? (double) world.radius(circle) + radius : 0;
        }

        /** The handle of the body that it is on. */
        private long bodyIn(World world) {
            return body == null ? world.terrain().ground().handle() : body.handleIn(world.simulation());
        }

        /** Joins a circle of a rope to this end. */
        private void join(World world, Net rope, int to, Joint joint) {
            if (isCircle()) {
                rope.joinTo(joint.form(), circle, to);
            } else {
                rope.anchor(joint.form(), to, bodyIn(world), x, y);
            }
        }

        /** Joins another end, which is a circle, to this one. */
        private void joinEnd(World world, Net rope, End to, Joint joint) {
            if (isCircle()) {
                rope.joinThere(joint.form(), circle, to.circle);
            } else {
                rope.anchorThere(joint.form(), to.circle, bodyIn(world), x, y);
            }
        }
    }

    /**
     * An end at the centre of a circle.
     *
     * @param handle the handle of the circle
     * @return the end
     * @throws IllegalArgumentException if the handle is 0, which is none
     */
    public static End circle(long handle) {
        if (handle == 0) {
            throw new IllegalArgumentException("the handle of the end is 0, but must be that of a circle");
        }
        return new End(handle, null, 0, 0);
    }

    /**
     * An end at a place of the world.
     *
     * @param x x of the place, up to 1e9 in magnitude
     * @param y y of the place
     * @return the end
     * @throws IllegalArgumentException if a value is out of range
     */
    public static End at(float x, float y) {
        return new End(0, null, coordinate("x", x), coordinate("y", y));
    }

    /**
     * An end at a place of a body of terrain, which goes with it.
     *
     * @param body the body
     * @param x x of the place in the body's own coordinates, up to 1e9 in magnitude
     * @param y y of the place
     * @return the end
     * @throws IllegalArgumentException if a value is out of range
     */
    public static End on(TerrainBody body, float x, float y) {
        return new End(0, Limits.notNull("body", body), coordinate("x", x), coordinate("y", y));
    }

    private static float coordinate(String what, float value) {
        return Limits.within(what, value, -Limits.COORDINATE, Limits.COORDINATE);
    }

    /**
     * Adds a rope that keeps its length. At least one end must be a circle, which the rope then holds; between two places it is a {@link #bridge}.
     *
     * @param world the world
     * @param from where it begins
     * @param to where it ends
     * @param count the number of its circles between the ends, 1 to 100,000
     * @param radius the radius of each
     * @param mass the mass of each
     * @param slack by which share it is longer than the ends are apart, 0 to 1
     * @return the circles from the first end to the last; the joints likewise, and the one that limits the length behind them
     * @throws IllegalArgumentException if a value is out of range, an end has gone, both ends are places or the same circle, or links
     *     would be shorter than the radius
     */
    public static JointedCircles rope(World world, End from, End to, int count, float radius, float mass, float slack) {
        return rope(world, from, to, count, radius, mass, slack, 0);
    }

    /**
     * Adds a rope that keeps its length, of circles of a {@link Kind}. If the mask of the kind leaves out other circles or pieces of terrain,
     * the rope passes them.
     *
     * @param world the world
     * @param from where it begins
     * @param to where it ends
     * @param count the number of its circles between the ends, 1 to 100,000
     * @param radius the radius of each
     * @param mass the mass of each
     * @param slack by which share it is longer than the ends are apart, 0 to 1
     * @param kind the number of the kind of each, 0 to 255
     * @return as {@link #rope(World, End, End, int, float, float, float)}
     * @throws IllegalArgumentException as {@link #rope(World, End, End, int, float, float, float)}, or if there is no such kind
     */
    public static JointedCircles rope(
            World world, End from, End to, int count, float radius, float mass, float slack, int kind) {
        if (!check(world, from, to).isCircle() && !to.isCircle()) {
            throw new IllegalArgumentException(
                    "both ends of the rope are places, but one must be a circle: bridge joins places");
        }
        return add(world, from, to, count, radius, mass, slack, kind, null, true);
    }

    /**
     * Adds a rope of links of any kind: springs make it elastic, and links that break may part. Nothing else holds its length.
     *
     * @param world the world
     * @param from where it begins
     * @param to where it ends
     * @param count the number of its circles between the ends, 1 to 100,000
     * @param radius the radius of each
     * @param mass the mass of each
     * @param slack by which share it is longer than the ends are apart, 0 to 1
     * @param link what joins each to the next: a joint of two circles, that an anchor may have, too
     * @return the circles from the first end to the last, and the joints likewise
     * @throws IllegalArgumentException as {@link #rope(World, End, End, int, float, float, float)}, but both ends may be places; or if the joint is refused
     */
    public static JointedCircles rope(
            World world, End from, End to, int count, float radius, float mass, float slack, Joint link) {
        return rope(world, from, to, count, radius, mass, slack, link, 0);
    }

    /**
     * Adds a rope of links of any kind, of circles of a {@link Kind}. Nothing else holds its length.
     *
     * @param world the world
     * @param from where it begins
     * @param to where it ends
     * @param count the number of its circles between the ends, 1 to 100,000
     * @param radius the radius of each
     * @param mass the mass of each
     * @param slack by which share it is longer than the ends are apart, 0 to 1
     * @param link what joins each to the next: a joint of two circles, that an anchor may have, too
     * @param kind the number of the kind of each circle, 0 to 255
     * @return the circles from the first end to the last, and the joints likewise
     * @throws IllegalArgumentException as {@link #rope(World, End, End, int, float, float, float, Joint)}, or if there is no such kind
     */
    public static JointedCircles rope(
            World world, End from, End to, int count, float radius, float mass, float slack, Joint link, int kind) {
        check(world, from, to);
        return add(world, from, to, count, radius, mass, slack, kind, Limits.notNull("link", link), false);
    }

    /**
     * Adds a bridge: circles between two places, which rigid joints hold. Its circles stop others, its joints stop nobody: fast circles can
     * slip through between two planks that are apart, or much lighter. So take enough planks that neighbours overlap, each about as heavy
     * as what falls on it. Give their kind a {@linkplain Kind#setDamping damping}: else the bridge moves for minutes. A link must be at least as long as the radius: neighbours may overlap by half, others do not.
     *
     * @param world the world
     * @param from where it begins
     * @param to where it ends
     * @param count the number of its circles, 1 to 100,000
     * @param radius the radius of each
     * @param mass the mass of each
     * @param slack by which share it is longer than the ends are apart, 0 to 1
     * @return the circles from the first end to the last, and the joints likewise
     * @throws IllegalArgumentException if a value is out of range, an end has gone, both ends are the same circle, or links would be
     *     shorter than the radius
     */
    public static JointedCircles bridge(
            World world, End from, End to, int count, float radius, float mass, float slack) {
        return bridge(world, from, to, count, radius, mass, slack, 0);
    }

    /**
     * Adds a bridge of circles of a {@link Kind}.
     *
     * @param world the world
     * @param from where it begins
     * @param to where it ends
     * @param count the number of its circles, 1 to 100,000
     * @param radius the radius of each
     * @param mass the mass of each
     * @param slack by which share it is longer than the ends are apart, 0 to 1
     * @param kind the number of the kind of each, 0 to 255
     * @return the circles from the first end to the last, and the joints likewise
     * @throws IllegalArgumentException as {@link #bridge(World, End, End, int, float, float, float)}, or if there is no such kind
     */
    public static JointedCircles bridge(
            World world, End from, End to, int count, float radius, float mass, float slack, int kind) {
        check(world, from, to);
        return add(world, from, to, count, radius, mass, slack, kind, null, false);
    }

    private static End check(World world, End from, End to) {
        Limits.notNull("world", world);
        Limits.notNull("from", from);
        Limits.notNull("to", to);
        if (from.isCircle() && from.circle == to.circle) {
            throw new IllegalArgumentException("both ends are the circle with the handle " + from.circle);
        }
        return from;
    }

    private static JointedCircles add(
            World world,
            End from,
            End to,
            int count,
            float radius,
            float mass,
            float slack,
            int kind,
            Joint link,
            boolean limited) {
        Limits.within("the number of circles", count, 1, MOST);
        Limits.within("slack", slack, 0f, GREATEST_SLACK);
        double x = from.x(world);
        double y = from.y(world);
        double dx = to.x(world) - x;
        double dy = to.y(world) - y;
        double distance = Math.sqrt(dx * dx + dy * dy);
        double length = distance * (1 + (double) slack);
        double[] lengths = lengths(length, from.clearance(world, radius), to.clearance(world, radius), count, radius);
        boolean left = dx * world.gravityY() - dy * world.gravityX() > 0;
        float[] circles = layOut(x, y, dx, dy, lengths, left ? 1 : -1, radius, mass);
        int joints = lengths.length + (limited ? 1 : 0);
        Net rope = JointedCircles.net(circles, kind, joints);
        from.join(world, rope, 0, link(link, lengths[0]));
        Joint between = link(link, lengths[1]);
        for (int k = 1; k < count; k++) {
            rope.join(between.form(), k - 1, k);
        }
        to.join(world, rope, count - 1, link(link, lengths[count]));
        if (limited) {
            Joint limit = Joint.rope((float) length).colliding(true);
            if (from.isCircle()) {
                to.joinEnd(world, rope, from, limit);
            } else {
                from.joinEnd(world, rope, to, limit);
            }
        }
        return JointedCircles.add(world, rope);
    }

    private static Joint link(Joint link, double length) {
        return link == null ? Joint.distance((float) length) : link;
    }

    /** The lengths of all links. Those at the ends reach beyond the circles there. */
    private static double[] lengths(double length, double first, double last, int count, float radius) {
        double even = length / (count + 1);
        boolean longFirst = first > even;
        boolean longLast = last > even;
        double rest = length - (longFirst ? first : 0) - (longLast ? last : 0);
        int equal = count + 1 - (longFirst ? 1 : 0) - (longLast ? 1 : 0);
        double each = equal == 0 ? 0 : rest / equal;
        if (!(rest >= 0) || equal > 0 && !(each >= radius)) {
            throw new IllegalArgumentException("the rope is " + (float) length + " long, which has no room for " + count
                    + " circles of the radius " + radius + ": links must be at least as long as that");
        }
        double[] lengths = new double[count + 1];
        for (int k = 0; k <= count; k++) {
            lengths[k] = k == 0 && longFirst ? first : k == count && longLast ? last : each;
        }
        return lengths;
    }

    /** Puts circles where links of these lengths are chords of one circle, whose own chord goes from end to end. */
    private static float[] layOut(
            double x, double y, double dx, double dy, double[] lengths, int side, float radius, float mass) {
        double distance = Math.sqrt(dx * dx + dy * dy);
        double bend = bend(lengths, distance);
        double whole = halfAngle(lengths, lengths.length, bend);
        float[] circles = new float[4 * (lengths.length - 1)];
        double sum = 0;
        for (int k = 0; k + 1 < lengths.length; k++) {
            sum += lengths[k];
            double angle = halfAngle(lengths, k + 1, bend);
            double chord = bend == 0 ? sum : StrictMath.sin(angle) / bend;
            double turn = side * (whole - angle);
            double along = chord * StrictMath.cos(turn) / distance;
            double across = chord * StrictMath.sin(turn) / distance;
            circles[4 * k] = (float) (x + dx * along - dy * across);
            circles[4 * k + 1] = (float) (y + dy * along + dx * across);
            circles[4 * k + 2] = radius;
            circles[4 * k + 3] = mass;
        }
        return circles;
    }

    /** One over the diameter of the circle on which links are chords, and the distance of the ends is theirs together. */
    private static double bend(double[] lengths, double distance) {
        double longest = 0;
        double sum = 0;
        for (double length : lengths) {
            longest = Math.max(longest, length);
            sum += length;
        }
        double low = 0;
        double high = sum > distance * (1 + 1e-9) ? 1 / longest : 0;
        for (int k = 0; k < HALVINGS; k++) {
            double middle = 0.5 * (low + high);
            double angle = halfAngle(lengths, lengths.length, middle);
            if (angle < Math.PI && StrictMath.sin(angle) > middle * distance) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Half of the angle that the first links take of the circle. */
    private static double halfAngle(double[] lengths, int count, double bend) {
        double sum = 0;
        for (int k = 0; k < count; k++) {
            sum += StrictMath.asin(Math.min(1, lengths[k] * bend));
        }
        return sum;
    }
}
