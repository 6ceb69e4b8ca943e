package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.KindMotion;
import io.github.circles2d.world.model.KindSleep;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.PairTable;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;

/**
 * The arrays of a World on a device. The rows give the kernels their argument list, the struct World and its initialiser
 * ({@link WorldTables}), and give {@link DeviceArrays} the sizes. Arrays with the same index lie in one block, one behind the other: a
 * launch costs some drivers time for each buffer among the arguments. Arrays that the host writes in each step have a block of their own.
 *
 * <p>The arrays for circles that can rotate come behind these, then those of worlds with terrain, of worlds whose circles sleep, of
 * worlds in which circles move in another way than those of their kind, and of worlds with joints. Kernels that are compiled for such worlds
 * (TURNING, TERRAIN, SLEEPING, OWN_MOTION, JOINTS) have them; in other worlds they take no memory.
 */
public enum DeviceArray {
    CONSTANTS("StepConstants", "constants", Index.STRUCT, "World has a copy, k"),
    LEVELS("Levels", "levels", Index.STRUCT, "shape of the grids"),
    WALLS("WallMotion", "walls", Index.STRUCT, "how walls move"),
    STATUS("int", "status", Index.STATUS, "see the defines above"),

    // The state between two steps.
    HOME_CIRCLE("float4", "homeCircle", Index.HOME_SLOT, "x, y of the base, radius, mass"),
    HOME_MOTION("float4", "homeMotion", Index.HOME_SLOT, "displacement x, y, velocity x, y"),
    HOME_TRAITS("float4", "homeTraits", Index.HOME_SLOT, "inverse mass, restitution, wall impulses x, y"),
    HOME_ID("int", "homeId", Index.HOME_SLOT, "NONE: empty"),
    HOME_FIRST_CACHED(
            "int",
            "homeFirstCached",
            Index.HOME_SLOT,
            "first entry in impulseCache as the lower id; NONE; FRESH: its id's entries are not its own"),
    SLOT_OF("int", "slotOf", Index.ID, "slot at home, or NONE"),
    FIELDS(FieldsStruct.NAME, "fields", Index.FIELDS_BY_ID, "the fields that only calls change"),
    KIND_MOTION(
            "float4",
            "kindMotion",
            Index.TABLE,
            "two elements a kind: gain of speed by gravity in a sub-step x, y, damping factor, greatest speed; time in which a velocity"
                    + " makes its part of a path, falls of a gain in a step, longest path"),
    RESPONSES("int", "responses", Index.TABLE, "two bits a pair of kinds: PAIR_SOLID, PAIR_IGNORE or PAIR_SENSE"),

    // Stage Grid.
    BUCKET_BEFORE("int", "bucketBefore", Index.SLOT, "bucket of the circle in the slot at home"),
    RANK("int", "rank", Index.RANK, "by slot at home: how many its bucket had before"),
    ORDER("int2", "order", Index.SLOT, "id and slot at home, bucket by bucket"),
    LISTED_SHEET("int", "listedSheet", Index.SLOT, "where there are sheets: as sheetKey, in the same order"),
    SHEET_KEY("int", "sheetKey", Index.SLOT, "where there are sheets: see sheetKeyOf; 1 more of a static circle"),
    BUCKET_START("int", "bucketStart", Index.BUCKET, "first working slot"),
    BUCKET_OF("int", "bucketOf", Index.SLOT, "bucket of the working slot"),
    SIGHT("float4", "sight", Index.SLOT, "what a search reads: base x, y, speculative distance, inverse mass"),
    CIRCLE("float4", "circle", Index.SLOT, "as homeCircle"),
    MOTION("float4", "motion", Index.SLOT, "as homeMotion"),
    TRAITS("float4", "traits", Index.SLOT, "as homeTraits"),
    ID("int", "id", Index.SLOT, "as homeId"),
    FIRST_CACHED("int", "firstCached", Index.SLOT, "as homeFirstCached"),
    LOAD(
            "float4",
            "load",
            Index.SLOT,
            "velocity before impulses x, y, or sum of contact impulses x, y; whether loaded; loaded in the sub-step to come"),
    WALL_BOUNCE("float2", "wallBounce", Index.SLOT, "target speed of a bounce off a wall x, y"),

