package io.github.circles2d.playground;

import io.github.circles2d.opencl.OpenClException;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;

/**
 * A window on a {@link io.github.circles2d.World} to play with: circles are grabbed and thrown, poured, blown up, drawn and erased, in
 * slow motion and back in time, on any back end. {@code --help} lists options, keys and scenes. {@code --picture}, {@code --film}, {@code --gallery},
 * {@code --save} and {@code --link} need no display.
 */
public final class Playground {
    private static final int FAILURE = 1;
    private static final int BAD_USAGE = 2;

    private Playground() {}

    /**
     * Runs the playground. The exit status is 0 if it ran, 1 if it could not (no display, no such device, a file that cannot be
     * written), 2 if the command line was not accepted.
     *
     * @param arguments the command line; {@code --help} explains it
     * @throws InterruptedException if the main thread is interrupted while the window is open
     */
    public static void main(String[] arguments) throws InterruptedException {
        int status = run(arguments, System.out, System.err);
        if (status != 0) {
            System.exit(status);
        }
        // Otherwise the JVM ends by itself: the window is gone, and the thread of the loop has ended.
    }

    static int run(String[] arguments, PrintStream out, PrintStream err) throws InterruptedException {
        PlaygroundOptions options;
        try {
            options = PlaygroundOptions.parse(arguments);
        } catch (PlaygroundOptions.UsageException e) {
            err.println("circles2d play: " + e.getMessage());
            err.println("circles2d play: --help lists the options");
            return BAD_USAGE;
        }
        if (options.help()) {
            out.print(PlaygroundOptions.usage());
            return 0;
        }
        try {
            if (options.writes()) {
                System.setProperty("java.awt.headless", "true"); // a display that cannot be reached must not matter
                writeFiles(options, out);
                return 0;
            }
            return showWindow(options, err);
        } catch (OpenClException | IOException | WorldLink.TooLongException e) {
            err.println("circles2d play: " + FileFailure.reason(e));
            return FAILURE;
        }
    }

    private static void writeFiles(PlaygroundOptions options, PrintStream out) throws IOException {
        if (options.film() != null) {
            out.println(options.film() + ": " + Film.write(options.film()) + " bytes");
        }
        if (options.gallery() != null) {
            Gallery.write(options.gallery());
        }
        if (options.picture() != null) {
            writePicture(options, options.picture());
            out.println(options.picture() + ": " + options.stage().name() + ", frame " + options.frames());
        }
        if (options.save() != null || options.link()) {
            writeWorld(options, out);
        }
    }

    private static void writePicture(PlaygroundOptions options, Path file) throws IOException {
        Frame frame = new Frame();
        try (Session session = afterFrames(options)) {
            session.setPaint(options.paint());
            session.frame(0, frame);
        }
        FileMenu.write(picture(frame, options.width(), options.height()), file);
    }

    private static void writeWorld(PlaygroundOptions options, PrintStream out) throws IOException {
        try (Session session = afterFrames(options)) {
            if (options.save() != null) {
                session.sandbox().save(options.save());
                long hash = session.world().hash();
                String name = options.stage().name();
                out.println(options.save() + ": " + name + ", frame " + options.frames() + ", hash "
                        + String.format("%016x", hash));
            }
            if (options.link()) {
                out.println(options.page() + session.link());
            }
        }
    }

    private static Session afterFrames(PlaygroundOptions options) {
        Session session = new Session(options.stage(), options.backend());
        for (int k = 0; k < options.frames(); k++) {
            session.sandbox().stepOnce(() -> {});
        }
        return session;
    }

    /** All of a frame's arena, without text. */
    static BufferedImage picture(Frame frame, int width, int height) {
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = picture.createGraphics();
        new Painter().paint(g, width, height, Camera.home(frame.arena, width, height), frame);
        g.dispose();
        return picture;
    }

    private static int showWindow(PlaygroundOptions options, PrintStream err) throws InterruptedException {
        String problem = PlaygroundWindow.problem();
        if (!problem.isEmpty()) {
            err.println("circles2d play: no window can be shown here: " + problem);
            err.println("circles2d play: without a display, write a picture: --picture playground.png --frames 300");
            return FAILURE;
        }
        SessionLoop loop = new SessionLoop(() -> {
            Session session = new Session(options.stage(), options.backend());
            session.setPaint(options.paint());
            session.say((StageNotes.of(options.stage().name()) + " H shows the keys.").strip());
            return session;
        });
        loop.start();
        PlaygroundWindow.show(loop, options.width(), options.height(), options.page());
        loop.join();
        return 0;
    }
}
