package io.github.circles2d.playground;

import io.github.circles2d.Backend;
import java.awt.Color;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.Map;
import javax.swing.BorderFactory;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.border.Border;

/** The menus: files, stages, the course of time, back ends, and what is shown. */
final class Menus {
    private static final Border ROOM = BorderFactory.createEmptyBorder(4, 10, 4, 14);

    private final JMenuBar bar = new JMenuBar();
    private final Map<Backend, JRadioButtonMenuItem> backends = new EnumMap<>(Backend.class);
    private final Map<String, JRadioButtonMenuItem> stages = new HashMap<>();
    private final ButtonGroup stageGroup = new ButtonGroup();

    /** The stage that is marked. */
    private String stage;

    Menus(
            SessionLoop loop,
            PlaygroundCanvas canvas,
            FileMenu files,
            BackendSwitch switcher,
            Runnable gallery,
            Runnable quit) {
        bar.setBackground(new Color(Theme.BAR.getRGB()));
        bar.setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Theme.LINE));
        JMenu file = menu("File");
        item(file, "Open world ...", "ctrl O", files::open);
        item(file, "Save world ...", "ctrl S", files::save);
        item(file, "Copy link for the browser", "ctrl L", files::copyLink);
        file.addSeparator();
        item(file, "Save picture ...", "ctrl P", files::savePicture);
        item(file, "Copy picture", "ctrl C", files::copyPicture);
        file.addSeparator();
        item(file, "Quit", "ctrl Q", quit);
        addStages(loop, gallery);
        JMenu run = menu("Run");
        shownItem(run, "Pause or go on", "SPACE", () -> loop.ask(Session::togglePause));
        shownItem(run, "One step", "PERIOD", () -> loop.ask(Session::stepOnce));
        shownItem(run, "One step back", "COMMA", () -> loop.ask(Session::stepBack));
        shownItem(run, "Slower", "S", () -> loop.ask(Session::slower));
        item(run, "Normal speed", null, () -> loop.ask(Session::normalSpeed));
        shownItem(run, "Start again", "R", () -> loop.ask(Session::restart));
        shownItem(run, "Sleep", "Z", () -> loop.ask(Session::toggleSleep));
        addBackends(switcher);
        JMenu view = menu("View");
        shownItem(view, "Back to all", "HOME", canvas::goHome);
        shownItem(view, "Contact points", "V", () -> loop.ask(Session::toggleContacts));
        shownItem(view, "Times by stage", "T", () -> loop.ask(Session::toggleProfile));
        shownItem(view, "Graphs", "G", canvas::toggleGraphs);
        shownItem(view, "Keys", "H", canvas::toggleHelp);
    }

    /** Colours of menus that are to come. */
    static void prepare() {
        for (String kind : new String[] {"Menu", "MenuItem", "RadioButtonMenuItem", "PopupMenu"}) {
            UIManager.put(kind + ".background", Theme.BAR);
            UIManager.put(kind + ".foreground", Theme.TEXT);
            UIManager.put(kind + ".selectionBackground", Theme.HOVER);
            UIManager.put(kind + ".selectionForeground", Theme.TEXT);
            UIManager.put(kind + ".acceleratorForeground", Theme.FAINT);
            UIManager.put(kind + ".acceleratorSelectionForeground", Theme.FAINT);
            UIManager.put(kind + ".disabledForeground", Theme.DISABLED);
            UIManager.put(kind + ".font", Theme.font(13));
            UIManager.put(kind + ".acceleratorFont", Theme.font(12));
            UIManager.put(kind + ".borderPainted", false);
        }
        UIManager.put("RadioButtonMenuItem.checkIcon", new Dot());
        UIManager.put("PopupMenu.border", BorderFactory.createLineBorder(Theme.LINE));
        UIManager.put("Separator.foreground", Theme.LINE);
        UIManager.put("Separator.background", Theme.BAR);
        UIManager.put("ToolTip.background", Theme.BUTTON);
        UIManager.put("ToolTip.foreground", Theme.TEXT);
        UIManager.put("ToolTip.border", BorderFactory.createLineBorder(Theme.LINE));
    }

    JMenuBar bar() {
        return bar;
    }

    /** Shows what a frame says: the stage and the back end that was asked for. */
    void show(Frame frame) {
        JRadioButtonMenuItem now = backends.get(frame.asked);
        if (now != null) {
            now.setSelected(true);
        }
        if (!frame.stage.equals(stage)) {
            stage = frame.stage;
            stageGroup.clearSelection(); // a world from a file is none of them
            JRadioButtonMenuItem item = stages.get(stage);
            if (item != null) {
                item.setSelected(true);
            }
        }
    }

    private void addStages(SessionLoop loop, Runnable gallery) {
        JMenu menu = menu("Scene");
        shownItem(menu, "All with pictures ...", "M", gallery);
        menu.addSeparator();
        boolean separated = false;
        for (Stage one : Stages.all()) {
            if (one.published() && !separated) {
                menu.addSeparator();
                separated = true;
            }
            JRadioButtonMenuItem item = choice(menu, stageGroup, StageNotes.title(one.name()));
            item.setToolTipText(StageNotes.of(one.name()));
            item.addActionListener(event -> {
                stage = null; // the next frame says whether it has come
                loop.ask(session -> session.load(one));
            });
            stages.put(one.name(), item);
        }
    }

    private void addBackends(BackendSwitch switcher) {
        JMenu menu = menu("Back end");
        ButtonGroup group = new ButtonGroup();
        for (Backend backend : new Backend[] {Backend.JVM, Backend.OPENCL_CPU, Backend.OPENCL_GPU, Backend.AUTO}) {
            String lack = switcher.lack(backend);
            String note = backend == Backend.AUTO ? "moves to where frames are shorter" : lack;
            JRadioButtonMenuItem item =
                    choice(menu, group, note.isEmpty() ? backend.toString() : backend + " (" + note + ")");
            item.setEnabled(lack.isEmpty());
            if (!lack.isEmpty() && !switcher.failure().isEmpty()) {
                item.setToolTipText(switcher.failure());
            }
            item.addActionListener(event -> switcher.to(backend));
            backends.put(backend, item);
        }
        menu.addSeparator();
        shownItem(menu, "Next back end", "N", switcher::next);
    }

    private static JRadioButtonMenuItem choice(JMenu menu, ButtonGroup group, String text) {
        JRadioButtonMenuItem item = new JRadioButtonMenuItem(text);
        item.setBorder(ROOM);
        group.add(item);
        menu.add(item);
        return item;
    }

    private JMenu menu(String text) {
        JMenu menu = new JMenu(text);
        menu.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));
        bar.add(menu);
        return menu;
    }

    private static JMenuItem item(JMenu menu, String text, String key, Runnable action) {
        JMenuItem item = new JMenuItem(text);
        item.setBorder(ROOM);
        if (key != null) {
            item.setAccelerator(KeyStroke.getKeyStroke(key.replace("ctrl ", "control ")));
        }
        item.addActionListener(event -> action.run());
        menu.add(item);
        return item;
    }

    /** An item whose key {@link Keys} binds: the menu only shows it, since an item that is pressed by its key stops all for a moment. */
    private static void shownItem(JMenu menu, String text, String key, Runnable action) {
        JMenuItem item = item(menu, text, key, action);
        SwingUtilities.replaceUIInputMap(item, JComponent.WHEN_IN_FOCUSED_WINDOW, null);
    }
}
