package io.github.circles2d.fuzz;

import static io.github.circles2d.fuzz.Drawn.angle;
import static io.github.circles2d.fuzz.Drawn.filled;
import static io.github.circles2d.fuzz.Drawn.flag;
import static io.github.circles2d.fuzz.Drawn.force;
import static io.github.circles2d.fuzz.Drawn.handle;
import static io.github.circles2d.fuzz.Drawn.length;
import static io.github.circles2d.fuzz.Drawn.offset;
import static io.github.circles2d.fuzz.Drawn.real;
import static io.github.circles2d.fuzz.Drawn.turning;
import static io.github.circles2d.fuzz.Drawn.whole;
import static io.github.circles2d.fuzz.Drawn.x;
import static io.github.circles2d.fuzz.Drawn.y;

import io.github.circles2d.Joint;
import io.github.circles2d.Joints;
import io.github.circles2d.TerrainBody;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;

/** The calls on joints. */
final class JointTable extends Table {
    private static final Function<Draw, Value> JOINTS = own("world.joints()", player -> player.world.joints());

    /** Joints of a call. */
    private static final int MANY = 12;

    JointTable() {
        addJoints();
        Drawn joint = handle(Ref.Of.JOINT);
        add(6, "remove", joint);
        add(2, "removeAll", new Drawn(long[].class, draw -> Drawn.handles(draw, Ref.Of.JOINT, 2)));
        add(1, "clear");
        setJoints(joint);
        readJoints(joint);
    }

    private void add(int weight, String name, Drawn... parameters) {
        call(weight, JOINTS, Joints.class, name, parameters);
    }

    private void addJoints() {
        Drawn circle = handle(Ref.Of.CIRCLE);
        Drawn joint = new Drawn(Joint.class, JointTable::joint);
        Drawn alone = new Drawn(Joint.class, JointTable::alone);
        Drawn circles = new Drawn(long[].class, draw -> Drawn.handles(draw, Ref.Of.CIRCLE, MANY));
        Drawn handles = filled(long[].class, "" + MANY, player -> MANY);
        add(20, "add", circle, circle, joint);
        add(12, "add", circle, x(), y(), joint);
        add(8, "add", circle, new Drawn(TerrainBody.class, Drawn::body), offset(), offset(), joint);
        add(8, "add", circle, alone);
        Drawn body = handle(Ref.Of.RIGID);
        add(8, "add", body, body, joint);
        add(8, "add", body, circle, joint);
        add(8, "add", circle, body, joint);
        add(8, "add", body, alone);
        add(20, "add", body, offset(), offset(), body, offset(), offset(), joint);
        add(12, "add", body, offset(), offset(), circle, joint);
        add(12, "add", body, offset(), offset(), x(), y(), joint);
        add(8, "add", body, offset(), offset(), new Drawn(TerrainBody.class, Drawn::body), offset(), offset(), joint);
        add(20, "addAll", circles, circles, joint, handles);
        add(6, "addAll", circles, alone, handles);
    }

    private void setJoints(Drawn joint) {
        add(3, "setAnchor", joint, x(), y());
        add(3, "setLength", joint, length());
        add(3, "setLimits", joint, real(draw -> draw.length() / 20), length());
        add(3, "setSpring", joint, real(0, 30), real(0, 2));
        add(3, "setSpeed", joint, turning());
        add(3, "setAngle", joint, angle());
        add(3, "setMaxForce", joint, force());
        add(3, "setMaxTorque", joint, force());
        add(3, "setBreaking", joint, force(), force());
        add(3, "setColliding", joint, flag());
    }

    private void readJoints(Drawn joint) {
        for (String name : new String[] {
            "contains",
            "circle",
            "other",
            "joint",
            "anchorX",
            "anchorY",
            "length",
            "forceX",
            "forceY",
            "force",
            "torque"
        }) {
            add(2, name, joint);
        }
        call(1, null, Joints.class, "id", joint);
        add(1, "size");
        add(1, "idLimit");
        add(1, "handle", whole(draw -> draw.below(5)));
        add(2, "ofCircle", handle(Ref.Of.CIRCLE), Drawn.room(long[].class));
        add(2, "ofBody", handle(Ref.Of.RIGID), Drawn.room(long[].class));
        add(2, "pick", x(), y(), real(draw -> draw.oneOf(3) ? Float.POSITIVE_INFINITY : draw.length()));
        add(
                2,
                "readEnds",
                filled(
                        float[].class,
                        "4 * joints",
                        player -> 4 * player.world.joints().size()));
        add(4, "report", new Drawn(boolean.class, draw -> new Values.Constant(!draw.oneOf(4))));
        add(6, "events");
    }

    // ---- what joints do

    /** Any joint, and things that it may have. */
    static Value joint(Draw draw) {
        float hertz = draw.oneOf(8) ? draw.between(0, 10_000) : draw.between(0, 30);
        float damping = draw.oneOf(8) ? draw.between(0, 1000) : draw.between(0, 2);
        float length = draw.length();
        float most = draw.oneOf(5) ? Float.POSITIVE_INFINITY : draw.force();
        List<Method> methods = new ArrayList<>();
        List<Value[]> arguments = new ArrayList<>();
        switch (draw.below(14)) {
            case 0, 1 -> then(methods, arguments, "distance");
            case 2 -> then(methods, arguments, "distance", length);
            case 3, 4 -> then(methods, arguments, "spring", hertz, damping);
            case 5 -> {
                then(methods, arguments, "spring", hertz, damping);
                then(methods, arguments, "withLength", length);
                then(methods, arguments, "withLimits", 0f, 1.1f * length);
            }
            case 6 -> then(methods, arguments, "rope", length);
            case 7 -> then(methods, arguments, "limits", length / 2, length);
            case 8, 9 -> then(methods, arguments, "weld");
            case 10 -> then(methods, arguments, "pin");
            case 11 -> {
                then(methods, arguments, "pin", hertz, damping);
                then(methods, arguments, "withMaxForce", most);
            }
            case 12 -> then(methods, arguments, "mouse", hertz, damping, most);
            default -> alone(draw, methods, arguments, hertz, damping, most);
        }
        return finish(draw, methods, arguments);
    }

    /** A joint of one circle. */
    private static Value alone(Draw draw) {
        List<Method> methods = new ArrayList<>();
        List<Value[]> arguments = new ArrayList<>();
        alone(draw, methods, arguments, draw.between(0, 30), draw.between(0, 2), draw.force());
        return finish(draw, methods, arguments);
    }

    private static void alone(
            Draw draw, List<Method> methods, List<Value[]> arguments, float hertz, float damping, float most) {
        switch (draw.below(3)) {
            case 0 -> then(methods, arguments, "motor", draw.angularVelocity(), most);
            case 1 -> then(methods, arguments, "servo", draw.angle(), hertz, damping, most);
            default -> then(methods, arguments, "friction", most, draw.force());
        }
    }

    private static Value finish(Draw draw, List<Method> methods, List<Value[]> arguments) {
        if (draw.oneOf(5)) {
            then(methods, arguments, "breakingAt", draw.force(), draw.force());
        }
        if (draw.oneOf(5)) {
            then(methods, arguments, "colliding", draw.random.nextBoolean());
        }
        return new Made(methods, arguments);
    }

    private static void then(List<Method> methods, List<Value[]> arguments, String name, Object... values) {
        methods.add(Stream.of(Joint.class.getMethods())
                .filter(method -> method.getName().equals(name)
                        && method.getReturnType() == Joint.class
                        && method.getParameterCount() == values.length)
                .findFirst()
                .orElseThrow());
        arguments.add(TerrainTable.values(values));
    }
}
