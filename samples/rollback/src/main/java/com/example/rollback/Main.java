package com.example.rollback;

import io.github.circles2d.Backend;
import java.awt.Graphics;
import java.awt.GraphicsEnvironment;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.regex.Pattern;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

/** Both peers side by side, with a slow network between them; or with {@code --frames N} a game that plays itself. */
public final class Main extends JComponent {
    private record Packet(int arrives, int to, int frame, long input) {}

    private final Hockey[] peers;
    private final long[] inputs = new long[2];
    private final List<Packet> network = new ArrayList<>();
    private final Random random = new Random(3);
    private int tick;

    private Main(Backend backend) {
        peers = new Hockey[] {new Hockey(backend), new Hockey(backend)};
    }

    public static void main(String[] arguments) {
        String name = "AUTO|JVM|OPENCL_CPU|OPENCL_GPU", pattern = "(--frames (\\d{1,6}) ?|--backend (" + name + ") ?)*";
        var options = Pattern.compile(pattern).matcher(String.join(" ", arguments));
        if (!options.matches() || options.group(2) == null && GraphicsEnvironment.isHeadless()) {
            String problem = "rollback: there is no display to show a window on; without one: --frames 300";
            System.err.println(options.matches() ? problem : "usage: rollback [--frames N] [--backend " + name + "]");
            System.exit(options.matches() ? 1 : 2);
        }
        Main main = new Main(options.group(3) == null ? Backend.AUTO : Backend.valueOf(options.group(3)));
        if (options.group(2) != null) {
            main.playAlone(Integer.parseInt(options.group(2)));
        } else {
            SwingUtilities.invokeLater(main::open);
        }
    }

    private void playAlone(int frames) {
        while (Math.min(peers[0].rollback.confirmedFrames(), peers[1].rollback.confirmedFrames()) < frames) {
            nextTick(frames);
        }
        for (Hockey peer : peers) {
            System.out.printf(
                    "rollback: %d frames, %d to %d points, %d events, hash %016x; rolled back %d times%n",
                    frames, peer.points[0], peer.points[1], peer.events, peer.hash, peer.rollback.rollbacks());
        }
    }

    /** Each peer takes what arrives, and makes a frame unless too much is on its way. */
    private void nextTick(int frames) {
        for (int side : new int[] {0, 1}) {
            // Players without hands go somewhere else every 20 ticks.
            inputs[side] = tick % 20 == 0 ? (long) random.nextInt(600) << 32 | random.nextInt(400) : inputs[side];
            var rollback = peers[side].rollback;
            network.stream()
                    .filter(packet -> packet.arrives == tick && packet.to == side)
                    .forEach(packet -> rollback.setInput(1 - side, packet.frame, packet.input));
            rollback.reconcile();
            if (rollback.canAdvance() && rollback.frame() < frames) {
                // A packet takes 2 to 9 ticks, so it may arrive before others that are sent earlier.
                network.add(new Packet(tick + 2 + random.nextInt(8), 1 - side, rollback.frame(), inputs[side]));
                rollback.setInput(side, rollback.frame(), inputs[side]);
                rollback.advance();
            }
        }
        network.removeIf(packet -> packet.arrives == tick);
        tick++;
    }

    private void open() {
        JFrame frame = new JFrame("Rollback: both peers of one game; the mouse on the left moves the left player");
        frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
        frame.add(this);
        frame.setSize(2 * Hockey.WIDTH + 20, Hockey.HEIGHT + 40);
        frame.setVisible(true);
        new Timer(1000 / 60, event -> {
                    var mouse = getMousePosition();
                    inputs[0] = mouse == null ? inputs[0] : (long) mouse.x << 32 | mouse.y;
                    nextTick(Integer.MAX_VALUE);
                    repaint();
                })
                .start();
    }

    @Override
    protected void paintComponent(Graphics g) {
        for (Hockey peer : peers) {
            float[] circles = new float[4 * peer.world.idLimit()];
            peer.world.readById(circles, null);
            for (int k = 0; k < circles.length; k += 4) {
                int radius = (int) circles[k + 2];
                g.fillOval((int) circles[k] - radius, (int) circles[k + 1] - radius, 2 * radius, 2 * radius);
            }
            g.drawString(peer.points[0] + " : " + peer.points[1], Hockey.WIDTH / 2, 20);
            g.translate(Hockey.WIDTH, 0);
        }
    }
}
