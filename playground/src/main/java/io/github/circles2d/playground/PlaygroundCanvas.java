package io.github.circles2d.playground;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.image.BufferedImage;
import java.util.List;
import javax.swing.JComponent;

/** Shows the newest frame of a loop, and has the camera. Belongs to the event thread, which never waits for a step. */
final class PlaygroundCanvas extends JComponent {
    private static final long serialVersionUID = 1;

    private final transient SessionLoop loop;
    private final transient Painter painter = new Painter();
    private final transient Hud hud = new Hud();
    private transient Arena arena;
    private transient Camera camera;
    private transient Frame frame;
    private transient HudLayout layout;

    /** Whether all of the arena is shown, however large the window is. */
    private boolean home = true;

    private HudLayout.Graphs graphs = HudLayout.Graphs.IF_THERE_IS_ROOM;
    private boolean help;

    /** Pixels of the keys above the upper end of their panel. */
    private int scroll;

    /** Where the mouse is; null outside. */
    private Point mouse;

    PlaygroundCanvas(SessionLoop loop, int width, int height) {
        this.loop = loop;
        setOpaque(true);
        setFocusable(true);
        setPreferredSize(new Dimension(width, height));
        refresh();
    }

    /** Takes the newest frame, which is the one to show until the next call. */
    Frame refresh() {
        frame = loop.latest();
        if (!frame.arena.equals(arena)) {
            arena = frame.arena;
            home = true;
        }
        layout = HudLayout.of(
                getWidth(),
                getHeight(),
                arena.width() / arena.height(),
                Hud.hasLegend(frame),
                graphs,
                frame.showsProfile);
        if (home) {
            camera = Camera.home(arena, layout.arena(), getWidth(), getHeight());
        }
        return frame;
    }

    /** Where scene and panels are, if there is room for them. */
    HudLayout hudLayout() {
        return layout;
    }

    /** Where panels, cards and the message are. */
    List<Rectangle> panels() {
        return hud.shown();
    }

    Camera camera() {
        return camera;
    }

    void zoom(double factor, double x, double y) {
        look(camera.zoom(factor, x, y, getWidth(), getHeight()));
    }

    void pan(double dx, double dy) {
        look(camera.pan(dx, dy));
    }

    private void look(Camera next) {
        camera = next.clamp(arena, layout.arena(), getWidth(), getHeight());
        home = false;
        repaint();
    }

    /** Shows all of the arena. */
    void goHome() {
        home = true;
        refresh();
        repaint();
    }

    /** Hides the graphs if they are there, else shows them even over the scene. */
    void toggleGraphs() {
        graphs = layout.steps() != null ? HudLayout.Graphs.NO : HudLayout.Graphs.OVER_THE_SCENE;
        repaint();
    }

    void toggleHelp() {
        help = !help;
        scroll = 0;
        repaint();
    }

    void hideHelp() {
        help = false;
        repaint();
    }

    /** Scrolls the keys by so many of their rows; false if they are not shown. */
    boolean scrollHelp(double rows) {
        if (help) {
            double next = Math.min(scroll, mostScroll()) + rows * HelpLayout.ROW;
            scroll = (int) Math.round(Math.min(Math.max(next, 0), mostScroll()));
            repaint();
        }
        return help;
    }

    private int mostScroll() {
        return Help.layout(getWidth(), getHeight()).mostScroll();
    }

    void setMouse(Point at) {
        mouse = at;
    }

    float worldX(double x) {
        return (float) camera.worldX(x, getWidth());
    }

    float worldY(double y) {
        return (float) camera.worldY(y, getHeight());
    }

    /** The circles as they are shown, without the text beside them; all of the arena in the middle unless a person looks elsewhere. */
    BufferedImage picture() {
        if (home) {
            return Playground.picture(frame, getWidth(), getHeight());
        }
        BufferedImage picture = new BufferedImage(getWidth(), getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = picture.createGraphics();
        painter.paint(g, getWidth(), getHeight(), camera, frame);
        g.dispose();
        return picture;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        refresh();
        Graphics2D g = (Graphics2D) graphics.create();
        painter.paint(g, getWidth(), getHeight(), camera, frame);
        hud.paintBrush(g, mouse, camera, frame);
        hud.paint(g, layout, frame);
        if (help) {
            Help.paint(g, getWidth(), getHeight(), Math.min(scroll, mostScroll()));
        }
        g.dispose();
        Toolkit.getDefaultToolkit().sync(); // some window systems gather requests until the next one comes
    }
}
