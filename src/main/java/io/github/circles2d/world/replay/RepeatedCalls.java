package io.github.circles2d.world.replay;

import static java.lang.Float.intBitsToFloat;

import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.KindField;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.log.LogReader;
import io.github.circles2d.world.shared.LoggedCall;

/** Makes the calls of {@link LoggedCall} again. It checks all values, since a log may come from anywhere. */
final class RepeatedCalls {
    private final Simulation simulation;
    private final RepeatedTerrain terrain;
    private final RepeatedJoints joints;

    RepeatedCalls(Simulation simulation) {
        this.simulation = simulation;
        terrain = new RepeatedTerrain(simulation);
        joints = new RepeatedJoints(simulation, this, terrain);
    }

    /** Makes a call that is neither a step nor a hash. */
    void repeat(LoggedCall call, int[] words) {
        float x = intBitsToFloat(words[0]);
        float y = intBitsToFloat(words[1]);
        float z = intBitsToFloat(words[2]);
        switch (call) {
            case GRAVITY -> simulation.setGravity(x, y);
            case BOUNDS -> simulation.setBounds(x, y, z, intBitsToFloat(words[3]));
            case FIELD ->
                simulation.fields().set(field(words[0]), handle(words[1]), LoggedCall.value(words[2], words[3]));
            case TRAVEL -> simulation.circles().move(handle(words[0]), y, z);
            case FORCE -> simulation.forces().apply(handle(words[0]), y, z);
            case KIND ->
                simulation.kinds().set(kindField(words[1]), simulation.kinds().check(words[0]), words[2]);
            case PAIR_OF_KINDS -> simulation.kinds().setSetting(words[0], words[1], setting(words[2]));
            case GROW -> simulation.growth().grow(handle(words[0]), y, words[2]);
            case CLEAR -> simulation.clearing().clear();
            case TORQUE -> simulation.forces().applyTorque(handle(words[0]), y);
            case WALL_SURFACE -> simulation.setWallSurface(words[0], y, z, intBitsToFloat(words[3]));
            case SEGMENT, ARC, CHAIN_START, CHAIN_LINE, CHAIN_ARC, CHAIN, REMOVE_PIECE, PIECE_KIND, CLEAR_TERRAIN ->
                terrain.repeatOfPieces(call, words);
            case BODY, REMOVE_BODY, BODY_VELOCITY, BODY_ANGULAR_VELOCITY, MOVE_BODY, TELEPORT_BODY ->
                terrain.repeatOfBodies(call, words);
            case JOINT_FORM, JOINT, ANCHORED_JOINT, JOINT_ALONE, JOINT_SETTING, REMOVE_JOINT, CLEAR_JOINTS ->
                joints.repeat(call, words);
            default -> throw new IllegalStateException("a log has no repetition of " + call);
        }
    }

    long handle(int id) {
        long handle = id >= 0 && id < simulation.circles().idLimit()
                ? simulation.circles().handle(id)
                : 0;
        if (handle == 0) {
            throw LogReader.refused("no circle has the id " + id);
        }
        return handle;
    }

    private static CircleField field(int number) {
        CircleField field = CircleField.ofNumber(number);
        if (field == null || !field.isOfSteps() && field != CircleField.TAG) {
            throw LogReader.refused("calls set no field with the number " + number);
        }
        return field;
    }

    private static KindField kindField(int number) {
        KindField field = KindField.ofNumber(number);
        if (field == null) {
            throw LogReader.refused("no field of a kind has the number " + number);
        }
        return field;
    }

    private static int setting(int number) {
        if (!KindTable.isSetting(number)) {
            throw LogReader.refused("kinds cannot have the response " + number);
        }
        return number;
    }
}
