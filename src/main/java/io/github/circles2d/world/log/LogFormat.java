package io.github.circles2d.world.log;

/**
 * The bytes of a log, little-endian. It is written and read from front to end.
 *
 * <pre>
 * header     int magic, version, steps between two hashes
 * block      byte type, int length, int CRC-32C of the bytes, the bytes; the first one is a snapshot
 *            1: calls, at most 64 KB of them, of which none is cut; 2: a snapshot; 3: the end of the log, without bytes
 * call       byte number, and as many ints as the number says
 * </pre>
 */
final class LogFormat {
    static final int MAGIC = 0x4C324443; // "CD2L" in the bytes of a file
    static final int VERSION = 1;
    static final int HEADER = 3 * Integer.BYTES;

    static final int CALLS = 1;
    static final int SNAPSHOT = 2;
    static final int END = 3;

    /** Bytes before those of a block. */
    static final int BLOCK_HEAD = 1 + 2 * Integer.BYTES;

    /** Most bytes of a block of calls. */
    static final int CALLS_BYTES = 1 << 16;

    private LogFormat() {}
}
