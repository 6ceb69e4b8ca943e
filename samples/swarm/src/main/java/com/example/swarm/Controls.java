package com.example.swarm;

/** What the player wants: set by mouse and keys, or by a script. */
final class Controls {
    float moveX; // -1 to 1
    float moveY;
    float aimX;
    float aimY;
    boolean fire;
    boolean bomb;

    /** A player without hands, who does the same in each game. */
    void script(int step) {
        moveX = 2 * swing(step, 280) - 1;
        moveY = 2 * swing(step + 70, 280) - 1;
        aimX = Swarm.WIDTH * swing(step, 90);
        aimY = Swarm.HEIGHT * swing(step + 23, 90);
        fire = true;
        bomb = step % 60 == 59;
    }

    /** From 1 to 0 and back in a period, on straight lines. */
    private static float swing(int step, int period) {
        return Math.abs(2f * (step % period) / period - 1);
    }
}
