package io.github.circles2d.reference;

import io.github.circles2d.JointEvents;
import java.util.ArrayList;
import java.util.List;

/** A joint that went by itself; without another circle, that is 0. */
public record JointEvent(long joint, long circle, long other, float force, float torque, JointEvents.Reason reason) {
    /** The events of a world. */
    public static List<JointEvent> of(JointEvents events) {
        List<JointEvent> list = new ArrayList<>();
        for (int i = 0; i < events.size(); i++) {
            list.add(new JointEvent(
                    events.joint(i),
                    events.circle(i),
                    events.other(i),
                    events.force(i),
                    events.torque(i),
                    events.reason(i)));
        }
        return list;
    }
}
