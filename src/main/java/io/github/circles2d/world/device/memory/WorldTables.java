package io.github.circles2d.world.device.memory;

import static io.github.circles2d.world.device.memory.KernelConstants.of;
import static io.github.circles2d.world.device.memory.KernelConstants.places;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.device.memory.DeviceArray.Index;
import io.github.circles2d.world.events.Partner;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.Features;
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

    /** What kernels with the arrays of {@link DeviceArray#FEATURES} are compiled for, in their order. */
    private static final List<String> FEATURES = List.of("TURNING", "TERRAIN", "SLEEPING", "OWN_MOTION", "JOINTS");

    /** Of which kernels have a macro each, {@code IF_TURNING(text)}: the text, or nothing. */
    private static final List<String> CONDITIONS =
            List.of("TURNING", "TERRAIN", "SLEEPING", "OWN_MOTION", "JOINTS", "BODIES", "RECORDING");

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
        text.append(JointUpload.Head.STRUCT.text());
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
        text.append(of(Tuning.class, ""))
                .append(of(Reach.class, "REACH_"))
                .append(of(CrossRule.class, "CROSS_"))
                .append(of(TouchRule.class, "TOUCH_"))
                .append(of(SensorRule.class, "SENSOR_"))
                .append(of(PairTable.class, "PAIR_"))
                .append(of(Surface.class, "SURFACE_"))
                .append(of(KindSurface.class, "SURFACE_"))
                .append(of(KindTerrain.class, "KIND_TERRAIN_"))
                .append(of(KindSleep.class, "KIND_SLEEP_"))
                .append(of(Sleep.class, "SLEEP_"))
                .append(of(PieceRow.class, "PIECE_"))
                .append(of(BodyRow.class, "BODY_"))
                .append(of(JointMath.class, "JOINT_"))
                .append(of(JointStep.class, "JOINT_"))
                .append(places(JointState.class, "KEPT_", "kept"))
                .append(places(JointSpring.class, "SPRING_", "spring"))
                .append(of(Commands.class, "COMMAND_"))
                .append(of(Scan.class, "SCAN_"))
                .append(of(TileRecord.class, "TILE_"));
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
        for (TerrainArray table : TerrainArray.values()) {
            define(text, "TERRAIN_" + table.name(), table.ordinal(), "int of terrain: words before " + table.comment());
        }
        define(text, "TERRAIN_NODES", TerrainArray.AT_NODES, "number of nodes");
        define(text, "TERRAIN_GROUND_NODES", TerrainArray.AT_GROUND_NODES, "of those of the ground, which come first");
        define(text, "TERRAIN_BODIES", TerrainArray.AT_BODIES, "number of bodies that move, and 1");
        define(text, "TRAIT_SHAPE", "s" + PieceRow.SHAPE, "of an int4 of traits: form and joints");
        define(text, "TRAIT_MOTION", "s" + PieceRow.MOTION, "row of its body's motion, or 0");
        define(text, "TRAIT_KIND", "s" + PieceRow.KIND, "kind");
        define(text, "TRAIT_SERIAL", "s" + PieceRow.SERIAL, "serial number");
    }

    /** The numbers of a joint's rows and traits, which kernels have as vectors, row[0] and so on, and the bits of its form. */
    private static void joints(StringBuilder text) {
        Class<?> rows = JointRow.class;
        text.append(places(
                        rows, "ROW_", "row", "LENGTH", "MIN_LENGTH", "MAX_LENGTH", "MAX_FORCE", "MAX_TORQUE", "SPEED"))
                .append(places(rows, "ROW_", "row", "ANCHOR_X", "ANCHOR_Y", "DIRECTION_X", "DIRECTION_Y"))
                .append(places(rows, "ROW_", "row", "BREAK_FORCE", "BREAK_TORQUE"))
                .append(places(rows, "HOLDS_", "traits", "A", "B"))
                .append(places(rows, "HOLD_", "traits", "FORM", "SPRING", "ANCHOR", "SERIAL"))
                .append(places(rows, "", "traits", "REFERENCE_A", "REFERENCE_B"))
                .append(of(rows, "HOLD_", "LINEAR", "AXIAL", "POINT", "DRAG", "RIGID", "ELASTIC", "LOWER", "UPPER"))
                .append(of(rows, "HOLD_", "ACROSS", "ANGULAR", "TURN_SPEED", "TURN_ANGLE", "TURN_RIGID", "BREAKABLE"));
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
        return array.feature() == Features.NONE ? "" : FEATURES.get(DeviceArray.FEATURES.indexOf(array.feature()));
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
