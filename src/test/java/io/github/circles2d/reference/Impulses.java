package io.github.circles2d.reference;

/**
 * The impulses with which a contact ended a step.
 *
 * @param normal along the normal
 * @param friction along the tangent
 * @param rolling angular, against rolling
 */
record Impulses(float normal, float friction, float rolling) {
    /** Those of circles that did not press. */
    static final Impulses NONE = new Impulses(0f, 0f, 0f);

    Impulses times(float factor) {
        return new Impulses(normal * factor, friction * factor, rolling * factor);
    }
}
