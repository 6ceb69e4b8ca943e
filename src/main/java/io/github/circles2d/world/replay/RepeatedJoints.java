package io.github.circles2d.world.replay;

import static java.lang.Float.intBitsToFloat;

import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.changes.JointCalls;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.joints.JointSetting;
import io.github.circles2d.world.log.LogReader;
import io.github.circles2d.world.shared.LoggedCall;

/** Makes the calls on joints again, which check all values. */
final class RepeatedJoints {
    private final JointCalls joints;
    private final RepeatedCalls circles;
    private final RepeatedTerrain terrain;

    /** What the next joints are; null if nothing has said so. */
    private JointForm form;

    RepeatedJoints(Simulation simulation, RepeatedCalls circles, RepeatedTerrain terrain) {
        joints = simulation.joints();
        this.circles = circles;
        this.terrain = terrain;
    }

    void repeat(LoggedCall call, int[] words) {
        switch (call) {
            case JOINT_FORM -> form = form(words);
            case JOINT -> joints.add(circles.handle(words[0]), circles.handle(words[1]), form());
            case JOINT_ALONE -> joints.add(circles.handle(words[0]), form());
            case ANCHORED_JOINT ->
                joints.add(
                        circles.handle(words[0]),
                        terrain.body(words[1]),
                        intBitsToFloat(words[2]),
                        intBitsToFloat(words[3]),
                        form());
            case JOINT_SETTING ->
                joints.set(setting(words[1]), joint(words[0]), intBitsToFloat(words[2]), intBitsToFloat(words[3]));
            case REMOVE_JOINT -> joints.remove(joint(words[0]));
            case CLEAR_JOINTS -> joints.clear();
            default -> throw new IllegalStateException(call + " is no call on joints");
        }
    }

    private static JointForm form(int[] words) {
        JointForm form = JointForm.of(words);
        if (form == null) {
            throw LogReader.refused("no joint has the form " + words[0]);
        }
        return form;
    }

    private JointForm form() {
        if (form == null) {
            throw LogReader.refused("a joint comes without a form");
        }
        return form;
    }

    private static JointSetting setting(int number) {
        JointSetting setting = JointSetting.of(number);
        if (setting == null) {
            throw LogReader.refused("no setting of a joint has the number " + number);
        }
        return setting;
    }

    private long joint(int id) {
        long handle = id >= 0 && id < joints.idLimit() ? joints.handle(id) : 0;
        if (handle == 0) {
            throw LogReader.refused("no joint has the id " + id);
        }
        return handle;
    }
}
