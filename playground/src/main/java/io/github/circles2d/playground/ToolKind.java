package io.github.circles2d.playground;

/** What the left mouse button does. */
enum ToolKind {
    GRAB("Grab", "pull a circle and throw it"),
    POUR("Pour", "a stream of circles"),
    EXPLODE("Explode", "push away what is near"),
    WALL("Draw", "a line of static circles"),
    ERASE("Erase", "remove circles");

    private final String label;
    private final String purpose;

    ToolKind(String label, String purpose) {
        this.label = label;
        this.purpose = purpose;
    }

    String label() {
        return label;
    }

    String purpose() {
        return purpose;
    }
}
