package io.github.circles2d;

import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.replay.LogPlayer;
import java.io.IOException;
import java.io.InputStream;

/**
 * Makes the calls of a {@link Recording} again, step by step, and compares the hashes of the state with those in the log.
 *
 * <pre>{@code
 * try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
 *     Replay replay = new Replay(in, world);
 *     while (replay.step()) {
 *         draw(world);
 *     }
 *     if (replay.differs()) {
 *         log.warning(replay.difference());
 *     }
 * }
 * }</pre>
 *
 * <p><b>The world</b> may be any, on any back end: the replay replaces its state by that of the log. You may read, draw and query it
 * between steps. You may stop a replay before its end, and go on with the world. If you change the world between steps, the replay
 * differs.
 *
 * <p><b>A screen</b> shows a replay by a {@link FixedStep} of the same world: {@link FixedStep#advanceReplay} makes the steps that are
 * due by the log, at any rate of frames, and {@link FixedStep#positions} gives positions in between.
 *
 * <pre>{@code
 * FixedStep loop = new FixedStep(world, 1 / 60f);
 * while (!replay.hasEnded()) {
 *     loop.advanceReplay(secondsSinceTheLastFrame, replay);
 *     draw(loop.positions(null));
 * }
 * }</pre>
 *
 * <p><b>The log</b> may come from anywhere: it is checked as it is read, its calls are checked as all calls are, and it takes no more
 * memory than it has bytes. If it is no log, damaged or cut off, an IllegalArgumentException says so, and after which step; the world has
 * the state after the calls before. So a log that ends early, because its program died or its disk was full, replays up to there. If
 * another version of the library has other physics, it replays an old log to other states, and {@link #differs} says so.
 */
public final class Replay {
    private final LogPlayer player;

    /**
     * Makes a world what it was when the recording began.
     *
     * @param in a log from its beginning; it is not closed
     * @param world makes the calls
     * @throws IOException if the stream fails
     * @throws IllegalArgumentException if this is no log, or one that is damaged or cut off before its first step
     */
    public Replay(InputStream in, World world) throws IOException {
        Limits.notNull("in", in);
        player = new LogPlayer(in, Limits.notNull("world", world).simulation());
    }

    /**
     * Makes the next step, and the changes before it. Several steps of one call are made one by one.
     *
     * @return false if the log has come to its end, and only changes were left
     * @throws IOException if the stream fails
     * @throws IllegalArgumentException if the log is damaged or cut off
     */
    public boolean step() throws IOException {
        if (!player.makeChanges()) {
            return false;
        }
        player.makeStep();
        return true;
    }

    /** Makes the changes before the next step. Returns whether there is a step. */
    boolean makeChanges() throws IOException {
        return player.makeChanges();
    }

    /** Makes the step behind these changes. */
    void makeStep() throws IOException {
        player.makeStep();
    }

    /** Whether a world is the one that this plays in. */
    boolean plays(World world) {
        return player.plays(world.simulation());
    }

    /** {@return whether the log has come to its end: {@link #step} has returned false, or {@link FixedStep#advanceReplay} has made the last step} */
    public boolean hasEnded() {
        return player.hasEnded();
    }

    /**
     * Makes all steps that are left.
     *
     * @return this
     * @throws IOException if the stream fails
     * @throws IllegalArgumentException if the log is damaged or cut off
     */
    public Replay run() throws IOException {
        while (step()) {
            // the step has been made
        }
        return this;
    }

    /** {@return the number of steps made, at least 0} */
    public long steps() {
        return player.steps();
    }

    /** {@return whether some hash so far was not that of the log: whether the replay has left the recording} */
    public boolean differs() {
        return player.differsAt() >= 0;
    }

    /**
     * The first step after which the hash was not that of the log. If the recording has a hash for each step, this step went another
     * way. Else the step that did so is one of those after {@link #equalUpTo}.
     *
     * @return the number of the step, from 1 on; 0 if the states differ from the start; -1 if no hash has differed
     */
    public long firstDifference() {
        return player.differsAt();
    }

    /** {@return the number of the last step, before any difference, after which the hash was that of the log; 0 if there is none} */
    public long equalUpTo() {
        return player.equalUpTo();
    }

    /** {@return the first difference, for people: a sentence with the step and both hashes} */
    public String difference() {
        if (!differs()) {
            return "no difference in " + steps() + " steps";
        }
        String hashes = String.format("the hash is %016x, not %016x as recorded", player.hash(), player.recordedHash());
        if (firstDifference() == 0) {
            return "the states differ from the start: " + hashes;
        }
        return "step " + firstDifference() + " differs: " + hashes + "; the last equal hash is of step " + equalUpTo();
    }
}
