package com.example.rollback;

import io.github.circles2d.Backend;
import org.teavm.jso.typedarrays.Float32Array;

/** The match of the sample game on the page, with what each peer sees as numbers. */
public final class Duel {
    private static final int HEAD = 5;
    private static final int OF_CORRECTION = 5;
    private static final int OF_CIRCLE = 3;

    private final Match match = new Match(Backend.JVM);

    /** Begins. */
    public Duel() {
        match.seen = new Corrections[] {new Corrections(match.peers[0]), new Corrections(match.peers[1])};
    }

    /** Sets how many ticks a packet takes at most, 2 or more. */
    public void setSlowest(int ticks) {
        match.slowest = ticks;
    }

    /** A player wants to be there. */
    public void steer(int side, int x, int y) {
        match.inputs[side] = (long) x << 32 | y;
    }

    /** A sixtieth of a second passes. */
    public void tick() {
        match.nextTick(Integer.MAX_VALUE);
    }

    /**
     * What a peer sees: points of both, frames that are a guess, how many guesses were wrong, and how many corrections follow. Each has the
     * place from which and to which, and how much of its time it has left. Circles follow, with x, y and radius.
     */
    public Float32Array seen(int side) {
        Hockey peer = match.peers[side];
        Corrections corrections = match.seen[side];
        corrections.look();
        float[] circles = corrections.circles;
        Float32Array numbers =
                new Float32Array(HEAD + OF_CORRECTION * corrections.all.size() + OF_CIRCLE * peer.world.size());
        numbers.set(0, peer.points[0]);
        numbers.set(1, peer.points[1]);
        numbers.set(2, peer.rollback.frame() - peer.rollback.confirmedFrames());
        numbers.set(3, peer.rollback.rollbacks());
        numbers.set(4, corrections.all.size());
        int at = HEAD;
        for (Corrections.Correction one : corrections.all) {
            numbers.set(at++, one.x());
            numbers.set(at++, one.y());
            numbers.set(at++, one.toX());
            numbers.set(at++, one.toY());
            numbers.set(at++, (one.ends() - corrections.frame) / (float) Corrections.FADE);
        }
        for (int id = 0; id < peer.world.idLimit(); id++) {
            if (!Float.isNaN(circles[4 * id])) {
                for (int k = 0; k < OF_CIRCLE; k++) {
                    numbers.set(at++, circles[4 * id + k]);
                }
            }
        }
        return numbers;
    }
}
