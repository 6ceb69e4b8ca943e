package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.memory.BodyArrays;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.jvm.HostBodies;
import io.github.circles2d.world.jvm.HostWaking;
import io.github.circles2d.world.model.Sleep;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/**
 * The bodies that are pushed, of a world on a device. The host makes their part of a step ({@link HostBodies}); for circles that touch them it waits for
 * the device twice in a sub-step, takes what these have become, and gives it back; {@code kernels/world/stages/Bodies.cl}. For circles that joints hold to
 * bodies it waits four times. Steps without such circles wait once. Where somebody sleeps, the host finds contacts once more before, and waits for each ring
 * of those that wake ({@link SleepStage}), if bodies touch circles that sleep.
 */
final class BodyStage {
    /** Words before the boxes: how many circles were found, whether the step is refused. */
    private static final int BOXES = 4;

    private static final int BOX_WORDS = 4;

    /** Words before the circles that sleep at bodies: how many circles woke in the last ring. */
    private static final int SLEEPERS = 4;

    /** Circles that there is room for at least. */
    private static final int LEAST_ROOM = 64;

    private final Session session;
    private final HostBodies bodies;
    private final BodyArrays arrays;
    private final Kernel find;
    private final Kernel sense;
    private final Kernel take;
    private final Kernel give;

    /** Null in worlds without joints. */
    private final Kernel free;

    /** Null in worlds without joints in which nobody sleeps. */
    private final Kernel name;

    BodyStage(
            StageKernels kernels,
            Session session,
            HostBodies bodies,
            BodyArrays arrays,
            boolean joints,
            boolean sleeping) {
        this.session = session;
        this.bodies = bodies;
        this.arrays = arrays;
        find = kernels.staged("bodies_find");
        sense = kernels.staged("bodies_sense");
        take = kernels.staged("bodies_take");
        give = kernels.staged("bodies_give");
        free = joints ? kernels.staged("bodies_free") : null;
        name = joints || sleeping ? kernels.staged("bodies_name") : null;
    }

    /** Adds the numbers that the kernels share with the host. */
    static KernelSource define(KernelSource source) {
        return source.define("BODY_BOXES", BOXES)
                .define("BODY_NEAR_WORDS", HostBodies.NEAR_WORDS)
                .define("BODY_SENSED_WORDS", HostBodies.SENSED_WORDS)
                .define("BODY_SLEEPERS", SLEEPERS)
                .define("BODY_SLEEPER_WORDS", HostWaking.SLEEPER_WORDS)
                .define("SLEEPER_SLOT", HostWaking.SLEEPER_SLOT)
                .define("SLEEPER_SPEED", HostWaking.SLEEPER_SPEED)
                .define("SLEEPER_WOKEN_BY", HostWaking.SLEEPER_WOKEN_BY)
                .define("SLEEPER_PRESSING", HostWaking.SLEEPER_PRESSING)
                .define("SLEEPER_SUMS", HostWaking.SLEEPER_SUMS)
                .define("BODY_ROW_WORDS", HostBodies.ROW_WORDS);
    }

    /** Before continuous collision: circles that joints hold to bodies may leave their paths. */
    void free() {
        if (bodies.areThere()) {
            bodies.findHeld();
        }
        int held = held();
        if (held > 0) {
            arrays.ensure(arrays.held, bytes(held));
            bodies.putHeld(arrays.host().ints().duplicate().clear());
            arrays.send(arrays.held, bytes(held));
            free.arg(StageKernels.own(0), arrays.held.get())
                    .arg(StageKernels.own(1), held)
                    .run(held);
        }
    }

    /** Finds what touches bodies, once contacts of circles are listed; false if nothing is there, or the step is refused: nothing has changed then. */
    boolean find(float warmScale, int circles) {
        if (!bodies.areThere()) {
            return false;
        }
        boolean goesOn = findContacts(warmScale, circles);
        if (!goesOn) {
            bodies.waking.undo();
        }
        return goesOn;
    }

    private boolean findContacts(float warmScale, int circles) {
        bodies.findBoxes(warmScale);
        int boxes = bodies.boxes();
        int found = find(find, boxes, circles, HostBodies.NEAR_WORDS);
        if (found >= 0) {
            bodies.findContacts(found, arrays.host().ints(), BOXES + BOX_WORDS * boxes);
        }
        return found >= 0;
    }

