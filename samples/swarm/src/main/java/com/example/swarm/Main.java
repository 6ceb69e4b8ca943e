package com.example.swarm;

import io.github.circles2d.Backend;
import io.github.circles2d.FixedStep;
import io.github.circles2d.opencl.OpenClException;
import java.awt.AWTError;
import java.awt.AWTEvent;
import java.awt.Color;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.RenderingHints;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
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
    private static final Color[] COLORS = {new Color(0x7df9c4), null, new Color(0xff4d6d), new Color(0xfff3b0)};
    private final BufferedImage image = new BufferedImage(Swarm.WIDTH, Swarm.HEIGHT, BufferedImage.TYPE_INT_RGB);
    private final float[] circles = new float[4 * Swarm.MOST_CIRCLES], velocities = new float[2 * Swarm.MOST_CIRCLES];
    private final int[] kinds = new int[Swarm.MOST_CIRCLES];
    private final Swarm game;
    private final FixedStep loop;
    private boolean isRewinding;
    private long lastFrame = System.nanoTime();

    private Main(Backend backend) {
        game = new Swarm(backend);
        loop = new FixedStep(game.world, 1 / 60f);
    }

    public static void main(String[] arguments) {
        Options options = Options.read(arguments);
        try {
            if (options.frames() == 0) {
                requireDisplay();
            }
            Main main = new Main(options.backend());
            if (options.frames() > 0) {
                main.playAlone(options.frames(), options.picture());
            } else {
                SwingUtilities.invokeLater(main::open);
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
            game.mouseX = Swarm.WIDTH * (0.5f + 0.4f * (float) StrictMath.sin(k / 45.0));
            game.mouseY = Swarm.HEIGHT * (0.5f + 0.4f * (float) StrictMath.sin(k / 30.0));
            game.isBombWanted = k % 60 == 59;
            loop.advance(1 / 60f, game);
        }
        if (!picture.isEmpty()) {
            draw();
            try (OutputStream file = Files.newOutputStream(Path.of(picture))) {
                ImageIO.write(image, "png", file);
            } catch (IOException | InvalidPathException e) {
                Options.end(1, "cannot write " + picture + ": " + e);
            }
        }
        String format = "swarm: %d frames, %d circles, %d points, hash %016x%n";
        System.out.printf(format, frames, game.world.size(), game.world.tag(game.player), game.world.hash());
        game.world.close();
    }

    private void open() {
        setIcon(new ImageIcon(image));
        setFocusable(true); // for keys
        enableEvents(AWTEvent.KEY_EVENT_MASK | AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_MOTION_EVENT_MASK);
        JFrame frame = new JFrame("Swarm: the mouse moves, a click bombs, R turns back time");
        frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
        frame.add(this);
        frame.pack();
        frame.setVisible(true);
        new Timer(1000 / 60, event -> nextFrame()).start();
    }

    @Override
    protected void processEvent(AWTEvent event) {
        if (event instanceof MouseEvent mouse) {
            game.mouseX = mouse.getX();
            game.mouseY = mouse.getY();
            game.isBombWanted |= mouse.getID() == MouseEvent.MOUSE_PRESSED;
        } else if (event instanceof KeyEvent key && key.getKeyCode() == KeyEvent.VK_R) {
            isRewinding = key.getID() == KeyEvent.KEY_PRESSED;
        }
    }

    private void nextFrame() {
        float seconds = (System.nanoTime() - lastFrame) * 1e-9f;
        lastFrame = System.nanoTime();
        if (isRewinding) {
            game.rewind();
            loop.reset();
        } else {
            loop.advance(seconds, game);
        }
        draw();
        repaint();
    }

    private void draw() {
        var g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setBackground(new Color(0x0d1020));
        g.clearRect(0, 0, Swarm.WIDTH, Swarm.HEIGHT);
        var positions = loop.positions(null);
        game.world.readById(circles, null);
        game.world.readVelocitiesById(velocities, null);
        game.world.readKindsById(kinds, null);
        long picked = game.nearest(game.mouseX, game.mouseY, 24);
        for (int id = 0; id < game.world.idLimit(); id++) {
            float x = positions.get(2 * id), y = positions.get(2 * id + 1), radius = circles[4 * id + 2];
            if (!Float.isNaN(x)) {
                float heat = Math.min(1, (Math.abs(velocities[2 * id]) + Math.abs(velocities[2 * id + 1])) / 340);
                Color hunter = Color.getHSBColor(0.70f + 0.33f * heat, 0.75f - 0.15f * heat, 0.55f + 0.45f * heat);
                Color color = kinds[id] == Swarm.SMALL ? hunter : COLORS[kinds[id]];
                g.setColor(game.world.handle(id) == picked ? Color.WHITE : color);
                g.fill(new Ellipse2D.Float(x - radius, y - radius, 2 * radius, 2 * radius));
            }
        }
        g.setColor(Color.WHITE);
        g.setFont(g.getFont().deriveFont(20f));
        g.drawString(game.world.tag(game.player) + " points", 20, 40);
    }
}
