package com.example.rollback;

import java.util.ArrayList;
import java.util.List;

/** Where a late input showed one peer that a guess was wrong: from what it had shown to what is. */
final class Corrections {
    private static final float SEEN = 2, JUMP = 150; // a correction is so far at least; what is farther is a new puck
    static final int FADE = 30; // frames

    record Correction(float x, float y, float toX, float toY, int ends) {}

    final List<Correction> all = new ArrayList<>();
    float[] circles = new float[0]; // by id: x, y, radius and mass
    int frame;
    private final Hockey peer;
    private float[] shown = new float[0];

    Corrections(Hockey peer) {
        this.peer = peer;
    }

    void before() {
        shown = read(shown);
    }

    void after() {
        circles = read(circles);
        frame++;
        all.removeIf(one -> one.ends < frame);
        for (int k = 0; k < Math.min(circles.length, shown.length); k += 4) {
            float dx = circles[k] - shown[k], dy = peer.world.shortestY(shown[k + 1], circles[k + 1]);
            float way = (float) Math.sqrt(dx * dx + dy * dy);
            if (way > SEEN && way < JUMP) {
                all.add(new Correction(shown[k], shown[k + 1], circles[k], shown[k + 1] + dy, frame + FADE));
            }
        }
    }

    /** The circles as they are now. */
    void look() {
        circles = read(circles);
    }

    private float[] read(float[] to) {
        float[] room = to.length < 4 * peer.world.idLimit() ? new float[4 * peer.world.idLimit()] : to;
        peer.world.readById(room, null);
        return room;
    }
}
