package io.github.circles2d.playground;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.BiConsumer;
import javax.swing.Box;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The tools, the course of time and the colours, as buttons that show what is on, and sliders of surfaces. */
final class Bar extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int GAP_X = 4;
    private static final int GAP_Y = 7;

    /** Between groups. */
    private static final int SPACE = 9;

    /** Before a frame has said it: of a scene of the playground's own. */
    private static final float GRAVITY_ROOM = 120;

    private final transient Map<ToolKind, FlatButton> tools = new EnumMap<>(ToolKind.class);
    private final transient Map<PaintMode, FlatButton> paints = new EnumMap<>(PaintMode.class);
    private final FlatButton pause;
    private final FlatButton slow;
    private final FlatButton sleep;
    private final FlatSlider size;
    private final FlatSlider gravity;
    private final FlatSlider restitution;
    private final FlatSlider friction;
    private final FlatSlider rolling;
    private final JLabel subSteps;
    private final int width;

    /** A bar in a window that is to have so many pixels across. */
    Bar(SessionLoop loop, Runnable gallery, int width) {
        super(new FlowLayout(FlowLayout.LEFT, GAP_X, GAP_Y));
        this.width = width;
        setBackground(Theme.BAR);
        button("Scenes", "all scenes with pictures (M)", gallery);
        add(Box.createHorizontalStrut(SPACE));
        for (ToolKind kind : ToolKind.values()) {
            String tip = kind.purpose() + " (" + kind.key() + ")";
            tools.put(kind, button(kind.label(), tip, () -> loop.ask(session -> session.setTool(kind))));
        }
        add(Box.createHorizontalStrut(SPACE));
        button("Back", "one step back (,); hold B to run backwards", () -> loop.ask(Session::stepBack));
        pause = button("Pause", "stop and go on (space)", () -> loop.ask(Session::togglePause));
        button("Step", "one step (.)", () -> loop.ask(Session::stepOnce));
        slow = button("Slow", "slow motion: 1/2, 1/4, 1/8, 1/16 (S)", () -> loop.ask(Session::slower));
        sleep = button("Sleep", "what lies still falls asleep, and is dim (Z)", () -> loop.ask(Session::toggleSleep));
        add(Box.createHorizontalStrut(SPACE));
        for (PaintMode mode : PaintMode.values()) {
            String label = mode.label().substring(0, 1).toUpperCase(Locale.ROOT)
                    + mode.label().substring(1);
            paints.put(mode, button(label, "paint by " + mode.label() + " (C)", () -> loop.ask(s -> s.setPaint(mode))));
        }
        add(Box.createHorizontalStrut(SPACE));
        size = slider("Size", "of circles that are poured, in usual ones", 4, Session::setSize, loop);
        gravity = slider("Gravity", "up to twice that of the scene", GRAVITY_ROOM, Session::setGravity, loop);
        restitution = slider(
                "Bounce", "restitution of circles that are no belts and of terrain", 1, Session::setRestitution, loop);
        friction = slider("Friction", "of walls and of circles that are no belts", 1, Session::setFriction, loop);
        rolling = slider(
                "Rolling", "rolling resistance: circles roll on at 0", 0.3f, Session::setRollingResistance, loop);
        subSteps = new JLabel("Sub-steps 16");
        subSteps.setFont(Theme.font(13));
        subSteps.setForeground(Theme.TEXT);
        subSteps.setPreferredSize(subSteps.getPreferredSize()); // whatever their number
        add(subSteps);
        button(
                "\u2212",
                "one sub-step a step fewer: less exact and faster; starts the scene again",
                () -> loop.ask(session -> session.addSubSteps(-1)));
        button(
                "+",
                "one sub-step a step more: more exact and slower; starts the scene again",
                () -> loop.ask(session -> session.addSubSteps(1)));
    }

    /** As high as its rows are, where the layout itself knows of one row only; and it asks for no width. */
    @Override
    public Dimension getPreferredSize() {
        boolean placed = getParent() != null && getParent().getWidth() > 0;
        int room = (placed ? getParent().getWidth() : width) - 2 * GAP_X;
        int x = 0;
        int row = 0;
        int above = GAP_Y;
        for (Component part : getComponents()) {
            Dimension size = part.getPreferredSize();
            if (x > 0 && x + size.width > room) { // the layout leaves out this gap, too
                above += row + GAP_Y;
                x = 0;
                row = 0;
            }
            x += (x > 0 ? GAP_X : 0) + size.width;
            row = Math.max(row, size.height);
        }
        return new Dimension(0, above + row + GAP_Y);
    }

    private FlatButton button(String text, String tip, Runnable action) {
        FlatButton button = new FlatButton(text, tip, action);
        add(button);
        button.addActionListener(event -> button.setSelected(false)); // the next frame says whether it is on
        return button;
    }

    private FlatSlider slider(
            String text, String tip, float greatest, BiConsumer<Session, Float> setter, SessionLoop loop) {
        FlatSlider slider =
                new FlatSlider(text, tip, greatest, value -> loop.ask(session -> setter.accept(session, value)));
        add(slider);
        return slider;
    }

    /** Shows what a frame says. */
    void show(Frame frame) {
        tools.forEach((kind, button) -> button.setSelected(kind == frame.tool));
        paints.forEach((mode, button) -> button.setSelected(mode == frame.paint));
        pause.setSelected(frame.paused);
        slow.setSelected(frame.speed < 1);
        sleep.setSelected(frame.sleeps);
        subSteps.setText("Sub-steps " + frame.subSteps);
        slow.setText(frame.speed < 1 ? "1/" + Math.round(1 / frame.speed) : "Slow");
        size.show(frame.size);
        gravity.show(frame.gravity, frame.greatestGravity);
        restitution.show(frame.restitution);
        friction.show(frame.friction);
        rolling.show(frame.rollingResistance);
    }
}