    /** Finds circles near to boxes, so many words each, which are on the host behind the boxes then. Returns how many, or -1 if the step is refused. */
    private int find(Kernel near, int boxes, int circles, int wordsEach) {
        int before = BOXES + BOX_WORDS * boxes;
        int named = near == find ? bodies.named() : 0;
        if (named > 0 && bodies.sleep()) { // else free() has sent them
            arrays.ensure(arrays.held, bytes(named));
            bodies.putNamed(arrays.host().ints().duplicate().clear());
            arrays.send(arrays.held, bytes(named));
        }
        for (int room = LEAST_ROOM; ; ) {
            arrays.ensure(arrays.found, bytes(before + (long) wordsEach * room));
            room = (int) Math.min(circles + named, (arrays.found.get().bytes() / Integer.BYTES - before) / wordsEach);
            putBoxes(near == find);
            arrays.send(arrays.found, bytes(before));
            near.arg(StageKernels.own(0), arrays.found.get())
                    .arg(StageKernels.own(1), boxes)
                    .arg(StageKernels.own(2), room)
                    .run(circles);
            if (named > 0) {
                name.arg(StageKernels.own(0), arrays.held.get())
                        .arg(StageKernels.own(1), named)
                        .arg(StageKernels.own(2), arrays.found.get())
                        .arg(StageKernels.own(3), boxes)
                        .arg(StageKernels.own(4), room)
                        .run(named);
            }
            int expected = Math.min(room, LEAST_ROOM);
            arrays.receive(arrays.found, bytes(before + (long) wordsEach * expected));
            int found = arrays.host().ints().get(0);
            if (arrays.host().ints().get(1) != 0) {
                return -1;
            }
            if (found <= room) {
                if (found > expected) {
                    arrays.receive(arrays.found, bytes(before + (long) wordsEach * found));
                }
                return found;
            }
            room = found;
        }
    }

    boolean areIdle() {
        return bodies.areIdle();
    }

    /** Whether bodies may wake as steps begin, or wake circles. */
    boolean wakes(Steps steps) {
        return bodies.areThere() && steps.sleeping() && (steps.waking() || bodies.anySleeps());
    }

    /** Wakes bodies and, if some may sleep, circles, behind the grid. If the step has been refused, nothing happens. */
    void wake(SleepStage sleep, boolean circlesSleep, float warmScale, int circles) {
        if (!findContacts(warmScale, circles)) {
            return;
        }
        bodies.beginWaking();
        int sleepers = circlesSleep ? bodies.waking.count() : 0;
        if (sleepers > 0) {
            arrays.ensure(arrays.sleepers, sleeperBytes(sleepers));
            bodies.putSleepers(arrays.host().ints(), SLEEPERS);
            sendSleepers(sleepers);
        }
        if (circlesSleep) {
            sleep.wake(circles, sleepers);
        }
        if (sleepers > 0) {
            spread(sleep, sleepers);
        } else {
            if (circlesSleep) {
                sleep.spread(1, Sleep.RINGS, 0);
            }
            bodies.waking.passOnAlone();
        }
        bodies.waking.end();
        if (circlesSleep) {
            sleep.keep(circles);
        }
    }

    private void spread(SleepStage sleep, int sleepers) {
        sleep.spread(1, 1, sleepers);
        int woken = receiveSleepers(sleepers, 0);
        for (int ring = 1; ring < Sleep.RINGS && (woken > 0 || bodies.waking.hasRing()); ring++) {
            bodies.waking.passOn(ring);
            bodies.waking.putReached(arrays.host().ints(), SLEEPERS);
            sendSleepers(sleepers);
            sleep.spread(ring, ring + 1, sleepers);
            woken = receiveSleepers(sleepers, ring);
        }
    }

    private void sendSleepers(int sleepers) {
        arrays.send(arrays.sleepers, sleeperBytes(sleepers));
    }

