package io.github.circles2d.demo;

import java.awt.Component;
import java.awt.Frame;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

/**
 * A main class for {@link WindowTest}: shows the window of a test engine, resizes it, closes it as a window manager
 * does, and leaves it to the JVM to end.
 */
final class WindowProgram {
    /** That of the engine's one disc, which lies on the floor, so that it stays there. */
    private static final float RADIUS = 0.08f;

    /** How many frames pass before the window is shown: a busy machine may take seconds for it. */
    private static final int FRAMES_BEFORE = 600;

    /** What was seen last, so that a failure can be told from a screen that shows nothing. */
    private static String lastSeen = "nothing";

    private WindowProgram() {}

    /** Ends the JVM after an exception, which the loop's thread would keep alive for ever. */
    public static void main(String[] arguments) {
        try {
            show();
        } catch (Throwable e) {
            e.printStackTrace();
            System.exit(1);
        }
    }

    private static void show() throws Exception {
        AtomicReference<TestEngine> engine = new AtomicReference<>();
        float[][] scene = {{0.5f}, {RADIUS}, {RADIUS}, {10}};
        SimulationLoop loop = new SimulationLoop(
                () -> {
                    engine.set(new TestEngine(scene));
                    for (int frame = 0; frame < FRAMES_BEFORE; frame++) {
                        engine.get().loop();
                    }
                    return engine.get();
                },
                0,
                SimulationLoop.FRAME_NANOS,
                millis -> {});
        loop.start();
        DemoWindow.show(loop, 480, false);
        JFrame frame = visibleFrame();
        Component content = frame.getContentPane();
        System.out.println("content " + content.getWidth() + " x " + content.getHeight());
        System.out.println("disc is lit: " + becomesTrue(() -> isLit(content)));

        int width = content.getWidth();
        SwingUtilities.invokeAndWait(() -> {
            frame.setSize(frame.getWidth() + 300, frame.getHeight() + 100);
            frame.validate();
        });
        becomesTrue(() -> content.getWidth() != width);
        System.out.println("resized " + content.getWidth() + " x " + content.getHeight());
        System.out.println("disc is lit: " + becomesTrue(() -> isLit(content)));

        frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING));
        loop.join();
        System.out.println(
                "closes " + engine.get().closes + ", on the event thread: " + engine.get().calledOnEventThread);
        System.out.println("main ends");
    }

    /** The window, on the event thread: before that has made it, it can be seen half made. */
    private static JFrame visibleFrame() throws Exception {
        AtomicReference<JFrame> frame = new AtomicReference<>();
        SwingUtilities.invokeAndWait(() -> frame.set((JFrame) Frame.getFrames()[0]));
        return frame.get();
    }

    /** Waits for what the window does on threads of its own; a machine with other work may take its time. */
    private static boolean becomesTrue(Callable<Boolean> condition) throws Exception {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(30);
        while (!condition.call()) {
            if (System.nanoTime() > deadline) {
                System.out.println("still waiting after 30 s; last seen: " + lastSeen);
                return false;
            }
            Thread.sleep(20);
        }
        return true;
    }

    /**
     * Counts the pixels of the colour that fills the engine's one disc, which must be as many as a disc of its size has. It
     * looks at the whole screen, because without a window manager Java may name a wrong place for the window.
     */
    private static boolean isLit(Component content) throws Exception {
        Rectangle screen = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
        BufferedImage picture = new Robot().createScreenCapture(screen);
        int[] colours = picture.getRGB(0, 0, screen.width, screen.height, null, 0, screen.width);
        int[] ramp = Palette.ramp(10);
        int lit = ramp[ramp.length - 1];
        long pixels =
                Arrays.stream(colours).filter(rgb -> (rgb & 0xffffff) == lit).count();
        double radius = RADIUS
                * Viewport.fit(content.getWidth(), content.getHeight(), 1).side();
        lastSeen = pixels + " pixels where a disc of radius " + radius
                + " should be, of a window that takes its place for " + content.getLocationOnScreen();
        double rim = 3;
        return pixels > Math.PI * (radius - rim) * (radius - rim) && pixels < Math.PI * radius * radius;
    }
}
