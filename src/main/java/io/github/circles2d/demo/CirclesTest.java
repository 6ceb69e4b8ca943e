package io.github.circles2d.demo;

import java.io.IOException;
import java.io.PrintStream;
import java.util.Locale;
import java.util.function.DoubleConsumer;

/**
 * The demo: circles fall in the unit square, y up, the brighter the heavier, and each frame prints how long the engine
 * took for it.
 *
 * <p>Without options it is the test program of the thesis: a window of 480 x 480 pixels and a margin of (20, 40), black
 * ground, gravity (0, -0.01), a time step of 1/60 s, 1,250 circles of radius 0.01 to 0.015 and mass 1 to 10 at 0.1 to 0.9
 * in x and y, strategy 2, restitution 0.5, and 17 ms a frame. {@code --help} lists the options and the keys. With {@code
 * --png} it needs no display.
 */
public final class CirclesTest {
    private static final int FAILURE = 1;
    private static final int BAD_USAGE = 2;

    private CirclesTest() {}

    /**
     * Runs the demo. The exit status is 0 where it ran, 1 where it could not (no OpenCL driver, no such device, no
     * display, a device that failed, too little memory), 2 where the command line was not accepted.
     *
     * @param arguments the command line; {@code --help} explains it
     * @throws InterruptedException if the main thread is interrupted while the window is open
     */
    public static void main(String[] arguments) throws InterruptedException {
        int status = run(arguments, System.out, System.err);
        if (status != 0) {
            System.exit(status);
        }
        // Otherwise the JVM ends by itself: the window is gone, the engine closed, the simulation thread over.
    }

    static int run(String[] arguments, PrintStream out, PrintStream err) throws InterruptedException {
        Options options;
        try {
            options = Options.parse(arguments);
        } catch (UsageException e) {
            err.println("circles2d demo: " + e.getMessage());
            err.println("circles2d demo: --help lists the options");
            return BAD_USAGE;
        }
        if (options.help()) {
            out.print(OptionsParser.usage());
            return 0;
        }
        try {
            if (options.png() != null) {
                writePicture(options, out, err);
                return 0;
            }
            return showWindow(options, out, err);
        } catch (EngineException | IOException e) {
            err.println("circles2d demo: " + e.getMessage());
            return FAILURE;
        } catch (OutOfMemoryError e) {
            err.println("circles2d demo: " + options.circles() + " circles need more memory than Java's heap has ("
                    + (Runtime.getRuntime().maxMemory() >> 20) + " MB): take fewer (-n), or a larger heap"
                    + " (export JDK_JAVA_OPTIONS=-Xmx8g)");
            return FAILURE;
        }
    }

    private static void writePicture(Options options, PrintStream out, PrintStream err)
            throws EngineException, IOException {
        System.setProperty("java.awt.headless", "true"); // a display that cannot be reached must not matter
        if (options.overlay() && !Overlay.available()) {
            err.println("circles2d demo: this Java runtime finds no font, so the picture has no overlay;"
                    + " on Debian or Ubuntu: apt-get install fontconfig fonts-dejavu-core");
        }
        int frames = options.frames() == 0 ? Options.PICTURE_FRAMES : options.frames();
        try (Engine engine = Circles2DEngine.open(options)) {
            PictureRun.write(engine, frames, printer(options, out), options.size(), options.overlay(), options.png());
        }
        out.println(options.png() + ": frame " + frames);
    }

    private static int showWindow(Options options, PrintStream out, PrintStream err)
            throws EngineException, InterruptedException {
        String problem = DemoWindow.problem();
        if (!problem.isEmpty()) {
            err.println("circles2d demo: no window can be shown here: " + problem);
            err.println("circles2d demo: without a display, write a picture: --frames 600 --png circles.png");
            return FAILURE;
        }
        SimulationLoop loop = new SimulationLoop(
                () -> Circles2DEngine.open(options),
                options.frames(),
                SimulationLoop.FRAME_NANOS,
                printer(options, out));
        loop.start();
        DemoWindow.show(loop, options.size(), options.overlay());
        loop.join();
        return 0;
    }

    /** Prints the time of each frame, as the test program of the thesis does. */
    private static DoubleConsumer printer(Options options, PrintStream out) {
        return options.quiet() ? millis -> {} : millis -> out.printf(Locale.ROOT, "%.3f ms%n", millis);
    }
}
