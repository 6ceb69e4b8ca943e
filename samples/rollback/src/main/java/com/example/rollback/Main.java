package com.example.rollback;

import io.github.circles2d.Backend;
import java.awt.BorderLayout;
import java.awt.GraphicsEnvironment;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.regex.Pattern;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

/** Both peers side by side, with a slow network between them; or with {@code --frames N} a game that plays itself. */
public final class Main {
    private record Packet(int arrives, int to, int frame, long input) {}

    private final Hockey[] peers;
    private final long[] inputs = new long[2];
    private final List<Packet> network = new ArrayList<>();
    private final Random random = new Random(3);
    private int slowest = 9; // ticks that a packet takes at most
    private int tick;
    private Rink[] rinks; // null without a window

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
            if (rinks != null) {
                rinks[side].beforeCorrection();
            }
            rollback.reconcile();
            if (rinks != null) {
                rinks[side].afterCorrection();
            }
            if (rollback.canAdvance() && rollback.frame() < frames) {
                // A packet takes 2 ticks at least, so it may arrive before others that are sent earlier.
                int ticks = 2 + random.nextInt(slowest - 1);
                network.add(new Packet(tick + ticks, 1 - side, rollback.frame(), inputs[side]));
                rollback.setInput(side, rollback.frame(), inputs[side]);
                rollback.advance();
            }
        }
        network.removeIf(packet -> packet.arrives == tick);
        tick++;
    }

    private void open() {
        rinks = new Rink[] {new Rink(peers[0], 0), new Rink(peers[1], 1)};
        JFrame frame = new JFrame("Rollback: both peers of one game; the mouse on the left moves the left player");
        frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
        JSlider delay = new JSlider(2, 30, slowest);
        JLabel label = new JLabel();
        delay.addChangeListener(event -> {
            slowest = delay.getValue();
            label.setText("a packet takes up to " + slowest + " frames, " + 1000 * slowest / 60 + " ms");
        });
        delay.getChangeListeners()[0].stateChanged(null);
        JPanel network = new JPanel();
        network.add(label);
        network.add(delay);
        JPanel both = new JPanel();
        both.add(rinks[0]);
        both.add(rinks[1]);
        for (var panel : new JPanel[] {network, both}) {
            panel.setBackground(Rink.GROUND);
        }
        delay.setBackground(Rink.GROUND);
        label.setForeground(Rink.TEXT);
        frame.add(both, BorderLayout.CENTER);
        frame.add(network, BorderLayout.SOUTH);
        frame.pack();
        frame.setVisible(true);
        new Timer(1000 / 60, event -> {
                    var mouse = rinks[0].mouse();
                    inputs[0] = mouse == null ? inputs[0] : (long) mouse.x << 32 | mouse.y;
                    nextTick(Integer.MAX_VALUE);
                    frame.repaint();
                })
                .start();
    }
}
