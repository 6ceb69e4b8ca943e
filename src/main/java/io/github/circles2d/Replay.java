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
 * <p><b>The world</b> may be any, on any back end: its own state gives way to that of the log. It may be read, drawn and queried between
 * steps, and a replay that is not played to its end leaves a world to go on with. Changes make it differ.
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
 * memory than it has bytes. What is no log, is damaged or is cut off throws an IllegalArgumentException that says which of these it is,
 * and after which step; the world is then what the calls before have made it. So a log that ends early, because its program died or its
 * disk was full, replays up to there. A version of the library whose physics are others replays an old log to other states, and {@link
 * #differs} says so.
 */
public final class Replay {
    private final LogPlayer player;

    /**
     * Makes a world what it was when the recording began.
     *
     * @param in a log from its beginning; it is not closed
     * @param world makes the calls
     * @throws IOException where the stream fails
     * @throws IllegalArgumentException where this is no log, or one that is damaged or cut off before its first step
     */
    public Replay(InputStream in, World world) throws IOException {
        Limits.notNull("in", in);
        player = new LogPlayer(in, Limits.notNull("world", world).simulation());
    }

    /**
     * Makes the next step, and the changes before it. Several steps of one call are made one by one.
     *
     * @return false where the log has come to its end, and only changes were left
     * @throws IOException where the stream fails
     * @throws IllegalArgumentException where the log is damaged or cut off
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

    /**
     * Whether the log has come to its end: {@link #step} has returned false, or {@link FixedStep#advanceReplay} has made the last step.
     *
     * @return true where no step is left
     */
    public boolean hasEnded() {
        return player.hasEnded();
    }

    /**
     * Makes all steps that are left.
     *
     * @return this
     * @throws IOException where the stream fails
     * @throws IllegalArgumentException where the log is damaged or cut off
     */
    public Replay run() throws IOException {
        while (step()) {
            // the step has been made
        }
        return this;
    }

    /**
     * The number of steps made.
     *
     * @return at least 0
     */
    public long steps() {
        return player.steps();
    }

    /**
     * Whether some hash so far was not that of the log.
     *
     * @return true where the replay has left the recording
     */
    public boolean differs() {
        return player.differsAt() >= 0;
    }

    /**
     * The first step after which the hash was not that of the log. It is the step that went another way if the recording has a hash for
     * each step. Else that is one of those after {@link #equalUpTo}.
     *
     * @return the number of the step, from 1 on; 0 where the states differ from the start; -1 where no hash has differed
     */
    public long firstDifference() {
        return player.differsAt();
    }

    /**
     * The last step, before any difference, after which the hash was that of the log.
     *
     * @return the number of the step; 0 where there is none
     */
    public long equalUpTo() {
        return player.equalUpTo();
    }

    /**
     * The first difference, for people.
     *
     * @return a sentence with the step and both hashes
     */
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
