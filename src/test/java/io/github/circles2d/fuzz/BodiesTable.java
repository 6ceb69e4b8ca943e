package io.github.circles2d.fuzz;

import static io.github.circles2d.fuzz.Drawn.angle;
import static io.github.circles2d.fuzz.Drawn.filled;
import static io.github.circles2d.fuzz.Drawn.force;
import static io.github.circles2d.fuzz.Drawn.handle;
import static io.github.circles2d.fuzz.Drawn.kind;
import static io.github.circles2d.fuzz.Drawn.number;
import static io.github.circles2d.fuzz.Drawn.one;
import static io.github.circles2d.fuzz.Drawn.optional;
import static io.github.circles2d.fuzz.Drawn.real;
import static io.github.circles2d.fuzz.Drawn.room;
import static io.github.circles2d.fuzz.Drawn.speed;
import static io.github.circles2d.fuzz.Drawn.turning;
import static io.github.circles2d.fuzz.Drawn.whole;
import static io.github.circles2d.fuzz.Drawn.x;
import static io.github.circles2d.fuzz.Drawn.y;

import io.github.circles2d.Bodies;
import io.github.circles2d.Chain;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Outline;
import io.github.circles2d.StaleHandles;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;

/** The calls on bodies that are pushed. */
final class BodiesTable extends Table {
    private static final Function<Draw, Value> BODIES = own("world.bodies()", player -> player.world.bodies());

    /** Bodies of a call about many. */
    private static final int CROWD = 4;

    BodiesTable() {
        Drawn outline = new Drawn(Outline.class, BodiesTable::outline);
        Drawn mass = real(draw -> draw.oneOf(20) ? draw.mass() : draw.between(0.1f, 10));
        add(40, "add", outline, x(), y(), angle(), mass);
        add(30, "add", outline, x(), y(), angle(), mass, kind());
        Drawn body = handle(Ref.Of.RIGID);
        add(8, "addAll", outline, crowd(), kinds(), handlesOf());
        add(8, "addAll", new Drawn(Outline[].class, BodiesTable::outlines), crowd(), kinds(), handlesOf());
        add(8, "remove", body);
        add(3, "removeAll", handles(), whole(draw -> CROWD), one(StaleHandles.class));
        add(1, "clear");
        change(body);
        changeMany();
        read(body);
    }

    /** Mostly as many in all arrays of a call. */
    private static int size(Draw draw) {
        return draw.setting.hostile && draw.oneOf(30) ? draw.below(9) : CROWD;
    }

    private static Drawn crowd() {
        return Drawn.floats(draw -> {
            float[] bodies = new float[4 * size(draw)];
            for (int k = 0; k < bodies.length; k += 4) {
                bodies[k] = draw.x();
                bodies[k + 1] = draw.y();
                bodies[k + 2] = draw.between(-4, 4);
                bodies[k + 3] = draw.oneOf(20) ? draw.mass() : draw.between(0.1f, 10);
            }
            return bodies;
        });
    }

    private static Drawn kinds() {
        return new Drawn(int[].class, draw -> {
            int[] kinds = new int[size(draw)];
            for (int k = 0; k < kinds.length; k++) {
                kinds[k] = draw.kind();
            }
            return new Values.Constant(draw.oneOf(2) ? null : kinds);
        });
    }

    private static Drawn handlesOf() {
        return new Drawn(long[].class, draw -> {
            int n = size(draw);
            return draw.oneOf(4) ? new Values.Constant(null) : new Values.Filled(long[].class, "" + n, player -> n);
        });
    }

    private static Value outlines(Draw draw) {
        Value[] outlines = new Value[size(draw)];
        for (int k = 0; k < outlines.length; k++) {
            outlines[k] = outline(draw);
        }
        return new Values.Several(Outline.class, outlines);
    }

    private static Drawn handles() {
        return new Drawn(long[].class, draw -> Drawn.handles(draw, Ref.Of.RIGID, CROWD));
    }

    private void changeMany() {
        many("teleportAll", 3, (draw, k) -> k == 0 ? draw.x() : k == 1 ? draw.y() : draw.between(-4, 4));
        many("setVelocities", 3, (draw, k) -> k == 2 ? draw.angularVelocity() : draw.speed());
        many("applyImpulses", 2, (draw, k) -> draw.between(-1e3f, 1e3f));
        many("setForces", 3, (draw, k) -> draw.between(-1e3f, 1e3f));
        add(
                3,
                "setKinds",
                handles(),
                count(),
                new Drawn(int[].class, draw -> {
                    int[] kinds = new int[CROWD];
                    for (int k = 0; k < CROWD; k++) {
                        kinds[k] = draw.kind();
                    }
                    return new Values.Constant(kinds);
                }),
                one(StaleHandles.class));
    }

