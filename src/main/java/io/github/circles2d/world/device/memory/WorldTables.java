package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.device.memory.DeviceArray.Index;
import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointState;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.KindSurface;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.PieceRow;
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

    private static final String TURNING = "TURNING";
    private static final String TERRAIN = "TERRAIN";
    private static final String JOINTS = "JOINTS";

    /** What kernels may be compiled for, in the order in which the struct World has the arrays. */
    private static final List<String> FEATURES = List.of(TURNING, TERRAIN, JOINTS);

    /** Macros that name all arrays, whether a kernel uses them or not. */
    static final Set<String> MACROS_OF_ALL_ARRAYS = macrosOfAllArrays();

    private WorldTables() {}

    static String text() {
        StringBuilder text = new StringBuilder();
        for (StatusWord word : StatusWord.values()) {
            define(text, word.name(), word.index(), word.comment());
        }
        commands(text);
        tileRecord(text);
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
        define(text, "PAIR_SOLID", PairTable.SOLID, "circles of two kinds push each other");
        define(text, "PAIR_IGNORE", PairTable.IGNORE, "they do not see each other");
        define(text, "PAIR_SENSE", PairTable.SENSE, "they are to be noticed, and do not push each other");
        text.append(StepParameters.CONSTANTS.text()).append(StepParameters.LEVELS.text());
        text.append(StepParameters.WALLS.text());
        text.append(FieldsStruct.text());
        surfaces(text);
        terrain(text);
        joints(text);
        text.append(JointHead.STRUCT.text());
        text.append(TouchArrays.text()).append(EventArrays.text());
        text.append(parameters()).append(struct()).append(initialiser());
        for (SharedArray array : SharedArray.values()) {
            text.append(array.text());
        }
        return text.toString();
    }

    private static void commands(StringBuilder text) {
        define(text, "COMMAND_STRIDE", Commands.STRIDE, "ints of a record");
        define(text, "COMMAND_OPCODE", Commands.OPCODE, "one of the next fifteen");
        define(text, "COMMAND_ADD", Commands.ADD, "a new circle");
        define(text, "COMMAND_REMOVE", Commands.REMOVE, "a circle goes");
        define(text, "COMMAND_POSITION", Commands.POSITION, "x, y");
        define(text, "COMMAND_VELOCITY", Commands.VELOCITY, "x, y");
        define(text, "COMMAND_RADIUS", Commands.RADIUS, "radius");
        define(text, "COMMAND_MASS", Commands.MASS, "mass");
        define(text, "COMMAND_RESTITUTION", Commands.RESTITUTION, "restitution");
        define(text, "COMMAND_IMPULSE", Commands.IMPULSE, "x, y");
        define(text, "COMMAND_DEPART", Commands.DEPART, "x, y, length of the step");
        define(text, "COMMAND_ARRIVE", Commands.ARRIVE, "x, y");
        define(text, "COMMAND_GROW", Commands.GROW, "radius");
        define(text, "COMMAND_FIELD", Commands.FIELD, "which int of CircleFields, or of homeOwn, the value");
        define(text, "COMMAND_ANGLE", Commands.ANGLE, "angle");
        define(text, "COMMAND_ANGULAR_VELOCITY", Commands.ANGULAR_VELOCITY, "angular velocity");
        define(text, "COMMAND_ANGULAR_IMPULSE", Commands.ANGULAR_IMPULSE, "impulse, inverse inertia by inverse mass");
        define(text, "COMMAND_ID", Commands.ID, "the circle's");
        define(text, "COMMAND_FIRST", Commands.FIRST, "first value of a change");
        define(text, "COMMAND_SECOND", Commands.SECOND, "second value of a change");
        define(text, "COMMAND_THIRD", Commands.THIRD, "third value of a change");
        define(text, "COMMAND_FOURTH", Commands.FOURTH, "fourth value of a change");
        define(text, "COMMAND_FIFTH", Commands.FIFTH, "fifth value of a change");
        define(text, "COMMAND_ADD_X", Commands.ADD_X, "of a new circle");
        define(text, "COMMAND_ADD_Y", Commands.ADD_Y, "of a new circle");
        define(text, "COMMAND_ADD_RADIUS", Commands.ADD_RADIUS, "of a new circle");
        define(text, "COMMAND_ADD_MASS", Commands.ADD_MASS, "of a new circle");
        define(text, "COMMAND_ADD_RESTITUTION", Commands.ADD_RESTITUTION, "of a new circle");
        define(text, "COMMAND_ADD_VX", Commands.ADD_VX, "of a new circle");
        define(text, "COMMAND_ADD_VY", Commands.ADD_VY, "of a new circle");
    }

    private static void surfaces(StringBuilder text) {
        define(text, "SURFACE_STRIDE", KindSurface.STRIDE, "floats of a row of surfaces");
        define(text, "SURFACE_BELT", KindSurface.BELT, "belt speed; of a wall: towards greater coordinates");
        define(text, "SURFACE_INERTIA", KindSurface.INERTIA, "inverse inertia by inverse mass");
        define(text, "SURFACE_DAMPING_FACTOR", KindSurface.DAMPING_FACTOR, "share that stays in a sub-step");
        define(text, "SURFACE_FRICTION", KindSurface.FRICTION, "friction");
        define(text, "SURFACE_ROLLING_RESISTANCE", KindSurface.ROLLING_RESISTANCE, "rolling resistance");
        define(text, "SURFACE_OWN", KindSurface.OWN, "1 if circles have surfaces or torques of their own, else 0");
        define(text, "SURFACE_DRIVES", KindSurface.DRIVES, "1 if torques or damping change angular velocities, else 0");
        define(text, "SURFACE_OF_WALLS", PairTable.KINDS, "the row of the first wall");
    }

    private static void tileRecord(StringBuilder text) {
        define(text, "RECORD_CIRCLES", TileRecord.AT_CIRCLES, "number of circles");
        define(text, "RECORD_PARTS", TileRecord.AT_PARTS, "number of parts");
        define(text, "RECORD_COPIES", TileRecord.AT_COPIES, "its first copy of a contact");
        define(text, "RECORD_CUT", TileRecord.AT_CUT, "where it is, if tiles are listed: see TileCuts.cl");
        define(text, "RECORD_STARTS", TileRecord.AT_STARTS, "by part: its first contact; and the end");
        define(text, "RECORD_SLOTS", TileRecord.AT_SLOTS, "by circle: see AT_WALL");
        define(text, "TILE_RECORD", TileRecord.WORDS, "ints of a record");
        define(text, "NO_TILE", TileRecord.NO_TILE, "TILE_PEAK where no tile would do");
    }

    private static void define(StringBuilder text, String name, Object value, String comment) {
        text.append("#define " + name + " " + value + " // " + comment + "\n");
    }

    private static void terrain(StringBuilder text) {
        define(text, "TERRAIN_AT", DeviceArray.TERRAIN_AT, "floats before terrain in the buffer of kindMotion");
        define(text, "TERRAIN_ROWS", TerrainRoom.ROWS, "int of terrain: floats before the rows of pieces");
        define(text, "TERRAIN_TRAITS", TerrainRoom.TRAITS, "before their traits, an int4 each");
        define(text, "TERRAIN_BOXES", TerrainRoom.BOXES, "before the boxes of nodes, a float4 each");
        define(text, "TERRAIN_LINKS", TerrainRoom.LINKS, "before their links, an int2 each");
        define(text, "TERRAIN_MOTION", TerrainRoom.MOTION, "before the motion of bodies");
        define(text, "TERRAIN_NODES", TerrainRoom.NODES, "number of nodes");
        define(text, "TERRAIN_BODIES", TerrainRoom.BODIES, "number of bodies that move, and 1");
        define(text, "KIND_TERRAIN_STRIDE", KindTerrain.STRIDE, "floats of a row of kindTerrain");
        define(text, "KIND_RESTITUTION", KindTerrain.RESTITUTION, "restitution");
        define(text, "KIND_ONE_WAY", KindTerrain.ONE_WAY, "1 if circles pass from behind");
        define(text, "PIECE_STRIDE", PieceRow.STRIDE, "floats of the row of a piece");
        define(text, "PIECE_X", PieceRow.X, "start of a line, centre of an arc");
        define(text, "PIECE_Y", PieceRow.Y, "the same");
        define(text, "PIECE_TX", PieceRow.TX, "direction of a line, of the middle of an arc");
        define(text, "PIECE_TY", PieceRow.TY, "the same");
        define(text, "PIECE_LENGTH", PieceRow.LENGTH, "length of a line, radius of an arc");
        define(text, "PIECE_SPREAD", PieceRow.SPREAD, "cosine of half the opening of an arc");
        define(text, "PIECE_THICKNESS", PieceRow.THICKNESS, "radius around a segment");
        define(text, "PIECE_MOST", PieceRow.MOST, "how far a point of it moves at most in the step");
        define(text, "PIECE_START_X", PieceRow.START_X, "start, from x and y");
        define(text, "PIECE_START_Y", PieceRow.START_Y, "the same");
        define(text, "PIECE_END_X", PieceRow.END_X, "end, from x and y");
        define(text, "PIECE_END_Y", PieceRow.END_Y, "the same");
        define(text, "PIECE_NEXT_X", PieceRow.NEXT_X, "direction in which the next piece leaves the end");
        define(text, "PIECE_NEXT_Y", PieceRow.NEXT_Y, "the same");
        define(text, "PIECE_MID_X", PieceRow.MID_X, "middle of its box");
        define(text, "PIECE_MID_Y", PieceRow.MID_Y, "the same");
        define(text, "PIECE_PIVOT_X", PieceRow.PIVOT_X, "what its body turns around, against x");
        define(text, "PIECE_PIVOT_Y", PieceRow.PIVOT_Y, "the same");
        define(text, "TRAIT_SHAPE", "s" + PieceRow.SHAPE, "of an int4 of traits: form and joints");
        define(text, "TRAIT_MOTION", "s" + PieceRow.MOTION, "row of its body's motion, or 0");
        define(text, "TRAIT_KIND", "s" + PieceRow.KIND, "kind");
        define(text, "TRAIT_SERIAL", "s" + PieceRow.SERIAL, "serial number");
        define(text, "FORM_BITS", PieceRow.FORM, "of a shape");
        define(text, "FORM_SEGMENT", PieceRow.SEGMENT, "solid on both sides");
        define(text, "FORM_LINE", PieceRow.LINE, "of a chain");
        define(text, "FORM_ARC", PieceRow.ARC, "arc");
        define(text, "SOLID_OUTSIDE", PieceRow.SOLID_OUTSIDE, "of a shape: circles are inside");
        define(text, "START_LOG", PieceRow.START_LOG, "where a shape has the joint of the start");
        define(text, "END_LOG", PieceRow.END_LOG, "of the end");
        define(text, "JOINT_BITS", PieceRow.JOINT, "of a joint");
        define(text, "JOINT_FREE", PieceRow.FREE, "no other piece there");
        define(text, "JOINT_CONVEX", PieceRow.CONVEX, "or straight");
        define(text, "JOINT_CONCAVE", PieceRow.CONCAVE, "the surface turns towards its free side");
        define(text, "BODY_VX", BodyRow.VX, "float of the motion of a body: its velocity");
        define(text, "BODY_VY", BodyRow.VY, "the same");
        define(text, "BODY_OMEGA", BodyRow.OMEGA, "angular velocity");
        define(text, "BODY_HEAD", BodyRow.pose(0), "floats before the first pose");
        define(text, "BODY_POSE", BodyRow.pose(1) - BodyRow.pose(0), "floats of a pose");
        define(text, "POSE_DX", BodyRow.DX, "float of a pose: displacement");
        define(text, "POSE_DY", BodyRow.DY, "the same");
        define(text, "POSE_COS", BodyRow.COS, "cosine of the angle");
        define(text, "POSE_SIN", BodyRow.SIN, "sine");
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
        row(text, "kept", "KEPT_AXIAL", JointState.AXIAL, "of what a joint keeps: impulse along");
        row(text, "kept", "KEPT_ACROSS", JointState.ACROSS, "across");
        row(text, "kept", "KEPT_LOWER", JointState.LOWER, "at the least length");
        row(text, "kept", "KEPT_UPPER", JointState.UPPER, "at the greatest length");
        row(text, "kept", "KEPT_ANGULAR", JointState.ANGULAR, "on A");
        row(text, "kept", "KEPT_SUM_X", JointState.SUM_X, "sum of a step");
        row(text, "kept", "KEPT_SUM_Y", JointState.SUM_Y, "the same");
        row(text, "kept", "KEPT_SUM_ANGULAR", JointState.SUM_ANGULAR, "the same");
        row(text, "spring", "SPRING_NOW", JointSpring.NOW, "of an exact spring");
        row(text, "spring", "SPRING_BEGUN", JointSpring.BEGUN, "the same");
        row(text, "spring", "SPRING_WAY", JointSpring.WAY, "the same");
        row(text, "spring", "SPRING_MASS_SCALE", JointSpring.MASS_SCALE, "of another one");
        row(text, "spring", "SPRING_BIAS_RATE", JointSpring.BIAS_RATE, "the same");
        row(text, "spring", "SPRING_IMPULSE_SCALE", JointSpring.IMPULSE_SCALE, "the same");
        row(text, "spring", "SPRING_EXACT", JointSpring.EXACT, "not 0: it is exact");
        define(text, "JOINT_COLOURS", JointStep.COLOURS, "colours of joints");
        define(text, "JOINT_STARTS", JointStep.BATCH_STRIDE, "starts of a batch");
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
        return array.turns() ? TURNING : array.isOfTerrain() ? TERRAIN : array.isOfJoints() ? JOINTS : "";
    }

    /** A macro for each feature, {@code TURNING_ARRAYS} for TURNING, and then the initialiser. */
    private static String initialiser() {
        StringBuilder text = new StringBuilder(
                "#ifdef TURNING\n#define IF_TURNING(text) text\n#else\n#define IF_TURNING(text)\n#endif\n");
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