    // Stage ContinuousCollision.
    MOTION_CLAMP(
            "float4",
            "motionClamp",
            Index.SLOT,
            "what it moves if nothing is in its way x, y, or what is free of that; allowance; length, or share that is free"),
    TIME_OF_IMPACT("int", "timeOfImpact", Index.SLOT, "as bits: the share of its path that it can go"),
    NEAR(
            "float2",
            "near",
            Index.SLOT,
            "the share up to where it touches one that it has a contact with, NOT_FAST where it is not; how far it may leave its path"
                    + " then, negative at a static one"),
    CARRY_TIME("int", "carryTime", Index.SLOT, "as bits: the share of the step after which a static circle carries it"),
    CARRIER("int", "carrier", Index.SLOT, "the slot of that static circle, or NOBODY"),
    REACH("float4", "reach", Index.SLOT, "x, y of the base, reach, 1 where it is fast and not static"),
    LAST_REACHED("int2", "lastReached", Index.SLOT, "two buckets: the slot that came last, or NONE"),
    REACHED_BEFORE("int", "reachedBefore", Index.SLOT, "the slot that came before it to its bucket, or NONE"),
    BLOCK_RANGE("float4", "blockRange", Index.CELL_BLOCK, "least, greatest x, least, greatest y of paths"),

    DRIVE("float4", "drive", Index.TILED_SLOT, "as the biased pass begins: velocity, the same before impulses"),
    SOLVED_MOTION("float4", "solvedMotion", Index.TILED_SLOT, "between the passes"),
    BURDEN("float", "burden", Index.TILED_SLOT, "as the biased pass begins: inverse mass, negative where loaded"),
    SOLVED_BURDEN("float", "solvedBurden", Index.TILED_SLOT, "between the passes"),

    // Stage Contacts.
    GROUP_START("int", "groupStart", Index.BUCKET, "by group: its first contact"),
    TALLY("int", "tally", Index.TALLY, "counts, later by group; 0 as a step begins, and behind a scan"),
    KEY("ulong", "key", Index.CONTACT, "lower id, higher id"),
    PAIR("uint2", "pair", Index.CONTACT, "working slots, in the same order"),
    BASE("float4", "base", Index.CONTACT, "difference of the bases x, y, sum of the radii, restitution"),
    MASSES("float4", "masses", Index.CONTACT, "inverse masses, effective mass, target speed of a bounce"),
    CONTACT("float4", "contact", Index.COPY, "normal x, y, separation, accumulated impulse"),
    LINK("uint", "link", Index.TILED_CONTACT, "see linkOf"),
    ORDERED("uint2", "ordered", Index.TILED_CONTACT, "working slots, where pair is in no order within a group"),
    SHAPE("float2", "shape", Index.TILED_COPY, "sum of the radii, restitution"),
    PLACED(
            "int2",
            "placed",
            Index.TILED_COPY,
            "number of the contact, or before it has one its place as listed, NOT_OWN too where it is not the tile's; circlesOf"),
    BASES("float2", "bases", Index.TILED_COPY, "difference of the bases x, y"),
    HELD("float", "held", Index.TILED_CONTACT, "accumulated impulse after a sub-step"),
    IMPULSE("float2", "impulse", Index.TILED_CONTACT, "between the passes: accumulated impulse, bounce speed"),
    CROSS_LOAD("int", "crossLoad", Index.SLOT, "of a heavy circle: the load of its cross contacts"),
    CLAIM("int", "claim", Index.SLOT, "of light circles that wait to bounce off it: 1 + the highest id, or 0"),
    COARSER("int", "coarser", Index.SLOT, "if there are several levels: the contacts that it found in coarser ones"),
    HEAVY_SUM("long4", "heavySum", Index.SLOT, "what cross contacts give in a pass, in units: velocity, impulse"),
    LIGHT_VELOCITY("float2", "lightVelocity", Index.SLOT, "of a circle both light and heavy, behind its visits"),
    IMPULSE_CACHE(
            "int4",
            "impulseCache",
            Index.OLD_CONTACT,
            "id of the circle of higher id, impulse, the next of the same circle of lower id or NONE; see CACHED_HIGHER_ID"),

