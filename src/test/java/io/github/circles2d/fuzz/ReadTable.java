package io.github.circles2d.fuzz;

import static io.github.circles2d.fuzz.Drawn.byCircle;
import static io.github.circles2d.fuzz.Drawn.byId;
import static io.github.circles2d.fuzz.Drawn.handle;
import static io.github.circles2d.fuzz.Drawn.living;
import static io.github.circles2d.fuzz.Drawn.optional;
import static io.github.circles2d.fuzz.Drawn.room;
import static io.github.circles2d.fuzz.Drawn.whole;
import static io.github.circles2d.fuzz.Drawn.x;
import static io.github.circles2d.fuzz.Drawn.y;

import io.github.circles2d.World;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;

/** The calls that read circles. */
final class ReadTable extends Table {
    ReadTable() {
        for (String name : new String[] {
            "x",
            "y",
            "radius",
            "mass",
            "vx",
            "vy",
            "angle",
            "angularVelocity",
            "restitution",
            "growthSteps",
            "forceX",
            "forceY",
            "torque",
            "friction",
            "rollingResistance",
            "gravityScale",
            "damping",
            "greatestSpeed",
            "tag",
            "kindOf",
            "group",
            "contains",
            "isAwake"
        }) {
            add(1, name, handle(Ref.Of.CIRCLE));
        }
        call(1, null, World.class, "id", handle(Ref.Of.CIRCLE));
        add(1, "handle", whole(draw -> draw.below(20) - (draw.setting.hostile ? 1 : 0)));
        add(1, "shortestX", x(), x());
        add(1, "shortestY", y(), y());
        add(1, "idLimit");
        add(1, "size");
        add(1, "hash");
        readAll();
        request();
    }

    private void add(int weight, String name, Drawn... parameters) {
        call(weight, own("world", player -> player.world), World.class, name, parameters);
    }

    private void readAll() {
        add(2, "read", byCircle(float[].class, 4));
        add(1, "read", byCircle(FloatBuffer.class, 4));
        add(2, "readVelocities", byCircle(float[].class, 2));
        add(1, "readVelocities", byCircle(FloatBuffer.class, 2));
        add(1, "readHandles", byCircle(long[].class, 1));
        add(1, "readHandles", byCircle(LongBuffer.class, 1));
        add(2, "readById", byId(float[].class, 4), living());
        add(2, "readVelocitiesById", byId(float[].class, 2), living());
        add(2, "readAnglesById", byId(float[].class, 1), living());
        add(2, "readAngularVelocitiesById", byId(float[].class, 1), living());
        add(2, "readRadiiById", byId(float[].class, 1), living());
        add(2, "readKindsById", byId(int[].class, 1), living());
        add(2, "readTagsById", byId(long[].class, 1), living());
        add(2, "readAwakeById", byId(long[].class, 1));
        add(3, "readLoadsById", byId(float[].class, 2), living());
        add(3, "contactsOf", handle(Ref.Of.CIRCLE), room(long[].class), optional(float[].class, "40", player -> 40));
        add(2, "positionsById", living());
        add(2, "positions");
        add(2, "angles");
    }

    private void request() {
        add(6, "requestPositions");
        add(4, "takePositions");
        add(4, "takePositionsById", living());
    }
}
