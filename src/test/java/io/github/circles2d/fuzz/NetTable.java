package io.github.circles2d.fuzz;

import static io.github.circles2d.fuzz.Drawn.kind;
import static io.github.circles2d.fuzz.Drawn.length;
import static io.github.circles2d.fuzz.Drawn.real;
import static io.github.circles2d.fuzz.Drawn.whole;
import static io.github.circles2d.fuzz.Drawn.x;
import static io.github.circles2d.fuzz.Drawn.y;

import io.github.circles2d.Blobs;
import io.github.circles2d.Joint;
import io.github.circles2d.Ropes;
import io.github.circles2d.World;
import java.lang.reflect.Method;
import java.util.List;
import java.util.stream.Stream;

/** Ropes, bridges and blobs. */
final class NetTable extends Table {
    private static final Drawn WORLD = new Drawn(World.class, draw -> new Values.Own("world", player -> player.world));

    NetTable() {
        Drawn end = new Drawn(Ropes.End.class, NetTable::end);
        Drawn count = whole(draw -> draw.count(14));
        Drawn radius = real(draw -> draw.setting.size / 2000);
        Drawn mass = real(draw -> draw.oneOf(20) ? draw.mass() : draw.between(0.1f, 5));
        Drawn slack = real(0, 1);
        Drawn link = new Drawn(Joint.class, JointTable::joint);
        add(Ropes.class, "rope", WORLD, end, end, count, radius, mass, slack);
        add(Ropes.class, "rope", WORLD, end, end, count, radius, mass, slack, kind());
        add(Ropes.class, "rope", WORLD, end, end, count, radius, mass, slack, link);
        add(Ropes.class, "rope", WORLD, end, end, count, radius, mass, slack, link, kind());
        add(Ropes.class, "bridge", WORLD, end, end, count, radius, mass, slack);
        add(Ropes.class, "bridge", WORLD, end, end, count, radius, mass, slack, kind());

        Drawn hertz = real(0, 20);
        Drawn damping = real(0, 2);
        Drawn around = whole(draw -> 2 + draw.count(20));
        Drawn some = whole(draw -> 1 + draw.count(6));
        Drawn spacing = real(draw -> draw.between(draw.setting.size / 1000, draw.setting.size / 100));
        add(Blobs.class, "ring", WORLD, x(), y(), length(), around, radius, mass, hertz, damping);
        add(Blobs.class, "ring", WORLD, x(), y(), length(), around, radius, mass, hertz, damping, kind());
        for (String name : new String[] {"lattice", "cloth"}) {
            add(Blobs.class, name, WORLD, x(), y(), some, some, spacing, radius, mass, hertz, damping);
            add(Blobs.class, name, WORLD, x(), y(), some, some, spacing, radius, mass, hertz, damping, kind());
        }
    }

    private void add(Class<?> of, String name, Drawn... parameters) {
        call(2, null, of, name, parameters);
    }

    private static Value end(Draw draw) {
        return switch (draw.below(3)) {
            case 0 -> made("circle", Drawn.handle(draw, Ref.Of.CIRCLE));
            case 1 -> made("at", constant(draw.x()), constant(draw.y()));
            default -> made("on", Drawn.body(draw), constant(draw.x()), constant(draw.y()));
        };
    }

    private static Value constant(float value) {
        return new Values.Constant(value);
    }

    private static Value made(String name, Value... arguments) {
        Method method = Stream.of(Ropes.class.getMethods())
                .filter(each -> each.getName().equals(name) && each.getReturnType() == Ropes.End.class)
                .findFirst()
                .orElseThrow();
        return new Made(List.of(method), List.<Value[]>of(arguments));
    }
}
