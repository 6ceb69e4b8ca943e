package io.github.circles2d.world.events;

/** The events of a number of frames, by place. Memory of a frame that has gone is used for the next at its place. */
public final class KeptEvents {
    private final EventRows[] rows;

    public KeptEvents(int places) {
        rows = new EventRows[places];
        for (int place = 0; place < places; place++) {
            rows[place] = new EventRows();
        }
    }

    /** Moves events to a place, instead of those that are there. The list that had them is empty then. */
    public void keep(int place, EventRows from) {
        rows[place].clear();
        from.moveFrom(0, rows[place]);
    }

    /** The events of a place, valid until others are kept there. */
    public EventRows at(int place) {
        return rows[place];
    }

    public long bytes() {
        long sum = 0;
        for (EventRows list : rows) {
            sum += list.bytes();
        }
        return sum;
    }
}