    BLOCK_SUMS("int", "blockSums", Index.SCAN_BLOCK, "counts of a block"),
    TILES("int", "tiles", Index.TILE, "a record of TILE_RECORD ints, see Tiles.cl"),

    // From here on up to SURFACES: if circles can rotate, behind the others of their blocks.
    HOME_TURN("int2", "homeTurn", Index.HOME_SLOT, "angle, bits of the angular velocity"),
    HOME_WALL_ROWS(WorldTables.WALL_ROWS, "homeWallRows", Index.HOME_SLOT, "impulses of the rows of walls x, y"),
    HOME_OWN(
            "float4",
            "homeOwn",
            Index.HOME_SLOT,
            "fields: own friction and rolling resistance, NaN for that of the kind; torque"),
    TURN("int2", "turn", Index.SLOT, "as homeTurn"),
    WALL_ROWS(WorldTables.WALL_ROWS, "wallRows", Index.SLOT, "as homeWallRows"),
    OWN("float4", "own", Index.SLOT, "as homeOwn"),
    SURFACE_SPEED("float", "surfaceSpeed", Index.SLOT, "angular velocity times radius"),
    SPIN_IMPULSE("float", "spinImpulse", Index.SLOT, "sum of impulses on it"),
    TURNED("float", "turned", Index.SLOT, "sum of the surface speeds of sub-steps"),
    INVERSE_INERTIA("float", "inverseInertia", Index.SLOT, "what a surface speed gains by an impulse"),
    CIRCLE_SURFACE("float8", "circleSurface", Index.SLOT, "a row as those of surfaces, see surfaceOfCircle"),
    HEAVY_SPIN("long2", "heavySpin", Index.SLOT, "as heavySum: surface speed, impulse on it"),
    LIGHT_SPIN("float", "lightSpin", Index.SLOT, "as lightVelocity: surface speed"),
    START_SPIN("float", "startSpin", Index.TILED_SLOT, "as drive: surface speed"),
    SOLVED_SPIN("float", "solvedSpin", Index.TILED_SLOT, "as solvedMotion: surface speed"),
    PAIR_SURFACE("float2", "pairSurface", Index.CONTACT, "friction, tangent mass; negative if pairRest has something"),
    ROW_IMPULSES(WorldTables.ROWS, "rowImpulses", Index.CONTACT, "accumulated impulses of rows"),
    PAIR_REST("float4", "pairRest", Index.CONTACT, "belt speed, reach of rolling resistance, rolling mass"),
    START_SPINS("float2", "startSpins", Index.TILED_CONTACT, "as startImpulses: impulses on surface speeds"),
    HELD_ROWS(WorldTables.ROWS, "heldRows", Index.TILED_CONTACT, "as held: impulses of rows; behind an even sub-step"),
    ODD_ROWS(
            WorldTables.ROWS,
            "oddRows",
            Index.TILED_CONTACT,
            "the same behind an odd one: neighbours read what was before"),
    COPIED_SURFACE("float2", "copiedSurface", Index.TILED_COPY, "as pairSurface"),
    COPIED_REST("float4", "copiedRest", Index.TILED_COPY, "as pairRest"),
    ROW_CACHE(WorldTables.ROWS, "rowCache", Index.OLD_CONTACT, "by entry of impulseCache: impulses of rows"),
    SURFACES("float", "surfaces", Index.TABLE, "a row a kind, then a row a wall, of SURFACE_STRIDE floats"),

