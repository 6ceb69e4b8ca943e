package io.github.circles2d.fuzz;

import static io.github.circles2d.fuzz.Drawn.coefficient;
import static io.github.circles2d.fuzz.Drawn.flag;
import static io.github.circles2d.fuzz.Drawn.kind;
import static io.github.circles2d.fuzz.Drawn.length;
import static io.github.circles2d.fuzz.Drawn.one;
import static io.github.circles2d.fuzz.Drawn.real;
import static io.github.circles2d.fuzz.Drawn.room;
import static io.github.circles2d.fuzz.Drawn.whole;
import static io.github.circles2d.fuzz.Drawn.x;
import static io.github.circles2d.fuzz.Drawn.y;

import io.github.circles2d.Inertia;
import io.github.circles2d.Kind;
import io.github.circles2d.Response;
import io.github.circles2d.Wall;
import io.github.circles2d.World;
import java.nio.ByteBuffer;
import java.util.function.Function;

/** The calls on the world as a whole and on kinds: steps, states, explosions, settings and reports. */
final class WorldTable extends Table {
    WorldTable() {
        makeSteps();
        add(10, "snapshot", new Drawn(ByteBuffer.class, draw -> new Values.NewSnapshot()));
        add(14, "restore", new Drawn(ByteBuffer.class, WorldTable::saved));
        add(1, "snapshotBytes");
        set();
        explode();
        report();
        setKinds();
        readSettings();
    }

    private void add(int weight, String name, Drawn... parameters) {
        call(weight, own("world", player -> player.world), World.class, name, parameters);
    }

    private void makeSteps() {
        Drawn length = real(Draw::timeStep);
        add(90, "step", length);
        add(25, "step", length, whole(draw -> draw.count(4)));
        add(1, "finish");
    }

    private static Value saved(Draw draw) {
        return new Values.Snapshot(draw.below(100), draw.oneOf(8) ? draw.below(1 << 20) : -1);
    }

    private void set() {
        Drawn gravity = real(draw -> draw.between(-draw.setting.size, draw.setting.size));
        add(4, "setGravity", gravity, gravity);
        add(5, "setBounds", bound(s -> s.minX), bound(s -> s.minY), bound(s -> s.maxX), bound(s -> s.maxY));
        add(1, "wakeAll");
        add(3, "setWallSurface", one(Wall.class), real(0, 2), real(0, 0.3f), real(-10, 10));
        add(4, "setResponse", kind(), kind(), one(Response.class));
    }

    /** A bound of now, or near it. */
    private static Drawn bound(Function<Setting, Float> of) {
        return real(draw -> of.apply(draw.setting) + (draw.oneOf(2) ? 0 : draw.offset() / 3));
    }

    private void explode() {
        Drawn impulse = real(-100, 100);
        Drawn mask = whole(draw -> draw.bits(6));
        for (String name : new String[] {"explode", "explodeInSight"}) {
            add(3, name, x(), y(), length(), impulse, length());
            add(3, name, x(), y(), length(), impulse, length(), mask);
        }
    }

    private void report() {
        add(6, "report", whole(draw -> draw.bits(4)));
        add(6, "report", kind(), kind(), whole(draw -> draw.bits(3)));
        add(4, "reportWalls", kind(), whole(draw -> draw.bits(3)));
        add(2, "setHitSpeed", real(draw -> draw.oneOf(3) ? Math.abs(draw.speed()) : 0));
        add(4, "touching", kind(), kind(), room(long[].class));
        add(4, "touchingPieces", kind(), kind(), room(long[].class));
        add(6, "events");
        add(6, "requestEvents");
        add(6, "takeEvents");
    }

    private void setKinds() {
        Drawn real = real(draw -> draw.oneOf(3) ? Float.NaN : draw.between(0, 1));
        ofKind("setCategory", whole(draw -> draw.oneOf(3) ? draw.bits(8) : 1 << draw.below(6)));
        ofKind("setMask", whole(draw -> draw.oneOf(3) ? draw.bits(8) : -1));
        ofKind("setSensor", new Drawn(boolean.class, draw -> new Values.Constant(draw.oneOf(4))));
        ofKind("setSensesStatic", flag());
        ofKind("setRestitution", real);
        ofKind("setGravityScale", real(-2, 2));
        ofKind("setDamping", real(draw -> draw.oneOf(3) ? draw.between(0, 1e6f) : draw.between(0, 2)));
        ofKind("setGreatestSpeed", real(draw -> draw.oneOf(3) ? Float.POSITIVE_INFINITY : Math.abs(draw.speed())));
        ofKind("setFriction", coefficient());
        ofKind("setRollingResistance", coefficient());
        ofKind("setBeltSpeed", real(draw -> draw.oneOf(5) ? draw.speed() : draw.between(-5, 5)));
        ofKind("setInertia", one(Inertia.class));
        ofKind("setAngularDamping", real(0, 2));
        ofKind("setOneWay", flag());
        ofKind("setSleeps", flag());
        ofKind("copyFrom", new Drawn(Kind.class, WorldTable::kindOf));
        for (String name : new String[] {
            "number",
            "category",
            "mask",
            "isSensor",
            "sensesStatic",
            "restitution",
            "gravityScale",
            "damping",
            "greatestSpeed",
            "friction",
            "rollingResistance",
            "beltSpeed",
            "inertia",
            "angularDamping",
            "isOneWay",
            "sleeps",
            "toString"
        }) {
            ofKind(name);
        }
        add(1, "kind", kind());
        add(1, "response", kind(), kind());
    }

    private void ofKind(String name, Drawn... parameters) {
        call(parameters.length == 0 ? 1 : 2, WorldTable::kindOf, Kind.class, name, parameters);
    }

    private static Value kindOf(Draw draw) {
        int number = draw.below(6);
        return new Values.Own("world.kind(" + number + ")", player -> player.world.kind(number));
    }

    private void readSettings() {
        for (String name : new String[] {
            "gravityX",
            "gravityY",
            "minX",
            "minY",
            "maxX",
            "maxY",
            "edgeX",
            "edgeY",
            "defaultRestitution",
            "defaultFriction",
            "defaultRollingResistance",
            "subSteps",
            "sleeps",
            "restitutionThreshold",
            "contactFrequency",
            "contactDamping",
            "greatestPushOutSpeed",
            "terrain",
            "joints",
            "bodies",
            "queries",
            "stats"
        }) {
            add(1, name);
        }
        for (String name : new String[] {"wallFriction", "wallRollingResistance", "wallBeltSpeed"}) {
            add(1, name, one(Wall.class));
        }
    }
}
