package io.github.circles2d.playground;

import java.util.Locale;
import java.util.Map;

/** A sentence on each stage: what there is to see and to try. */
final class StageNotes {
    private static final Map<String, String> NOTES = Map.ofEntries(
            Map.entry("sandbox", "Two heaps slide down ramps, over a basin that can be moved."),
            Map.entry("hourglass", "Sand runs through a neck. Grab the glass, and turn it with [ and ]."),
            Map.entry("pegs", "Balls fall through a board of nails into bins."),
            Map.entry("marbles", "A few large, lively marbles to throw."),
            Map.entry("crowd", "About ten thousand circles come to rest, and most fall asleep. Blow them up."),
            Map.entry("rest", "A hundred thousand grains sleep, and wake where a ball rolls. Grab it."),
            Map.entry("slopes-and-belts", "Balls roll down a slope, are carried up, and slide down ice."),
            Map.entry("drum", "A half-full drum with paddles turns."),
            Map.entry("bridge", "A bridge of circles and joints carries what rolls onto it."),
            Map.entry("blobs", "Soft rings fall down a stair of pegs."),
            Map.entry("cloth", "A curtain that tears where it is pulled too hard."),
            Map.entry("wrecking-ball", "A heavy ball on a chain swings into a wall of balls."),
            Map.entry("tower", "A heavy ball flies into a pyramid of crates. Draw bodies of your own with D."),
            Map.entry("crates", "Crates in a pit of balls: light ones stay on top, heavy ones sink."),
            Map.entry("dominoes", "A ball topples three rows of dominoes."),
            Map.entry("see-saw", "What falls on one end throws what is on the other."),
            Map.entry("shapes", "Boxes, capsules, stars and angles tumble in a drum."),
            Map.entry("empty", "Nothing: pour, draw and join what you like."),
            Map.entry("thesis", "The test program of the thesis: 1,250 circles fall slowly."),
            Map.entry("packed", "The scene of the thesis with 10,000 smaller circles, as closely packed."),
            Map.entry("gas", "Elastic circles without gravity, whose energy stays."),
            Map.entry("pyramid", "A pyramid of 15 circles falls, and bursts on the floor."),
            Map.entry("barrel", "After Box2D's barrel: 26 columns of 150 circles fall into a box."),
            Map.entry("balls2", "Rapier's balls2: 50 columns of 250 balls collapse."),
            Map.entry("confined", "Rapier's confined: balls without enough room push each other apart."),
            Map.entry("restitution", "Rapier's restitution: from left to right, balls bounce higher."),
            Map.entry("nexus-balls2", "Nexus's balls2: 124 columns of 496 balls fall."),
            Map.entry("bouncy", "After Chipmunk: 500 elastic circles fly apart, without gravity."),
            Map.entry("no-collide", "Chipmunk's no-collide: movers thread between static circles and touch none."),
            Map.entry("billiards", "After dyn4j: a fast cue ball breaks the rack."),
            Map.entry("mixed", "Radii over two decades: large balls among fine grains."),
            Map.entry("one-cell", "A thousand circles that start in one place push each other apart."));

    /** Names in words that do not follow from the short ones. */
    private static final Map<String, String> TITLES = Map.of(
            "thesis", "The thesis's test",
            "balls2", "Rapier's balls",
            "nexus-balls2", "Nexus's balls",
            "no-collide", "No collision",
            "one-cell", "All in one place",
            "crowd", "Ten thousand",
            "rest", "A hundred thousand");

    private StageNotes() {}

    /** The name of a stage in words, such as "Slopes and belts". */
    static String title(String stage) {
        String words = stage.replace('-', ' ');
        return stage.isEmpty() || of(stage).isEmpty()
                ? stage
                : TITLES.getOrDefault(stage, words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1));
    }

    /** The sentence on a stage; the empty string for a world from a file. */
    static String of(String stage) {
        return NOTES.getOrDefault(stage, "");
    }
}
