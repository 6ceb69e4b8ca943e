package io.github.circles2d.reference;

import java.util.Comparator;

/** What a body that is pushed touches in a step, and how. Numbers are those of its event. */
record RigidTouch(Key key, float[] point, float[] normal, float impulse, float speed) {
    /**
     * A pair.
     *
     * @param sensed whether both only sense each other
     * @param type of the other thing, by {@link RigidThing}
     */
    record Key(boolean sensed, int type, int body, int other) {
        static final Comparator<Key> ORDER = Comparator.comparing(Key::sensed)
                .thenComparingInt(Key::type)
                .thenComparingInt(Key::body)
                .thenComparingInt(Key::other);
    }
}
