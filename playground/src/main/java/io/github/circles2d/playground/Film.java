package io.github.circles2d.playground;

import io.github.circles2d.Backend;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** The short film of the README: circles are poured into a basin, and blown up, twice. Then it begins again. */
final class Film {
    private static final int WIDTH = 864;
    private static final int HEIGHT = 540;

    /** Steps of a frame; the film runs as fast as the world. */
    private static final int STEPS = 4;

    private static final int FRAMES_A_SECOND = 60 / STEPS;
    private static final int FRAMES = 6 * FRAMES_A_SECOND;
    private static final int POURED = FRAMES * 55 / 100;
    private static final int[] BLASTS = {FRAMES * 64 / 100, FRAMES * 80 / 100};
    private static final float[][] PLACES = {{64, 4}, {106, 2}};

    private Film() {}

    /** Writes the film, and tells how many bytes it has. */
    static long write(Path file) throws IOException {
        BufferedImage[] pictures = render();
        try (OutputStream out = Files.newOutputStream(file)) {
            new ApngWriter(WIDTH, HEIGHT, FRAMES_A_SECOND).write(pictures, out);
        }
        return Files.size(file);
    }

    private static BufferedImage[] render() {
        BufferedImage[] pictures = new BufferedImage[FRAMES];
        Frame frame = new Frame();
        try (Session session = new Session(Stages.named("sandbox"), Backend.JVM)) {
            for (int k = 0; k < FRAMES; k++) {
                act(session, k);
                for (int step = 0; step < STEPS; step++) {
                    session.frame(Sandbox.TIME_STEP, frame);
                }
                pictures[k] = Playground.picture(frame, WIDTH, HEIGHT);
            }
        }
        return pictures;
    }

    private static void act(Session session, int k) {
        if (k < POURED) {
            double sway = Math.sin(k * 0.09);
            session.moveMouse((float) (78 + 20 * sway), 90);
        }
        if (k == 0 || k == POURED) {
            session.pour(k == 0);
        }
        for (int blast = 0; blast < BLASTS.length; blast++) {
            if (k == BLASTS[blast]) {
                session.moveMouse(PLACES[blast][0], PLACES[blast][1]);
                session.explode();
            }
        }
    }
}
