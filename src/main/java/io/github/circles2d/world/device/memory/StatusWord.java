package io.github.circles2d.world.device.memory;

/** Ints by which kernels tell the host and each other how a step went. Kernels use the same names. */
public enum StatusWord {
    OUT_OF_ROOM(
            0, "set by a step that lacks room for its contacts or copies of them, or found no way to go on with them"),
    CONTACTS(1, "contacts of the last step, or of one that was out of room"),
    STEPS_DONE(2, "steps written home, since the world was made"),
    FAST(3, "1 where some circle is fast"),
    CROWDED(4, "1 where some circle has so many candidates that pairs are to be thinned out"),
    TILE_PEAK(5, "the fullest tile: percent of the room, or NONE"),
    TILE_NUMBERS(6, "contacts that tiles have numbered"),
    TILE_COPIES(7, "copies of contacts that tiles have made"),
    EVENTS_LACK(8, "1 where the last step waits for room for its events"),
    CARRYING(11, "1 where circles are fast and a static one moves"),
    LONGEST_PATH(12, "then, as bits: the longest path of a circle that is not static"),
    SLEEPERS(13, "1 where some circle sleeps as the step begins"),
    REACHES(14, "a bit for each class of reaches that has fast circles that reach far"),
    RESTLESS(15, "0 if circles sleep, and the next step leaves all as it is unless something else is new"),
    AWAKE(16, "circles that are awake behind the last step, where some may sleep"),
    ARRIVALS(32, "of work-groups at barriers over all of them, in a cache line of its own"),
    DEPARTURES(33, "of work-groups"),
    FOUND(48, "contacts found so far, in no order; away from what every work-item reads"),
    PIECES_FOUND(49, "the same of piece contacts"),
    DRAFTS(50, "events of the step, also those that there is no room for"),
    NEWCOMERS(51, "pairs that begin to touch in the step, likewise"),
    OPEN_HITS(52, "hits that are not complete after the step, likewise"),
    TILES_LISTED(53, "tiles of the list, if there is one, also those that there is no room for"),
    TILES_CUT(54, "1 where some tile of the list is cut"),
    LEAVERS(55, "pairs that end to touch in the step"),
    EVENTS_BEFORE(56, "events that lie before those of the step"),
    KEPT_COUNT(57, "impulses of pairs at rest of the last step, also those that there is no room for"),
    TOUCHING(58, "pairs that touch"),
    PLACES_USED(59, "places of their table that are or have been used"),
    PLACES_BEFORE(60, "the same as the step began"),
    PAIRS_MARKED(61, "pairs of marked circles, also those that there is no room for"),
    JOINTS_BROKEN(62, "joints that have broken, of which the host does not know"),
    WOKEN_COUNT(63, "circles that wake, but for those that others wake");

    /** Ints of the status. */
    static final int WORDS = 64;

    private final int index;
    private final String comment;

    StatusWord(int index, String comment) {
        this.index = index;
        this.comment = comment;
    }

    int index() {
        return index;
    }

    String comment() {
        return comment;
    }
}
