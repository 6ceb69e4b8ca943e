package io.github.circles2d.reference;

import io.github.circles2d.Joints;
import java.util.List;
import java.util.stream.IntStream;

/** What a joint did in the last step, on its first circle. */
public record JointLoad(long joint, float forceX, float forceY, float torque) {
    /** Those of a world, in the order of the ids of joints. */
    public static List<JointLoad> of(Joints joints) {
        return IntStream.range(0, joints.idLimit())
                .mapToLong(joints::handle)
                .filter(joint -> joint != 0)
                .mapToObj(
                        joint -> new JointLoad(joint, joints.forceX(joint), joints.forceY(joint), joints.torque(joint)))
                .toList();
    }
}
