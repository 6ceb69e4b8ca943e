package io.github.circles2d;

import io.github.circles2d.world.events.EventRows;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.reports.Reports;
import java.nio.Buffer;
import java.nio.BufferOverflowException;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Rollback netcode: frames are made at once, with predictions for the inputs that have not come yet. If an input turns out different from
 * its prediction, the world goes back to the frame of that input and makes the frames since again.
 *
 * <pre>{@code
 * Rollback rollback = new Rollback(world, game, 1 / 60f, 2, 8); // two players; up to 8 frames are predicted
 * while (playing()) { // once a frame
 *     for (Packet packet : arrived()) {
 *         rollback.setInput(packet.player, packet.frame, packet.input);
 *     }
 *     if (rollback.canAdvance()) {
 *         long keys = keys();
 *         send(me, rollback.frame(), keys);
 *         rollback.setInput(me, rollback.frame(), keys);
 *         rollback.advance();
 *     } else {
 *         rollback.reconcile(); // the others are too late: wait for them
 *     }
 *     draw(world);
 * }
 * }</pre>
 *
 * <p><b>A frame</b> is one step of the world, with the changes that {@link Game#beforeStep} makes before it by the inputs, and those
 * that {@link Game#afterStep(int, Events)} makes after it by its events. Frames are numbered from 0 on. The prediction for a player whose input has
 * not come is the input of the frame before, or 0 in frame 0. Inputs may come in any order, late, and more than once.
 *
 * <p>A frame is <i>confirmed</i> if it was made with the inputs of all players, and all frames before it were too. It is never made
 * again, and it is the same on all machines that play together.
 *
 * <h2>The rules</h2>
 *
 * <p>A frame that is made again must come out the same, here and on every other machine:
 *
 * <ol>
 *   <li><b>All that decides the game happens in a frame</b>, by the inputs, the world, and the state that {@link Game#save} writes. A
 *       change of the world that is made between frames is lost in the next rollback.
 *   <li><b>{@link Game#save} writes the state of the game</b>: points, lives, timers, and handles that change. All of the world comes back
 *       without it: circles, tags, kinds, gravity, bounds. Handles repeat, too: a circle that is added again gets the same one ({@link
 *       Rewind}).
 *   <li><b>Random numbers</b> come from {@link #randomLong}, {@link #randomInt} and {@link #randomFloat}, whose state comes back.
 *   <li><b>Events</b> of each frame go to {@link Game#afterStep(int, Events)}, for what they change in the game. Those of confirmed frames go to {@link
 *       Game#confirmed(int, Events)}, once and in order, for what cannot be taken back: sounds, statistics, the end of a match. Joints that go by themselves and
 *       touches of bodies have methods of the same names. Do not take events by {@link World#events}, {@link World#takeEvents}, {@link Joints#events} or {@link
 *       Bodies#events}: a frame that is made again tells them again. Events that wait when a frame begins are dropped.
 *   <li><b>The reported types of events and the hit speed</b> come back with a frame, so a frame may change them by {@link World#report}, {@link
 *       World#reportWalls}, {@link World#setHitSpeed}, {@link Joints#report} and {@link Bodies#report}. Snapshots and frames of {@link Rewind} do not have them.
 *   <li><b>Arithmetic</b> has the same bits on all machines by {@code + - * /}, {@code Math.sqrt} and {@code StrictMath}. Other functions
 *       of {@code Math} may differ. Nothing depends on a clock, on the order of a HashMap, or on another thread.
 * </ol>
 *
 * <p>To find out whether a game keeps these rules, note {@link World#hash} in {@link Game#afterStep(int, Events)}, by the number of the frame, and
 * compare it with that of the other machines in {@link Game#confirmed(int, Events)}.
 *
 * <p><b>Failures.</b> If a method of the game throws, the caller of {@link #advance} or {@link #reconcile} gets its exception. Nothing is
 * lost: the next call makes the frame again, from its start. Until then the world is in the middle of the frame.
 *
 * <p><b>Cost.</b> Each frame costs a step and a {@link Rewind#save}, also if it is made again, and a rollback costs a {@link
 * Rewind#restore}. Memory is that of as many frames of {@link Rewind} as may be predicted, with their events; {@link #bytes} tells it. It
 * grows with the world and not with time. On the JVM frames leave no garbage once it has grown, unless dozens of pairs touch that
 * are reported: saving them takes memory for a sort. A {@link Recording} of such a world writes each rollback; the inputs of the players
 * are a shorter log of a match.
 *
 * <p>This makes the steps, so a world has either this or a {@link FixedStep}. One thread at a time uses it, as the world.
 */
public final class Rollback {
    private static final int GREATEST_PLAYERS = 64;
    private static final int GREATEST_WINDOW = 3600;

    /** How far ahead inputs may come, in windows: other machines are up to one ahead of this, and delay their own inputs. */
    private static final int WINDOWS_OF_INPUTS = 4;

    private static final int LEAST_STATE = 64;
    private static final int GREATEST_STATE = 1 << 28;

    /**
     * The rules of a game, and its state apart from the world. {@link #beforeStep}, {@link #afterStep} and {@link #save} are called
     * again for frames that are made again. No method may give inputs or make frames.
     */
    public interface Game {
        /**
         * Makes the changes of a frame by the inputs, before its step.
         *
         * @param frame its number
         * @param inputs by player; some may be predictions. The array is used again
         */
        void beforeStep(int frame, long[] inputs);

        /**
         * Makes the changes of a frame by its events, after its step.
         *
         * @param frame its number
         * @param events those of its step, valid during the call
         */
        default void afterStep(int frame, Events events) {}

        /**
         * Makes the changes of a frame by the joints that went by themselves in it, behind {@link #afterStep(int, Events)}. There are some only if
         * {@link Joints#report} says so. Of joints that go by this call no event tells.
         *
         * @param frame its number
         * @param gone those of its changes and of its step, valid during the call
         */
        default void afterStep(int frame, JointEvents gone) {}

        /**
         * Makes the changes of a frame by what bodies have begun to touch or touch no more, behind {@link #afterStep(int, JointEvents)}. There are some
         * only if {@link Bodies#report} says so.
         *
         * @param frame its number
         * @param touches those of its changes and of its step, valid during the call
         */
        default void afterStep(int frame, BodyEvents touches) {}

        /**
         * Writes the state of the game, at the start of a frame. If the buffer is too short, let its BufferOverflowException pass: the
         * method is called again, with a longer one.
         *
         * @param to takes the state, up to 256 MB
         */
        void save(ByteBuffer to);

        /**
         * Reads the state of the game, to the end.
         *
         * @param from what {@link #save} has written
         */
        void restore(ByteBuffer from);

        /**
         * Takes note of a confirmed frame. The calls come in the order of frames, one for each; a call that throws is made again. The
         * world is at a later frame: do not change it.
         *
         * @param frame its number
         * @param events those of its step, valid during the call
         */
        default void confirmed(int frame, Events events) {}

        /**
         * Takes note of the joints that went by themselves in a confirmed frame, behind {@link #confirmed(int, Events)} and under the same rules.
         *
         * @param frame its number
         * @param gone those of its changes and of its step, valid during the call
         */
        default void confirmed(int frame, JointEvents gone) {}

        /**
         * Takes note of what bodies have begun to touch or touch no more in a confirmed frame, behind {@link #confirmed(int, JointEvents)} and under the
         * same rules.
         *
         * @param frame its number
         * @param touches those of its changes and of its step, valid during the call
         */
        default void confirmed(int frame, BodyEvents touches) {}
    }

    /** The state of the game at the start of a frame, what the world reported then, and the events of the frame. */
    private static final class Frame {
        ByteBuffer state = ByteBuffer.allocate(LEAST_STATE);
        long random;
        Reports.Settings reported;
        boolean reportedJoints;
        boolean reportedBodies;
        final EventRows events = new EventRows();
        final JointEvents joints = new JointEvents();
        final BodyEvents bodies = new BodyEvents();
    }

    private final World world;
    private final Game game;
    private final float timeStep;
    private final int window;
    private final Rewind rewind;
    private final FrameInputs inputs;
    private final long[] now;
    private final Events events = new Events();

    /** By place: those from the first that is not confirmed to the next one. */
    private final Frame[] frames;

    /** The number of frames that have been made, and the next one to confirm. */
    private int frame;

    private int confirmed;

    /** How much the game has been told of the next frame to confirm: nothing, its events, or its joints too. */
    private int told;

    /** The next frame to make: one that was made with a wrong prediction, or the next new one. */
    private int next;

    /** Whether the world and the game are at the start of that frame, and whether this is saved. */
    private boolean isAtStart = true;

    private boolean isSaved;
    private boolean isInGame;
    private boolean isInFrame;
    private long random;
    private long rollbacks;
    private long repeated;

    /**
     * Frames from the world and the game as they are.
     *
     * @param world the world that makes the steps
     * @param game the rules
     * @param timeStep the length of each step in seconds, 1e-6 to 1; games use 1 / 60f
     * @param players how many give inputs, 1 to 64
     * @param window how many frames may be made ahead, from the first frame that lacks an input on, 1 to 3,600. Games take about 8: an
     *     input may then come 8 frames late before the game waits for it
     * @throws IllegalArgumentException if a value is out of range
     */
    public Rollback(World world, Game game, float timeStep, int players, int window) {
        this.world = Limits.notNull("world", world);
        this.game = Limits.notNull("game", game);
        this.timeStep = Limits.within("the time step", timeStep, Limits.LEAST_STEP, Limits.GREATEST_STEP);
        now = new long[Limits.within("the number of players", players, 1, GREATEST_PLAYERS)];
        this.window = Limits.within("the window", window, 1, GREATEST_WINDOW);
        rewind = new Rewind(world, window);
        inputs = new FrameInputs(players, WINDOWS_OF_INPUTS * window);
        frames = new Frame[window];
        Arrays.setAll(frames, place -> new Frame());
    }

    /** {@return the number of the next new frame, which {@link #advance} makes: how many frames have been made} */
    public int frame() {
        return frame;
    }

    /** {@return the number of confirmed frames that {@link Game#confirmed(int, Events)} has been told of: at least 0, at most {@link #frame}} */
    public int confirmedFrames() {
        return confirmed;
    }

    /**
     * Sets the input of a player in a frame. If the frame has been made with another input, the next call of {@link #advance} or {@link
     * #reconcile} goes back to it. A game that delays its own inputs by some frames sets those of its first frames, too, to 0.
     *
     * @param player 0 to the number of players - 1
     * @param frame the number of the frame, 0 to {@link #confirmedFrames} + 4 windows - 1. In a confirmed frame the input is ignored:
     *     it has come before
     * @param input any number: keys as bits, sticks, the place of a mouse
     * @throws IllegalArgumentException if player or frame is out of range, or the player has another input in this frame
     * @throws IllegalStateException if a method of the game calls this
     */
    public void setInput(int player, int frame, long input) {
        refuseGame();
        if (inputs.set(player, frame, input) && frame < next) {
            next = frame;
            isAtStart = false;
        }
    }

    /** {@return whether {@link #advance} may make a frame: whether the window has room for it; false if inputs of other players must come first} */
    public boolean canAdvance() {
        return frame - Math.min(frame, inputs.complete()) < window;
    }

    /**
     * Does what {@link #reconcile} does, and makes the next new frame.
     *
     * @throws IllegalStateException if the window is full ({@link #canAdvance}), or a method of the game calls this
     */
    public void advance() {
        refuseGame();
        if (!canAdvance()) {
            throw new IllegalStateException("frame " + frame + " would be " + window + " frames ahead of frame "
                    + inputs.complete() + ", which lacks an input: call canAdvance first");
        }
        reconcile();
        make(frame + 1);
        frame = next;
    }

    /**
     * Makes frames again, from the first one on whose prediction was wrong, and tells {@link Game#confirmed(int, Events)} of those that have all
     * their inputs now.
     *
     * @throws IllegalStateException if a method of the game calls this
     */
    public void reconcile() {
        refuseGame();
        world.simulation().check();
        make(frame);
        int end = Math.min(frame, inputs.complete());
        while (confirmed < end) {
            isInGame = true;
            try {
                Frame made = frames[confirmed % window];
                if (told == 0) {
                    game.confirmed(confirmed, events.of(made.events));
                    told = 1;
                }
                if (told == 1) {
                    game.confirmed(confirmed, made.joints);
                    told = 2;
                }
                game.confirmed(confirmed, made.bodies);
            } finally {
                isInGame = false;
            }
            inputs.dropFirst();
            confirmed++;
            told = 0;
        }
    }

    private void refuseGame() {
        if (isInGame) {
            throw new IllegalStateException("a method of the game is running: it cannot give inputs or make frames");
        }
    }

    /** Makes all frames that are to be made before one. */
    private void make(int end) {
        isInGame = true;
        try {
            if (!isAtStart) {
                goBack();
            }
            while (next < end) {
                if (!isSaved) {
                    save();
                }
                makeNext();
            }
        } finally {
            isInGame = false;
        }
    }

    /** Makes the world and the game what they were at the start of the next frame to make. May be repeated if it fails. */
    private void goBack() {
        Frame to = frames[next % window];
        world.simulation().reports.restore(to.reported); // first: it decides which pairs that touch are restored
        world.joints().report(to.reportedJoints);
        world.bodies().report(to.reportedBodies);
        rewind.restore(next);
        random = to.random;
        ByteBuffer state = to.state;
        ((Buffer) state).rewind();
        game.restore(state);
        if (state.hasRemaining()) {
            throw new IllegalStateException("restore has read " + state.position() + " of the " + state.limit()
                    + " bytes that save has written");
        }
        rollbacks += next < frame ? 1 : 0;
        isAtStart = true;
        isSaved = true;
    }

    private void save() {
        Frame start = frames[next % window];
        while (!hasSavedGame(start.state)) {
            start.state = ByteBuffer.allocate(2 * start.state.capacity());
        }
        start.random = random;
        start.reported = world.simulation().reports.settings();
        start.reportedJoints = world.simulation().joints.reports();
        start.reportedBodies = world.simulation().rigidReads.reports();
        world.events();
        world.joints().events();
        world.bodies().events();
        rewind.save(next);
        isSaved = true;
    }

    private boolean hasSavedGame(ByteBuffer state) {
        try {
            ((Buffer) state).clear();
            game.save(state);
            ((Buffer) state).flip();
            return true;
        } catch (BufferOverflowException e) {
            if (state.capacity() >= GREATEST_STATE) {
                throw e;
            }
            return false;
        }
    }

    private void makeNext() {
        inputs.read(next, now);
        isAtStart = false;
        isInFrame = true;
        try {
            game.beforeStep(next, now);
            world.step(timeStep);
            Events happened = world.events();
            game.afterStep(next, happened);
            JointEvents gone = world.joints().events();
            game.afterStep(next, gone);
            BodyEvents touches = world.bodies().events();
            game.afterStep(next, touches);
            Frame made = frames[next % window];
            happened.rows().moveTo(made.events);
            gone.rows().moveTo(made.joints.rows());
            touches.rows().moveTo(made.bodies.rows());
        } finally {
            isInFrame = false;
        }
        repeated += next < frame ? 1 : 0;
        next++;
        isAtStart = true;
        isSaved = false;
    }

    /**
     * Sets the seed of the random numbers. It is 0 at first.
     *
     * @param seed any number, the same on all machines
     * @throws IllegalStateException if frames have been made, and none is being made
     */
    public void seed(long seed) {
        if (frame > 0 || !isAtStart) {
            requireFrame();
        }
        isSaved = false; // a frame that failed may have left the start saved with another seed
        random = seed;
    }

    /**
     * A random number that is the same on all machines (SplitMix64).
     *
     * @return any long
     * @throws IllegalStateException if no frame is being made
     */
    public long randomLong() {
        requireFrame();
        random += 0x9e3779b97f4a7c15L;
        long mixed = (random ^ random >>> 30) * 0xbf58476d1ce4e5b9L;
        mixed = (mixed ^ mixed >>> 27) * 0x94d049bb133111ebL;
        return mixed ^ mixed >>> 31;
    }

    /**
     * A random whole number that is the same on all machines.
     *
     * @param bound at least 1
     * @return 0 to bound - 1
     * @throws IllegalArgumentException if the bound is less than 1
     * @throws IllegalStateException if no frame is being made
     */
    public int randomInt(int bound) {
        Limits.within("the bound", bound, 1, Integer.MAX_VALUE);
        return (int) ((randomLong() >>> 32) * bound >>> 32);
    }

    /**
     * A random number that is the same on all machines.
     *
     * @return 0 to less than 1
     * @throws IllegalStateException if no frame is being made
     */
    public float randomFloat() {
        return (randomLong() >>> 40) * 0x1p-24f;
    }

    private void requireFrame() {
        if (!isInFrame) {
            throw new IllegalStateException(
                    "no frame is being made: random numbers belong into beforeStep and afterStep");
        }
    }

    /** {@return how many times a wrong prediction has led back to an earlier frame, at least 0} */
    public long rollbacks() {
        return rollbacks;
    }

    /** {@return how many frames have been made again because of wrong predictions, at least 0} */
    public long repeatedFrames() {
        return repeated;
    }

    /** {@return the memory of the frames in bytes} */
    public long bytes() {
        long sum = rewind.bytes();
        for (Frame made : frames) {
            sum += made.state.capacity()
                    + made.events.bytes()
                    + made.joints.rows().bytes()
                    + made.bodies.rows().bytes();
        }
        return sum;
    }
}
