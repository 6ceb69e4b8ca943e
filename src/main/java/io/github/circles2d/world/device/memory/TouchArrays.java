package io.github.circles2d.world.device.memory;

import io.github.circles2d.opencl.Kernel;
import io.github.circles2d.opencl.Session;

/** The memory in which a step notes what contacts, walls and pieces of terrain do, if they are reported; {@code kernels/world/stages/Touches.cl}. */
public final class TouchArrays implements AutoCloseable {
    /** Arguments of {@link #bind}. */
    public static final int ARGUMENTS = 3;

    private static final long CONTACT_BYTES = 32;
    /** More, if circles turn. */
    private static final long SLIP_BYTES = 8;

    /** More, if there is terrain: of a piece contact, for which there is as much room. */
    private static final long PIECE_BYTES = 32;

    private static final long SLOT_BYTES = 32;

    private final boolean walls;
    private boolean pieces;
    private final GrownBuffer contacts;
    private final GrownBuffer slots;

    public TouchArrays(Session session, boolean walls) {
        this.walls = walls;
        contacts = new GrownBuffer(session, "touches");
        slots = new GrownBuffer(session, "touches of walls");
    }

    /** Sets whether the steps to come report pieces of terrain. */
    public void setPieces(boolean some) {
        pieces = some;
    }

    /** A struct and the arguments that fill it, for kernels of steps that record (RECORDING). */
    static String text() {
        return """
                #ifdef RECORDING
                typedef struct {
                    global float4 *touch; // by contact: see the plan's files
                    global float4 *wallTouch; // by slot and axis: see Touches.cl
                    int walls; // whether walls are reported
                    int numbers; // by tiles: see SET_TOUCH_NUMBERS
                    int pieces; // whether pieces of terrain are reported
                } Recording;
                #define RECORDING_PARAMETERS , global float4 *touch, global float4 *wallTouch, int recorded
                #define RECORD_IN(w) \
                    Recording recording = {touch, wallTouch, recorded & 1, 0, recorded & 2}; \
                    (w).recording = recording
                #else
                #define RECORDING_PARAMETERS
                #define RECORD_IN(w)
                #endif
                """;
    }

    /** Gives a kernel its RECORDING_PARAMETERS, of which the first is an argument of its own. */
    public void bind(Kernel kernel, int first) {
        kernel.arg(StageKernels.own(first), contacts.get())
                .arg(StageKernels.own(first + 1), slots.get())
                .arg(StageKernels.own(first + 2), (walls ? 1 : 0) | (pieces ? 2 : 0));
    }

    /** Makes room for what other arrays have room for. */
    public void ensure(DeviceArrays arrays) {
        long contactBytes = CONTACT_BYTES
                + (arrays.features().terrain() ? PIECE_BYTES : 0)
                + (arrays.features().turning() ? SLIP_BYTES : 0);
        contacts.ensure(contactBytes * arrays.contactCapacity());
        slots.ensure(SLOT_BYTES * arrays.slotCapacity());
    }

    @Override
    public void close() {
        contacts.close();
        slots.close();
    }
}
