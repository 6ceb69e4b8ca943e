package io.github.circles2d.fuzz;

import static io.github.circles2d.fuzz.Drawn.angle;
import static io.github.circles2d.fuzz.Drawn.coefficient;
import static io.github.circles2d.fuzz.Drawn.handle;
import static io.github.circles2d.fuzz.Drawn.kind;
import static io.github.circles2d.fuzz.Drawn.mass;
import static io.github.circles2d.fuzz.Drawn.number;
import static io.github.circles2d.fuzz.Drawn.one;
import static io.github.circles2d.fuzz.Drawn.radius;
import static io.github.circles2d.fuzz.Drawn.real;
import static io.github.circles2d.fuzz.Drawn.speed;
import static io.github.circles2d.fuzz.Drawn.turning;
import static io.github.circles2d.fuzz.Drawn.whole;
import static io.github.circles2d.fuzz.Drawn.x;
import static io.github.circles2d.fuzz.Drawn.y;

import io.github.circles2d.StaleHandles;
import io.github.circles2d.World;
import java.util.function.Function;

/** The calls that add, change and remove circles. */
final class CircleTable extends Table {
    private static final int MOST_ADDED = 40;

    CircleTable() {
        addCircles();
        changeOne();
        changeMany();
        call("remove", handle(Ref.Of.CIRCLE));
        add(2, "clear");
    }

    private void call(String name, Drawn... parameters) {
        add(4, name, parameters);
    }

    private void add(int weight, String name, Drawn... parameters) {
        call(weight, own("world", player -> player.world), World.class, name, parameters);
    }

    private void addCircles() {
        add(4, "add", x(), y(), radius(), mass());
        add(4, "add", x(), y(), radius(), mass(), speed(), speed());
        add(12, "add", x(), y(), radius(), mass(), speed(), speed(), kind());
        add(4, "addAll", sized(0), handlesOf());
        add(4, "addAll", sized(0), sized(1), handlesOf());
        add(8, "addAll", sized(0), sized(1), sized(2), handlesOf());
    }

    /** Array k of a crowd whose number of circles is the same for all arrays of a call, mostly. */
    private static Drawn sized(int k) {
        Class<?>[] types = {float[].class, float[].class, int[].class};
        return new Drawn(types[k], draw -> crowd(draw, size(draw))[k]);
    }

    private static int size(Draw draw) {
        int usual = 3 + draw.setting.frames;
        return draw.setting.hostile && draw.oneOf(30) ? draw.below(MOST_ADDED) : usual;
    }

    private static Drawn handlesOf() {
        return new Drawn(long[].class, draw -> {
            int n = size(draw);
            return draw.oneOf(4) ? new Values.Constant(null) : new Values.Filled(long[].class, "" + n, player -> n);
        });
    }

    /** Circles, velocities and kinds. */
    static Value[] crowd(Draw draw, int n) {
        float[] circles = new float[4 * n];
        float[] velocities = new float[2 * n];
        int[] kinds = new int[n];
        boolean isGrid = draw.oneOf(3);
        for (int k = 0; k < n; k++) {
            circles[4 * k] = isGrid ? place(draw.setting.minX, draw.setting.maxX, k % 12) : draw.x();
            circles[4 * k + 1] = isGrid ? place(draw.setting.minY, draw.setting.maxY, k / 12 % 12) : draw.y();
            circles[4 * k + 2] = draw.radius();
            circles[4 * k + 3] = draw.mass();
            velocities[2 * k] = draw.speed();
            velocities[2 * k + 1] = draw.speed();
            kinds[k] = draw.kind();
        }
        return new Value[] {new Values.Constant(circles), new Values.Constant(velocities), new Values.Constant(kinds)};
    }

    private static float place(float low, float high, int k) {
        return low + (k + 0.5f) * (high - low) / 12;
    }

    private void changeOne() {
        Drawn circle = handle(Ref.Of.CIRCLE);
        call("setPosition", circle, x(), y());
        call("teleport", circle, x(), y());
        call("setVelocity", circle, speed(), speed());
        call("setRadius", circle, radius());
        call("grow", circle, radius(), whole(draw -> draw.oneOf(9) ? draw.below(100_000) : draw.count(30)));
        call("setMass", circle, mass());
        call("setRestitution", circle, real(0, 1));
        call("wake", circle);
        call("setTag", circle, number());
        call("setKind", circle, kind());
        call("setGroup", circle, whole(draw -> draw.below(4)));
        call("applyImpulse", circle, real(-1e6f, 1e6f), real(-1e3f, 1e3f));
        call("setForce", circle, real(-1e6f, 1e6f), real(-1e3f, 1e3f));
        call("applyForce", circle, real(-1e6f, 1e6f), real(-1e3f, 1e3f));
        call("setFriction", circle, coefficient());
        call("setRollingResistance", circle, coefficient());
        call("setGravityScale", circle, orNone(draw -> draw.between(-2, 2)));
        call("setDamping", circle, orNone(draw -> draw.between(0, draw.oneOf(3) ? 1e6f : 2)));
        call(
                "setGreatestSpeed",
                circle,
                orNone(draw -> draw.oneOf(3) ? Float.POSITIVE_INFINITY : Math.abs(draw.speed())));
        call("setAngle", circle, angle());
        call("setAngularVelocity", circle, turning());
        call("applyAngularImpulse", circle, real(-1e4f, 1e4f));
        call("setTorque", circle, real(-1e4f, 1e4f));
        call("applyTorque", circle, real(-1e4f, 1e4f));
    }

    private static Drawn orNone(Function<Draw, Float> value) {
        return real(draw -> draw.oneOf(3) ? Float.NaN : value.apply(draw));
    }

    private void changeMany() {
        many("setPositions", float[].class, draw -> draw.oneOf(2) ? draw.x() : draw.y());
        many("setVelocities", float[].class, Draw::speed);
        many("applyImpulses", float[].class, Draw::speed);
        many("setForces", float[].class, Draw::speed);
        many("setAngularVelocities", float[].class, Draw::angularVelocity);
        many("setKinds", int[].class, null);
        add(3, "removeAll", handlesUpTo(5), whole(draw -> 5), one(StaleHandles.class));
    }

    /** A call with five handles, and two values each where one would do; rarely it says that there are others. */
    private void many(String name, Class<?> type, Function<Draw, Float> value) {
        Drawn values = new Drawn(type, draw -> {
            float[] floats = new float[10];
            int[] kinds = new int[10];
            for (int k = 0; k < 10; k++) {
                floats[k] = value == null ? 0 : value.apply(draw);
                kinds[k] = draw.kind();
            }
            return new Values.Constant(value == null ? kinds : floats);
        });
        Drawn count = whole(draw -> draw.setting.hostile && draw.oneOf(12) ? draw.below(30) - 10 : draw.below(6));
        call(name, handlesUpTo(5), count, values, one(StaleHandles.class));
    }

    private static Drawn handlesUpTo(int n) {
        return new Drawn(long[].class, draw -> Drawn.handles(draw, Ref.Of.CIRCLE, n));
    }
}
