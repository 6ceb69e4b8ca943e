package io.github.circles2d.world.device;

import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.joints.JointSetting;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.shared.Call;
import java.util.SplittableRandom;

/** Random calls that add, change and remove joints. Equal worlds and numbers lead to the same calls. */
final class RandomJoints {
    private static final JointSetting[] SETTINGS = JointSetting.values();

    private static final int[] OF_CIRCLES = {
        JointRow.AXIAL | JointRow.RIGID,
        JointRow.AXIAL | JointRow.ELASTIC,
        JointRow.AXIAL,
        JointRow.TURN_SPEED,
        JointRow.ELASTIC | JointRow.TURN_ANGLE,
        JointRow.AXIAL | JointRow.RIGID | JointRow.ACROSS | JointRow.TURN_RIGID
    };

    private static final int[] OF_ANCHORS = {
        JointRow.POINT | JointRow.RIGID,
        JointRow.POINT | JointRow.ELASTIC,
        JointRow.AXIAL | JointRow.RIGID,
        JointRow.AXIAL | JointRow.ELASTIC,
        JointRow.AXIAL
    };

    private static final int[] ALONE = {
        JointRow.TURN_SPEED, JointRow.ELASTIC | JointRow.TURN_ANGLE, JointRow.DRAG | JointRow.TURN_SPEED
    };

    private final Simulation simulation;
    private final SplittableRandom random;
    private final boolean turning;
    private final float width;

    /** Without turning, joints turn no circle. */
    RandomJoints(Simulation simulation, SplittableRandom random, boolean turning) {
        this.simulation = simulation;
        this.random = random;
        this.turning = turning;
        Bounds bounds = simulation.settings().bounds();
        width = bounds.maxX() - bounds.minX();
    }

    /** Makes a call, of which some are refused. Returns whether it was not. */
    boolean change(long circle, long other, long body) {
        try {
            make(circle, other, body);
            return true;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }

    private void make(long circle, long other, long body) {
        long joint = anyJoint();
        switch (random.nextInt(10)) {
            case 0, 1, 2 -> simulation.joints.add(circle, other, form(OF_CIRCLES, turning ? OF_CIRCLES.length : 3));
            case 3, 4 -> {
                boolean ground = body == simulation.bodies.ground();
                float x = ground ? at(simulation.settings().bounds().minX()) : 0.1f * between(-1, 1);
                float y = ground ? at(simulation.settings().bounds().minY()) : 0.1f * between(-1, 1);
                simulation.joints.add(circle, body, x, y, form(OF_ANCHORS, OF_ANCHORS.length));
            }
            case 5 -> {
                if (turning) {
                    simulation.joints.add(circle, form(ALONE, ALONE.length));
                }
            }
            case 6 -> {
                if (joint != 0) {
                    simulation.calls.change(Call.REMOVE_JOINT, joint);
                }
            }
            default -> {
                if (joint != 0) {
                    set(joint);
                }
            }
        }
    }

    private void set(long joint) {
        JointSetting setting = SETTINGS[random.nextInt(SETTINGS.length)];
        switch (setting) {
            case LENGTH -> set(setting, joint, 0.1f * width * between(0, 1), 0);
            case LIMITS -> set(setting, joint, 0.05f * width * between(0, 1), 0.1f * width * between(0, 1));
            case ANCHOR ->
                set(
                        setting,
                        joint,
                        at(simulation.settings().bounds().minX()),
                        at(simulation.settings().bounds().minY()));
            case COLLIDING -> set(setting, joint, random.nextInt(2), 0);
            case BREAKING -> set(setting, joint, between(0, 50), between(0, 5));
            default -> set(setting, joint, between(0, 5), between(0, 2));
        }
    }

    private void set(JointSetting setting, long joint, float a, float b) {
        simulation.calls.change(
                Call.JOINT_SETTING, joint, setting.number, Float.floatToRawIntBits(a), Float.floatToRawIntBits(b));
    }

    private JointForm form(int[] forms, int count) {
        JointForm form = new JointForm(forms[random.nextInt(count)]);
        int traits = form.traits();
        if ((traits & JointRow.ELASTIC) != 0) {
            form.set(JointSetting.SPRING, between(0, 6), between(0, 1.5f));
        }
        if (traits == JointRow.AXIAL) {
            form.set(JointSetting.LIMITS, 0.02f * width, 0.1f * width);
        }
        if (random.nextInt(4) == 0) {
            form.set(JointSetting.BREAKING, between(0, 50), Float.POSITIVE_INFINITY);
        }
        return random.nextInt(3) == 0 ? form.set(JointSetting.COLLIDING, 1, 0) : form;
    }

    private long anyJoint() {
        int ids = simulation.jointIds.limit();
        return ids == 0 ? 0 : simulation.jointIds.handle(random.nextInt(ids));
    }

    private float at(float from) {
        return from + width * between(0, 1);
    }

    private float between(float low, float high) {
        return low + (float) random.nextDouble() * (high - low);
    }
}