    private static Drawn count() {
        return whole(draw -> draw.setting.hostile && draw.oneOf(12) ? draw.below(30) - 10 : draw.below(CROWD + 1));
    }

    /** A value of each body. */
    private interface Column {
        float value(Draw draw, int column);
    }

    private void many(String name, int each, Column column) {
        Drawn values = Drawn.floats(draw -> {
            float[] floats = new float[each * CROWD];
            for (int k = 0; k < floats.length; k++) {
                floats[k] = column.value(draw, k % each);
            }
            return floats;
        });
        add(3, name, handles(), count(), values, one(StaleHandles.class));
    }

    private void add(int weight, String name, Drawn... parameters) {
        call(weight, BODIES, Bodies.class, name, parameters);
    }

    private void change(Drawn body) {
        add(3, "setVelocity", body, speed(), speed());
        add(3, "setAngularVelocity", body, turning());
        add(3, "applyImpulse", body, force(), force());
        add(5, "applyImpulse", body, force(), force(), x(), y());
        add(3, "applyAngularImpulse", body, force());
        add(4, "applyForce", body, force(), force());
        add(3, "applyForce", body, force(), force(), x(), y());
        add(4, "applyTorque", body, force());
        add(3, "setForce", body, force(), force());
        add(3, "setTorque", body, force());
        add(4, "teleport", body, x(), y(), angle());
        add(2, "setKind", body, kind());
        add(3, "setGroup", body, whole(draw -> draw.below(4)));
        add(2, "wake", body);
        add(2, "setTag", body, number());
        add(2, "setRestitution", body, real(0, 1));
        add(2, "setInertia", body, real(draw -> draw.oneOf(3) ? Float.POSITIVE_INFINITY : draw.between(0, 1e6f)));
    }

    private void read(Drawn body) {
        for (String name : new String[] {
            "contains",
            "outline",
            "mass",
            "inertia",
            "restitution",
            "kindOf",
            "group",
            "forceX",
            "forceY",
            "torque",
            "tag",
            "x",
            "y",
            "angle",
            "vx",
            "vy",
            "angularVelocity",
            "isAwake"
        }) {
            add(1, name, body);
        }
        call(1, null, Bodies.class, "id", body);
        add(1, "size");
        add(1, "awake");
        add(1, "idLimit");
        add(1, "handle", whole(draw -> draw.below(5)));
        add(6, "report", new Drawn(boolean.class, draw -> new Values.Constant(!draw.oneOf(4))));
        add(4, "events");
        add(3, "touching", body, room(long[].class));
        Drawn poses = filled(
                float[].class,
                "3 * world.bodies().idLimit()",
                player -> 3 * player.world.bodies().idLimit());
        Drawn living = optional(
                long[].class,
                "words(world.bodies().idLimit())",
                player -> player.world.bodies().idLimit() / 64 + 1);
        add(3, "readById", poses, living);
        add(3, "readVelocitiesById", poses, living);
        add(2, "readHandles", filled(long[].class, "world.bodies().size()", player -> player.world
                .bodies()
                .size()));
        call(4, own("fixedStep", player -> player.fixedStep), FixedStep.class, "bodies", poses, living);
    }

    /** One of few of a world, mostly. */
    private static Value outline(Draw draw) {
        float size = draw.setting.size / (4 + draw.below(20));
        List<Method> methods = new ArrayList<>();
        List<Value[]> arguments = new ArrayList<>();
        switch (draw.below(6)) {
            case 0, 1 -> then(methods, arguments, "box", size, size / 2);
            case 2 -> then(methods, arguments, "box", draw.length(), draw.length());
            case 3 -> then(methods, arguments, "capsule", size, size / 4);
            case 4 -> then(methods, arguments, "polygon", (Object) new float[] {0, 0, size, 0, size / 2, size});
            default -> {
                float[] corner = {0, 0, size, 0, size, size / 3, size / 3, size / 3, size / 3, size, 0, size};
                then(methods, arguments, "polygon", (Object) corner);
            }
        }
        if (draw.oneOf(5)) {
            then(methods, arguments, "round", draw.between(0, size / 10));
        }
        if (draw.oneOf(6)) {
            methods.clear();
            arguments.clear();
            methods.add(method("of"));
            arguments.add(new Value[] {TerrainTable.chain(draw)});
        }
        return new Made(methods, arguments);
    }

    private static void then(List<Method> methods, List<Value[]> arguments, String name, Object... values) {
        methods.add(method(name));
        arguments.add(TerrainTable.values(values));
    }

    private static Method method(String name) {
        return Stream.of(Outline.class.getMethods())
                .filter(method -> method.getName().equals(name)
                        && (!name.equals("of") || method.getParameterTypes()[0] == Chain.class))
                .findFirst()
                .orElseThrow();
    }
}
