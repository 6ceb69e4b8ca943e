package io.github.circles2d.playground;

import io.github.circles2d.Backend;
import java.awt.Color;
import java.util.EnumMap;
import java.util.Map;
import javax.swing.BorderFactory;
import javax.swing.ButtonGroup;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import javax.swing.border.Border;

/** The menus: files, stages, the course of time, back ends, and what is shown. */
final class Menus {
    private static final Border ROOM = BorderFactory.createEmptyBorder(4, 10, 4, 14);

    private final JMenuBar bar = new JMenuBar();
    private final Map<Backend, JRadioButtonMenuItem> backends = new EnumMap<>(Backend.class);

    Menus(SessionLoop loop, PlaygroundCanvas canvas, FileMenu files, BackendSwitch switcher, Runnable quit) {
        bar.setBackground(new Color(Theme.BAR.getRGB()));
        bar.setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Theme.LINE));
        JMenu file = menu("File");
        item(file, "Open world ...", "ctrl O", files::open);
        item(file, "Save world ...", "ctrl S", files::save);
        file.addSeparator();
        item(file, "Save picture ...", "ctrl P", files::savePicture);
        item(file, "Copy picture", "ctrl C", files::copyPicture);
        file.addSeparator();
        item(file, "Quit", "ctrl Q", quit);
        addStages(loop);
        JMenu run = menu("Run");
        item(run, "Pause or go on", null, () -> loop.ask(Session::togglePause));
        item(run, "One step", null, () -> loop.ask(Session::stepOnce));
        item(run, "One step back", null, () -> loop.ask(Session::stepBack));
        item(run, "Slower", null, () -> loop.ask(Session::slower));
        item(run, "Normal speed", null, () -> loop.ask(Session::normalSpeed));
        item(run, "Start again", null, () -> loop.ask(Session::restart));
        addBackends(switcher);
        JMenu view = menu("View");
        item(view, "Back to all", null, canvas::goHome);
        item(view, "Graphs", null, canvas::toggleGraphs);
        item(view, "Keys", null, canvas::toggleHelp);
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
            UIManager.put(kind + ".disabledForeground", Theme.LINE.brighter());
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

    /** Shows what a frame says. */
    void show(Frame frame) {
        JRadioButtonMenuItem now = backends.get(frame.backend);
        if (now != null) {
            now.setSelected(true);
        }
    }

    private void addStages(SessionLoop loop) {
        JMenu menu = menu("Scene");
        boolean separated = false;
        for (Stage stage : Stages.all()) {
            if (stage.published() && !separated) {
                menu.addSeparator();
                separated = true;
            }
            item(menu, stage.name(), null, () -> loop.ask(session -> session.load(stage)));
        }
    }

    private void addBackends(BackendSwitch switcher) {
        JMenu menu = menu("Back end");
        ButtonGroup group = new ButtonGroup();
        for (Backend backend : new Backend[] {Backend.JVM, Backend.OPENCL_CPU, Backend.OPENCL_GPU}) {
            JRadioButtonMenuItem item = new JRadioButtonMenuItem(backend.toString());
            item.setBorder(ROOM);
            item.setEnabled(switcher.has(backend));
            item.addActionListener(event -> switcher.to(backend));
            group.add(item);
            menu.add(item);
            backends.put(backend, item);
        }
    }

    private JMenu menu(String text) {
        JMenu menu = new JMenu(text);
        menu.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));
        bar.add(menu);
        return menu;
    }

    private static void item(JMenu menu, String text, String key, Runnable action) {
        JMenuItem item = new JMenuItem(text);
        item.setBorder(ROOM);
        if (key != null) {
            item.setAccelerator(KeyStroke.getKeyStroke(key.replace("ctrl ", "control ")));
        }
        item.addActionListener(event -> action.run());
        menu.add(item);
    }
}
