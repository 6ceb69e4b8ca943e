package io.github.circles2d.demo;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.nio.file.Path;

/**
 * What a person asked for on the command line; {@link #defaults} are the thesis's constants.
 *
 * @param circles     number of circles
 * @param packed      whether radii are scaled by sqrt(1250 / circles), so that the circles fill as much of the arena at
 *     every number
 * @param strategy    number of the engine's strategy to start with
 * @param restitution 0 (inelastic) to 1 (elastic)
 * @param gravityX    arena lengths per second squared
 * @param gravityY    the same, up
 * @param device      "best", "gpu", "cpu", a number in the list of devices, or a part of a device's name
 * @param seed        of the random start
 * @param frames      how many frames; 0: until a person quits
 * @param png         the file to write instead of showing a window; null: a window
 * @param size        side of the arena in pixels
 * @param overlay     whether the overlay is on, to start with
 * @param quiet       whether to keep the time of each frame to oneself
 * @param help        whether the usage text was asked for
 */
record Options(
        int circles,
        boolean packed,
        int strategy,
        float restitution,
        float gravityX,
        float gravityY,
        String device,
        long seed,
        int frames,
        Path png,
        int size,
        boolean overlay,
        boolean quiet,
        boolean help) {

    /** The time step of the thesis, seconds a frame. */
    static final float TIME_STEP = 1 / 60f;

    /** Frames of a picture where the command line names no number: long enough for the circles to fall and settle. */
    static final int PICTURE_FRAMES = 600;

    /** The circles to start with. */
    Scene scene() {
        return packed ? Scenes.packed(circles, seed) : Scenes.thesis(circles, seed);
    }

    /**
     * Reads a command line.
     *
     * @throws UsageException at the first argument that is not accepted, with a message that says which and what is
     *     allowed
     */
    static Options parse(String... arguments) throws UsageException {
        return new OptionsParser().parse(arguments);
    }
}
