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
import java.util.function.BiConsumer;
import java.util.function.Predicate;

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

    private static final int FLOATS = 4;

    /** The sections, in the order of their numbers. */
    private enum Section {
        WALL_START(
                FIRST,
                s -> s.parameters().wallsMove(),
                ParameterSections::writeWallStart,
                ParameterSections::readWallStart),
        CONTACTS(
                FIRST + 1,
                ParameterSections::hasContacts,
                ParameterSections::writeContacts,
                ParameterSections::readContacts),
        KINDS(
                FIRST + 2,
                s -> KindSection.isNeeded(s.kinds),
                (s, out) -> KindSection.write(s.kinds, out),
                (in, s) -> KindSection.read(in, s.kinds)),
        SURFACES(
                FIRST + 3,
                ParameterSections::hasSurfaces,
                ParameterSections::writeSurfaces,
                ParameterSections::readSurfaces),
        TURNS(FIRST + 4, s -> TurnSections.circles(s) > 0, TurnSections::writeCircles, TurnSections::readCircles),
        ROWS(FIRST + 5, s -> TurnSections.impulses(s) > 0, TurnSections::writeImpulses, TurnSections::readImpulses),
        TERRAIN(
                FIRST + 6,
                s -> !s.terrain.isAsAtFirst(),
                (s, out) -> TerrainSection.write(s.terrain, out),
                TerrainSection::readTerrain),
        TERRAIN_CONTACTS(
                FIRST + 7,
                s -> s.pieceContacts.count > 0,
                (s, out) -> TerrainSection.write(s.pieceContacts, out),
                TerrainSection::readContacts),
        JOINTS(FIRST + 8, s -> !s.joints.isAsAtFirst(), JointSection::write, JointSection::read),
        SLEEP(FIRST + 9, s -> s.parameters().sleeps(), SleepSection::write, SleepSection::read),
        RIGIDS(
                FIRST + 20,
                s -> !s.rigids.isAsAtFirst(),
                (s, out) -> RigidSection.write(s.rigids, out),
                RigidSection::read);

        /** An array: an iterator would be garbage of each snapshot. */
        static final Section[] ALL = values();

        final int number;
        final Predicate<SavedState> isNeeded;
        final BiConsumer<SavedState, ByteBuffer> writer;
        final BiConsumer<ByteBuffer, SavedState> reader;

        Section(
                int number,
                Predicate<SavedState> isNeeded,
                BiConsumer<SavedState, ByteBuffer> writer,
                BiConsumer<ByteBuffer, SavedState> reader) {
            this.number = number;
            this.isNeeded = isNeeded;
            this.writer = writer;
            this.reader = reader;
        }
    }

    private ParameterSections() {}

    private static boolean hasContacts(SavedState s) {
        return !s.parameters().contacts().isDefault();
    }

    private static boolean hasSurfaces(SavedState s) {
        return s.parameters().surfaces().any();
    }

    /** Returns how many sections these are. */
    static int write(SavedState s, ByteBuffer out) {
        int sections = 0;
        for (Section section : Section.ALL) {
            if (section.isNeeded.test(s)) {
                out.putInt(section.number);
                section.writer.accept(s, out);
                sections++;
            }
        }
        return sections;
    }

    private static void writeWallStart(SavedState s, ByteBuffer out) {
        Bounds b = s.parameters().wallStart();
        out.putInt(FLOATS).putFloat(b.minX()).putFloat(b.minY());
        out.putFloat(b.maxX()).putFloat(b.maxY());
    }

    private static void writeContacts(SavedState s, ByteBuffer out) {
        ContactSettings c = s.parameters().contacts();
        out.putInt(FLOATS).putFloat(c.restitutionThreshold()).putFloat(c.frequency());
        out.putFloat(c.damping()).putFloat(c.pushOutSpeed());
    }

    private static void writeSurfaces(SavedState s, ByteBuffer out) {
        out.putInt(SurfaceSettings.VALUES);
        for (int k = 0; k < SurfaceSettings.VALUES; k++) {
            out.putFloat(s.parameters().surfaces().value(k));
        }
    }

    /** Reads a section behind its number, and checks it. */
    static void read(ByteBuffer in, SavedState s, int number) {
        for (Section section : Section.ALL) {
            if (section.number == number) {
                section.reader.accept(in, s);
                return;
            }
        }
        throw SnapshotCodec.later("it has a section with the unknown number " + number);
    }

    /** Whether a section of floats is to be read. What was known before is left out: new objects would be garbage of each frame. */
    private static boolean begin(ByteBuffer in, int floats, boolean known) {
        SnapshotCodec.require(in.getInt() == floats, "a section of parameters has not its length");
        if (known) {
            ((Buffer) in).position(in.position() + floats * Float.BYTES);
        }
        return !known;
    }

    private static void readWallStart(ByteBuffer in, SavedState s) {
        WorldParameters p = s.parameters();
        if (begin(in, FLOATS, p.wallsMove())) {
            Bounds start = new Bounds(wall(in), wall(in), wall(in), wall(in));
            s.setParameters(
                    p.startingAt(start.with(p.bounds().edgeX(), p.bounds().edgeY())));
            SnapshotCodec.require(s.parameters().wallsMove(), "its walls do not move");
            SnapshotCodec.require(startsAtWalls(s.parameters()), "an edge moves that is no wall");
        }
    }

    private static void readContacts(ByteBuffer in, SavedState s) {
        if (begin(in, FLOATS, hasContacts(s))) {
            s.setParameters(s.parameters()
                    .with(new ContactSettings(in.getFloat(), in.getFloat(), in.getFloat(), in.getFloat())));
            SnapshotCodec.require(hasContacts(s), "its contacts are as by default");
        }
    }

    private static void readSurfaces(ByteBuffer in, SavedState s) {
        if (begin(in, SurfaceSettings.VALUES, hasSurfaces(s))) {
            SurfaceSettings surfaces = SurfaceSettings.NONE.ofCircles(in.getFloat(), in.getFloat());
            for (int wall = 0; wall < WallMotion.COUNT; wall++) {
                surfaces = surfaces.withWall(wall, in.getFloat(), in.getFloat(), in.getFloat());
            }
            s.setParameters(s.parameters().with(surfaces));
            SnapshotCodec.require(hasSurfaces(s), "its surfaces do not grip");
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