    // From here on up to TERRAIN: of worlds with terrain, behind all others of their blocks. There is room for as many
    // piece contacts
    // as for contacts.
    HOME_PIECES("int2", "homePieces", Index.HOME_SLOT, "piece contacts: the first, how many"),
    PIECES("int2", "pieces", Index.SLOT, "as homePieces; before they are found, those of the step before"),
    HOME_PIECE("int2", "homePiece", Index.OLD_CONTACT, "by piece contact: piece, serial number"),
    HOME_PUSH("float2", "homePush", Index.OLD_CONTACT, "by piece contact: side, normal impulse"),
    HOME_PIECE_ROWS(WorldTables.ROWS, "homePieceRows", Index.OLD_CONTACT, "by piece contact: impulses of other rows"),
    PIECE(
            "int4",
            "piece",
            Index.CONTACT,
            "as homePiece; then PAIR_SOLID or PAIR_SENSE; where the circle is at, or AT_NOTHING if the piece is no constraint"),
    PUSH("float2", "push", Index.CONTACT, "as homePush"),
    PIECE_ROWS(WorldTables.ROWS, "pieceRows", Index.CONTACT, "as homePieceRows"),
    MEASURED("float4", "measured", Index.CONTACT, "by piece contact: normal x, y, gap, curve"),
    STANDING(
            "float4",
            "standing",
            Index.CONTACT,
            "by piece contact: centre against x and y of the piece, in the frame of the start of the step; target speed of a bounce;"
                    + " gap as the sub-step begins if it is deep, else 0"),
    KIND_TERRAIN("float", "kindTerrain", Index.TABLE, "a row a kind, of KIND_TERRAIN_STRIDE floats"),
    TERRAIN("int", "terrain", Index.TABLE, "see TerrainArray: where arrays lie behind it, number of nodes"),

    // From here on up to KIND_SLEEP: of worlds whose circles sleep, behind all others of their blocks.
    HOME_SLEEP("int4", "homeSleep", Index.HOME_SLOT, "rest, by the Java class Sleep; bits of the drift x, y; turned"),
    SLEEP("int4", "sleep", Index.SLOT, "as homeSleep"),
    WAKING("int2", "waking", Index.SLOT, "as bits: the speed that wakes it; of one that sleeps, what presses it"),
    WOKEN("int2", "woken", Index.SLOT, "two lists of slots: those that wake in a ring, and in the next"),
    KEPT(
            "int4",
            "kept",
            Index.CONTACT,
            "impulses of pairs at rest: slot of the lower id, higher id, bits of the impulse"),
    KEPT_ROWS(WorldTables.ROWS, "keptRows", Index.CONTACT, "the same: impulses of rows"),
    KIND_SLEEP("float", "kindSleep", Index.TABLE, "a row a kind, of KIND_SLEEP_STRIDE floats"),

    // Of worlds in which circles move in another way than those of their kind.
    OWN_MOTION(
            "float4",
            "ownMotion",
            Index.FIELDS_BY_ID,
            "fields: own gravity scale, damping, greatest speed, NaN for those of the kind"),

    // From here on: of worlds with joints.
    JOINTS(
            JointUpload.Head.NAME,
            "joints",
            Index.TABLE,
            "where tables lie, from here on, and how many joints there are");

