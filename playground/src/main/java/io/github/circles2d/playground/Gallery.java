package io.github.circles2d.playground;

import io.github.circles2d.Backend;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.GridLayout;
import java.awt.Insets;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.BorderFactory;
import javax.swing.ImageIcon;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.SwingConstants;

/** All scenes with their pictures and names, to choose from. */
final class Gallery {
    private static final int WIDTH = 208;
    private static final int HEIGHT = 130;
    private static final int COLUMNS = 4;
    private static final int ROWS_SHOWN = 4;
    private static final int GAP = 8;

    /** Steps until a scene shows what it is. */
    private static final int STEPS = 150;

    /** The same if more circles than this many are awake. */
    private static final int MANY = 20_000;

    private static final int STEPS_OF_MANY = 40;

    private Gallery() {}

    /** Writes a picture of each scene into a folder. */
    static void write(Path folder) throws IOException {
        Files.createDirectories(folder);
        Frame frame = new Frame();
        for (Stage stage : Stages.all()) {
            try (Session session = new Session(stage, Backend.JVM)) {
                int steps = session.world().stats().awake() > MANY ? STEPS_OF_MANY : STEPS;
                for (int k = 0; k < steps; k++) {
                    session.sandbox().stepOnce(() -> {});
                }
                session.frame(0, frame);
            }
            FileMenu.write(Playground.picture(frame, WIDTH, HEIGHT), folder.resolve(stage.name() + ".png"));
        }
    }

    /** Opens the window, which closes when a scene is chosen. */
    static void show(JFrame owner, SessionLoop loop) {
        JDialog window = new JDialog(owner, "Scenes");
        JPanel scenes = new JPanel(new GridLayout(0, COLUMNS, GAP, GAP));
        scenes.setBackground(Theme.BAR);
        scenes.setBorder(BorderFactory.createEmptyBorder(GAP, GAP, GAP, GAP));
        for (Stage stage : Stages.all()) {
            scenes.add(button(stage, () -> {
                window.dispose();
                loop.ask(session -> session.load(stage));
            }));
        }
        JScrollPane all = new JScrollPane(
                scenes, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        all.setBorder(BorderFactory.createEmptyBorder());
        all.getVerticalScrollBar().setUnitIncrement(HEIGHT / 4);
        Dimension row = scenes.getComponent(0).getPreferredSize();
        int bar = all.getVerticalScrollBar().getPreferredSize().width;
        all.setPreferredSize(
                new Dimension(COLUMNS * (row.width + GAP) + GAP + bar, ROWS_SHOWN * (row.height + GAP) + GAP));
        window.setLayout(new BorderLayout());
        window.add(all);
        window.getRootPane()
                .registerKeyboardAction(
                        event -> window.dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
        window.pack();
        window.setLocationRelativeTo(owner);
        window.setVisible(true);
    }

    private static JButton button(Stage stage, Runnable action) {
        var picture = Gallery.class.getResource("scenes/" + stage.name() + ".png");
        JButton button = new JButton(StageNotes.title(stage.name()), new ImageIcon(picture));
        button.setToolTipText(StageNotes.of(stage.name()));
        button.setVerticalTextPosition(SwingConstants.BOTTOM);
        button.setHorizontalTextPosition(SwingConstants.CENTER);
        button.setIconTextGap(4);
        button.setMargin(new Insets(0, 0, 0, 0));
        button.setBorder(BorderFactory.createEmptyBorder(4, 4, 5, 4));
        button.setBackground(Theme.BUTTON);
        button.setForeground(Theme.TEXT);
        button.setFont(Theme.font(13));
        button.setFocusPainted(false);
        button.addActionListener(event -> action.run());
        button.addChangeListener(event -> {
            Color ground = button.getModel().isRollover() ? Theme.HOVER : Theme.BUTTON;
            if (!ground.equals(button.getBackground())) {
                button.setBackground(ground);
            }
        });
        return button;
    }
}
