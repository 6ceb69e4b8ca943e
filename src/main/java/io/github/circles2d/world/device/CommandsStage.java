package io.github.circles2d.world.device;

import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.model.Bounds;
import java.nio.IntBuffer;
import java.util.Arrays;

/** Applies commands on a device; {@code kernels/world/Commands.cl}. */
final class CommandsStage {
    private final Session session;
    private final DeviceArrays buffers;
    private final Kernel apply;
    private final Kernel confine;
    private DeviceBuffer records;
    private DeviceBuffer links;

    /** By id: its last record so far of the batch numbered by {@link #batchOf}. */
    private int[] last = new int[64];

    private int[] batchOf = new int[64];
    private int batch;
    private int[] link = new int[0];

    /** By id: the slot that it was given since the slots were last put in order, the time of which is {@link #orderOf}. */
    private int[] given = new int[64];

    private int[] orderOf = new int[64];
    private int order = 1;

    /** Slots that have been given and left since then: without a step between, circles that come and go need no others. */
    private int[] free = new int[64];

    private int freeCount;

    CommandsStage(Session session, StageKernels kernels, DeviceArrays buffers) {
        this.session = session;
        this.buffers = buffers;
        apply = kernels.plain("commands_apply");
        confine = kernels.plain("commands_confine");
        records = session.allocate("commands", 4L * Commands.STRIDE * 64);
        links = session.allocate("command links", 8L * 64);
    }

    /** Makes room for commands, of which {@link #apply} says what they need. */
    void makeRoom(Commands commands, int slots) {
        int count = commands.count();
        int[] words = commands.records();
        int removed = 0;
        for (int k = 0; k < count * Commands.STRIDE; k += Commands.STRIDE) {
            removed += words[k] == Commands.REMOVE ? 1 : 0;
            if (words[k + 1] >= last.length) {
                ensureIds(words[k + 1] + (words[k + 1] >> 1));
            }
        }
        if (free.length < freeCount + removed) {
            free = Arrays.copyOf(free, Math.max(2 * free.length, freeCount + removed));
        }
        if (link.length < 2 * count) {
            link = new int[2 * count + count];
        }
        buffers.ensureIds(last.length);
        if (records.bytes() < 4L * Commands.STRIDE * count) {
            DeviceBuffer larger = session.allocate("commands", 4L * Commands.STRIDE * (count + (count >> 1)));
            records.close();
            records = larger;
        }
        if (links.bytes() < 8L * count) {
            DeviceBuffer larger = session.allocate("command links", 8L * (count + (count >> 1)));
            links.close();
            links = larger;
        }
        buffers.ensureSlots(slots + Math.max(0, commands.added() - freeCount), slots);
    }

    /**
     * Applies commands in call order. New circles take slots that are known to be free, then those from {@code slots} on.
     *
     * @return slots at home afterwards
     */
    int apply(Commands commands, int slots) {
        int count = commands.count();
        int[] words = commands.records();
        int nextSlot = link(words, count, slots);
        records.write(0, IntBuffer.wrap(words, 0, Commands.STRIDE * count));
        links.write(0, IntBuffer.wrap(link, 0, 2 * count));
        apply.arg(0, records).arg(1, links).arg(2, count);
        int[] homes = {
            DeviceArrays.HOME_CIRCLE,
            DeviceArrays.HOME_MOTION,
            DeviceArrays.HOME_TRAITS,
            DeviceArrays.HOME_ID,
            DeviceArrays.HOME_MEMORY,
            DeviceArrays.SLOT_OF
        };
        for (int i = 0; i < homes.length; i++) {
            apply.arg(3 + i, buffers.get(homes[i]));
        }
        apply.run(count);
        return nextSlot;
    }

    /** Takes note that the slots were put in order, without gaps: by a step, or anew. */
    void slotsInOrder() {
        order++;
        freeCount = 0;
    }

    /** Brings circles that are outside of new bounds inside. */
    void confine(Bounds bounds, int slots) {
        confine.arg(0, buffers.get(DeviceArrays.HOME_ID))
                .arg(1, buffers.get(DeviceArrays.HOME_CIRCLE))
                .arg(2, buffers.get(DeviceArrays.HOME_MOTION))
                .arg(3, buffers.get(DeviceArrays.HOME_TRAITS))
                .arg(4, slots)
                .arg(5, bounds.minX())
                .arg(6, bounds.minY())
                .arg(7, bounds.maxX())
                .arg(8, bounds.maxY())
                .run(slots);
    }

    /**
     * Links the records of each circle: for a record, the next of the same circle or -1, and (slot of a new circle) times
     * 2, plus 1 for its circle's first record.
     */
    private int link(int[] words, int count, int slots) {
        batch++;
        int nextSlot = slots;
        // What becomes free now is for the next batch: circles are independent of each other within one.
        int reusable = freeCount;
        int reused = 0;
        for (int r = 0; r < count; r++) {
            int operation = words[r * Commands.STRIDE];
            int id = words[r * Commands.STRIDE + 1];
            boolean first = batchOf[id] != batch;
            if (!first) {
                link[2 * last[id]] = r;
            }
            batchOf[id] = batch;
            last[id] = r;
            link[2 * r] = -1;
            int slot = 0;
            if (operation == Commands.ADD) {
                slot = reused < reusable ? free[reused++] : nextSlot++;
                given[id] = slot;
                orderOf[id] = order;
            } else if (operation == Commands.REMOVE && orderOf[id] == order) {
                free[freeCount++] = given[id];
            }
            link[2 * r + 1] = 2 * slot + (first ? 1 : 0);
        }
        freeCount -= reused;
        System.arraycopy(free, reused, free, 0, freeCount);
        return nextSlot;
    }

    /** Makes room for ids. The length of the array that grows last tells whether there is room. */
    private void ensureIds(int ids) {
        batchOf = Arrays.copyOf(batchOf, ids);
        given = Arrays.copyOf(given, ids);
        orderOf = Arrays.copyOf(orderOf, ids);
        last = Arrays.copyOf(last, ids);
    }
}