    /** What an array is indexed by, which decides its size, and the block that it is in. */
    enum Index {
        STRUCT("once", false, null, null),
        STATUS("once", false, null, null),
        TABLE("once", false, null, null),
        HOME_SLOT("by slot at home", true, "homeBlock", DeviceCount.SLOT_STRIDE),
        ID("by id", true, "idBlock", null),
        FIELDS_BY_ID("by id", true, "fieldsBlock", DeviceCount.ID_STRIDE),
        SLOT("by slot", false, "slotBlock", DeviceCount.SLOT_STRIDE),
        RANK("by slot", false, "rankBlock", null),
        BUCKET("by bucket", false, "bucketBlock", DeviceCount.BUCKET_STRIDE),
        TALLY("by bucket", false, "tallyBlock", null),
        SCAN_BLOCK("by block of a scan", false, "scanBlock", null),
        CELL_BLOCK("by block of cells", false, "cellBlock", null),
        CONTACT("by contact", false, "contactBlock", DeviceCount.CONTACT_STRIDE),
        OLD_CONTACT("by contact of the step before", true, "oldContactBlock", DeviceCount.CONTACT_STRIDE),
        COPY("by contact; by tiles, by copy of a contact", false, "copyBlock", DeviceCount.COPY_ROOM),
        TILED_SLOT("by tiles, by slot", false, "tiledSlotBlock", DeviceCount.SLOT_STRIDE),
        TILED_CONTACT("by tiles, by contact", false, "tiledContactBlock", DeviceCount.CONTACT_STRIDE),
        TILED_COPY("by tiles, by copy of a contact", false, "tiledCopyBlock", DeviceCount.COPY_ROOM),
        TILE("by tile", false, "tileBlock", null);

        private final String words;
        private final boolean kept;
        private final String block;
        private final DeviceCount stride;

        Index(String words, boolean kept, String block, DeviceCount stride) {
            this.words = words;
            this.kept = kept;
            this.block = block;
            this.stride = stride;
        }

        /** The kernels' name of the block; null if each array is an argument of its own. */
        String block() {
            return block;
        }

        /** Elements from the start of an array of the block to that of the next; null if there is one alone. */
        DeviceCount stride() {
            return stride;
        }

        /** Whether a device without tiles can do without it. */
        boolean forTilesAlone() {
            return this == TILED_SLOT || this == TILED_CONTACT || this == TILED_COPY;
        }

        /** Whether some of the arrays are there for a feature. */
        boolean isOf(Features feature) {
            return Arrays.stream(values).anyMatch(array -> array.index == this && array.feature() == feature);
        }

        /** Bytes of an element of each array of the block, in a world with these features. */
        long elementBytes(Features features) {
            long sum = 0;
            for (DeviceArray array : values) {
                sum += array.index == this && array.isHeld(features) ? array.elementBytes() : 0;
            }
            return sum;
        }
    }

    /** Features that arrays are there for, in the order in which the struct World has these. */
    static final List<Features> FEATURES =
            List.of(Features.TURNING, Features.TERRAIN, Features.SLEEPING, Features.OWN_MOTION, Features.JOINTS);

    /** Floats before {@link #SURFACES} in the buffer of {@link #KIND_MOTION}: each buffer among the arguments costs time. */
    static final int SURFACES_AT = KindMotion.of(PairTable.KINDS);

    /** Floats before {@link #KIND_TERRAIN} in the same buffer. */
    static final int KIND_TERRAIN_AT = SURFACES_AT + KindSurface.FLOATS;

    /** Floats before {@link #KIND_SLEEP} in the same buffer. */
    static final int KIND_SLEEP_AT = KIND_TERRAIN_AT + KindTerrain.of(PairTable.KINDS);

    /** Floats before {@link #JOINTS} in the same buffer: a multiple of 4. */
    static final int JOINTS_AT = KIND_SLEEP_AT + KindSleep.of(PairTable.KINDS) + 3 & ~3;

    /** Floats before {@link #TERRAIN} in the same buffer: a multiple of 4. */
    static final int TERRAIN_AT = JOINTS_AT + JointUpload.Head.STRUCT.words() + 3 & ~3;

    private static final DeviceArray[] values = values();

    private final String type;
    private final String kernelName;
    private final Index index;
    private final String comment;

    DeviceArray(String type, String kernelName, Index index, String comment) {
        this.type = type;
        this.kernelName = kernelName;
        this.index = index;
        this.comment = comment;
    }

    String kernelName() {
        return kernelName;
    }

    Index index() {
        return index;
    }

    /** Whether its elements stay when it grows. */
    boolean kept() {
        return index.kept;
    }

