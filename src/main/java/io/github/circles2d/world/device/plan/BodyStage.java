package io.github.circles2d.world.device.plan;

import io.github.circles2d.opencl.HostBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.memory.BodyArrays;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.jvm.HostBodies;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/**
 * The bodies that are pushed, of a world on a device. The host makes their part of a step ({@link HostBodies}); for circles that touch them it waits for
 * the device twice in a sub-step, takes what these have become, and gives it back; {@code kernels/world/stages/Bodies.cl}. For circles that joints hold to
 * bodies it waits four times. Steps without such circles wait once.
 */
final class BodyStage {
    /** Words before the boxes: how many circles were found, whether the step is refused. */
    private static final int BOXES = 4;

    private static final int BOX_WORDS = 4;

    /** Circles that there is room for at least. */
    private static final int LEAST_ROOM = 64;

    private final Session session;
    private final HostBodies bodies;
    private final BodyArrays arrays;
    private final Kernel find;
    private final Kernel take;
    private final Kernel give;

    /** Null, as the next, in worlds without joints. */
    private final Kernel free;

    private final Kernel name;

    BodyStage(StageKernels kernels, Session session, HostBodies bodies, BodyArrays arrays, boolean joints) {
        this.session = session;
        this.bodies = bodies;
        this.arrays = arrays;
        find = kernels.staged("bodies_find");
        take = kernels.staged("bodies_take");
        give = kernels.staged("bodies_give");
        free = joints ? kernels.staged("bodies_free") : null;
        name = joints ? kernels.staged("bodies_name") : null;
    }

    /** Adds the numbers that the kernels share with the host. */
    static KernelSource define(KernelSource source) {
        return source.define("BODY_BOXES", BOXES)
                .define("BODY_NEAR_WORDS", HostBodies.NEAR_WORDS)
                .define("BODY_ROW_WORDS", HostBodies.ROW_WORDS);
    }

    /** Before continuous collision: circles that joints hold to bodies may leave their paths. */
    void free() {
        int held = bodies.areThere() ? bodies.held() : 0;
        if (held > 0) {
            arrays.ensureHeld(bytes(held));
            bodies.putHeld(arrays.host().ints().duplicate().clear());
            arrays.held().write(0, arrays.host(), 0, bytes(held));
            free.arg(StageKernels.own(0), arrays.held())
                    .arg(StageKernels.own(1), held)
                    .run(held);
        }
    }

    /** Finds what touches bodies, once contacts of circles are listed; false if nothing is there, or the step is refused: nothing has changed then. */
    boolean find(float warmScale, int circles) {
        if (!bodies.areThere()) {
            return false;
        }
        bodies.findBoxes(warmScale);
        int boxes = bodies.boxes();
        int before = BOXES + BOX_WORDS * boxes;
        int room = LEAST_ROOM;
        while (true) {
            arrays.ensureFound(bytes(before + HostBodies.NEAR_WORDS * room));
            room = (int) Math.min(
                    circles + bodies.held(), (arrays.found().bytes() / Integer.BYTES - before) / HostBodies.NEAR_WORDS);
            HostBuffer host = arrays.host();
            putBoxes(host);
            arrays.found().write(0, host, 0, bytes(before));
            find.arg(StageKernels.own(0), arrays.found())
                    .arg(StageKernels.own(1), boxes)
                    .arg(StageKernels.own(2), room)
                    .run(circles);
            if (bodies.held() > 0) {
                name.arg(StageKernels.own(0), arrays.held())
                        .arg(StageKernels.own(1), bodies.held())
                        .arg(StageKernels.own(2), arrays.found())
                        .arg(StageKernels.own(3), boxes)
                        .arg(StageKernels.own(4), room)
                        .run(bodies.held());
            }
            arrays.found().read(0, host, 0, bytes(before + HostBodies.NEAR_WORDS * Math.min(room, LEAST_ROOM)));
            IntBuffer words = host.ints();
            int found = words.get(0);
            if (words.get(1) != 0) {
                return false;
            }
            if (found > room) {
                room = found;
                continue;
            }
            if (found > LEAST_ROOM) {
                arrays.found().read(0, host, 0, bytes(before + HostBodies.NEAR_WORDS * found));
            }
            bodies.findContacts(found, words, before);
            return true;
        }
    }

    private void putBoxes(HostBuffer host) {
        IntBuffer words = host.ints();
        for (int k = 0; k < BOXES; k++) {
            words.put(k, 0);
        }
        FloatBuffer boxes = host.floats().duplicate();
        bodies.putBoxes(boxes.position(BOXES));
    }

    private static long bytes(int words) {
        return (long) Integer.BYTES * words;
    }

    /** Begins the passes, once circles have what they carry on from the step before. */
    void begin() {
        int n = bodies.circles();
        if (n > 0) {
            arrays.ensureRows(bytes(n), bytes(HostBodies.ROW_WORDS * n));
            HostBuffer host = arrays.host();
            bodies.putSlots(host.ints().duplicate().clear());
            arrays.slots().write(0, host, 0, bytes(n));
            bind(take);
            bind(give);
            take();
            receive();
        }
        bodies.begin();
        give();
    }

    private void bind(Kernel kernel) {
        kernel.arg(StageKernels.own(0), arrays.slots())
                .arg(StageKernels.own(1), bodies.circles())
                .arg(StageKernels.own(2), arrays.rows());
    }

    private void take() {
        if (bodies.circles() > 0) {
            take.run(bodies.circles());
            session.flush();
        }
    }

    private void receive() {
        if (bodies.circles() > 0) {
            arrays.rows().read(0, arrays.host(), 0, bytes(HostBodies.ROW_WORDS * bodies.circles()));
            bodies.take(arrays.host().floats());
        }
    }

    private void give() {
        if (bodies.circles() > 0) {
            bodies.put(arrays.host().floats());
            arrays.rows().write(0, arrays.host(), 0, bytes(HostBodies.ROW_WORDS * bodies.circles()));
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

    /** Behind the last pass. */
    void end() {
        bodies.end();
    }
}
