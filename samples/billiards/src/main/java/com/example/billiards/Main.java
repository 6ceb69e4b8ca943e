package com.example.billiards;

import io.github.circles2d.Backend;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Queries;
import java.awt.AWTEvent;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsEnvironment;
import java.awt.RenderingHints;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
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
    private static final int SCALE = 400, EDGE = 60, WIDTH = 1136, HEIGHT = 628; // pixels a metre, and pixels
    private static final int[] COLORS = { // by number; a striped ball has the colour of the ball eight before it
        0xf4f0e2, 0xf2c230, 0x2456c9, 0xd8312f, 0x6a3da3, 0xf07c25, 0x1f8a4c, 0x8e2430, 0x1c1c20
    };
    private final Billiards game;
    private final FixedStep loop;
    private final float[] ball = new float[Queries.HIT_STRIDE], cushion = new float[Queries.HIT_STRIDE];

    private Main(Backend backend) {
        game = new Billiards(backend);
        loop = new FixedStep(game.world, Billiards.STEP);
        setSize(WIDTH, HEIGHT);
    }

    public static void main(String[] arguments) throws IOException {
        String name = "AUTO|JVM|OPENCL_CPU|OPENCL_GPU";
        String pattern = "(--frames (\\d{1,6}) ?|--backend (" + name + ") ?|--picture (.+\\.png) ?)*";
        var options = Pattern.compile(pattern).matcher(String.join(" ", arguments));
        if (!options.matches() || options.group(2) == null && GraphicsEnvironment.isHeadless()) {
            String usage = "usage: billiards [--frames N [--picture FILE.png]] [--backend " + name + "]";
            System.err.println(usage + (options.matches() ? "; without a display: --frames 300" : ""));
            System.exit(options.matches() ? 1 : 2);
        }
        Main main = new Main(options.group(3) == null ? Backend.AUTO : Backend.valueOf(options.group(3)));
        int frames = options.group(2) == null ? 0 : Integer.parseInt(options.group(2));
        for (int frame = 0; frame < frames; frame++) {
            main.game.playAlone();
            main.loop.advance(1 / 60f, main.game);
        }
        if (frames == 0) {
            SwingUtilities.invokeLater(main::open);
            return;
        }
        Billiards game = main.game;
        String format = "billiards: %d frames, %d shots, %d balls potted, %d fouls, hash %016x%n";
        System.out.printf(format, frames, game.shots, game.potted, game.fouls, game.world.hash());
        if (options.group(4) != null) {
            game.playAlone(); // aims, if the cue ball lies still
            BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
            main.paintComponent(image.createGraphics());
            ImageIO.write(image, "png", new File(options.group(4)));
        }
    }

    private void open() {
        JFrame frame =
                new JFrame("Billiards: click to shoot, harder from afar; the arrow keys move where the cue hits");
        frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
        setPreferredSize(getSize());
        setFocusable(true); // for keys
        enableEvents(AWTEvent.KEY_EVENT_MASK | AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_MOTION_EVENT_MASK);
        frame.add(this);
        frame.pack();
        frame.setVisible(true);
        new Timer(1000 / 60, event -> {
                    loop.advance(1 / 60f, game);
                    repaint();
                })
                .start();
    }

    @Override
    protected void processEvent(AWTEvent event) {
        if (event instanceof MouseEvent mouse) {
            float x = (float) (mouse.getX() - EDGE) / SCALE, y = (float) (mouse.getY() - EDGE) / SCALE;
            game.aimAt(x, y);
            if (mouse.getID() == MouseEvent.MOUSE_PRESSED && game.isReady()) {
                game.wantedSpeed = 4 * (float) Math.hypot(x - game.world.x(game.cue), y - game.world.y(game.cue));
            }
        } else if (event instanceof KeyEvent key && key.getID() == KeyEvent.KEY_PRESSED) {
            switch (key.getKeyCode()) { // farther out the cue would slip off
                case KeyEvent.VK_RIGHT -> game.side = Math.min(game.side + 0.1f, 0.4f);
                case KeyEvent.VK_LEFT -> game.side = Math.max(game.side - 0.1f, -0.4f);
                case KeyEvent.VK_UP -> game.top = Math.min(game.top + 0.1f, 0.4f);
                case KeyEvent.VK_DOWN -> game.top = Math.max(game.top - 0.1f, -0.4f);
            }
        }
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics;
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(new Color(0x4a2c1a));
        g.fillRect(0, 0, WIDTH, HEIGHT);
        g.setColor(new Color(0x17795a));
        g.fillRect(34, 34, WIDTH - 68, HEIGHT - 68);
        g.setColor(Color.WHITE);
        g.drawString(game.potted + " balls, " + game.shots + " shots, " + game.fouls + " fouls", EDGE, 20);
        g.translate(EDGE, EDGE);
        g.scale(SCALE, SCALE);
        for (float[] pocket : Billiards.POCKETS) {
            disc(g, 0x080808, pocket[0], pocket[1], Billiards.HOLE);
        }
        g.setColor(new Color(0x0e4a36));
        for (float[] c : Billiards.CUSHIONS) {
            Path2D.Float path = new Path2D.Float(new Line2D.Float(c[0], c[1], c[2], c[3]));
            path.append(new Line2D.Float(c[4], c[5], c[6], c[7]), true);
            g.fill(path);
        }
        var positions = loop.positions(null);
        var angles = loop.angles();
        for (int id = Billiards.POCKETS.length; id < game.world.idLimit(); id++) {
            if (!Float.isNaN(positions.get(2 * id))) {
                ball(g, game.world.handle(id), positions.get(2 * id), positions.get(2 * id + 1), angles.get(id));
            }
        }
        if (game.isReady()) { // the cue, and how far the cue ball would come: a disc that moves until it meets
            // something
            float x = game.world.x(game.cue), y = game.world.y(game.cue), dx = game.aimX, dy = game.aimY;
            game.balls.circleCast(x, y, Billiards.RADIUS, 3 * dx, 3 * dy, ball);
            game.world.queries().terrain().circleCast(x, y, Billiards.RADIUS, 3 * dx, 3 * dy, cushion);
            float way = Math.min(ball[Queries.DISTANCE], cushion[Queries.DISTANCE]);
            line(g, 0xffffff, 0.003f, x, y, x + way * dx, y + way * dy);
            line(g, 0xd9b37c, 0.014f, x - 0.05f * dx, y - 0.05f * dy, x - 1.2f * dx, y - 1.2f * dy);
        }
        disc(g, COLORS[0], 2.44f, -0.105f, 0.035f); // where the cue hits
        disc(g, 0xd8312f, 2.44f + 0.035f * game.side, -0.105f - 0.035f * game.top, 0.007f);
    }

    /** A ball has a mark that turns with it, and a striped one a band. */
    private void ball(Graphics2D g, long ball, float x, float y, float angle) {
        int number = (int) game.world.tag(ball);
        float r = Billiards.RADIUS, cos = 0.7f * r * (float) Math.cos(angle), sin = 0.7f * r * (float) Math.sin(angle);
        disc(g, 0x0c3d2c, x + 0.2f * r, y + 0.25f * r, r); // its shadow
        disc(g, COLORS[number > 8 ? 0 : number], x, y, r);
        line(g, COLORS[number > 8 ? number - 8 : number], 0.7f * r, x - cos, y - sin, x + cos, y + sin);
        disc(g, number == 0 ? 0xd8312f : COLORS[0], x + 0.5f * sin, y - 0.5f * cos, 0.25f * r);
    }

    private static void line(Graphics2D g, int color, float width, float x1, float y1, float x2, float y2) {
        g.setColor(new Color(color));
        g.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(new Line2D.Float(x1, y1, x2, y2));
    }

    private static void disc(Graphics2D g, int color, float x, float y, float radius) {
        g.setColor(new Color(color));
        g.fill(new Ellipse2D.Float(x - radius, y - radius, 2 * radius, 2 * radius));
    }
}
