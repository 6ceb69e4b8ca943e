package io.github.circles2d;

/**
 * The side of an arc of {@link Terrain} that circles touch.
 *
 * <p><img src="doc-files/terrain-sides.svg" alt="Circles touch a chain from its right, a segment from both sides, an arc from the side that it says, a one-way piece from the front">
 */
public enum ArcSide {
    /** Circles are inside, as in a bowl, a half-pipe or a drum: all outside of the arc is solid. */
    INNER,

    /** Circles are outside, as on a hill or a bumper: the disc is solid. */
    OUTER
}
