package com.example.hook;

import io.github.circles2d.Backend;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Terrain;
import io.github.circles2d.opencl.OpenClException;
import java.awt.AWTError;
import java.awt.AWTEvent;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.GradientPaint;
import java.awt.Graphics2D;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.swing.ImageIcon;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

/** A window to play in; or with {@code --frames N} a game that plays itself, and one line of what became of it. */
@SuppressWarnings("serial") // nobody writes it to a file
public final class Main extends JLabel {
    private static final int SCALE = 8; // pixels a length: 1280 for the width
    private static final int[] COLORS = {0x26364f, 0xffd166, 0xef476f, 0xfff3b0}; // by kind
    private final BufferedImage image = new BufferedImage(1280, 720, BufferedImage.TYPE_INT_RGB);
    private final Hook game;
    private final FixedStep loop;
    private final float[] circles = new float[400], angles = new float[100], numbers = new float[2000];
    private final int[] kinds = new int[100];
    private long lastFrame = System.nanoTime();

    private Main(Backend backend) {
        game = new Hook(backend);
        loop = new FixedStep(game.world, Hook.STEP);
    }

    public static void main(String[] arguments) {
        Options options = Options.read(arguments);
        try {
            if (options.frames() > 0) {
                new Main(options.backend()).playAlone(options.frames(), options.picture());
            } else {
                requireDisplay();
                SwingUtilities.invokeLater(new Main(options.backend())::open);
            }
        } catch (OpenClException e) { // no such device, or its driver fails
            Options.end(1, e.getMessage());
        }
    }

    private static void requireDisplay() {
        try {
            GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice();
        } catch (HeadlessException | AWTError | LinkageError | InternalError e) { // none, or a Java without windows
            Options.end(1, "no window can be shown here", "without a display, it plays by itself: --frames 300");
        }
    }

    private void playAlone(int frames, String picture) {
        for (int k = 0; k < frames; k++) {
            game.playAlone(k);
            loop.advance(Hook.STEP, game);
        }
        if (!picture.isEmpty()) {
            draw();
            try (OutputStream file = Files.newOutputStream(Path.of(picture))) {
                ImageIO.write(image, "png", file);
            } catch (IOException | InvalidPathException e) {
                Options.end(1, "cannot write " + picture + ": " + e);
            }
        }
        System.out.printf("hook: %d frames, %d lights, hash %016x%n", frames, game.score, game.world.hash());
        game.world.close();
    }

    private void open() {
        setIcon(new ImageIcon(image));
        setFocusable(true); // for keys
        enableEvents(AWTEvent.KEY_EVENT_MASK | AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_MOTION_EVENT_MASK);
        JFrame frame = new JFrame("Hook: hold the mouse to swing, A and D drive the car; take all lights");
        frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
        frame.add(this);
        frame.pack();
        frame.setVisible(true);
        new Timer(1000 / 60, event -> nextFrame()).start();
    }

    private void nextFrame() {
        loop.advance((System.nanoTime() - lastFrame) * 1e-9f, game);
        lastFrame = System.nanoTime();
        draw();
        repaint();
    }

    @Override
    protected void processEvent(AWTEvent event) {
        if (event instanceof MouseEvent mouse) {
            game.aimX = mouse.getX() / (float) SCALE;
            game.aimY = Hook.HEIGHT - mouse.getY() / (float) SCALE;
            int what = mouse.getID();
            game.isHooked = what == MouseEvent.MOUSE_PRESSED || game.isHooked && what != MouseEvent.MOUSE_RELEASED;
        } else if (event instanceof KeyEvent key) {
            int way = key.getKeyCode() == KeyEvent.VK_A ? -1 : key.getKeyCode() == KeyEvent.VK_D ? 1 : 0;
            game.drive = key.getID() == KeyEvent.KEY_RELEASED ? 0 : way;
        }
    }

