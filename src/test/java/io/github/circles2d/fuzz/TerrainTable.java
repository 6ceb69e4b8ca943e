package io.github.circles2d.fuzz;

import static io.github.circles2d.fuzz.Drawn.angle;
import static io.github.circles2d.fuzz.Drawn.filled;
import static io.github.circles2d.fuzz.Drawn.floats;
import static io.github.circles2d.fuzz.Drawn.handle;
import static io.github.circles2d.fuzz.Drawn.kind;
import static io.github.circles2d.fuzz.Drawn.length;
import static io.github.circles2d.fuzz.Drawn.one;
import static io.github.circles2d.fuzz.Drawn.real;
import static io.github.circles2d.fuzz.Drawn.speed;
import static io.github.circles2d.fuzz.Drawn.turning;
import static io.github.circles2d.fuzz.Drawn.whole;
import static io.github.circles2d.fuzz.Drawn.x;
import static io.github.circles2d.fuzz.Drawn.y;

import io.github.circles2d.ArcSide;
import io.github.circles2d.Chain;
import io.github.circles2d.Terrain;
import io.github.circles2d.TerrainBody;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/** The calls on terrain and its bodies. */
final class TerrainTable extends Table {
    private static final Function<Draw, Value> TERRAIN = own("world.terrain()", player -> player.world.terrain());

    /** Most pieces of a chain. */
    private static final int PIECES = 8;

    TerrainTable() {
        pieces(TERRAIN, Terrain.class, x(), y());
        pieces(Drawn::body, TerrainBody.class, Drawn.offset(), Drawn.offset());
        changeTerrain();
        moveBodies();
        readTerrain();
    }

    private void pieces(Function<Draw, Value> receiver, Class<?> type, Drawn x, Drawn y) {
        Drawn side = one(ArcSide.class);
        Drawn to = real(draw -> draw.angle() * (draw.oneOf(3) ? 0.3f : 1));
        call(4, receiver, type, "addSegment", x, y, x, y);
        call(6, receiver, type, "addSegment", x, y, x, y, real(d -> d.oneOf(3) ? d.length() / 4 : 0), kind());
        call(3, receiver, type, "addArc", x, y, length(), angle(), to, side);
        call(5, receiver, type, "addArc", x, y, length(), angle(), to, side, kind());
        Drawn chain = new Drawn(Chain.class, TerrainTable::chain);
        Drawn handles = new Drawn(
                long[].class,
                draw -> draw.oneOf(3)
                        ? new Values.Constant(null)
                        : new Values.Filled(long[].class, "" + PIECES, player -> PIECES));
        call(4, receiver, type, "addChain", chain);
        call(8, receiver, type, "addChain", chain, kind(), handles);
        Drawn ends = floats(draw -> {
            float[] segments = new float[4 * draw.below(PIECES)];
            for (int k = 0; k < segments.length; k++) {
                boolean follows = k >= 4 && k % 4 < 2 && !draw.oneOf(3);
                segments[k] = follows ? segments[k - 2] : k % 2 == 0 ? draw.x() : draw.y();
            }
            return segments;
        });
        call(6, receiver, type, "addSegments", ends, kind(), handles);
    }

    /** Lines and arcs; one of some is closed. */
    static Value chain(Draw draw) {
        List<Method> methods = new ArrayList<>();
        List<Value[]> arguments = new ArrayList<>();
        float x = draw.plain(draw.setting.minX, draw.setting.maxX);
        float y = draw.plain(draw.setting.minY, draw.setting.maxY);
        float size = draw.setting.size / (4 + draw.below(20));
        try {
            if (draw.oneOf(4)) {
                float[] corners = {x, y, x + size, y, x + size, y + size, x, y + size};
                methods.add(Chain.class.getMethod("of", float[].class));
                arguments.add(values((Object) corners));
            } else {
                methods.add(Chain.class.getMethod("from", float.class, float.class));
                arguments.add(values(x, y));
                for (int k = 1 + draw.below(PIECES - 2); k > 0; k--) {
                    boolean isArc = draw.oneOf(4);
                    x = isArc ? x : x + draw.between(-size, size);
                    y = isArc ? y : y + draw.between(-size, size);
                    methods.add(
                            isArc
                                    ? Chain.class.getMethod("arcTo", float.class, float.class, float.class)
                                    : Chain.class.getMethod("lineTo", float.class, float.class));
                    arguments.add(
                            isArc ? values(x + size, y - size, draw.between(-6.2831855f, 6.2831855f)) : values(x, y));
                }
            }
            if (draw.oneOf(2)) {
                methods.add(Chain.class.getMethod("close"));
                arguments.add(new Value[0]);
            }
            if (draw.oneOf(4)) {
                methods.add(Chain.class.getMethod("reversed"));
                arguments.add(new Value[0]);
            }
        } catch (NoSuchMethodException e) {
            throw new IllegalStateException(e);
        }
        return new Made(methods, arguments);
    }

    static Value[] values(Object... constants) {
        Value[] values = new Value[constants.length];
        for (int k = 0; k < values.length; k++) {
            values[k] = new Values.Constant(constants[k]);
        }
        return values;
    }

    private void changeTerrain() {
        Drawn piece = handle(Ref.Of.PIECE);
        call(8, TERRAIN, Terrain.class, "remove", piece);
        call(4, TERRAIN, Terrain.class, "setKind", piece, kind());
        call(8, TERRAIN, Terrain.class, "addBody", x(), y(), angle());
        call(1, TERRAIN, Terrain.class, "clear");
    }

    private void moveBodies() {
        call(6, Drawn::body, TerrainBody.class, "setVelocity", speed(), speed());
        call(6, Drawn::body, TerrainBody.class, "setAngularVelocity", turning());
        call(6, Drawn::body, TerrainBody.class, "moveTo", x(), y(), angle());
        call(4, Drawn::body, TerrainBody.class, "teleport", x(), y(), angle());
        call(2, Drawn::body, TerrainBody.class, "remove");
    }

    private void readTerrain() {
        Drawn piece = handle(Ref.Of.PIECE);
        call(1, TERRAIN, Terrain.class, "ground");
        call(1, TERRAIN, Terrain.class, "body", handle(Ref.Of.BODY));
        call(1, TERRAIN, Terrain.class, "bodyOf", piece);
        call(1, TERRAIN, Terrain.class, "contains", piece);
        call(1, TERRAIN, Terrain.class, "kindOf", piece);
        call(1, null, Terrain.class, "id", piece);
        call(1, TERRAIN, Terrain.class, "idLimit");
        call(1, TERRAIN, Terrain.class, "size");
        call(1, TERRAIN, Terrain.class, "handle", whole(draw -> draw.below(5)));
        String size = "world.terrain().size()";
        call(
                4,
                TERRAIN,
                Terrain.class,
                "readPieces",
                filled(
                        float[].class,
                        "PIECE_STRIDE * " + size,
                        p -> Terrain.PIECE_STRIDE * p.world.terrain().size()),
                filled(long[].class, size, player -> player.world.terrain().size()));
        for (String name :
                new String[] {"handle", "exists", "x", "y", "angle", "vx", "vy", "angularVelocity", "toString"}) {
            call(1, Drawn::body, TerrainBody.class, name);
        }
        for (String name : new String[] {"localX", "localY", "worldX", "worldY", "vxAt", "vyAt"}) {
            call(1, Drawn::body, TerrainBody.class, name, x(), y());
        }
    }
}
