package io.github.circles2d;

import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.opencl.RunningBuilds;
import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.snapshots.SavedState;
import java.lang.ref.SoftReference;
import java.util.HashSet;
import java.util.Set;
import java.util.function.IntFunction;

/**
 * Opens a device for a world, compiles kernels for it, and rehearses a move there, on a thread beside the world's. The thread ends when it has
 * done what it was asked for, and keeps no JVM alive; an exit waits for the program that is being compiled, or the round of a rehearsal, and not
 * for the next.
 */
final class DeviceBeside {
    /** A device that would not take so many circles, not even in a rehearsal, and why. */
    record Lack(String device, int circles, Throwable why) {}

    /** A rehearsal has a quarter more circles than there are, so that the next ones need none. */
    private static final int SPARE = 4;

    /** Opens a pipeline with room for so many circles, or throws why there is none. */
    private final IntFunction<Pipeline> opens;

    /** What the device was ready for when it was asked last: to ask in each step would be garbage. */
    private Readiness last;

    /** Null until it is open. Belongs to the thread beside while that is at work. */
    private Pipeline device;

    private Thread thread;
    private boolean closed;

    /** What a compiler has refused. */
    private final Set<Readiness> refused = new HashSet<>();

    /** Why a compiler has refused the last of them, if nobody has asked yet; else null. */
    private Throwable refusal;

    /** What moves have been rehearsed for, and of how many circles. */
    private final Set<Readiness> rehearsed = new HashSet<>();

    private int room;

    /** For a state on the way, if a rehearsal has left some and nobody has taken it. */
    private SoftReference<SavedState> memory = new SoftReference<>(null);

    /** What the device has lacked, if nobody has asked yet; else null. */
    private Lack lack;

    /** Why there is no device, and never will be; null if there may be one. */
    private Throwable failure;

    DeviceBeside(IntFunction<Pipeline> opens) {
        this.opens = opens;
    }

    /** The pipeline, if it is ready for so many circles; else null. */
    synchronized Pipeline ready(Readiness wanted, int circles) {
        if (thread != null || device == null || circles > room) {
            return null;
        }
        if (wanted != last && rehearsed.contains(wanted) && device.isReady(wanted)) {
            last = wanted;
        }
        return wanted == last ? device : null;
    }

    /** Begins to open it, unless that goes on or is of no use. */
    void open(int circles) {
        prepare(null, circles, circles);
    }

    /**
     * Begins to make it ready, likewise.
     *
     * @param wanted null opens it alone
     * @param circles how many there are
     * @param expected for how many it is made ready if it has the memory; at least as many
     */
    synchronized void prepare(Readiness wanted, int circles, int expected) {
        if (thread == null && failure == null && !closed && !refused.contains(wanted)) {
            last = null;
            thread = new Thread(() -> work(wanted, circles, expected), "circles2d beside");
            thread.setDaemon(true);
            thread.start();
        }
    }

    /** Why there is no device; null if there is one, or may be. */
    synchronized Throwable failure() {
        return failure;
    }

    /** Why a compiler has refused kernels, once; else null. */
    synchronized Throwable takeRefusal() {
        Throwable taken = refusal;
        refusal = null;
        return taken;
    }

    private void work(Readiness wanted, int circles, int expected) {
        Throwable thrown = null;
        try {
            if (device == null) {
                RunningBuilds.make(() -> take(opens.apply(expected)));
            }
            if (wanted != null && goesOn()) {
                device.compile(wanted);
                rehearse(wanted, circles, expected);
            }
        } catch (RuntimeException | Error e) {
            thrown = e;
        }
        end(wanted, thrown);
    }

    private synchronized void take(Pipeline opened) {
        device = opened;
    }

    private synchronized boolean goesOn() {
        return !closed && !RunningBuilds.isExiting();
    }

    private void rehearse(Readiness wanted, int circles, int expected) {
        try {
            int most = expected + expected / SPARE;
            if (!rehearse(wanted, most, most > circles) && goesOn()) {
                rehearse(wanted, circles, false);
            }
        } catch (OpenClException e) {
            lack(new Lack(device.device(), circles, e));
        } catch (RuntimeException | Error e) { // of the heap, perhaps: the move itself may go well
            Notice.debug("World rehearses no move to " + device.device() + ": " + e);
            rehearsed(wanted, circles + circles / SPARE, null);
        }
    }

    /** Returns false, where that may be, if the device refuses so many circles. */
    private boolean rehearse(Readiness wanted, int circles, boolean mayRefuse) {
        try {
            rehearsed(wanted, circles, Rehearsal.of(device, wanted, circles, this::goesOn));
            return true;
        } catch (OpenClException e) {
            if (mayRefuse) {
                return false;
            }
            throw e;
        }
    }

    private synchronized void rehearsed(Readiness wanted, int circles, SavedState left) {
        rehearsed.add(wanted);
        room = Math.max(room, circles);
        memory = new SoftReference<>(left);
    }

    private synchronized void lack(Lack of) {
        lack = closed || RunningBuilds.isExiting() ? null : of;
    }

    /** What the device has lacked in a rehearsal, once; else null. */
    synchronized Lack takeLack() {
        Lack taken = lack;
        lack = null;
        return taken;
    }

    /** Memory for a state on the way, once; null if there is none. */
    synchronized SavedState takeMemory() {
        SavedState taken = memory.get();
        memory.clear();
        return taken;
    }

    private synchronized void end(Readiness wanted, Throwable thrown) {
        thread = null;
        if (device == null) {
            failure = thrown;
        } else if (thrown != null) {
            refused.add(wanted);
            refusal = thrown;
        }
        if (closed) {
            closeDevice();
        }
    }

    /** Frees the device, which may be opened again. */
    synchronized void free() {
        if (thread == null) {
            closeDevice();
        }
    }

    /** Closes the device: at once, or behind what the thread is at. */
    synchronized void close() {
        closed = true;
        if (thread == null) {
            closeDevice();
        }
    }

    private void closeDevice() {
        Pipeline open = device;
        device = null;
        last = null;
        rehearsed.clear();
        room = 0;
        memory.clear();
        if (open != null) {
            open.close();
        }
    }
}
