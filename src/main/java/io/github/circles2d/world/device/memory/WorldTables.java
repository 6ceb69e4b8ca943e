package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.device.memory.DeviceArray.Index;
import io.github.circles2d.world.events.Partner;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.JointMath;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointState;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.KindSleep;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.Reach;
import io.github.circles2d.world.model.SensorRule;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.Surface;
import io.github.circles2d.world.model.TouchRule;
import io.github.circles2d.world.model.Tuning;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * The text that the tables of the host give to the kernels: status words, structs that the host fills, the fields of elements, the argument
 * list of the stages' kernels, the struct World that they pack it into, and the numbers of records.
 */
final class WorldTables {
    /** The name of the text in messages of a compiler. */
    static final String NAME = "world/tables of the host";

    /** The kernels' type of the impulses of a contact's rows, by {@link ContactRows}. */
    static final String ROWS = "RowImpulses";

    /** The kernels' type of those of a circle's walls: a row's two axes side by side. */
    static final String WALL_ROWS = "WallRows";

    private static final String TURNING = "TURNING";
    private static final String TERRAIN = "TERRAIN";
    private static final String SLEEPING = "SLEEPING";
    private static final String OWN_MOTION = "OWN_MOTION";
    private static final String JOINTS = "JOINTS";

    /** What kernels may be compiled for, in the order in which the struct World has the arrays. */
    private static final List<String> FEATURES = List.of(TURNING, TERRAIN, SLEEPING, OWN_MOTION, JOINTS);

    /** Of which kernels have a macro each, {@code IF_TURNING(text)}: the text, or nothing. */
    private static final List<String> CONDITIONS =
            List.of(TURNING, TERRAIN, SLEEPING, OWN_MOTION, JOINTS, "BODIES", "RECORDING");

    /** Macros that name all arrays, whether a kernel uses them or not. */
    static final Set<String> MACROS_OF_ALL_ARRAYS = macrosOfAllArrays();

    private WorldTables() {}

    static String text() {
        StringBuilder text = new StringBuilder();
        for (StatusWord word : StatusWord.values()) {
            define(text, word.name(), word.index(), word.comment());
        }
        tables(text);
        for (ElementField field : ElementField.values()) {
            define(text, field.name(), field.components(), "of " + field.array().kernelName());
            define(text, field.name() + "_AT", field.at(), "for those who touch no other component");
        }
        define(text, "NONE", "(" + CachedImpulse.NONE + ")", "no slot, no id, no contact");
        define(text, "FRESH", "(" + CachedImpulse.FRESH + ")", "cached impulses that are not its circle's own");
        define(text, "CACHED_HIGHER_ID", "s" + CachedImpulse.AT_HIGHER_ID, "of an entry of impulseCache");
        define(text, "CACHED_IMPULSE", "s" + CachedImpulse.AT_IMPULSE, "its bits");
        define(
                text,
                "CACHED_NEXT",
                "s" + CachedImpulse.AT_NEXT,
                "the next entry of the same circle of lower id, or NONE");
        text.append(StepParameters.CONSTANTS.text()).append(StepParameters.LEVELS.text());
        text.append(StepParameters.WALLS.text());
        text.append(FieldsStruct.text());
        joints(text);
        text.append(JointHead.STRUCT.text());
        text.append("typedef float" + ContactRows.STRIDE + " " + ROWS + ";\n");
        text.append("typedef float" + 2 * ContactRows.STRIDE + " " + WALL_ROWS + ";\n");
        text.append(TouchArrays.text()).append(EventArrays.text());
        text.append(parameters()).append(struct()).append(initialiser());
        for (SharedArray array : SharedArray.values()) {
            text.append(array.text());
        }
        return text.toString();
    }

    private static void define(StringBuilder text, String name, Object value, String comment) {
        text.append("#define " + name + " " + value + " // " + comment + "\n");
    }

