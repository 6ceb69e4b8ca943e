package io.github.circles2d.world.model;

/** What a pipeline must be ready for; worlds that do without pay nothing. */
public record Features(boolean edges, boolean turning, boolean terrain, boolean joints) {
    /** A walled world of circles that do not turn. */
    public static final Features NONE = new Features(false, false, false, false);

    /** Both together. */
    public Features and(Features other) {
        return new Features(
                edges || other.edges, turning || other.turning, terrain || other.terrain, joints || other.joints);
    }
}
