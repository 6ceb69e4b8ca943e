package com.example.swarm;

import io.github.circles2d.FixedStep;
import io.github.circles2d.World;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.nio.FloatBuffer;
import javax.swing.AbstractAction;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

/** Draws the game, and makes mouse and keys its controls. */
@SuppressWarnings("serial") // nobody writes it to a file
final class Screen extends JPanel {
    private static final Color BACKGROUND = new Color(0x0d1020);
    private static final Color SHADE = new Color(0xb00d1020, true); // behind text
    private static final Color PLAYER = new Color(0x7df9c4);
    private static final Color BULLET = new Color(0xfff3b0);
    private static final Color EXPLOSION = new Color(0xffd166);
    private static final Color LARGE = new Color(0xff4d6d);
    private static final Color[] CHASERS = new Color[16]; // by speed

    static {
        for (int k = 0; k < CHASERS.length; k++) {
            CHASERS[k] = Color.getHSBColor(0.70f + 0.022f * k, 0.75f - 0.01f * k, 0.55f + 0.03f * k);
        }
    }

    private final Swarm game;
    private final World world;
    private final FixedStep loop;
    private final float[] circles = new float[4 * Swarm.MOST_CIRCLES];
    private final float[] velocities = new float[2 * Swarm.MOST_CIRCLES];
    private final Ellipse2D.Float disc = new Ellipse2D.Float();
    private boolean rewinding;
    private long lastFrame;