    /** Numbers that rows of the host's tables have. */
    private static void tables(StringBuilder text) {
        text.append(KernelConstants.of(Tuning.class, ""))
                .append(KernelConstants.of(Reach.class, "REACH_"))
                .append(KernelConstants.of(CrossRule.class, "CROSS_"))
                .append(KernelConstants.of(TouchRule.class, "TOUCH_"))
                .append(KernelConstants.of(SensorRule.class, "SENSOR_"))
                .append(KernelConstants.of(PairTable.class, "PAIR_"))
                .append(KernelConstants.of(Surface.class, "SURFACE_"))
                .append(KernelConstants.of(KindSurface.class, "SURFACE_"))
                .append(KernelConstants.of(KindTerrain.class, "KIND_TERRAIN_"))
                .append(KernelConstants.of(KindSleep.class, "KIND_SLEEP_"))
                .append(KernelConstants.of(Sleep.class, "SLEEP_"))
                .append(KernelConstants.of(PieceRow.class, "PIECE_"))
                .append(KernelConstants.of(BodyRow.class, "BODY_"))
                .append(KernelConstants.of(JointMath.class, "JOINT_"))
                .append(KernelConstants.of(JointStep.class, "JOINT_"))
                .append(KernelConstants.places(JointState.class, "KEPT_", "kept"))
                .append(KernelConstants.places(JointSpring.class, "SPRING_", "spring"))
                .append(KernelConstants.of(Commands.class, "COMMAND_"))
                .append(KernelConstants.of(Scan.class, "SCAN_"))
                .append(KernelConstants.of(TileRecord.class, "TILE_"));
        for (CircleField field : CircleField.OF_STEPS) {
            define(text, "FIELD_" + field.name(), CircleField.OF_STEPS.indexOf(field), "of a record that sets a field");
        }
        define(text, "SURFACE_OF_WALLS", PairTable.KINDS, "the row of the first wall");
        define(text, "EDGE_WALL", AxisEdge.WALL.ordinal(), "of an axis");
        define(text, "EDGE_OPEN", AxisEdge.OPEN.ordinal(), "the same");
        define(text, "LEVELS", GridLevels.COUNT, "levels of the grid");
        define(text, "FEW", GridLevels.FEW, "see GridLevels.java, as the next");
        define(text, "ENDLESS", GridLevels.ENDLESS, "no number of columns");
        define(text, "SHEET_X_FACTOR", GridLevels.SHEET_X_FACTOR, "of a hash");
        define(text, "SHEET_Y_FACTOR", GridLevels.SHEET_Y_FACTOR, "of a hash");
        define(text, "FIRST_WALL", Limits.CIRCLES, "behind the ids of circles");
        define(text, "FIRST_PIECE", Partner.ofPiece(0), "behind the walls");
        define(text, "BLOCK_LOG", DeviceArrays.BLOCK_LOG, "of the cells of a block");
        define(text, "TERRAIN_AT", DeviceArray.TERRAIN_AT, "floats before terrain in the buffer of kindMotion");
        define(text, "TERRAIN_ROWS", TerrainRoom.ROWS, "int of terrain: floats before the rows of pieces");
        define(text, "TERRAIN_TRAITS", TerrainRoom.TRAITS, "before their traits, an int4 each");
        define(text, "TERRAIN_BOXES", TerrainRoom.BOXES, "before the boxes of nodes, a float4 each");
        define(text, "TERRAIN_LINKS", TerrainRoom.LINKS, "before their links, an int2 each");
        define(text, "TERRAIN_MOTION", TerrainRoom.MOTION, "before the motion of bodies");
        define(text, "TERRAIN_NODES", TerrainRoom.NODES, "number of nodes");
        define(
                text,
                "TERRAIN_GROUND_NODES",
                TerrainRoom.GROUND_NODES,
                "number of those of the ground, which come first");
        define(text, "TERRAIN_BODIES", TerrainRoom.BODIES, "number of bodies that move, and 1");
        define(text, "TRAIT_SHAPE", "s" + PieceRow.SHAPE, "of an int4 of traits: form and joints");
        define(text, "TRAIT_MOTION", "s" + PieceRow.MOTION, "row of its body's motion, or 0");
        define(text, "TRAIT_KIND", "s" + PieceRow.KIND, "kind");
        define(text, "TRAIT_SERIAL", "s" + PieceRow.SERIAL, "serial number");
    }

