package io.github.circles2d;

import io.github.circles2d.world.model.Limits;

/** The inputs of the players by frame: those that have come, and predictions in place of the others. A ring of frames. */
final class FrameInputs {
    private final int players;
    private final int frames;

    /** By frame and player: the input, or the last prediction. */
    private final long[] inputs;

    private final boolean[] known;

    /** By player: the input of the frame before the first one. */
    private final long[] before;

    private int first;
    private int complete;

    /**
     * No inputs.
     *
     * @param players how many
     * @param frames how many frames there are from the first one on
     */
    FrameInputs(int players, int frames) {
        this.players = players;
        this.frames = frames;
        inputs = new long[players * frames];
        known = new boolean[players * frames];
        before = new long[players];
    }

    /** The first frame that lacks the input of some player. */
    int complete() {
        return complete;
    }

    /**
     * Takes the input of a player for a frame.
     *
     * @return whether it is another than the frame had: a prediction was wrong, unless the frame has not been made yet
     */
    boolean set(int player, int frame, long input) {
        Limits.within("the player", player, 0, players - 1);
        Limits.within("the frame", frame, 0, first + frames - 1);
        if (frame < first) {
            return false; // it came before, else the frame would not be complete
        }
        int at = at(frame) + player;
        boolean differs = inputs[at] != input;
        if (known[at]) {
            if (differs) {
                throw new IllegalArgumentException("player " + player + " has the input " + inputs[at] + " in frame "
                        + frame + " already, and cannot have " + input + " too");
            }
            return false;
        }
        inputs[at] = input;
        known[at] = true;
        while (complete - first < frames && isComplete(complete)) {
            complete++;
        }
        return differs;
    }

    private int at(int frame) {
        return frame % frames * players;
    }

    private boolean isComplete(int frame) {
        for (int player = 0; player < players; player++) {
            if (!known[at(frame) + player]) {
                return false;
            }
        }
        return true;
    }

    /** Gives the inputs of a frame by player. Whose input has not come is taken to do as in the frame before, which was read before. */
    void read(int frame, long[] into) {
        for (int player = 0; player < players; player++) {
            int at = at(frame) + player;
            if (!known[at]) {
                inputs[at] = frame == first ? before[player] : inputs[at(frame - 1) + player];
            }
            into[player] = inputs[at];
        }
    }

    /** Drops the first frame, which is complete. */
    void dropFirst() {
        int at = at(first);
        System.arraycopy(inputs, at, before, 0, players);
        for (int player = 0; player < players; player++) {
            known[at + player] = false;
            inputs[at + player] = 0;
        }
        first++;
    }
}
