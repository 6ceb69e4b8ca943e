package io.github.circles2d;

import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.shared.Pipeline;

/**
 * What a world runs on, and why. It touches no class of OpenCL until a device may be taken, so World runs where there are none.
 *
 * @param backend the back end, never {@link Backend#AUTO}
 * @param pipeline the engine
 * @param reason why it was taken
 * @param lacksGpu whether the builder's capacity asks for a GPU, and none can be used
 * @param running where it runs later; null if it stays
 */
record BackendChoice(Backend backend, Pipeline pipeline, String reason, boolean lacksGpu, RunningChoice running) {
    static final String ASKED_FOR = "asked for";

    /** Takes what is asked for, or the fastest that is there. */
    static BackendChoice of(BackendWish wish) {
        BackendChoice choice = wish.device == null && wish.backend == Backend.AUTO
                ? fastest(wish)
                : wish.device == null && wish.backend == Backend.JVM
                        ? jvm(wish, ASKED_FOR)
                        : OpenClChoice.askedFor(wish);
        String device = choice.pipeline.device();
        String text = "World on " + choice.backend + ", " + device + ": " + choice.reason;
        if (choice.lacksGpu) {
            Notice.once(choice.backend + device, text);
        } else {
            Notice.debug(text);
        }
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
        this(backend, pipeline, reason, false, null);
    }

    static BackendChoice jvm(BackendWish wish, String reason) {
        return jvm(wish, reason, false);
    }

    static BackendChoice jvm(BackendWish wish, String reason, boolean lacksGpu) {
        return new BackendChoice(Backend.JVM, jvm(wish), reason, lacksGpu, null);
    }

    static Pipeline jvm(BackendWish wish) {
        return new JvmPipeline(wish.threads, JvmPipeline.LEAST_SHARE, wish.capacity, wish.profiling);
    }
}