    /** The feature that only worlds have which have this array, or {@link Features#NONE}. */
    Features feature() {
        if (ordinal() < HOME_TURN.ordinal()) {
            return Features.NONE;
        }
        if (ordinal() < HOME_PIECES.ordinal()) {
            return Features.TURNING;
        }
        if (ordinal() < HOME_SLEEP.ordinal()) {
            return Features.TERRAIN;
        }
        return this == OWN_MOTION ? Features.OWN_MOTION : this == JOINTS ? Features.JOINTS : Features.SLEEPING;
    }

    /** Whether it has memory in a world with these features. */
    boolean isHeld(Features features) {
        return features.have(feature());
    }

    /** The bits of an element of a new circle, or contact, in a world that gets a feature. */
    int[] initial() {
        return switch (this) {
            case HOME_OWN -> FieldsStruct.initialTurning();
            case OWN_MOTION -> FieldsStruct.initialMotion();
            default -> new int[elementBytes() / Integer.BYTES];
        };
    }

    /** The declaration as a parameter, or as a member of the struct World. */
    String declaration() {
        return (index == Index.STRUCT ? "constant " : "global ") + type + " *" + kernelName;
    }

    /** Bytes of an element of each array that lies in the block before this one, in a world with these features. */
    long bytesBefore(Features features) {
        return bytesBefore(features::have);
    }

    private long bytesBefore(Predicate<Features> counts) {
        long sum = 0;
        for (DeviceArray array : values) {
            if (array == this) {
                break;
            }
            sum += array.index == index && counts.test(array.feature()) ? array.elementBytes() : 0;
        }
        return sum;
    }

    /** What the kernels make the array of, out of their arguments. */
    String expression() {
        if (index == Index.TABLE && tableAt() > 0) {
            return "(global " + type + " *) ((global float *) " + KIND_MOTION.kernelName + " + " + tableAt() + ")";
        }
        if (index.block == null) {
            return kernelName;
        }
        long before = bytesBefore(of -> of == Features.NONE || of == feature());
        long ofTurning = bytesBefore(of -> of == Features.TURNING && of != feature());
        long ofTerrain = bytesBefore(of -> of == Features.TERRAIN && of != feature());
        String bytes = before
                + (ofTurning == 0 ? "" : " IF_TURNING(+ " + ofTurning + ")")
                + (ofTerrain == 0 ? "" : " IF_TERRAIN(+ " + ofTerrain + ")");
        boolean isFirst = before == 0 && ofTurning == 0 && ofTerrain == 0;
        String offset = isFirst ? "" : " + (size_t) " + index.stride.kernelName() + " * (" + bytes + ")";
        return "(global " + type + " *) (" + index.block + offset + ")";
    }

    /** Floats before this table in the buffer of another; 0 if it has its own. */
    private int tableAt() {
        return switch (this) {
            case SURFACES -> SURFACES_AT;
            case KIND_TERRAIN -> KIND_TERRAIN_AT;
            case KIND_SLEEP -> KIND_SLEEP_AT;
            case TERRAIN -> TERRAIN_AT;
            case JOINTS -> JOINTS_AT;
            default -> 0;
        };
    }

    String comment() {
        return index.words + ": " + comment;
    }

    /** Bytes of an element, of an array that is no struct. */
    int elementBytes() {
        return bytesOf(type);
    }

    static int bytesOf(String type) {
        return switch (type) {
            case "int", "uint", "float" -> 4;
            case WorldTables.ROWS -> Float.BYTES * ContactRows.STRIDE;
            case WorldTables.WALL_ROWS -> 2 * Float.BYTES * ContactRows.STRIDE;
            case "int2", "uint2", "float2", "ulong" -> 8;
            case "int4", "float4", "ulong2", "long2" -> 16;
            case "long4", "float8" -> 32;
            case FieldsStruct.NAME -> FieldsStruct.BYTES;
            case JointUpload.Head.NAME -> Integer.BYTES * JointUpload.Head.STRUCT.words();
            default -> throw new IllegalStateException(type + " has no size here");
        };
    }
}
