package io.github.circles2d.fuzz;

import static io.github.circles2d.fuzz.Drawn.floats;
import static io.github.circles2d.fuzz.Drawn.handle;
import static io.github.circles2d.fuzz.Drawn.length;
import static io.github.circles2d.fuzz.Drawn.offset;
import static io.github.circles2d.fuzz.Drawn.optional;
import static io.github.circles2d.fuzz.Drawn.real;
import static io.github.circles2d.fuzz.Drawn.room;
import static io.github.circles2d.fuzz.Drawn.whole;
import static io.github.circles2d.fuzz.Drawn.x;
import static io.github.circles2d.fuzz.Drawn.y;

import io.github.circles2d.BodyQueries;
import io.github.circles2d.Queries;
import io.github.circles2d.TerrainQueries;
import java.util.function.Function;

/** The queries of circles, of terrain and of bodies, alone and many at once. */
final class QueryTable extends Table {
    /** Shapes of a call. */
    private static final int SHAPES = 6;

    private static final int MOST = 3;

    private Class<?> type;
    private Function<Draw, Value> receiver;

    QueryTable() {
        type = Queries.class;
        receiver = own("queries", player -> player.queries);
        query("terrain");
        query("bodies");
        query("without", handle(Ref.Of.CIRCLE));
        query("pick", x(), y());
        query("pick", shapes(2), count(), filled(long[].class, SHAPES));
        all();
        type = TerrainQueries.class;
        receiver = own("terrainQueries", player -> player.terrainQueries);
        query("pick", x(), y(), within());
        query("pick", shapes(2), count(), within(), filled(long[].class, SHAPES));
        all();
        type = BodyQueries.class;
        receiver = own("bodyQueries", player -> player.bodyQueries);
        query("without", handle(Ref.Of.RIGID));
        query("pick", x(), y());
        query("pick", shapes(2), count(), filled(long[].class, SHAPES));
        all();
    }

    private void all() {
        query("withMask", whole(draw -> draw.bits(6)));
        query("overlapCircle", x(), y(), length(), room(long[].class));
        query("overlapBox", x(), y(), beyond(s -> s.maxX), beyond(s -> s.maxY), room(long[].class));
        query("nearest", x(), y(), within(), whole(draw -> draw.count(MOST)), filled(long[].class, MOST), hits(MOST));
        query("rayCast", x(), y(), offset(), offset(), hits(1));
        query("rayCastAll", x(), y(), offset(), offset(), room(long[].class), hits(20));
        query("circleCast", x(), y(), length(), offset(), offset(), hits(1));
        query("circleCastAll", x(), y(), length(), offset(), offset(), room(long[].class), hits(20));
        Drawn ends = filled(int[].class, SHAPES);
        query("overlapCircle", shapes(3), count(), ends, room(long[].class));
        query("overlapBox", boxes(), count(), ends, room(long[].class));
        Drawn found = filled(long[].class, SHAPES);
        query(
                "nearest",
                shapes(2),
                count(),
                within(),
                whole(draw -> MOST),
                filled(long[].class, MOST * SHAPES),
                hits(MOST * SHAPES));
        query("rayCast", shapes(4), count(), found, hits(SHAPES));
        query("rayCastAll", shapes(4), count(), ends, room(long[].class), hits(20));
        query("circleCast", shapes(5), count(), found, hits(SHAPES));
        query("circleCastAll", shapes(5), count(), ends, room(long[].class), hits(20));
    }

    private void query(String name, Drawn... parameters) {
        call(2, receiver, type, name, parameters);
    }

    private static Drawn within() {
        return real(draw -> draw.oneOf(4) ? Float.POSITIVE_INFINITY : draw.length());
    }

    private static Drawn beyond(Function<Setting, Float> greatest) {
        return real(draw -> draw.between(greatest.apply(draw.setting), 1.2f * greatest.apply(draw.setting)));
    }

    private static Drawn count() {
        return whole(draw -> draw.setting.hostile && draw.oneOf(20) ? draw.below(12) - 3 : draw.below(SHAPES + 1));
    }

    private static Drawn filled(Class<?> of, int n) {
        return Drawn.filled(of, "" + n, player -> n);
    }

    private static Drawn hits(int n) {
        return optional(float[].class, "5 * " + n, player -> Queries.HIT_STRIDE * n);
    }

    /** A place each, with lengths: points of two numbers, circles of three, rays of four, and casts of circles of five. */
    private static Drawn shapes(int each) {
        return floats(draw -> {
            float[] shapes = new float[each * SHAPES];
            for (int k = 0; k < shapes.length; k++) {
                shapes[k] = switch (k % each) {
                    case 0 -> draw.x();
                    case 1 -> draw.y();
                    case 2 -> each == 4 ? draw.offset() : draw.length();
                    default -> draw.offset();
                };
            }
            return shapes;
        });
    }

    private static Drawn boxes() {
        return floats(draw -> {
            float[] boxes = new float[4 * SHAPES];
            for (int k = 0; k < SHAPES; k++) {
                boxes[4 * k] = draw.x();
                boxes[4 * k + 1] = draw.y();
                boxes[4 * k + 2] = boxes[4 * k] + draw.length();
                boxes[4 * k + 3] = boxes[4 * k + 1] + draw.length();
            }
            return boxes;
        });
    }
}