    private static void joints(StringBuilder text) {
        row(text, "row", "ROW_LENGTH", JointRow.LENGTH, "of a joint's row");
        row(text, "row", "ROW_ANCHOR_X", JointRow.ANCHOR_X, "anchor, if it has no B");
        row(text, "row", "ROW_ANCHOR_Y", JointRow.ANCHOR_Y, "the same");
        row(text, "row", "ROW_MIN_LENGTH", JointRow.MIN_LENGTH, "least length");
        row(text, "row", "ROW_MAX_LENGTH", JointRow.MAX_LENGTH, "greatest length");
        row(text, "row", "ROW_MAX_FORCE", JointRow.MAX_FORCE, "greatest force");
        row(text, "row", "ROW_MAX_TORQUE", JointRow.MAX_TORQUE, "greatest torque");
        row(text, "row", "ROW_SPEED", JointRow.SPEED, "of A against B");
        row(text, "row", "ROW_BREAK_FORCE", JointRow.BREAK_FORCE, "by which it breaks");
        row(text, "row", "ROW_BREAK_TORQUE", JointRow.BREAK_TORQUE, "the same");
        row(text, "row", "ROW_DIRECTION_X", JointRow.DIRECTION_X, "from A to B");
        row(text, "row", "ROW_DIRECTION_Y", JointRow.DIRECTION_Y, "the same");
        row(text, "traits", "HOLDS_A", JointRow.A, "of a joint's traits: id of A");
        row(text, "traits", "HOLDS_B", JointRow.B, "id of B, or NONE");
        row(text, "traits", "HOLD_FORM", JointRow.FORM, "its form");
        row(text, "traits", "HOLD_SPRING", JointRow.SPRING, "its spring");
        row(text, "traits", "HOLD_ANCHOR", JointRow.ANCHOR, "its anchor that moves, or 0");
        row(text, "traits", "HOLD_SERIAL", JointRow.SERIAL, "serial number");
        row(text, "traits", "REFERENCE_A", JointRow.REFERENCE_A, "angle of A");
        row(text, "traits", "REFERENCE_B", JointRow.REFERENCE_B, "angle of B");
        define(text, "HOLD_LINEAR", JointRow.LINEAR, "of a form: one of the next three, or 0");
        define(text, "HOLD_AXIAL", JointRow.AXIAL, "along the line from A to B");
        define(text, "HOLD_POINT", JointRow.POINT, "in both axes");
        define(text, "HOLD_DRAG", JointRow.DRAG, "on the velocity alone");
        define(text, "HOLD_RIGID", JointRow.RIGID, "not by a spring");
        define(text, "HOLD_ELASTIC", JointRow.ELASTIC, "by a spring");
        define(text, "HOLD_LOWER", JointRow.LOWER, "has a least length");
        define(text, "HOLD_UPPER", JointRow.UPPER, "has a greatest length");
        define(text, "HOLD_ACROSS", JointRow.ACROSS, "keeps its direction");
        define(text, "HOLD_ANGULAR", JointRow.ANGULAR, "one of the next three, or 0");
        define(text, "HOLD_TURN_SPEED", JointRow.TURN_SPEED, "a motor");
        define(text, "HOLD_TURN_ANGLE", JointRow.TURN_ANGLE, "a servo");
        define(text, "HOLD_TURN_RIGID", JointRow.TURN_RIGID, "a weld");
        define(text, "HOLD_BREAKABLE", JointRow.BREAKABLE, "it may break");
    }

    /** A number of a row, which kernels have as vectors, row[0] and so on. */
    private static void row(StringBuilder text, String vectors, String name, int place, String comment) {
        define(text, name, vectors + "[" + place / 4 + "].s" + place % 4, comment);
    }

