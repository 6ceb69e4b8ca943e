package io.github.circles2d.fuzz;

import io.github.circles2d.Joints;
import io.github.circles2d.Terrain;
import io.github.circles2d.World;
import java.util.Arrays;
import java.util.function.IntToLongFunction;
import java.util.stream.Collectors;

/** Handles of what is there, or was, when the call is made: a program names them by numbers, so it stays one if calls are left out. */
final class Ref {
    private static final long[] NONE = {0, -1, 77, Long.MAX_VALUE, Long.MIN_VALUE, 1L << 31, 1L << 32 | 1 << 30};

    /** What a handle is of. */
    enum Of {
        CIRCLE,
        JOINT,
        PIECE,
        BODY,
        /** A body that is pushed. */
        RIGID,
        /** Any thing, which may have gone. */
        STALE
    }

    private Ref() {}

    /** The handle of the circle, joint, piece or body that comes next to a number. */
    record Handle(Of of, int number) implements Value {
        @Override
        public Object find(Player first) {
            return handle(first, of, number);
        }

        @Override
        public String toString() {
            return of.name().toLowerCase(java.util.Locale.ROOT) + "(" + number + ")";
        }
    }

    /** Handles, of which some may be the same. */
    record Handles(Of of, int[] numbers) implements Value {
        @Override
        public Object find(Player first) {
            return Arrays.stream(numbers)
                    .mapToLong(number -> handle(first, number % 31 == 30 ? Of.STALE : of, number))
                    .toArray();
        }

        @Override
        public String toString() {
            return Arrays.stream(numbers)
                    .mapToObj(number -> new Handle(number % 31 == 30 ? Of.STALE : of, number).toString())
                    .collect(Collectors.joining(", ", "{", "}"));
        }
    }

    /** A body as an object. */
    record Body(Value handle) implements Value {
        @Override
        public Object find(Player first) {
            return handle.find(first);
        }

        @Override
        public Object on(Player player, Object found) {
            return player.world.terrain().body((Long) found);
        }

        @Override
        public String toString() {
            return "world.terrain().body(" + handle + ")";
        }
    }

    private static long handle(Player first, Of of, int number) {
        World world = first.world;
        Joints joints = world.joints();
        Terrain terrain = world.terrain();
        long handle =
                switch (of) {
                    case CIRCLE -> next(world.idLimit(), number, world::handle);
                    case JOINT -> next(joints.idLimit(), number, joints::handle);
                    case PIECE -> next(terrain.idLimit(), number, terrain::handle);
                    case BODY ->
                        first.bodies.isEmpty() || number % 4 == 0
                                ? terrain.ground().handle()
                                : first.bodies.get(number % first.bodies.size());
                    case RIGID -> next(world.bodies().idLimit(), number, world.bodies()::handle);
                    case STALE ->
                        number % 5 == 0 || first.seen.isEmpty()
                                ? NONE[number % NONE.length]
                                : first.seen.get(number % first.seen.size());
                };
        if (of != Of.STALE && handle != 0 && first.seen.size() < 1000) {
            first.seen.add(handle);
        }
        return handle;
    }

    /** The handle of the first id from a number on, around the end, that is in use; 0 if none is. */
    private static long next(int limit, int number, IntToLongFunction handles) {
        for (int k = 0; k < limit; k++) {
            long handle = handles.applyAsLong((int) (((long) number + k) % limit));
            if (handle != 0) {
                return handle;
            }
        }
        return 0;
    }
}
