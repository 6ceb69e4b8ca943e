package io.github.circles2d.opencl;

import java.lang.ref.Reference;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.bridj.Pointer;

/**
 * A filter of system calls for one thread: its calls that would set a signal handler succeed and do nothing. Threads and
 * processes that it starts inherit the filter.
 *
 * <p>The filter is a program of the kernel's packet filter; {@code linux/seccomp.h} and {@code linux/filter.h} define it.
 */
final class SignalFilter {
    private static final int LOAD = 0x20;
    private static final int JUMP_IF_EQUAL = 0x15;
    private static final int RETURN = 0x06;
    private static final int ALLOW = 0x7fff0000;
    private static final int SUCCEED_WITHOUT_CALL = 0x00050000;

    // Where the kernel puts what the filter looks at.
    private static final int NUMBER = 0;
    private static final int PROCESSOR = 4;
    private static final int SECOND_ARGUMENT = 24;

    private static final int SET_NO_NEW_PRIVILEGES = 38;
    private static final int SET_FILTER = 1;

    /** Without it, kernels before 5.16 slow the thread's loads and stores down. */
    private static final int ALLOW_SPECULATION = 4;

    private static final int INSTRUCTIONS = 10;
    private static final int INSTRUCTION_BYTES = 8;

    private SignalFilter() {}

    /**
     * Installs the filter for the calling thread, for the rest of its life.
     *
     * @return false if the system refuses
     */
    static boolean install() {
        StandardC.LinuxAbi abi = StandardC.LinuxAbi.HERE;
        ByteBuffer program =
                ByteBuffer.allocateDirect(INSTRUCTIONS * INSTRUCTION_BYTES).order(ByteOrder.nativeOrder());
        add(program, LOAD, 0, 0, PROCESSOR);
        add(program, JUMP_IF_EQUAL, 0, 6, abi.auditName());
        add(program, LOAD, 0, 0, NUMBER);
        add(program, JUMP_IF_EQUAL, 0, 4, abi.rtSigaction());
        // A call without a new handler only asks for the present one.
        add(program, LOAD, 0, 0, SECOND_ARGUMENT);
        add(program, JUMP_IF_EQUAL, 0, 3, 0);
        add(program, LOAD, 0, 0, SECOND_ARGUMENT + 4);
        add(program, JUMP_IF_EQUAL, 0, 1, 0);
        add(program, RETURN, 0, 0, ALLOW);
        add(program, RETURN, 0, 0, SUCCEED_WITHOUT_CALL);

        ByteBuffer description = ByteBuffer.allocateDirect(2 * Pointer.SIZE).order(ByteOrder.nativeOrder());
        description.putShort(0, (short) INSTRUCTIONS);
        long address = Pointer.pointerToBytes(program).getPeer();
        if (Pointer.SIZE == Long.BYTES) {
            description.putLong(Pointer.SIZE, address);
        } else {
            description.putInt(Pointer.SIZE, (int) address);
        }
        StandardC.control(SET_NO_NEW_PRIVILEGES, 1);
        boolean installed = set(abi, ALLOW_SPECULATION, description) || set(abi, 0, description);
        Reference.reachabilityFence(program);
        return installed;
    }

    /** Adds an instruction; both jumps count the instructions that they leave out. */
    private static void add(ByteBuffer program, int code, int jumpIfTrue, int jumpIfFalse, int operand) {
        program.putShort((short) code)
                .put((byte) jumpIfTrue)
                .put((byte) jumpIfFalse)
                .putInt(operand);
    }

    private static boolean set(StandardC.LinuxAbi abi, int flags, ByteBuffer description) {
        long address = Pointer.pointerToBytes(description).getPeer();
        boolean installed = StandardC.systemCall(abi.seccomp(), SET_FILTER, flags, address, 0) == 0;
        Reference.reachabilityFence(description);
        return installed;
    }
}
