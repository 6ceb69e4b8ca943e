package io.github.circles2d.playground;

/** What the left mouse button does. */
enum ToolKind {
    GRAB("Grab", "pull a circle and throw it"),
    POUR("Pour", "a stream of circles"),
    EXPLODE("Explode", "push away what is near"),
    WALL("Draw", "a wall along the way of the mouse"),
    ERASE("Erase", "remove circles and terrain"),
    LINE("Line", "a straight wall"),
    ARC("Arc", "half a pipe: to the right a bowl, to the left a roof"),
    CHAIN("Chain", "ground that is smooth: drawn to the left it carries circles"),
    CUT("Cut", "remove joints"),
    ROPE("Rope", "a rope between circles, terrain or places"),
    SPRING("Spring", "a spring between circles, terrain or places"),
    PIN("Pin", "hold a circle where it is"),
    BODY("Body", "a closed shape, which falls");

    private static final String KEYS = "123456789JKLD";

    private final String label;
    private final String purpose;

    ToolKind(String label, String purpose) {
        this.label = label;
        this.purpose = purpose;
    }

    /** What takes the tool. */
    String key() {
        return KEYS.substring(ordinal(), ordinal() + 1);
    }

    String label() {
        return label;
    }

    String purpose() {
        return purpose;
    }
}
