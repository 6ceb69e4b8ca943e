package com.example.golf;

import io.github.circles2d.Backend;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Terrain;
import java.awt.AWTEvent;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsEnvironment;
import java.awt.RenderingHints;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Arc2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

/** A window to play in; or with {@code --frames N} a game that plays itself, and one line of what became of it. */
public final class Main extends JComponent {
    private static final int SCALE = 8, PREVIEW = 100; // pixels for a length of 1, and steps that the ghost shows
    private final Golf game;
    private final FixedStep loop;
    private final float[] pieces = new float[40 * Terrain.PIECE_STRIDE];
    private float mouseX, mouseY;
    private boolean isAiming, isUndoWanted;
    private long lastFrame = System.nanoTime();

    private Main(Backend backend) {
        game = new Golf(backend);
        loop = new FixedStep(game.world, Golf.STEP);
        setPreferredSize(new Dimension(Golf.WIDTH * SCALE, Golf.HEIGHT * SCALE));
        setSize(getPreferredSize());
        setFocusable(true); // for keys
        enableEvents(AWTEvent.KEY_EVENT_MASK | AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_MOTION_EVENT_MASK);
    }

    public static void main(String[] arguments) throws IOException {
        String name = "AUTO|JVM|OPENCL_CPU|OPENCL_GPU";
        String pattern = "(--frames (\\d{1,6}) ?|--backend (" + name + ") ?|--picture (.+\\.png) ?)*";
        var options = Pattern.compile(pattern).matcher(String.join(" ", arguments));
        if (!options.matches() || options.group(2) == null && GraphicsEnvironment.isHeadless()) {
            String usage = "usage: golf [--frames N [--picture FILE.png]] [--backend " + name + "]";
            System.err.println(usage + (options.matches() ? "; without a display: --frames 300" : ""));
            System.exit(options.matches() ? 1 : 2);
        }
        Main main = new Main(options.group(3) == null ? Backend.AUTO : Backend.valueOf(options.group(3)));
        int frames = options.group(2) == null ? 0 : Integer.parseInt(options.group(2));
        for (int frame = 0; frame < frames; frame++) {
            main.game.playAlone();
            main.loop.advance(Golf.STEP, main.game);
        }
        if (frames == 0) {
            SwingUtilities.invokeLater(main::open);
            return;
        }
        Golf game = main.game;
        System.out.printf("golf: %d frames, %d strokes, hash %016x%n", frames, game.strokes, game.world.hash());
        if (options.group(4) != null) {
            main.isAiming = true;
            main.mouseX = game.world.x(game.ball) + 24;
            main.mouseY = 33;
            BufferedImage image = new BufferedImage(main.getWidth(), main.getHeight(), BufferedImage.TYPE_INT_RGB);
            main.paintComponent(image.createGraphics());
            ImageIO.write(image, "png", new File(options.group(4)));
        }
    }

    private void open() {
        JFrame frame = new JFrame("Golf");
        frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
        frame.add(this);
        frame.pack();
        frame.setVisible(true);
        new Timer(1000 / 60, event -> nextFrame()).start();
    }

    private void nextFrame() {
        loop.advance((System.nanoTime() - lastFrame) * 1e-9f, game);
        lastFrame = System.nanoTime();
        if (isUndoWanted || game.isInWater()) {
            game.undo(isUndoWanted ? 1 : 0); // out of the water, the stroke counts
            isUndoWanted = false;
            loop.reset(); // or the ball would fly back
        }
        repaint();
    }

