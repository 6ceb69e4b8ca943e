package io.github.circles2d;

/** What a {@link Joint} is. */
public enum JointType {
    /** Two ends that keep their distance. */
    DISTANCE,

    /** Two ends that a spring holds at a distance; it may have a least and a greatest length, too. */
    SPRING,

    /** Two ends that are free between a least and a greatest length, such as those of a rope. */
    LIMITS,

    /** A circle whose centre stays at an anchor, or is drawn to it by a spring. */
    PIN,

    /** A circle that is to turn at a speed. */
    MOTOR,

    /** A circle that a spring turns to an angle. */
    SERVO,

    /** A circle that something below it slows down, in a world that is seen from above. */
    FRICTION,

    /** Two circles that keep their distance and their angles, as one body. */
    WELD
}
