package io.github.circles2d.reference;

import io.github.circles2d.Events;
import java.util.ArrayList;
import java.util.List;

/** An event. The side is the number of the wall, or -1; a wall and a piece have the handle 0, and what is no piece has the piece 0. */
public record Event(
        int step,
        int type,
        long a,
        long b,
        int side,
        long piece,
        float speed,
        float slipSpeed,
        float impulse,
        float x,
        float y,
        float normalX,
        float normalY) {
    /** The same in a step. */
    Event at(int number) {
        return new Event(number, type, a, b, side, piece, speed, slipSpeed, impulse, x, y, normalX, normalY);
    }

    /** The events of a world. */
    public static List<Event> of(Events events) {
        List<Event> list = new ArrayList<>();
        for (int i = 0; i < events.size(); i++) {
            list.add(new Event(
                    events.step(i),
                    events.type(i),
                    events.a(i),
                    events.b(i),
                    events.side(i) == null ? -1 : events.side(i).ordinal(),
                    events.piece(i),
                    events.speed(i),
                    events.slipSpeed(i),
                    events.impulse(i),
                    events.x(i),
                    events.y(i),
                    events.normalX(i),
                    events.normalY(i)));
        }
        return list;
    }
}
