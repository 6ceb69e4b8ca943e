package io.github.circles2d.reference;

import io.github.circles2d.BodyEvents;
import io.github.circles2d.Wall;
import java.util.ArrayList;
import java.util.List;

/** A touch of a body that is pushed has begun or ended. A wall has the handle 0; an end has no numbers. */
public record RigidEvent(
        boolean begin,
        long body,
        BodyEvents.Partner partner,
        long other,
        Wall wall,
        float x,
        float y,
        float normalX,
        float normalY,
        float impulse,
        float speed) {
    /** The events of a world. */
    public static List<RigidEvent> of(BodyEvents events) {
        List<RigidEvent> list = new ArrayList<>();
        for (int i = 0; i < events.size(); i++) {
            list.add(new RigidEvent(
                    events.isBegin(i),
                    events.body(i),
                    events.partner(i),
                    events.other(i),
                    events.wall(i),
                    events.x(i),
                    events.y(i),
                    events.normalX(i),
                    events.normalY(i),
                    events.impulse(i),
                    events.speed(i)));
        }
        return list;
    }
}