    Screen(Swarm game) {
        this.game = game;
        world = game.world;
        loop = new FixedStep(world, Swarm.TIME_STEP);
        setPreferredSize(new Dimension(1280, 800));
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mouseMoved(MouseEvent event) {
                float scale = scale();
                game.controls.aimX = event.getX() / scale;
                game.controls.aimY = Swarm.HEIGHT - event.getY() / scale;
            }

            @Override
            public void mouseDragged(MouseEvent event) {
                mouseMoved(event);
            }

            @Override
            public void mousePressed(MouseEvent event) {
                if (SwingUtilities.isLeftMouseButton(event)) {
                    game.controls.fire = true;
                } else {
                    game.controls.bomb = true;
                }
            }

            @Override
            public void mouseReleased(MouseEvent event) {
                game.controls.fire &= !SwingUtilities.isLeftMouseButton(event);
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        onKeys(() -> game.controls.moveX = -1, () -> game.controls.moveX = 0, KeyEvent.VK_A, KeyEvent.VK_LEFT);
        onKeys(() -> game.controls.moveX = 1, () -> game.controls.moveX = 0, KeyEvent.VK_D, KeyEvent.VK_RIGHT);
        onKeys(() -> game.controls.moveY = 1, () -> game.controls.moveY = 0, KeyEvent.VK_W, KeyEvent.VK_UP);
        onKeys(() -> game.controls.moveY = -1, () -> game.controls.moveY = 0, KeyEvent.VK_S, KeyEvent.VK_DOWN);
        onKeys(() -> rewinding = true, () -> rewinding = false, KeyEvent.VK_R);
    }

    private void onKeys(Runnable pressed, Runnable released, int... keys) {
        for (int key : keys) {
            onKey(KeyStroke.getKeyStroke(key, 0, false), pressed);
            onKey(KeyStroke.getKeyStroke(key, 0, true), released);
        }
    }

    private void onKey(KeyStroke key, Runnable job) {
        getInputMap(WHEN_IN_FOCUSED_WINDOW).put(key, key);
        getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                job.run();
            }
        });
    }

    void open() {
        JFrame frame = new JFrame("Swarm");
        frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
        frame.add(this);
        frame.pack();
        frame.setLocationRelativeTo(null);
        frame.setVisible(true);
        lastFrame = System.nanoTime();
        new Timer(1000 / 60, event -> nextFrame()).start();
    }

    private void nextFrame() {
        long now = System.nanoTime();
        float seconds = (now - lastFrame) * 1e-9f;
        lastFrame = now;
        if (rewinding) {
            game.rewind();
            loop.reset();
        } else if (!game.isOver()) {
            loop.advance(seconds, game);
        }
        repaint();
        Toolkit.getDefaultToolkit().sync();
    }

    private float scale() {
        return getHeight() / Swarm.HEIGHT;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        paint((Graphics2D) graphics.create(), loop, scale());
    }

    void paint(Graphics2D g, FixedStep loop, float scale) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setColor(BACKGROUND);
        g.fillRect(0, 0, Math.round(Swarm.WIDTH * scale), Math.round(Swarm.HEIGHT * scale));
        Graphics2D field = (Graphics2D) g.create();
        field.translate(0, Swarm.HEIGHT * scale);
        field.scale(scale, -scale);
        drawCircles(field, loop);
        drawExplosions(field);
        drawTarget(field);
        field.dispose();
        drawText(g, scale);
        g.dispose();
    }

    private void drawCircles(Graphics2D g, FixedStep loop) {
        FloatBuffer positions = loop.positions(null);
        world.readById(circles, null);
        world.readVelocitiesById(velocities, null);
        for (int id = 0; id < world.idLimit(); id++) {
            float x = positions.get(2 * id);
            if (Float.isNaN(x)) {
                continue; // no circle has this id, or one that is new
            }
            long circle = world.handle(id);
            float speed = Math.abs(velocities[2 * id]) + Math.abs(velocities[2 * id + 1]);
            g.setColor(color(circle, speed));
            fill(g, x, positions.get(2 * id + 1), circles[4 * id + 2]);
        }
    }

    private Color color(long circle, float speed) {
        if (circle == game.player) {
            return PLAYER;
        }
        if (game.isBullet(circle)) {
            return BULLET;
        }
        return world.tag(circle) > 1 ? LARGE : CHASERS[Math.min(CHASERS.length - 1, (int) (speed * 0.7f))];
    }

    private void fill(Graphics2D g, float x, float y, float radius) {
        disc.setFrame(x - radius, y - radius, 2 * radius, 2 * radius);
        g.fill(disc);
    }

    private void draw(Graphics2D g, float x, float y, float radius) {
        disc.setFrame(x - radius, y - radius, 2 * radius, 2 * radius);
        g.draw(disc);
    }

    private void drawExplosions(Graphics2D g) {
        for (Swarm.Explosion explosion : game.explosions) {
            float age = (game.step() - explosion.step()) / 20f;
            if (age < 1) {
                g.setColor(new Color(EXPLOSION.getRGB() & 0xffffff | (int) (160 * (1 - age)) << 24, true));
                g.setStroke(new BasicStroke(0.3f * explosion.radius() * (1 - age)));
                draw(g, explosion.x(), explosion.y(), explosion.radius() * (0.5f + age));
            }
        }
    }

    private void drawTarget(Graphics2D g) {
        long target = game.target();
        if (target != 0) {
            g.setColor(Color.WHITE);
            g.setStroke(new BasicStroke(0.25f));
            draw(g, world.x(target), world.y(target), world.radius(target) + 0.6f);
        }
    }

    private void drawText(Graphics2D g, float scale) {
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        float health = Math.max(0, (game.health() - Swarm.DEAD) / (Swarm.HEALTHY - Swarm.DEAD));
        g.setColor(PLAYER);
        g.fillRect(0, 0, Math.round(health * Swarm.WIDTH * scale), Math.round(0.8f * scale));
        String points = String.format("%,d points", game.score());
        drawLabel(g, points, 2 * scale, 6 * scale, Math.round(3.6f * scale));
        String help = game.isOver()
                ? "Eaten! Hold R to turn back time."
                : "WASD: move    left button: fire    right button: bomb (50 points)    R: turn back time";
        drawLabel(g, help, 2 * scale, 97.5f * scale, Math.round(2 * scale));
    }

    private static void drawLabel(Graphics2D g, String text, float x, float y, int size) {
        g.setFont(new Font(Font.SANS_SERIF, Font.BOLD, size));
        int width = g.getFontMetrics().stringWidth(text);
        g.setColor(SHADE);
        g.fillRoundRect((int) x - size / 2, (int) y - size, width + size, size * 3 / 2, size, size);
        g.setColor(Color.WHITE);
        g.drawString(text, x, y);
    }
}
