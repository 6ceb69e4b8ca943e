package io.github.circles2d.demo;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.DoubleConsumer;
import javax.imageio.ImageIO;

/** Runs a simulation without a display, as fast as it goes, and writes its last frame as a PNG file. */
final class PictureRun {
    private PictureRun() {}

    /**
     * @param size    side of the arena in pixels
     * @param frames  how many frames to compute first
     * @param overlay whether to draw the overlay; left out where the runtime has no font
     */
    static void write(Engine engine, long frames, DoubleConsumer loopTimes, int size, boolean overlay, Path file)
            throws EngineException, IOException {
        DemoRun simulation = new DemoRun(engine, System::nanoTime, loopTimes);
        while (simulation.computed() < frames) {
            simulation.advance();
        }
        BufferedImage picture = new DemoPainter()
                .picture(
                        size + Viewport.MARGIN_X,
                        size + Viewport.MARGIN_Y,
                        simulation.frame(),
                        overlay && Overlay.available());
        if (!ImageIO.write(picture, "png", file.toFile())) {
            throw new IOException("this Java runtime cannot write PNG files");
        }
    }
}
