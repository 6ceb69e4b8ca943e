package com.example.swarm;

import io.github.circles2d.Backend;
import io.github.circles2d.FixedStep;
import java.awt.GraphicsEnvironment;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import javax.imageio.ImageIO;
import javax.swing.SwingUtilities;

/** A window to play in; or with {@code --frames N} a game that plays itself, and one line of what became of it. */
public final class Main {
    private Main() {}

    public static void main(String[] arguments) throws IOException {
        Backend backend = Backend.AUTO;
        int frames = 0;
        String picture = null;
        for (int k = 0; k < arguments.length; k += 2) {
            if (k + 1 == arguments.length) {
                usage();
            }
            switch (arguments[k]) {
                case "--backend" -> backend = Backend.valueOf(arguments[k + 1]);
                case "--frames" -> frames = Integer.parseInt(arguments[k + 1]);
                case "--picture" -> picture = arguments[k + 1];
                default -> usage();
            }
        }
        if (frames > 0) {
            playAlone(backend, frames, picture);
        } else if (GraphicsEnvironment.isHeadless()) {
            System.err.println("There is no display to show a window on. Try --frames 300.");
            System.exit(3);
        } else {
            Swarm game = new Swarm(backend);
            SwingUtilities.invokeLater(() -> new Screen(game).open());
        }
    }

    private static void usage() {
        System.err.println("usage: swarm [--frames N [--picture FILE.png]] [--backend AUTO|JVM|OPENCL_CPU|OPENCL_GPU]");
        System.exit(2);
    }

    private static void playAlone(Backend backend, int frames, String picture) throws IOException {
        try (Swarm game = new Swarm(backend)) {
            FixedStep loop = new FixedStep(game.world, Swarm.TIME_STEP);
            while (game.step() < frames) {
                game.controls.script(game.step());
                loop.advance(Swarm.TIME_STEP, game);
            }
            if (picture != null) {
                BufferedImage image = new BufferedImage(800, 500, BufferedImage.TYPE_INT_RGB);
                new Screen(game).paint(image.createGraphics(), loop, 5);
                ImageIO.write(image, "png", new File(picture));
            }
            System.out.printf(
                    "swarm: %d frames, %d circles, %d points, hash %016x%n",
                    frames, game.world.size(), game.score(), game.world.hash());
        }
    }
}