    private static String parameters() {
        StringBuilder text = new StringBuilder("#define WORLD_PARAMETERS");
        String separator = " ";
        for (DeviceArray array : DeviceArguments.ARRAYS) {
            text.append(separator).append(array.declaration());
            separator = ", ";
        }
        for (Index block : DeviceArguments.BLOCKS) {
            text.append(separator).append("global char *").append(block.block());
        }
        for (DeviceCount count : DeviceCount.values()) {
            text.append(", int ").append(count.kernelName());
        }
        return text.append("\n").toString();
    }

    private static String struct() {
        StringBuilder text = new StringBuilder("typedef struct {\n");
        text.append("    StepConstants k; // by value: read once, not at every use\n");
        members(text, "");
        for (String feature : FEATURES) {
            text.append("#ifdef " + feature + "\n");
            members(text, feature);
            text.append("#endif\n");
        }
        for (DeviceCount count : DeviceCount.values()) {
            text.append("    int " + count.kernelName() + "; // " + count.comment() + "\n");
        }
        text.append("    float warmScale; // what cached impulses are multiplied by\n");
        text.append("    int subStep; // the one that is made, where walls may move\n");
        text.append("#ifdef TURNING\n    int relaxed; // the one whose contacts are visited\n#endif\n");
        text.append("#ifdef RECORDING\n    Recording recording;\n#endif\n");
        text.append("#ifdef REPORTING\n    Reporting reporting;\n#endif\n");
        return text.append("} World;\n").toString();
    }

    /** Declares the arrays of all worlds, or those that only worlds with a feature have. */
    private static void members(StringBuilder text, String feature) {
        for (DeviceArray array : DeviceArray.values()) {
            if (array != DeviceArray.CONSTANTS && featureOf(array).equals(feature)) {
                text.append("    " + array.declaration() + "; // " + array.comment() + "\n");
            }
        }
    }

    private static Set<String> macrosOfAllArrays() {
        Set<String> macros = new HashSet<>(Set.of("WORLD", "WORLD_PARAMETERS"));
        FEATURES.forEach(feature -> macros.add(feature + "_ARRAYS"));
        return macros;
    }

    /** What kernels are compiled for that have an array; empty if all have it. */
    private static String featureOf(DeviceArray array) {
        return array.turns()
                ? TURNING
                : array.isOfTerrain()
                        ? TERRAIN
                        : array.isOfSleep()
                                ? SLEEPING
                                : array.isOfOwnMotion() ? OWN_MOTION : array.isOfJoints() ? JOINTS : "";
    }

    /** A macro for each feature, {@code TURNING_ARRAYS} for TURNING, and then the initialiser. */
    private static String initialiser() {
        StringBuilder text = new StringBuilder();
        for (String feature : CONDITIONS) {
            String name = "#define IF_" + feature + "(text)";
            text.append("#ifdef " + feature + "\n" + name + " text\n#else\n" + name + "\n#endif\n");
        }
        for (String feature : FEATURES) {
            text.append("#ifdef " + feature + "\n#define " + feature + "_ARRAYS ");
            expressions(text, feature);
            text.append("\n#else\n#define " + feature + "_ARRAYS\n#endif\n");
        }
        String constants = DeviceArray.CONSTANTS.kernelName();
        text.append("#define WORLD { *" + constants);
        expressions(text, "");
        for (String feature : FEATURES) {
            text.append(" " + feature + "_ARRAYS");
        }
        for (DeviceCount count : DeviceCount.values()) {
            text.append(", ").append(count.kernelName());
        }
        return text.append(", " + constants + "->warmScale, 0 }\n").toString();
    }

    private static void expressions(StringBuilder text, String feature) {
        for (DeviceArray array : DeviceArray.values()) {
            if (array != DeviceArray.CONSTANTS && featureOf(array).equals(feature)) {
                text.append(", ").append(array.expression());
            }
        }
    }
}
