package io.github.circles2d;

/** How the mass of a circle lies in it, which decides how hard it is to turn; see {@link Kind#setInertia}. */
public enum Inertia {
    /** Evenly, as in a coin: the inertia is m r^2 / 2. A ball, with 2/5 m r^2, is nearest to this. */
    DISC,

    /** At the edge, as in a hoop: the inertia is m r^2. */
    RING,

    /**
     * As if it were infinite: no contact, torque or angular impulse turns the circle, so friction holds it as it holds a box. It turns only
     * by the angular velocity that is set for it. As a motor it keeps that, whatever it drives; {@link Kind#setAngularDamping} slows it.
     */
    NONE
}