    /** Returns how many circles have woken in the ring. */
    private int receiveSleepers(int sleepers, int ring) {
        arrays.receive(arrays.sleepers, sleeperBytes(sleepers));
        bodies.waking.take(arrays.host().ints(), SLEEPERS, ring);
        return arrays.host().ints().get(0);
    }

    /** Behind a step: circles that joints hold to bodies do not fall asleep. */
    void keepAwake(SleepStage sleep) {
        int held = held();
        if (held > 0) {
            arrays.ensure(arrays.held, bytes(held));
            int still = bodies.putStillHeld(arrays.host().ints().duplicate().clear());
            if (still > 0) {
                arrays.send(arrays.held, bytes(still));
                sleep.keepAwake(still);
            }
        }
    }

    private int held() {
        return bodies.areThere() ? bodies.held() : 0;
    }

    private void putBoxes(boolean ofAll) {
        IntBuffer words = arrays.host().ints();
        for (int k = 0; k < BOXES; k++) {
            words.put(k, 0);
        }
        FloatBuffer boxes = arrays.host().floats().duplicate().position(BOXES);
        if (ofAll) {
            bodies.putBoxes(boxes);
        } else {
            bodies.putSensingBoxes(boxes);
        }
    }

    private static long sleeperBytes(int sleepers) {
        return bytes(SLEEPERS + (long) HostWaking.SLEEPER_WORDS * sleepers);
    }

    private long rowBytes() {
        return bytes((long) HostBodies.ROW_WORDS * bodies.circles());
    }

    private static long bytes(long words) {
        return Integer.BYTES * words;
    }

    /** Begins the passes, once circles have what they carry on from the step before. */
    void begin() {
        int n = bodies.circles();
        if (n > 0) {
            arrays.ensure(arrays.slots, bytes(n));
            arrays.ensure(arrays.rows, rowBytes());
            bodies.putSlots(arrays.host().ints().duplicate().clear());
            arrays.send(arrays.slots, bytes(n));
            bind(take);
            bind(give);
            take();
            receive();
        }
        bodies.begin();
        give();
    }

    private void bind(Kernel kernel) {
        kernel.arg(StageKernels.own(0), arrays.slots.get())
                .arg(StageKernels.own(1), bodies.circles())
                .arg(StageKernels.own(2), arrays.rows.get());
    }

    private void take() {
        if (bodies.circles() > 0) {
            take.run(bodies.circles());
            session.flush();
        }
    }

    private void receive() {
        if (bodies.circles() > 0) {
            arrays.receive(arrays.rows, rowBytes());
            bodies.take(arrays.host().floats());
        }
    }

    private void give() {
        if (bodies.circles() > 0) {
            bodies.put(arrays.host().floats());
            arrays.send(arrays.rows, rowBytes());
            give.run(bodies.circles());
        }
    }

    /** Behind the biased pass over joints, and before that over cross contacts. */
    void solveJoints(int sub) {
        if (bodies.held() > 0) {
            take();
            bodies.driveBodies();
            receive();
            bodies.solveBodies(sub);
            give();
        }
    }

    /** Behind the biased pass of circles; what bodies do without circles they do beside it. */
    void solve(int sub) {
        take();
        if (bodies.held() == 0) {
            bodies.driveBodies();
            bodies.solveBodies(sub);
        }
        receive();
        bodies.solveCircles();
        give();
    }

    /** Behind the relaxing pass over joints, and before that over cross contacts. */
    void relaxJoints(int sub, boolean last) {
        if (bodies.held() > 0) {
            take();
            receive();
            bodies.relaxBodies(sub, last);
            give();
        }
    }

    /** Behind the relaxing pass of circles. */
    void relax(int sub, boolean last) {
        take();
        receive();
        if (bodies.held() == 0) {
            bodies.relaxBodies(sub, last);
        }
        bodies.relaxCircles();
        give();
    }

    /** Behind the last pass, and the end of the step of circles. */
    void end(int circles) {
        bodies.end();
        if (bodies.seeksCircles()) {
            int boxes = bodies.sensingBoxes();
            int found = find(sense, boxes, circles, HostBodies.SENSED_WORDS);
            bodies.takeSensed(found, arrays.host().ints(), BOXES + BOX_WORDS * boxes);
        }
        bodies.tell();
    }
}
