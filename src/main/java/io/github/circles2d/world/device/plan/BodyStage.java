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
    private final Kernel sense;
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
        sense = kernels.staged("bodies_sense");
        take = kernels.staged("bodies_take");
        give = kernels.staged("bodies_give");
        free = joints ? kernels.staged("bodies_free") : null;
        name = joints ? kernels.staged("bodies_name") : null;
    }

    /** Adds the numbers that the kernels share with the host. */
    static KernelSource define(KernelSource source) {
        return source.define("BODY_BOXES", BOXES)
                .define("BODY_NEAR_WORDS", HostBodies.NEAR_WORDS)
                .define("BODY_SENSED_WORDS", HostBodies.SENSED_WORDS)
                .define("BODY_ROW_WORDS", HostBodies.ROW_WORDS);
    }

    /** Before continuous collision: circles that joints hold to bodies may leave their paths. */
    void free() {
        if (bodies.areThere()) {
            bodies.findHeld();
        }
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
        int found = find(find, boxes, circles, HostBodies.NEAR_WORDS);
        if (found < 0) {
            return false;
        }
        bodies.findContacts(found, arrays.host().ints(), BOXES + BOX_WORDS * boxes);
        return true;
    }

    /** Finds circles near to boxes, so many words each, which are on the host behind the boxes then. Returns how many, or -1 if the step is refused. */
    private int find(Kernel near, int boxes, int circles, int wordsEach) {
        int before = BOXES + BOX_WORDS * boxes;
        for (int room = LEAST_ROOM; ; ) {
            arrays.ensureFound(bytes(before + (long) wordsEach * room));
            room = (int)
                    Math.min(circles + bodies.held(), (arrays.found().bytes() / Integer.BYTES - before) / wordsEach);
            putBoxes(near == find);
            arrays.found().write(0, arrays.host(), 0, bytes(before));
            near.arg(StageKernels.own(0), arrays.found())
                    .arg(StageKernels.own(1), boxes)
                    .arg(StageKernels.own(2), room)
                    .run(circles);
            if (near == find && bodies.held() > 0) {
                name.arg(StageKernels.own(0), arrays.held())
                        .arg(StageKernels.own(1), bodies.held())
                        .arg(StageKernels.own(2), arrays.found())
                        .arg(StageKernels.own(3), boxes)
                        .arg(StageKernels.own(4), room)
                        .run(bodies.held());
            }
            int expected = Math.min(room, LEAST_ROOM);
            arrays.found().read(0, arrays.host(), 0, bytes(before + (long) wordsEach * expected));
            int found = arrays.host().ints().get(0);
            if (arrays.host().ints().get(1) != 0) {
                return -1;
            }
            if (found <= room) {
                if (found > expected) {
                    arrays.found().read(0, arrays.host(), 0, bytes(before + (long) wordsEach * found));
                }
                return found;
            }
            room = found;
        }
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

    private static long bytes(long words) {
        return Integer.BYTES * words;
    }

    /** Begins the passes, once circles have what they carry on from the step before. */
    void begin() {
        int n = bodies.circles();
        if (n > 0) {
            arrays.ensureRows(bytes(n), bytes((long) HostBodies.ROW_WORDS * n));
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
            arrays.rows().read(0, arrays.host(), 0, bytes((long) HostBodies.ROW_WORDS * bodies.circles()));
            bodies.take(arrays.host().floats());
        }
    }

    private void give() {
        if (bodies.circles() > 0) {
            bodies.put(arrays.host().floats());
            arrays.rows().write(0, arrays.host(), 0, bytes((long) HostBodies.ROW_WORDS * bodies.circles()));
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
