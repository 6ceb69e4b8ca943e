package io.github.circles2d;

/** The side of an arc of {@link Terrain} that circles touch. */
public enum ArcSide {
    /** Circles are inside, as in a bowl, a half-pipe or a drum: all outside of the arc is solid. */
    INNER,

    /** Circles are outside, as on a hill or a bumper: the disc is solid. */
    OUTER
}
