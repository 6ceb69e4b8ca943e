package io.github.circles2d.playground;

import io.github.circles2d.Backend;
import java.awt.Component;
import java.awt.Container;
import java.awt.Image;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.datatransfer.DataFlavor;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;

/**
 * A main class for {@link PlaygroundWindowTest}: opens the real window, uses mouse and keys as a person does, and prints what came of
 * it. With a folder as its argument it saves the screen at each turn.
 */
final class WindowProgram {
    private static final long PATIENCE = TimeUnit.SECONDS.toNanos(30);

    private final Path folder;
    private SessionLoop loop;
    private JFrame window;
    private PlaygroundCanvas canvas;

    private WindowProgram(Path folder) {
        this.folder = folder;
    }

    /** Ends the JVM after an exception, which other threads would keep alive for ever. */
    public static void main(String[] arguments) {
        try {
            new WindowProgram(arguments.length == 0 ? null : Path.of(arguments[0])).run();
        } catch (Throwable e) {
            e.printStackTrace();
            System.exit(1);
        }
    }

    private void run() throws Exception {
        if (folder != null) {
            Files.createDirectories(folder);
        }
        loop = new SessionLoop(() -> new Session(Stages.named("sandbox"), Backend.JVM));
        loop.start();
        PlaygroundWindow.show(loop, 1100, 700, "https://example.org/");
        SwingUtilities.invokeAndWait(() -> window = (JFrame) java.awt.Frame.getFrames()[0]);
        canvas = (PlaygroundCanvas) find(window.getContentPane(), PlaygroundCanvas.class);
        say("circles are lit", becomesTrue(this::isLit));
        save("1-start");
        time();
        grab();
        pour();
        explode();
        switchBackends();
        drawAndErase();
        slide();
        look();
        copy();
        saveTheRest();
        window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING));
        loop.join();
        System.out.println("main ends");
    }

    private void time() throws Exception {
        say("time runs", becomesTrue(() -> ask(s -> s.sandbox().step()) > 60));
        key(KeyEvent.VK_SPACE);
        int paused = ask(s -> s.sandbox().step());
        long hash = ask(s -> s.world().hash());
        Thread.sleep(100);
        say("a pause stops it", ask(s -> s.sandbox().step()) == paused);
        key(KeyEvent.VK_PERIOD);
        say("a step is one step", ask(s -> s.sandbox().step()) == paused + 1);
        key(KeyEvent.VK_COMMA);
        say("a step back is the state of before", ask(s -> s.world().hash()) == hash);
        press(KeyEvent.VK_B);
        say("time runs backwards", becomesTrue(() -> ask(s -> s.sandbox().step()) < paused - 30));
        save("2-back-in-time");
        release(KeyEvent.VK_B);
        key(KeyEvent.VK_S);
        key(KeyEvent.VK_SPACE);
        say(
                "a rewound world comes to the same state",
                becomesTrue(() -> ask(s -> s.sandbox().step()) >= paused));
        key(KeyEvent.VK_S);
        key(KeyEvent.VK_S);
        key(KeyEvent.VK_S);
        key(KeyEvent.VK_S);
    }

    private void grab() throws Exception {
        long ball = ask(s ->
                s.world().queries().pick(120, s.world().y(s.world().queries().pick(120, 6))));
        float x = ask(s -> s.world().x(ball));
        float y = ask(s -> s.world().y(ball));
        mouse(MouseEvent.MOUSE_PRESSED, x, y);
        mouse(MouseEvent.MOUSE_DRAGGED, x, y + 25);
        say("a circle comes along", becomesTrue(() -> ask(s -> s.world().y(ball)) > y + 15));
        save("3-grabbed");
        mouse(MouseEvent.MOUSE_RELEASED, x, y + 25);
        say("and falls when it is let go", becomesTrue(() -> ask(s -> s.world().y(ball)) < y + 5));
    }

    private void pour() throws Exception {
        int before = ask(s -> s.world().size());
        mouse(MouseEvent.MOUSE_MOVED, 90, 90);
        press(KeyEvent.VK_F);
        say("a key pours circles", becomesTrue(() -> ask(s -> s.world().size()) > before + 300));
        save("4-pouring");
        release(KeyEvent.VK_F);
        becomesTrue(() -> ask(s -> s.held() == 0));
        Thread.sleep(200);
        int after = ask(s -> s.world().size());
        Thread.sleep(200);
        say("and no more when it is up", ask(s -> s.world().size()) == after);
    }

    private void explode() throws Exception {
        key(KeyEvent.VK_SPACE);
        double before = energy();
        mouse(MouseEvent.MOUSE_MOVED, 62, 6);
        key(KeyEvent.VK_X);
        say("an explosion gives energy", becomesTrue(() -> energy() > before));
        key(KeyEvent.VK_SPACE);
        Thread.sleep(150);
        save("5-explosion");
    }

    private double energy() throws Exception {
        Frame frame = new Frame();
        return ask(s -> {
            s.frame(0, frame);
            return frame.energy;
        });
    }

    private void switchBackends() throws Exception {
        key(KeyEvent.VK_SPACE);
        long hash = ask(s -> s.world().hash());
        Backend first = ask(s -> s.sandbox().stats().backend());
        boolean others =
                new BackendSwitch(loop).has(Backend.OPENCL_CPU) || new BackendSwitch(loop).has(Backend.OPENCL_GPU);
        key(KeyEvent.VK_N);
        say(
                "another back end comes",
                becomesTrue(() -> ask(s -> s.sandbox().stats().backend()) != first == others));
        say("with the same hash", ask(s -> s.world().hash()) == hash);
        save("6-back-end");
        key(KeyEvent.VK_SPACE);
        int step = ask(s -> s.sandbox().step());
        say("and goes on", becomesTrue(() -> ask(s -> s.sandbox().step()) > step + 5));
        ask(s -> {
            s.switchTo(Backend.JVM);
            return 0;
        });
    }

    private void drawAndErase() throws Exception {
        key(KeyEvent.VK_4);
        int before = ask(s -> s.world().terrain().size());
        mouse(MouseEvent.MOUSE_PRESSED, 20, 40);
        for (int x = 22; x <= 50; x += 2) {
            mouse(MouseEvent.MOUSE_DRAGGED, x, 40 - (x - 20) / 3);
        }
        mouse(MouseEvent.MOUSE_RELEASED, 50, 30);
        say("a wall is drawn", becomesTrue(() -> ask(s -> s.world().terrain().size()) > before + 10));
        key(KeyEvent.VK_5);
        int drawn = ask(s -> s.world().terrain().size());
        mouse(MouseEvent.MOUSE_PRESSED, 20, 40);
        mouse(MouseEvent.MOUSE_DRAGGED, 36, 35);
        save("7-erasing");
        mouse(MouseEvent.MOUSE_RELEASED, 36, 35);
        say("and erased", becomesTrue(() -> ask(s -> s.world().terrain().size()) < drawn - 5));
        key(KeyEvent.VK_1);
    }

    private void slide() throws Exception {
        FlatSlider slider = slider("of walls and of circles that are no belts");
        say("nothing turns at first", !onEventThread(this::isMarked));
        for (int type : new int[] {MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_DRAGGED, MouseEvent.MOUSE_RELEASED}) {
            int x = slider.getWidth() * (type == MouseEvent.MOUSE_PRESSED ? 1 : 2) / 4;
            SwingUtilities.invokeAndWait(() -> slider.dispatchEvent(
                    new MouseEvent(slider, type, 0, InputEvent.BUTTON1_DOWN_MASK, x, 9, 1, false, MouseEvent.BUTTON1)));
        }
        say("a slider sets friction", ask(s -> s.sandbox().friction()) == 0.5f);
        say("and circles show how they have turned", becomesTrue(() -> onEventThread(this::isMarked)));
        save("8-friction");
    }

    private boolean isMarked() {
        Frame newest = loop.latest();
        for (int k = 0; k < newest.circles; k++) {
            if (newest.angle[k] == newest.angle[k]) {
                return true;
            }
        }
        return false;
    }

    private void look() throws Exception {
        double scale = onEventThread(() -> canvas.camera().scale());
        for (int k = 0; k < 8; k++) {
            wheel(62, 10);
        }
        say("the wheel zooms in", onEventThread(() -> canvas.camera().scale()) > 2 * scale);
        save("8-zoomed");
        double x = onEventThread(() -> canvas.camera().x());
        drag(MouseEvent.MOUSE_PRESSED, 400);
        drag(MouseEvent.MOUSE_DRAGGED, 300);
        drag(MouseEvent.MOUSE_RELEASED, 300);
        say(
                "the right button moves the picture",
                onEventThread(() -> canvas.camera().x()) > x);
        key(KeyEvent.VK_HOME);
        say("home shows all", onEventThread(() -> canvas.camera().scale()) == scale);
    }

    private void copy() throws Exception {
        SwingUtilities.invokeAndWait(
                () -> window.getJMenuBar().getMenu(0).getItem(5).doClick());
        ask(s -> 0); // the session has copied it
        Image picture = (Image) Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.imageFlavor);
        say("a picture is in the clipboard", picture.getWidth(null) == canvas.getWidth());
        ask(s -> {
            s.load(Stages.named("marbles"));
            return 0;
        });
        SwingUtilities.invokeAndWait(
                () -> window.getJMenuBar().getMenu(0).getItem(2).doClick());
        ask(s -> 0); // the session has copied it
        Object link = Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor);
        say("a link is in the clipboard", link.toString().startsWith("https://example.org/#world="));
    }

    private void saveTheRest() throws Exception {
        if (folder == null) {
            return;
        }
        key(KeyEvent.VK_C);
        Thread.sleep(500);
        save("9-pressure");
        key(KeyEvent.VK_C);
        Thread.sleep(300);
        save("10-contacts");
        key(KeyEvent.VK_V);
        Thread.sleep(500);
        save("10-contact-points");
        key(KeyEvent.VK_V);
        key(KeyEvent.VK_H);
        Thread.sleep(300);
        save("11-help");
        key(KeyEvent.VK_H);
        for (int menu = 0; menu < window.getJMenuBar().getMenuCount(); menu++) {
            JMenu opened = window.getJMenuBar().getMenu(menu);
            SwingUtilities.invokeAndWait(opened::doClick);
            Thread.sleep(300);
            save("12-menu-" + menu);
            SwingUtilities.invokeAndWait(
                    () -> MenuSelectionManager.defaultManager().clearSelectedPath());
        }
        SwingUtilities.invokeLater(
                () -> window.getJMenuBar().getMenu(0).getItem(1).doClick());
        Thread.sleep(1000);
        save("14-dialog");
        SwingUtilities.invokeAndWait(() -> {
            for (Window other : Window.getWindows()) {
                if (other != window) {
                    other.dispose();
                }
            }
        });
        ask(s -> {
            s.load(Stages.named("crowd"));
            return 0;
        });
        Thread.sleep(4000);
        save("13-crowd");
    }

    // ---- what a person does

    private void mouse(int type, float worldX, float worldY) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            int x = (int) Math.round(canvas.camera().screenX(worldX, canvas.getWidth()));
            int y = (int) Math.round(canvas.camera().screenY(worldY, canvas.getHeight()));
            int down = type == MouseEvent.MOUSE_MOVED ? 0 : InputEvent.BUTTON1_DOWN_MASK;
            int button = type == MouseEvent.MOUSE_MOVED ? MouseEvent.NOBUTTON : MouseEvent.BUTTON1;
            canvas.dispatchEvent(
                    new MouseEvent(canvas, type, System.currentTimeMillis(), down, x, y, 1, false, button));
        });
        Thread.sleep(50);
    }

    /** With the right button. */
    private void drag(int type, int x) throws Exception {
        SwingUtilities.invokeAndWait(() -> canvas.dispatchEvent(
                new MouseEvent(canvas, type, 0, InputEvent.BUTTON3_DOWN_MASK, x, 300, 1, false, MouseEvent.BUTTON3)));
    }

    private void wheel(float worldX, float worldY) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            int x = (int) Math.round(canvas.camera().screenX(worldX, canvas.getWidth()));
            int y = (int) Math.round(canvas.camera().screenY(worldY, canvas.getHeight()));
            canvas.dispatchEvent(new MouseWheelEvent(
                    canvas, MouseEvent.MOUSE_WHEEL, 0, 0, x, y, 0, false, MouseWheelEvent.WHEEL_UNIT_SCROLL, 1, -1));
        });
    }

    private void key(int code) throws Exception {
        press(code);
        release(code);
        ask(s -> 0); // the session has seen it
    }

    private void press(int code) throws Exception {
        send(KeyEvent.KEY_PRESSED, code);
    }

    private void release(int code) throws Exception {
        send(KeyEvent.KEY_RELEASED, code);
    }

    /** To the component, since without a window manager the window may not have the keyboard. */
    private void send(int type, int code) throws Exception {
        SwingUtilities.invokeAndWait(() -> KeyboardFocusManager.getCurrentKeyboardFocusManager()
                .redispatchEvent(
                        canvas,
                        new KeyEvent(canvas, type, System.currentTimeMillis(), 0, code, KeyEvent.CHAR_UNDEFINED)));
    }

    // ---- what comes of it

    private <T> T ask(Function<Session, T> question) throws Exception {
        CompletableFuture<T> answer = new CompletableFuture<>();
        loop.ask(session -> {
            try {
                answer.complete(question.apply(session));
            } catch (RuntimeException e) {
                answer.completeExceptionally(e);
            }
        });
        return answer.get(30, TimeUnit.SECONDS);
    }

    private static <T> T onEventThread(Callable<T> question) throws Exception {
        CompletableFuture<T> answer = new CompletableFuture<>();
        SwingUtilities.invokeAndWait(() -> {
            try {
                answer.complete(question.call());
            } catch (Exception e) {
                answer.completeExceptionally(e);
            }
        });
        return answer.get();
    }

    private static void say(String what, boolean holds) {
        System.out.println(what + ": " + holds);
    }

    private static boolean becomesTrue(Callable<Boolean> condition) throws Exception {
        long deadline = System.nanoTime() + PATIENCE;
        while (!condition.call()) {
            if (System.nanoTime() > deadline) {
                return false;
            }
            Thread.sleep(20);
        }
        return true;
    }

    /** Many pixels have the colour of static circles: those of the ramps. */
    private boolean isLit() throws Exception {
        int lit = 0;
        BufferedImage screen = screen();
        for (int rgb : screen.getRGB(0, 0, screen.getWidth(), screen.getHeight(), null, 0, screen.getWidth())) {
            lit += (rgb & 0xffffff) == Theme.STATIC ? 1 : 0;
        }
        return lit > 1000;
    }

    private static BufferedImage screen() throws Exception {
        return new Robot()
                .createScreenCapture(new Rectangle(Toolkit.getDefaultToolkit().getScreenSize()));
    }

    private void save(String name) throws Exception {
        if (folder != null) {
            Thread.sleep(100);
            FileMenu.write(screen(), folder.resolve(name + ".png"));
        }
    }

    /** The slider with that tip. */
    private FlatSlider slider(String tip) {
        for (Component part : ((Container) find(window.getContentPane(), Bar.class)).getComponents()) {
            if (part instanceof FlatSlider slider && tip.equals(slider.getToolTipText())) {
                return slider;
            }
        }
        throw new IllegalStateException("there is no slider with the tip " + tip);
    }

    private static Component find(Container container, Class<?> type) {
        ArrayDeque<Component> open = new ArrayDeque<>();
        open.add(container);
        while (!open.isEmpty()) {
            Component next = open.poll();
            if (type.isInstance(next)) {
                return next;
            }
            if (next instanceof Container inner) {
                open.addAll(List.of(inner.getComponents()));
            }
        }
        throw new IllegalStateException("there is no " + type);
    }
}
