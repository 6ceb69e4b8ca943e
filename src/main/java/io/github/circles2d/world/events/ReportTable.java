package io.github.circles2d.world.events;

import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.SensorRule;
import io.github.circles2d.world.model.StepReports;
import java.util.Arrays;

/**
 * Which types of events are reported, by pair of kinds and by kind for walls; and what follows from it and from what the circles of two
 * kinds do to each other: whether steps record contacts, and which circles look for those that they sense.
 */
final class ReportTable {
    private static final int KINDS = PairTable.KINDS;

    /** Longs of a row of bits by kind. */
    private static final int ROW = KINDS / Long.SIZE;

    /** What a sensed pair can report. */
    private static final int SENSED_TYPES = ContactEvents.BEGIN | ContactEvents.END;

    /** The types of all pairs, where they are the same. */
    private int types;

    /** By pair of kinds: the types; null where they are the same. */
    private byte[] typesOf;

    private final byte[] wallTypes = new byte[KINDS];
    private boolean wallsByKind;
    private boolean some;
    private boolean walls;

    // What follows. Versions count changes.

    /** By pair of kinds, who looks for whom: by {@link SensorRule}. */
    private final int[] seeking = new int[PairTable.WORDS];

    private int version;
    private int resolvedVersion = -1;
    private int resolvedKinds = -1;
    private int resolvedCircles = -1;
    private int resolvedPieces = -1;

    /** By kind, a row of bits: the kinds with which it makes contacts that are reported. */
    private final long[] solidWith = new long[KINDS * ROW];

    /** The same: the kinds with which it makes pairs that are only sensed. */
    private final long[] senseWith = new long[KINDS * ROW];

    /** A bit by kind: whether there are circles of it. */
    private final long[] living = new long[ROW];

    /** A bit by kind: whether it asks for pairs that do not move. */
    private final long[] asking = new long[ROW];

    private boolean asks;
    private boolean statics;
    private boolean bodies;

    private boolean seeks;
    private boolean solids;
    private boolean wallsOfCircles;
    private boolean piecesOfCircles;
    private boolean senses;
    private int seekingVersion;

    /** Sets the types of all pairs and walls: a sum of those in {@link ContactEvents}. */
    void set(int all) {
        types = all & ContactEvents.OF_PAIR_TYPES;
        typesOf = null;
        wallsByKind = false;
        Arrays.fill(wallTypes, (byte) ((all & ContactEvents.WALL) != 0 ? types : 0));
        changed();
    }

    /** Makes room for the types of single pairs. */
    void makeRoom() {
        if (typesOf == null) {
            byte[] all = new byte[KINDS * KINDS];
            Arrays.fill(all, (byte) types);
            typesOf = all;
        }
    }

    /** Sets the types of a pair of kinds, for which there is room. */
    void set(int a, int b, int ofPair) {
        typesOf[KINDS * a + b] = (byte) ofPair;
        typesOf[KINDS * b + a] = (byte) ofPair;
        changed();
    }

    void setWalls(int kind, int ofWalls) {
        wallTypes[kind] = (byte) ofWalls;
        wallsByKind = true;
        changed();
    }

    private void changed() {
        some = types != 0 && typesOf == null;
        for (int k = 0; typesOf != null && k < typesOf.length; k++) {
            some |= typesOf[k] != 0;
        }
        walls = false;
        for (byte ofWalls : wallTypes) {
            walls |= ofWalls != 0;
        }
        version++;
    }

    /** Counts changes. */
    int version() {
        return version;
    }

    /** Whether anything is reported. */
    boolean isOn() {
        return some || walls;
    }

    boolean hasWalls() {
        return walls;
    }

    /** Whether all pairs of kinds have the same types. */
    boolean isUniform() {
        return typesOf == null;
    }

    boolean dependsOnKinds() {
        return typesOf != null || wallsByKind;
    }

    /** The types of a pair of kinds. */
    int types(int a, int b) {
        return typesOf == null ? types : typesOf[KINDS * a + b];
    }

    int wallTypes(int kind) {
        return wallTypes[kind];
    }

    /** Of a saved pair or late event. If kinds decide, it may: they may change, and that of a removed circle is not known any more. */
    boolean mayReport(boolean ofWall, int wanted) {
        int now = ofWall ? wallTypes(0) : types(0, 0);
        return dependsOnKinds() || (now & wanted) != 0;
    }

