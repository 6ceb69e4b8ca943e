package io.github.circles2d.demo;

import java.util.Locale;

/** The engines that the demo can show. */
enum EngineKind {
    /** The engine of the thesis. */
    CIRCLES2D {
        @Override
        Engine open(Options options) throws EngineException {
            return Circles2DEngine.open(options);
        }
    },

    /** The engine for games. */
    WORLD {
        @Override
        Engine open(Options options) throws EngineException {
            return WorldEngine.open(options);
        }
    };

    /** Opens it with the scene that the options ask for; the calling thread is the one that uses and closes it. */
    abstract Engine open(Options options) throws EngineException;

    /** The name on the command line. */
    String option() {
        return name().toLowerCase(Locale.ROOT);
    }
}
