package io.github.circles2d;

import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.shared.Mover;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.Locale;
import java.util.function.IntFunction;
import java.util.function.Supplier;

/**
 * Where a world of {@link Backend#AUTO} runs, while it runs. It begins on the JVM. {@link DeviceBeside} makes a device ready, {@link FrameRule} says
 * when to go there and when to come home.
 */
final class RunningChoice implements Mover {
    /** Frames after which the memory of the side that is not used goes: on the JVM, which is soon made again, and on a device. */
    private static final int FRAMES_TO_KEEP_HOME = 600;

    private static final int FRAMES_TO_KEEP_DEVICE = 3600;

    private final Supplier<Pipeline> opensHome;
    private final DeviceBeside beside;
    private final FrameRule rule;

    /** Null while the world is away, once its memory has gone. */
    private Pipeline home;

    private boolean away;

    /** What {@link #choose} gave last. */
    private Pipeline chosen;

    private int circles;

    /** From so many circles on the device lacks memory. */
    private int tooMany = Integer.MAX_VALUE;

    /** How many circles there will be, as far as the game has said; else 0. */
    private final int crowd;

    /** For so many circles a device is opened before they are there, but not beside the first frame, which has all processors; else 0. */
    private int expected;

    private boolean hasBegun;

    /** Frames since the last move. */
    private int frames;

    private int moves;
    private long nanosOfMoves;

    /** Why it runs where it does, if no times say so; else null. */
    private String reason;

    private boolean hasFailed;

    RunningChoice(
            Pipeline home,
            Supplier<Pipeline> opensHome,
            IntFunction<Pipeline> opensDevice,
            FrameRule rule,
            int capacity) {
        this.home = home;
        this.opensHome = opensHome;
        this.rule = rule;
        beside = new DeviceBeside(opensDevice);
        crowd = capacity < FrameRule.LEAST_CIRCLES ? 0 : capacity;
        expected = crowd;
        reason = expected == 0
                ? "no GPU is looked for below " + FrameRule.LEAST_CIRCLES + " circles, and the capacity is " + capacity
                : "it starts here, and a GPU is made ready beside it";
    }

    @Override
    public Pipeline choose(Pipeline now, Readiness wanted, int circlesNow, int awake, double nanos) {
        frames++;
        circles = circlesNow;
        boolean goes = nanos > 0 && rule.frame(nanos, circles, awake);
        chosen = away ? fromDevice(now, goes) : fromHome(now, wanted, goes);
        return chosen;
    }

    @Override
    public boolean settles() {
        return away && rule.endsGroup();
    }

    private Pipeline fromDevice(Pipeline now, boolean goes) {
        if (frames == FRAMES_TO_KEEP_HOME && home != null) {
            home.close();
            home = null;
        }
        return goes ? home() : now;
    }

    private Pipeline fromHome(Pipeline now, Readiness wanted, boolean goes) {
        learn();
        if (!hasBegun) {
            hasBegun = true;
            return now;
        }
        if (expected > 0) {
            beside.open(expected);
            expected = 0;
        }
        boolean idle = frames >= FRAMES_TO_KEEP_DEVICE && !goes;
        if (hasFailed || idle || circles < FrameRule.LEAST_CIRCLES || circles >= tooMany) {
            if (frames == FRAMES_TO_KEEP_DEVICE) {
                beside.free();
            }
            return now;
        }
        Pipeline device = beside.ready(wanted, circles);
        if (device == null) {
            beside.prepare(wanted, circles, Math.max(circles, crowd));
        }
        return goes && device != null ? device : now;
    }

    /** Takes note of what has come of the work beside. */
    private void learn() {
        Throwable refusal = beside.takeRefusal();
        if (refusal != null) {
            reason = "the GPU refuses kernels: " + refusal.getMessage();
            Notice.once(reason, "World stays on " + Backend.JVM + ": " + reason);
        }
        DeviceBeside.Lack lack = beside.takeLack();
        if (lack != null) {
            lack(lack.device(), lack.circles(), lack.why());
            beside.free();
        }
        Throwable failure = hasFailed ? null : beside.failure();
        if (failure != null) {
            hasFailed = true;
            reason = (failure instanceof LinkageError
                            ? "this system lacks a class that looks for devices: "
                            : "no GPU can be used: ")
                    + failure.getMessage();
            Notice.debug("World on " + Backend.JVM + ", " + home().device() + ": " + reason);
        }
    }

    @Override
    public Pipeline home() {
        if (home == null) {
            home = opensHome.get();
        }
        return home;
    }

    @Override
    public boolean isHome(Pipeline pipeline) {
        return pipeline == home;
    }

    @Override
    public void moved(Pipeline from, Pipeline to, long nanos, Throwable cause) {
        away = to != home;
        rule.moved(away, to == chosen);
        moves++;
        nanosOfMoves += nanos;
        frames = 0;
        if (hasFailed) {
            beside.close();
            return;
        }
        reason = null;
        if (cause != null) {
            lack(from.device(), circles, cause);
        } else if (to != chosen) {
            reason = from.device() + " compiles what has come to the world";
        }
        Notice.debug("World goes from " + from.device() + " to " + to.device() + ": " + reason());
    }

    @Override
    public void refused(Pipeline device, Throwable why) {
        if (device != home) {
            lack(device.device(), circles, why);
            beside.free();
        }
    }

    @Override
    public void lost(Pipeline device, Throwable why) {
        hasFailed = true;
        reason = device.device() + " has failed: " + why.getMessage();
        Notice.once(
                reason,
                "World has lost all since its last save: " + reason + "; with a snapshot or a frame it goes on on "
                        + Backend.JVM);
    }

    private void lack(String device, int count, Throwable why) {
        tooMany = count - count / 10; // else the loss of one circle would be reason to try again
        reason = device + " cannot take " + count + " circles: " + why.getMessage();
        Notice.once(reason, "World goes on on " + Backend.JVM + ": " + reason);
    }

    @Override
    public SavedState takeMemory() {
        return beside.takeMemory();
    }

    boolean isAway() {
        return away;
    }

    int moves() {
        return moves;
    }

    double moveMillis() {
        return nanosOfMoves * 1e-6;
    }

    /** Why it runs where it does. */
    String reason() {
        if (!away) {
            learn();
        }
        return reason != null
                ? reason
                : String.format(
                        Locale.ROOT,
                        "frames take %.2f ms here, and %.2f ms on %s",
                        rule.millisHere(),
                        rule.millisThere(),
                        away ? "the JVM" : "the GPU");
    }

    @Override
    public void close() {
        if (home != null) {
            home.close();
        }
        beside.close();
    }
}
