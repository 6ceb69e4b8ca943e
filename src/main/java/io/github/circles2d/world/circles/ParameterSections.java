package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Limits;
import java.nio.ByteBuffer;

/**
 * The parameters of a world in a snapshot that have no place in its header: a section for each that is not what most worlds have. They
 * come behind those of fields ({@link FieldSections}), whose numbers are lower.
 *
 * <pre>
 * section    int number, number of floats; the floats
 *            1,000: where walls that the next step moves start: min x, min y, max x, max y
 * </pre>
 */
final class ParameterSections {
    /** The number of the first section; fields have lower ones. */
    static final int FIRST = 1_000;

    private static final int WALL_START = FIRST;
    private static final int HEAD = 2 * Integer.BYTES;

    private ParameterSections() {}

    /** The number of sections of a state. */
    static int count(SavedState s) {
        return s.parameters().wallsMove() ? 1 : 0;
    }

    /** The length of all sections. */
    static int bytes(SavedState s) {
        return s.parameters().wallsMove() ? HEAD + 4 * Float.BYTES : 0;
    }

    static void write(SavedState s, ByteBuffer out) {
        WorldParameters p = s.parameters();
        if (p.wallsMove()) {
            Bounds b = p.wallStart();
            out.putInt(WALL_START).putInt(4);
            out.putFloat(b.minX()).putFloat(b.minY()).putFloat(b.maxX()).putFloat(b.maxY());
        }
    }

    /** Reads a section behind its number, and checks it. */
    static void read(ByteBuffer in, SavedState s, int number) {
        SnapshotCodec.require(in.remaining() >= Integer.BYTES, "it ends early");
        int count = in.getInt();
        SnapshotCodec.require(number == WALL_START, "no section has the number " + number);
        SnapshotCodec.require(count == 4 && in.remaining() >= 4 * Float.BYTES, "it ends within a section");
        Bounds start = new Bounds(wall(in), wall(in), wall(in), wall(in));
        s.setParameters(s.parameters().startingAt(start));
        SnapshotCodec.require(s.parameters().wallsMove(), "its walls do not move");
    }

    private static float wall(ByteBuffer in) {
        return Limits.within("the start of a wall", in.getFloat(), -Limits.COORDINATE, Limits.COORDINATE);
    }
}