    /** Finds out what follows, if anything has changed. */
    void resolve(KindTable kinds, KnownCircles circles, KnownPieces pieces) {
        boolean same = resolvedVersion == version && resolvedKinds == kinds.version();
        if (!same) {
            resolvedVersion = version;
            resolvedKinds = kinds.version();
            resolveKinds(kinds);
        }
        if (!same || resolvedCircles != circles.kindsVersion()) {
            resolvedCircles = circles.kindsVersion();
            resolveCircles(circles);
            same = false;
        }
        if (!same || resolvedPieces != pieces.version()) {
            resolvedPieces = pieces.version();
            resolvePieces(circles, pieces);
        }
    }

    /** Finds out whether something of circles and pieces that there are is reported. */
    private void resolvePieces(KnownCircles circles, KnownPieces pieces) {
        piecesOfCircles = false;
        bodies = false;
        for (int piece = 0; piece < KINDS; piece++) {
            for (int kind = 0; kind < KINDS && pieces.has(piece); kind++) {
                long sensed = senseWith[ROW * kind + piece / Long.SIZE];
                long row = solidWith[ROW * kind + piece / Long.SIZE] | sensed;
                piecesOfCircles |= circles.has(kind) && (row & 1L << piece) != 0;
                boolean asked = StepReports.asks(asking, kind) || StepReports.asks(asking, piece);
                bodies |= asked && circles.has(kind) && (sensed & 1L << piece) != 0;
            }
        }
    }

    private void resolveKinds(KindTable kinds) {
        boolean before = seeks;
        seeks = false;
        if (before) {
            Arrays.fill(seeking, 0);
        }
        Arrays.fill(solidWith, 0);
        Arrays.fill(senseWith, 0);
        asks = false;
        for (int kind = 0; kind < KINDS; kind++) {
            boolean own = kinds.get(KindField.SENSES_STATIC, kind) != 0;
            asking[kind / Long.SIZE] = asking[kind / Long.SIZE] & ~(1L << kind) | (own ? 1L << kind : 0);
            asks |= own;
        }
        for (int a = 0; a < KINDS && some; a++) {
            for (int b = 0; b < KINDS; b++) {
                resolve(kinds, a, b);
            }
        }
        if (before || seeks) {
            seekingVersion++;
        }
    }

    /** Finds out which kinds matter: those of which there are circles. */
    private void resolveCircles(KnownCircles circles) {
        Arrays.fill(living, 0);
        wallsOfCircles = false;
        for (int kind = 0; kind < KINDS; kind++) {
            if (circles.has(kind)) {
                living[kind / Long.SIZE] |= 1L << kind;
                wallsOfCircles |= wallTypes[kind] != 0;
            }
        }
        solids = false;
        senses = false;
        statics = false;
        for (int kind = 0; kind < KINDS; kind++) {
            for (int k = 0; k < ROW && circles.has(kind); k++) {
                boolean sensed = (senseWith[ROW * kind + k] & living[k]) != 0;
                solids |= (solidWith[ROW * kind + k] & living[k]) != 0;
                senses |= sensed;
                statics |= sensed && StepReports.asks(asking, kind);
            }
        }
    }

    private void resolve(KindTable kinds, int a, int b) {
        int response = PairTable.get(kinds.responses(), a, b);
        int reported = types(a, b);
        if (response == PairTable.SOLID) {
            solidWith[ROW * a + b / Long.SIZE] |= reported != 0 ? 1L << b : 0;
        } else if (response == PairTable.SENSE && (reported & SENSED_TYPES) != 0) {
            seeks = true;
            senseWith[ROW * a + b / Long.SIZE] |= 1L << b;
            int own = kinds.get(KindField.SENSOR, a);
            int other = kinds.get(KindField.SENSOR, b);
            // There are fewer sensors than others, mostly.
            PairTable.setOne(
                    seeking,
                    a,
                    b,
                    own == other ? SensorRule.BOTH_SEEK : own > other ? SensorRule.SEEKS : SensorRule.FOUND);
        }
    }

    /** Tells a step what it reports, as of the last {@link #resolve}. */
    void tell(StepReports reports) {
        boolean records = solids || wallsOfCircles || piecesOfCircles;
        reports.set(records, piecesOfCircles, senses || bodies, seeking, seekingVersion);
        reports.setStatics(statics, bodies, asks ? asking : null);
    }

    long bytes() {
        return wallTypes.length
                + 8L * (2 * solidWith.length)
                + 4L * seeking.length
                + (typesOf == null ? 0 : typesOf.length);
    }
}
