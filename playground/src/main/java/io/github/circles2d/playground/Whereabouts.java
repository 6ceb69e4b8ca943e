package io.github.circles2d.playground;

import io.github.circles2d.Backend;
import io.github.circles2d.WorldStats;

/** Tells where a world runs that may move, and that it has moved. */
final class Whereabouts {
    private int moves;
    private double millis;

    /** Another world has come. */
    void start(WorldStats world) {
        moves = world.moves();
        millis = world.moveMillis();
    }

    /** What there is to say if the world has moved since; empty if it has not. */
    String news(WorldStats world) {
        if (world.moves() == moves) {
            return "";
        }
        String text = Figures.format(
                "the world goes on on %s; the move took %.1f ms: %s",
                world.backend(), world.moveMillis() - millis, world.reason());
        start(world);
        return text;
    }

    /** A few words: the back end that was asked for, and where the world is, if that does not say it. */
    static String words(Backend asked, Backend now) {
        return asked == now ? now.toString() : asked + " on " + (now == Backend.JVM ? "JVM" : "GPU");
    }
}
