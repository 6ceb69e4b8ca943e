package io.github.circles2d.world.snapshots;

import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.SurfaceSettings;
import io.github.circles2d.world.model.WallMotion;
import java.nio.Buffer;
import java.nio.ByteBuffer;

/**
 * The parameters of a world in a snapshot that have no place in its header, and what its circles turn by: a section for each that is not
 * what most worlds have. They come behind those of fields ({@link FieldSections}), whose numbers are lower.
 *
 * <pre>
 * section    int number
 *            1,000: int 4; floats: where walls that the next step moves start: min x, min y, max x, max y
 *            1,001: int 4; floats: contacts that are not as by default: the numbers of {@link ContactSettings}, in order
 *            1,002: kinds, as {@link KindSection} has them
 *            1,003: int 14; floats: surfaces that grip: friction and rolling resistance of circles; friction, rolling resistance and
 *            belt speed of each wall, by {@link WallMotion#of}
 *            1,004, 1,005: what circles turn by, as {@link TurnSections} has it
 *            1,006, 1,007: terrain, and contacts with it, as {@link TerrainSection} has them
 *            1,008: joints, as {@link JointSection} has them
 *            1,009: how circles sleep, as {@link SleepSection} has it
 *            1,020: rigid bodies, as {@link RigidSection} has them
 * </pre>
 */
final class ParameterSections {
    /** The number of the first section; fields have lower ones. */
    static final int FIRST = 1_000;

    private static final int WALL_START = FIRST;
    private static final int CONTACTS = FIRST + 1;
    private static final int KINDS = FIRST + 2;
    private static final int SURFACES = FIRST + 3;
    private static final int TURNS = FIRST + 4;
    private static final int GRIPS = FIRST + 5;
    private static final int TERRAIN = FIRST + 6;
    private static final int TERRAIN_CONTACTS = FIRST + 7;
    private static final int JOINTS = FIRST + 8;
    private static final int SLEEP = FIRST + 9;
    private static final int RIGIDS = FIRST + 20;

    private static final int FLOATS = 4;
    private static final int BYTES = (2 + FLOATS) * Integer.BYTES;
    private static final int SURFACE_BYTES = (2 + SurfaceSettings.VALUES) * Integer.BYTES;

    private ParameterSections() {}

    static int count(SavedState s) {
        return ofFloats(s)
                + (KindSection.isNeeded(s.kinds) ? 1 : 0)
                + (hasSurfaces(s) ? 1 : 0)
                + (TurnSections.circles(s) > 0 ? 1 : 0)
                + (TurnSections.impulses(s) > 0 ? 1 : 0)
                + (s.terrain.isAsAtFirst() ? 0 : 1)
                + (s.pieceContacts.count > 0 ? 1 : 0)
                + (s.joints.isAsAtFirst() ? 0 : 1)
                + (s.parameters().sleeps() ? 1 : 0)
                + (s.rigids.isAsAtFirst() ? 0 : 1);
    }

    private static int ofFloats(SavedState s) {
        return (s.parameters().wallsMove() ? 1 : 0) + (hasContacts(s) ? 1 : 0);
    }

    private static boolean hasContacts(SavedState s) {
        return !s.parameters().contacts().isDefault();
    }

    private static boolean hasSurfaces(SavedState s) {
        return s.parameters().surfaces().any();
    }

    static long bytes(SavedState s) {
        int kinds = KindSection.isNeeded(s.kinds) ? Integer.BYTES + KindSection.bytes(s.kinds) : 0;
        int surfaces = hasSurfaces(s) ? SURFACE_BYTES : 0;
        int ofTurns =
                (TurnSections.circles(s) > 0 ? Integer.BYTES : 0) + (TurnSections.impulses(s) > 0 ? Integer.BYTES : 0);
        long terrain = s.terrain.isAsAtFirst() ? 0 : Integer.BYTES + TerrainSection.bytes(s.terrain);
        long contacts = s.pieceContacts.count > 0 ? Integer.BYTES + TerrainSection.bytes(s.pieceContacts) : 0;
        long joints = s.joints.isAsAtFirst() ? 0 : Integer.BYTES + JointSection.bytes(s);
        long sleep = s.parameters().sleeps() ? Integer.BYTES + SleepSection.bytes(s) : 0;
        long rigids = s.rigids.isAsAtFirst() ? 0 : Integer.BYTES + RigidSection.bytes(s.rigids);
        return ofFloats(s) * BYTES
                + kinds
                + surfaces
                + ofTurns
                + TurnSections.bytes(s)
                + terrain
                + contacts
                + joints
                + sleep
                + rigids;
    }