    private void draw() {
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setPaint(new GradientPaint(0, 0, new Color(0x141235), 0, image.getHeight(), new Color(0x6b3a6b)));
        g.fillRect(0, 0, image.getWidth(), image.getHeight());
        g.translate(0, image.getHeight());
        g.scale(SCALE, -SCALE);
        g.setColor(new Color(0xf6d6a8));
        g.fill(disc(132, 34, 9)); // the moon
        g.setColor(new Color(0x2c2150));
        for (int k = 0; k < 6; k++) { // mountains
            g.fill(disc(10 + 30 * k, -22 + 7 * (k % 2), 42));
        }
        drawTerrain(g);
        int joints = loop.jointEnds(numbers, null);
        g.setColor(new Color(0xcfd8e6));
        g.setStroke(new BasicStroke(0.3f));
        for (int k = 0; k < joints; k++) {
            g.draw(new Line2D.Float(numbers[4 * k], numbers[4 * k + 1], numbers[4 * k + 2], numbers[4 * k + 3]));
        }
        var positions = loop.positions(null);
        game.world.readById(circles, null);
        game.world.readKindsById(kinds, null);
        loop.angles().get(0, angles, 0, game.world.idLimit());
        for (int id = 0; id < game.world.idLimit(); id++) {
            float x = positions.get(2 * id), y = positions.get(2 * id + 1), radius = circles[4 * id + 2];
            if (!Float.isNaN(x)) {
                g.setColor(new Color(COLORS[kinds[id]] & 0xffffff | 0x30000000, true));
                g.fill(disc(x, y, kinds[id] == Hook.LIGHT ? 2.2f * radius : 0)); // its glow
                g.setColor(new Color(COLORS[kinds[id]]));
                g.fill(disc(x, y, radius));
                float markX = (float) Math.cos(angles[id]), markY = (float) Math.sin(angles[id]);
                g.setColor(new Color(COLORS[kinds[id] == Hook.LIGHT ? Hook.LIGHT : 0]));
                g.fill(disc(x + 0.55f * radius * markX, y + 0.55f * radius * markY, 0.25f * radius));
            }
        }
        g.scale(1.0 / SCALE, -1.0 / SCALE);
        g.setColor(Color.WHITE);
        g.setFont(g.getFont().deriveFont(20f));
        g.drawString(game.score + " lights", 20, 34 - image.getHeight());
        g.setFont(g.getFont().deriveFont(15f));
        g.drawString("hold the mouse: throw the hook, and swing    A, D: drive", 20, 60 - image.getHeight());
    }

    private void drawTerrain(Graphics2D g) {
        int count = loop.pieces(numbers, null);
        Path2D.Float ground = new Path2D.Float();
        ground.moveTo(Hook.WIDTH, 0);
        g.setColor(new Color(0x3d5a80));
        for (int k = 0; k < count; k++) {
            int row = Terrain.PIECE_STRIDE * k;
            float x = numbers[row + Terrain.X1], y = numbers[row + Terrain.Y1];
            float toX = numbers[row + Terrain.X2], toY = numbers[row + Terrain.Y2];
            if (numbers[row + Terrain.FORM] == Terrain.LINE) { // of the hills
                ground.lineTo(x, y);
                ground.lineTo(toX, toY);
            } else if (numbers[row + Terrain.FORM] == Terrain.ARC) {
                g.fill(disc(
                        numbers[row + Terrain.CENTRE_X],
                        numbers[row + Terrain.CENTRE_Y],
                        numbers[row + Terrain.RADIUS]));
            } else {
                float width = 2 * numbers[row + Terrain.THICKNESS];
                g.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
                g.draw(new Line2D.Float(x, y, toX, toY));
            }
        }
        ground.lineTo(0, 0);
        g.fill(ground);
    }

    private static Shape disc(float x, float y, float radius) {
        return new Ellipse2D.Float(x - radius, y - radius, 2 * radius, 2 * radius);
    }
}
