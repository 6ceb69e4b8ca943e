package io.github.circles2d;

import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.shared.Pipeline;

/**
 * What a world runs on, and why. It touches no class of OpenCL until a device may be taken, so World runs where there are none.
 *
 * @param backend the back end, never {@link Backend#AUTO}
 * @param pipeline the engine
 * @param reason why it was taken
 * @param running where it runs later; null if it stays
 */
record BackendChoice(Backend backend, Pipeline pipeline, String reason, RunningChoice running) {
    static final String ASKED_FOR = "asked for";

    /** Takes what is asked for, or the fastest that is there. */
    static BackendChoice of(BackendWish wish) {
        BackendChoice choice = wish.device == null && wish.backend == Backend.AUTO
                ? fastest(wish)
                : wish.device == null && wish.backend == Backend.JVM
                        ? jvm(wish, ASKED_FOR)
                        : OpenClChoice.askedFor(wish);
        Notice.debug("World on " + choice.backend + ", " + choice.pipeline.device() + ": " + choice.reason);
        return choice;
    }

    private static BackendChoice fastest(BackendWish wish) {
        try {
            return wish.moves() ? OpenClChoice.moving(wish) : OpenClChoice.fastest(wish);
        } catch (LinkageError e) {
            return jvm(wish, "this system lacks a class that looks for devices: " + e.getMessage());
        }
    }

    BackendChoice(Backend backend, Pipeline pipeline, String reason) {
        this(backend, pipeline, reason, null);
    }

    static BackendChoice jvm(BackendWish wish, String reason) {
        return new BackendChoice(Backend.JVM, jvm(wish), reason);
    }

    static Pipeline jvm(BackendWish wish) {
        return new JvmPipeline(wish.threads, JvmPipeline.LEAST_SHARE, wish.capacity, wish.profiling);
    }
}
