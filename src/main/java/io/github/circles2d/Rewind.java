package io.github.circles2d;

import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.saves.Snapshots;
import io.github.circles2d.world.snapshots.SnapshotRing;

/**
 * Keeps the last frames of a world and goes back to any of them: for a key that rewinds, or for a search that tries moves.
 * {@link Rollback} uses it for rollback netcode, and has the rules for a game that repeats frames.
 *
 * <pre>{@code
 * Rewind rewind = new Rewind(world, 600);
 * rewind.save(frame);          // before the frame's changes and steps
 * ...
 * rewind.restore(frame - 10);  // the world is as it was when this frame was saved
 * }</pre>
 *
 * <p><b>Frames</b> have numbers of the caller's, which ascend; there may be gaps. {@link #save} drops the frames whose numbers are not
 * lower than its own, and the oldest one if there is no place. {@link #restore} drops none, so a player may move to and fro in time. A game
 * that rolls back restores a frame, repeats the frames since with its new inputs, and saves each of them again. The first save after a
 * restore drops the frames that are newer, since they belong to a past that did not happen. To look at a frame and come back to the
 * newest one, restore both and save neither.
 *
 * <p><b>Memory.</b> A frame takes as much as a snapshot: some 50 bytes a circle, and 60 a body that flies, 130 in a pile. 600 frames of 1,000 circles
 * are 30 MB, of 1,000 crates in a pile 80 MB.
 *
 * <p><b>State.</b> A restored world goes on to the same bits as it did before, on every back end. All that {@link World#restore}
 * brings back comes back, parameters such as gravity and the bounds too.
 *
 * <p><b>Handles</b> are those of the frame. Handles of circles that have been removed since are valid again. Handles of circles that have
 * been added since are stale, until the world gives the same ones again: it repeats its handles as it repeats its bits, so machines that
 * roll back differently agree on them. Save and restore the handles that your game keeps together with the frame.
 *
 * <p><b>The game's own state</b>, such as points and lives, is not in a frame. A number that belongs to one circle may be its tag
 * ({@link World#setTag}), which is in the frame. All else goes into an array beside this object, with as many places as it keeps frames;
 * the number of a frame decides the place:
 *
 * <pre>{@code
 * Rewind rewind = new Rewind(world, 600);
 * GameState[] states = new GameState[600]; // your own: points, lives, the handles of the players
 *
 * void save(int frame) {
 *     rewind.save(frame);
 *     states[frame % 600] = game.copy();
 * }
 *
 * void restore(int frame) {
 *     rewind.restore(frame); // refuses a frame that is not there, before the game's state changes
 *     game.set(states[frame % 600]);
 * }
 * }</pre>
 *
 * <p><b>Events</b> that have not been taken are in no frame, and {@link #restore} drops them. So take them before {@link #save}, or their
 * effects on your game are lost. The reported types of events and the hit speed are in no frame either: they stay as they are.
 *
 * <p><b>Cost.</b> A frame takes 33 bytes a circle and 5 or 6 a contact that presses. 1,000 circles in a dense heap take 49 KB a frame,
 * and 600 frames 30 MB. On the JVM, on one core of an AMD EPYC, {@link #save} takes 0.05 to 0.07 ms for them and {@link #restore} 0.04
 * ms. Neither leaves garbage once the memory of the frames has grown. (A frame whose time step, gravity or bounds differ from those of
 * the last one leaves some 50 bytes. A world in which dozens of reported pairs touch leaves what Java takes to sort them.) On an OpenCL
 * device each waits for the device, copies the whole state and allocates for it.
 *
 * <p>One thread at a time uses it, as the world.
 */
public final class Rewind {
    private static final int GREATEST_FRAMES = 1 << 20;

    private final Snapshots snapshots;
    private final SnapshotRing ring;

    /**
     * No frames yet. Memory comes as frames are saved.
     *
     * @param world the world
     * @param frames how many frames to keep, 1 to 1,048,576
     * @throws IllegalArgumentException if the number is out of range
     */
    public Rewind(World world, int frames) {
        Limits.notNull("world", world).simulation().check();
        snapshots = world.simulation().snapshots;
        ring = new SnapshotRing(Limits.within("the number of frames", frames, 1, GREATEST_FRAMES));
    }

    /**
     * Saves the world as it is. Frames from this number on are dropped, also those that are newer after a {@link #restore}, and the
     * oldest one if there is no place.
     *
     * @param frame the number of the frame
     */
    public void save(int frame) {
        snapshots.save(ring, frame);
    }

    /**
     * Makes the world what it was when a frame was saved. All frames stay.
     *
     * @param frame the number of the frame
     * @throws IllegalArgumentException if the frame is not there (any more); the message has the range of those that are
     */
    public void restore(int frame) {
        snapshots.restore(ring, frame);
    }

    /**
     * Drops all frames, as for a new level: the next {@link #save} begins anew, with any number. The memory of the frames stays for those
     * that come.
     */
    public void clear() {
        ring.clear();
    }

    /**
     * Whether a frame can be restored.
     *
     * @param frame the number of the frame
     * @return false if it has not been saved, or has been dropped
     */
    public boolean has(int frame) {
        return ring.has(frame);
    }

    /** {@return the number of frames that can be restored: at least 0, at most what the constructor was told} */
    public int size() {
        return ring.size();
    }

    /**
     * The oldest frame that can be restored.
     *
     * @return its number
     * @throws IllegalStateException if there is none
     */
    public int oldest() {
        return frame(0);
    }

    /**
     * The newest frame that can be restored.
     *
     * @return its number
     * @throws IllegalStateException if there is none
     */
    public int newest() {
        return frame(ring.size() - 1);
    }

    private int frame(int k) {
        if (ring.size() == 0) {
            throw new IllegalStateException("no frame has been saved");
        }
        return ring.frame(k);
    }

    /** {@return the memory of the frames in bytes} */
    public long bytes() {
        return ring.bytes();
    }
}