    @Override
    protected void processEvent(AWTEvent event) {
        if (event instanceof MouseEvent mouse) {
            mouseX = mouse.getX() / (float) SCALE;
            mouseY = Golf.HEIGHT - mouse.getY() / (float) SCALE;
            if (mouse.getID() == MouseEvent.MOUSE_RELEASED && game.canShoot) {
                float[] shot = game.aim(mouseX, mouseY);
                game.shoot(shot[0], shot[1]);
            }
            isAiming = (mouse.getModifiersEx() & MouseEvent.BUTTON1_DOWN_MASK) != 0;
        } else if (event instanceof KeyEvent key && key.getKeyCode() == KeyEvent.VK_Z) {
            isUndoWanted |= key.getID() == KeyEvent.KEY_PRESSED;
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.translate(0, getHeight());
        g.scale(SCALE, -SCALE);
        line(g, 0xa9d8f0, 2 * Golf.WIDTH, 0, 0, Golf.WIDTH, 0); // the sky
        for (int k = 0; k < 5; k++) { // hills
            disc(g, k % 2 == 0 ? 0x9fd0a8 : 0xb4dcb4, 40 * k, -12, 36 + 5 * (k % 3));
        }
        line(g, 0x3f8fd2, 6, 111, Golf.WATER - 3, 129, Golf.WATER - 3); // water
        line(g, 0xb8c4cc, 0.4f, Golf.HOLE, 9, Golf.HOLE, 26); // the flag
        line(g, 0xe63946, 3, Golf.HOLE + 1.5f, 24, Golf.HOLE + 4, 24);
        Path2D.Float soil = new Path2D.Float();
        soil.moveTo(Golf.WIDTH, 0);
        float[] points = game.ground.points(0.1f);
        for (int k = 0; k < points.length; k += 2) {
            soil.lineTo(points[k], points[k + 1]);
        }
        soil.lineTo(0, 0);
        g.setColor(new Color(0x5fa64e));
        g.fill(soil);
        line(g, 0x7d5a3c, 1.2f, 98, Golf.GROUND, 98, 24); // the mill's post
        for (int k = loop.pieces(pieces, null) - 1; k >= 0; k--) {
            drawPiece(g, k * Terrain.PIECE_STRIDE);
        }
        if (isAiming && game.canShoot) {
            float[] shot = game.aim(mouseX, mouseY);
            float[] way = game.ghost(shot[0], shot[1], PREVIEW);
            for (int k = 6; k < way.length; k += 8) {
                disc(g, 230 - 200 * k / way.length << 24 | 0xffffff, way[k], way[k + 1], 0.45f);
            }
        }
        var positions = loop.positions(null);
        disc(g, 0xffffff, positions.get(0), positions.get(1), Golf.RADIUS);
        g.scale(1.0 / SCALE, -1.0 / SCALE);
        g.translate(0, -getHeight());
        g.setColor(new Color(0x1d3557));
        g.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 24));
        g.drawString((game.isHoled ? "In the hole! Strokes: " : "Strokes: ") + game.strokes, 20, 38);
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 16));
        g.drawString("hold the mouse to aim, let go to shoot; Z takes the last stroke back", 20, 64);
    }

    private void drawPiece(Graphics2D g, int row) {
        int kind = (int) pieces[row + Terrain.KIND];
        float x = pieces[row + Terrain.X1], y = pieces[row + Terrain.Y1];
        float toX = pieces[row + Terrain.X2], toY = pieces[row + Terrain.Y2];
        if (pieces[row + Terrain.FORM] == Terrain.ARC) {
            double r = pieces[row + Terrain.RADIUS] + 0.3;
            double centreX = pieces[row + Terrain.CENTRE_X] - r, centreY = pieces[row + Terrain.CENTRE_Y] - r;
            double from = Math.toDegrees(pieces[row + Terrain.FROM]), to = Math.toDegrees(pieces[row + Terrain.TO]);
            g.setColor(new Color(0xe76f51));
            g.setStroke(new BasicStroke(0.6f));
            g.draw(new Arc2D.Double(centreX, centreY, 2 * r, 2 * r, -from, from - to, Arc2D.OPEN)); // y points up
        } else if ((kind == Golf.SAND || kind == Golf.GREEN) && y == Golf.GROUND) {
            g.setColor(new Color(kind == Golf.SAND ? 0xecd9a0 : 0x8fd16f));
            g.fill(new Rectangle2D.Float(toX, y - 1.2f, x - toX, 1.2f));
        } else if (kind == Golf.MILL) {
            line(g, 0xf4f1de, 2 * pieces[row + Terrain.THICKNESS], x, y, toX, toY);
        }
    }

    private static void line(Graphics2D g, int colour, float width, float x, float y, float toX, float toY) {
        g.setColor(new Color(colour, colour >>> 24 != 0));
        g.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(new Line2D.Float(x, y, toX, toY));
    }

    private static void disc(Graphics2D g, int colour, float x, float y, float r) {
        line(g, colour, 2 * r, x, y, x, y); // with round ends
    }
}
