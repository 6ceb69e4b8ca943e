package io.github.circles2d.playground;

import io.github.circles2d.Backend;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.event.WindowEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;

/**
 * A main class for {@link PlaygroundSizesTest}: opens the real window in several sizes and prints whether all of it has its place. With
 * a folder as its argument it saves the screen at each turn.
 */
final class SizesProgram {
    private static final List<Dimension> SIZES = List.of(
            new Dimension(420, 320), new Dimension(600, 700), new Dimension(1000, 800), new Dimension(1600, 1000));

    private static final String MESSAGE =
            "a message of some length, as that of a back end that goes on with the same hash";

    private final Path folder;
    private SessionLoop loop;
    private JFrame window;
    private PlaygroundCanvas canvas;
    private Bar bar;

    private SizesProgram(Path folder) {
        this.folder = folder;
    }

    public static void main(String[] arguments) {
        try {
            new SizesProgram(arguments.length == 0 ? null : Path.of(arguments[0])).run();
        } catch (Throwable e) {
            e.printStackTrace();
            System.exit(1);
        }
    }

    private void run() throws Exception {
        if (folder != null) {
            Files.createDirectories(folder);
        }
        loop = new SessionLoop(() -> new Session(Stages.named("pegs"), Backend.JVM));
        loop.start();
        PlaygroundWindow.show(loop, 1000, 700, "");
        SwingUtilities.invokeAndWait(() -> window = (JFrame) java.awt.Frame.getFrames()[0]);
        canvas = (PlaygroundCanvas) find(PlaygroundCanvas.class);
        bar = (Bar) find(Bar.class);
        for (Dimension size : SIZES) {
            show(size);
        }
        menus();
        window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING));
        loop.join();
        System.out.println("main ends");
    }

    private Component find(Class<?> type) {
        for (Component part : window.getContentPane().getComponents()) {
            if (type.isInstance(part)) {
                return part;
            }
        }
        throw new IllegalStateException("there is no " + type);
    }

    private void show(Dimension size) throws Exception {
        String name = size.width + " x " + size.height;
        SwingUtilities.invokeAndWait(() -> {
            window.setBounds(0, 0, size.width, size.height);
            window.validate();
        });
        loop.ask(SizesProgram::select);
        becomesShown(MESSAGE);
        say(name + ", the window has its size", onEventThread(() -> window.getSize()
                .equals(size)));
        say(name + ", all buttons are in the bar", onEventThread(this::areButtonsInTheBar));
        say(name + ", no button is over another", onEventThread(() -> apart(bounds(bar))));
        say(
                name + ", bar and canvas are in the window",
                onEventThread(() -> apart(List.of(bar.getBounds(), canvas.getBounds()))
                        && new Rectangle(window.getContentPane().getSize())
                                .contains(bar.getBounds().union(canvas.getBounds()))));
        say(name + ", the panels are in the canvas", onEventThread(this::arePanelsInTheCanvas));
        say(name + ", no panel is over another", onEventThread(() -> apart(canvas.panels())));
        save(name + " message");
        becomesShown("");
        say(name + ", the figures are there", onEventThread(() -> canvas.panels()
                .contains(canvas.hudLayout().figures())));
        save(name);
        loop.ask(session -> session.press(-100, -100)); // where nothing is: the card goes
        loop.ask(session -> session.release());
        say(
                name + ", nothing is over the scene",
                becomesTrue(() -> onEventThread(() ->
                        canvas.panels().stream().noneMatch(canvas.hudLayout().arena()::intersects))));
        System.out.println(name + ", graphs are shown: " + onEventThread(this::areGraphsShown));
        profile(name);
        SwingUtilities.invokeAndWait(canvas::toggleHelp);
        Thread.sleep(200);
        save(name + " help");
        int most = onEventThread(
                () -> Help.layout(canvas.getWidth(), canvas.getHeight()).mostScroll());
        say(name + ", the keys scroll", onEventThread(() -> canvas.scrollHelp(100)));
        Thread.sleep(200);
        if (most > 0) {
            save(name + " help, its end");
        }
        SwingUtilities.invokeAndWait(canvas::hideHelp);
    }

    private boolean areGraphsShown() {
        Rectangle steps = canvas.hudLayout().steps();
        return steps != null && canvas.panels().contains(steps);
    }

    /** Shows the times of the stages for a while. */
    private void profile(String name) throws Exception {
        loop.ask(Session::toggleProfile);
        boolean shown =
                becomesTrue(() -> onEventThread(() -> !canvas.refresh().profile.isEmpty()));
        becomesShown("");
        int height = onEventThread(() -> ProfileCard.height(canvas.refresh()));
        boolean placed = onEventThread(() -> canvas.panels().stream().anyMatch(panel -> panel.height == height));
        say(
                name + ", the card of the stages is there, unless the canvas is narrow",
                shown && placed == canvas.getWidth() >= HudLayout.CARDS_FROM);
        say(name + ", and is over no panel", onEventThread(() -> apart(canvas.panels()) && arePanelsInTheCanvas()));
        save(name + " stages");
        loop.ask(Session::toggleProfile);
        becomesShown("");
    }

    /** Clicks a circle, so that its card is in the picture. */
    private static void select(Session session) {
        long circle = session.world().handle(0);
        session.setTool(ToolKind.GRAB);
        session.press(session.world().x(circle), session.world().y(circle));
        session.release();
    }

    /** Waits until a frame with that message is painted. */
    private void becomesShown(String message) throws Exception {
        loop.ask(session -> session.say(message));
        boolean shown = becomesTrue(() -> onEventThread(() -> {
            boolean come = canvas.refresh().message.equals(message);
            canvas.paintImmediately(0, 0, canvas.getWidth(), canvas.getHeight());
            return come;
        }));
        say("the message '" + message + "' is shown", shown);
    }

    private static boolean becomesTrue(Callable<Boolean> condition) throws Exception {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(30);
        while (!condition.call()) {
            if (System.nanoTime() > deadline) {
                return false;
            }
            Thread.sleep(20);
        }
        return true;
    }

    private boolean areButtonsInTheBar() {
        Rectangle room = new Rectangle(bar.getSize());
        return bounds(bar).stream().allMatch(room::contains);
    }

    private boolean arePanelsInTheCanvas() {
        Rectangle room = new Rectangle(canvas.getSize());
        return canvas.panels().stream().allMatch(room::contains);
    }

    private static List<Rectangle> bounds(Container container) {
        List<Rectangle> bounds = new ArrayList<>();
        for (Component part : container.getComponents()) {
            if (part instanceof FlatButton || part instanceof FlatSlider) {
                bounds.add(part.getBounds());
            }
        }
        return bounds;
    }

    private static boolean apart(List<Rectangle> all) {
        for (int k = 0; k < all.size(); k++) {
            if (all.subList(0, k).stream().anyMatch(all.get(k)::intersects)) {
                return false;
            }
        }
        return true;
    }

    private void menus() throws Exception {
        say("the scene is marked", becomesTrue(() -> marked(1).equals(List.of(StageNotes.title("pegs")))));
        SwingUtilities.invokeAndWait(() -> item(1, StageNotes.title("marbles")).doClick());
        say("the next scene is marked", becomesTrue(() -> marked(1).equals(List.of(StageNotes.title("marbles")))));
        say("the back end is marked", marked(3).equals(List.of("JVM")));
        System.out.println("keys of the menus: " + keys());
        int step = onEventThread(() -> loop.latest().step);
        say("time runs", becomesTrue(() -> onEventThread(() -> loop.latest().step > step)));
        for (int menu = 0; menu < window.getJMenuBar().getMenuCount(); menu++) {
            for (JMenuItem item : items(menu)) {
                if (!item.isEnabled()) {
                    say(
                            "a disabled entry says why: " + item.getText(),
                            item.getText().matches("OPENCL_.PU \\(no .*\\)"));
                }
            }
            JMenu opened = window.getJMenuBar().getMenu(menu);
            SwingUtilities.invokeAndWait(opened::doClick);
            Thread.sleep(300);
            save("menu " + menu);
            SwingUtilities.invokeAndWait(
                    () -> MenuSelectionManager.defaultManager().clearSelectedPath());
        }
    }

    private List<JMenuItem> items(int menu) {
        List<JMenuItem> items = new ArrayList<>();
        for (Component part : window.getJMenuBar().getMenu(menu).getMenuComponents()) {
            if (part instanceof JMenuItem item) {
                items.add(item);
            }
        }
        return items;
    }

    private JMenuItem item(int menu, String text) {
        return items(menu).stream()
                .filter(item -> item.getText().equals(text))
                .findFirst()
                .orElseThrow();
    }

    private List<String> marked(int menu) throws Exception {
        return onEventThread(() -> items(menu).stream()
                .filter(JMenuItem::isSelected)
                .map(JMenuItem::getText)
                .toList());
    }

    private String keys() throws Exception {
        return onEventThread(() -> {
            StringBuilder text = new StringBuilder();
            for (int menu = 0; menu < window.getJMenuBar().getMenuCount(); menu++) {
                for (JMenuItem item : items(menu)) {
                    if (item.getAccelerator() != null) {
                        text.append(item.getText())
                                .append('=')
                                .append(item.getAccelerator())
                                .append(", ");
                    }
                }
            }
            return text.toString().replace("pressed ", "");
        });
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

    private void save(String name) throws Exception {
        if (folder != null) {
            Rectangle screen = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
            FileMenu.write(new Robot().createScreenCapture(screen), folder.resolve(name.replace(' ', '-') + ".png"));
        }
    }
}
