package io.github.circles2d.opencl;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.bridj.Pointer;

/** The signal handlers of this process, as the kernel of Linux knows them, and a way back to those of earlier. */
final class SignalHandlers {
    private static final int SIGNALS = 64;

    /** Bytes of one handler: address, flags, restorer, mask; a 32-bit kernel writes fewer. */
    private static final int SIZE = 32;

    /** Bytes of a set of signals. */
    private static final int SET = 8;

    private static final String JAVA_VIRTUAL_MACHINE = "libjvm.so";

    private final LoadedLibraries libraries;
    private final Table saved = new Table();
    private final Table present = new Table();

    /** The handlers of all signals, in memory that the kernel can reach. */
    private static final class Table {
        private final ByteBuffer bytes = ByteBuffer.allocateDirect(SIGNALS * SIZE);
        private final long address = Pointer.pointerToBytes(bytes).getPeer();
    }

    SignalHandlers(LoadedLibraries libraries) {
        this.libraries = libraries;
    }

    /** Saves all handlers as they are now. */
    void save() {
        read(saved);
    }

    /**
     * Puts the saved handlers back in place of others. The handlers of the Java virtual machine stay, for a program may call
     * {@code sun.misc.Signal.handle} at any time.
     */
    void restore() {
        read(present);
        if (present.bytes.equals(saved.bytes)) {
            return;
        }
        for (int at = 0; at < SIGNALS * SIZE; at += SIZE) {
            boolean changed = !present.bytes.slice(at, SIZE).equals(saved.bytes.slice(at, SIZE));
            if (changed && !libraries.contains(JAVA_VIRTUAL_MACHINE, address(present, at))) {
                call(at, saved.address + at, 0);
            }
        }
    }

    /** The bytes by which the kernel describes the present handler of a signal. */
    byte[] describe(int signal) {
        read(present);
        byte[] one = new byte[SIZE];
        present.bytes.get((signal - 1) * SIZE, one);
        return one;
    }

    private static long address(Table table, int at) {
        ByteBuffer bytes = table.bytes.duplicate().order(ByteOrder.nativeOrder());
        return Pointer.SIZE == Long.BYTES ? bytes.getLong(at) : Integer.toUnsignedLong(bytes.getInt(at));
    }

    /** Asks for all handlers. The kernel says nothing of signals that cannot be handled; theirs stay zero. */
    private void read(Table table) {
        for (int at = 0; at < SIGNALS * SIZE; at += SIZE) {
            call(at, 0, table.address + at);
        }
    }

    private void call(int at, long handler, long old) {
        StandardC.systemCall(StandardC.LinuxAbi.HERE.rtSigaction(), at / SIZE + 1, handler, old, SET);
    }
}
