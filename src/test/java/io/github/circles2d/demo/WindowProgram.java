package io.github.circles2d.demo;

import java.awt.Component;
import java.awt.Frame;
import java.awt.Robot;
import java.awt.event.WindowEvent;
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
    /** What was seen last where the disc was not lit, so that a failure can be told from a screen that shows nothing. */
    private static String lastOtherColour = "nothing";

    private WindowProgram() {}

    public static void main(String[] arguments) throws Exception {
        AtomicReference<TestEngine> engine = new AtomicReference<>();
        float[][] scene = {{0.5f}, {0.9f}, {0.08f}, {10}};
        SimulationLoop loop = new SimulationLoop(
                () -> {
                    engine.set(new TestEngine(scene));
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

    private static JFrame visibleFrame() throws InterruptedException {
        while (true) {
            for (Frame frame : Frame.getFrames()) {
                if (frame.isShowing()) {
                    return (JFrame) frame;
                }
            }
            Thread.sleep(10);
        }
    }

    /** Waits for what the window does on threads of its own; a machine with other work may take its time. */
    private static boolean becomesTrue(Callable<Boolean> condition) throws Exception {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(30);
        while (!condition.call()) {
            if (System.nanoTime() > deadline) {
                System.out.println("still waiting after 30 s; last seen in place of the disc: " + lastOtherColour);
                return false;
            }
            Thread.sleep(20);
        }
        return true;
    }

    /** Looks at the screen, at the place where the engine's one disc must be. */
    private static boolean isLit(Component content) throws Exception {
        Viewport arena = Viewport.fit(content.getWidth(), content.getHeight(), 1);
        java.awt.Point corner = content.getLocationOnScreen();
        int x = corner.x + (int) arena.x(0.5);
        int y = corner.y + (int) arena.y(0.9);
        Robot robot = new Robot();
        int seen = robot.getPixelColor(x, y).getRGB() & 0xffffff;
        int lit = Palette.ramp(10)[Palette.ramp(10).length - 1];
        if (seen != lit) {
            lastOtherColour = String.format("%06x at %d, %d", seen, x, y);
        }
        return seen == lit;
    }
}
