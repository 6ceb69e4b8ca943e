package com.example.rollback;

import io.github.circles2d.Backend;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Both peers of one game, with a slow network between them. */
final class Match {
    private record Packet(int arrives, int to, int frame, long input) {}

    final Hockey[] peers;
    final long[] inputs = new long[2];
    int slowest = 9; // ticks that a packet takes at most
    Corrections[] seen; // null if nobody looks
    private final List<Packet> network = new ArrayList<>();
    private final Random random = new Random(3);
    private int tick;

    Match(Backend backend) {
        peers = new Hockey[] {new Hockey(backend), new Hockey(backend)};
    }

    /** Each peer takes what arrives, and makes a frame unless too much is on its way. */
    void nextTick(int frames) {
        for (int side : new int[] {0, 1}) {
            // Players without hands go somewhere else every 20 ticks.
            inputs[side] = tick % 20 == 0 ? (long) random.nextInt(600) << 32 | random.nextInt(400) : inputs[side];
            var rollback = peers[side].rollback;
            network.stream()
                    .filter(packet -> packet.arrives == tick && packet.to == side)
                    .forEach(packet -> rollback.setInput(1 - side, packet.frame, packet.input));
            if (seen != null) {
                seen[side].before();
            }
            rollback.reconcile();
            if (seen != null) {
                seen[side].after();
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
}
