package com.example.rollback;

import io.github.circles2d.Backend;
import java.awt.BorderLayout;
import java.awt.GraphicsEnvironment;
import java.util.regex.Pattern;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

/** Both peers side by side, with a slow network between them; or with {@code --frames N} a game that plays itself. */
public final class Main {
    private final Match match;

    private Main(Backend backend) {
        match = new Match(backend);
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
        Hockey[] peers = match.peers;
        while (Math.min(peers[0].rollback.confirmedFrames(), peers[1].rollback.confirmedFrames()) < frames) {
            match.nextTick(frames);
        }
        for (Hockey peer : peers) {
            System.out.printf(
                    "rollback: %d frames, %d to %d points, %d events, hash %016x; rolled back %d times%n",
                    frames, peer.points[0], peer.points[1], peer.events, peer.hash, peer.rollback.rollbacks());
        }
    }

    private void open() {
        match.seen = new Corrections[] {new Corrections(match.peers[0]), new Corrections(match.peers[1])};
        Rink[] rinks = {new Rink(match.peers[0], match.seen[0], 0), new Rink(match.peers[1], match.seen[1], 1)};
        JFrame frame = new JFrame("Rollback: both peers of one game; the mouse on the left moves the left player");
        frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
        JSlider delay = new JSlider(2, 30, match.slowest);
        JLabel label = new JLabel();
        delay.addChangeListener(event -> {
            match.slowest = delay.getValue();
            label.setText("a packet takes up to " + match.slowest + " frames, " + 1000 * match.slowest / 60 + " ms");
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
                    match.inputs[0] = mouse == null ? match.inputs[0] : (long) mouse.x << 32 | mouse.y;
                    match.nextTick(Integer.MAX_VALUE);
                    frame.repaint();
                })
                .start();
    }
}
