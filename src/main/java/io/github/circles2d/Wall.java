package io.github.circles2d;

/** The four walls of a world; see {@link World#setWallSurface}. An axis that is open or wraps has none. */
public enum Wall {
    /** The left one, at the least x. */
    MIN_X,

    /** The right one, at the greatest x. */
    MAX_X,

    /** The lower one, at the least y. */
    MIN_Y,

    /** The upper one, at the greatest y. */
    MAX_Y
}