    static void write(SavedState s, ByteBuffer out) {
        if (s.parameters().wallsMove()) {
            Bounds b = s.parameters().wallStart();
            write(out, WALL_START, b.minX(), b.minY(), b.maxX(), b.maxY());
        }
        if (hasContacts(s)) {
            ContactSettings c = s.parameters().contacts();
            write(out, CONTACTS, c.restitutionThreshold(), c.frequency(), c.damping(), c.pushOutSpeed());
        }
        if (KindSection.isNeeded(s.kinds)) {
            out.putInt(KINDS);
            KindSection.write(s.kinds, out);
        }
        if (hasSurfaces(s)) {
            out.putInt(SURFACES).putInt(SurfaceSettings.VALUES);
            for (int k = 0; k < SurfaceSettings.VALUES; k++) {
                out.putFloat(s.parameters().surfaces().value(k));
            }
        }
        int circles = TurnSections.circles(s);
        if (circles > 0) {
            out.putInt(TURNS);
            TurnSections.writeCircles(s, circles, out);
        }
        int impulses = TurnSections.impulses(s);
        if (impulses > 0) {
            out.putInt(GRIPS);
            TurnSections.writeImpulses(s, impulses, out);
        }
        if (!s.terrain.isAsAtFirst()) {
            out.putInt(TERRAIN);
            TerrainSection.write(s.terrain, out);
        }
        if (s.pieceContacts.count > 0) {
            out.putInt(TERRAIN_CONTACTS);
            TerrainSection.write(s.pieceContacts, out);
        }
        if (!s.joints.isAsAtFirst()) {
            out.putInt(JOINTS);
            JointSection.write(s, out);
        }
        if (s.parameters().sleeps()) {
            out.putInt(SLEEP);
            SleepSection.write(s, out);
        }
        if (!s.rigids.isAsAtFirst()) {
            out.putInt(RIGIDS);
            RigidSection.write(s.rigids, out);
        }
    }

    private static void write(ByteBuffer out, int number, float a, float b, float c, float d) {
        out.putInt(number).putInt(FLOATS).putFloat(a).putFloat(b).putFloat(c).putFloat(d);
    }

    /** Reads a section behind its number, and checks it. */
    static void read(ByteBuffer in, SavedState s, int number) {
        switch (number) {
            case KINDS -> KindSection.read(in, s.kinds);
            case SURFACES -> readSurfaces(in, s);
            case TURNS -> TurnSections.readCircles(in, s);
            case GRIPS -> TurnSections.readImpulses(in, s);
            case TERRAIN -> TerrainSection.readTerrain(in, s);
            case TERRAIN_CONTACTS -> TerrainSection.readContacts(in, s);
            case JOINTS -> JointSection.read(in, s);
            case SLEEP -> SleepSection.read(in, s);
            case RIGIDS -> RigidSection.read(in, s);
            default -> readFloats(in, s, number);
        }
    }

    private static void readSurfaces(ByteBuffer in, SavedState s) {
        SnapshotCodec.require(in.remaining() >= SURFACE_BYTES - Integer.BYTES, "it ends early");
        SnapshotCodec.require(in.getInt() == SurfaceSettings.VALUES, "a section of parameters has not its length");
        if (hasSurfaces(s)) {
            ((Buffer) in).position(in.position() + SurfaceSettings.VALUES * Float.BYTES); // as in readFloats
            return;
        }
        SurfaceSettings surfaces = SurfaceSettings.NONE.ofCircles(in.getFloat(), in.getFloat());
        for (int wall = 0; wall < WallMotion.COUNT; wall++) {
            surfaces = surfaces.withWall(wall, in.getFloat(), in.getFloat(), in.getFloat());
        }
        s.setParameters(s.parameters().with(surfaces));
        SnapshotCodec.require(hasSurfaces(s), "its surfaces do not grip");
    }

    private static void readFloats(ByteBuffer in, SavedState s, int number) {
        if (number > CONTACTS) {
            throw SnapshotCodec.later("it has a section with the unknown number " + number);
        }
        SnapshotCodec.require(in.remaining() >= BYTES - Integer.BYTES, "it ends early");
        SnapshotCodec.require(in.getInt() == FLOATS, "a section of parameters has not its length");
        WorldParameters p = s.parameters();
        if (number == WALL_START && p.wallsMove() || number == CONTACTS && hasContacts(s)) {
            ((Buffer) in)
                    .position(in.position()
                            + FLOATS * Float.BYTES); // they were known before, and new objects would be garbage
        } else if (number == WALL_START) {
            Bounds start = new Bounds(wall(in), wall(in), wall(in), wall(in));
            s.setParameters(
                    p.startingAt(start.with(p.bounds().edgeX(), p.bounds().edgeY())));
            SnapshotCodec.require(s.parameters().wallsMove(), "its walls do not move");
            SnapshotCodec.require(startsAtWalls(s.parameters()), "an edge moves that is no wall");
        } else {
            s.setParameters(p.with(new ContactSettings(in.getFloat(), in.getFloat(), in.getFloat(), in.getFloat())));
            SnapshotCodec.require(hasContacts(s), "its contacts are as by default");
        }
    }

    private static boolean startsAtWalls(WorldParameters p) {
        Bounds b = p.bounds();
        Bounds start = p.wallStart();
        return (b.edgeX() == AxisEdge.WALL || b.minX() == start.minX() && b.maxX() == start.maxX())
                && (b.edgeY() == AxisEdge.WALL || b.minY() == start.minY() && b.maxY() == start.maxY());
    }

    private static float wall(ByteBuffer in) {
        return Limits.within("the start of a wall", in.getFloat(), -Limits.COORDINATE, Limits.COORDINATE);
    }
}
