package io.github.circles2d.world.log;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.function.IntUnaryOperator;

/**
 * Reads a log from a stream, block by block, and checks its form. The stream may be anything: it takes as much memory as it has bytes,
 * whatever it says of its length.
 */
public final class LogReader {
    /** What comes next. */
    public enum Next {
        /** A call. */
        CALL,
        /** A snapshot. */
        SNAPSHOT,
        /** Nothing more. */
        END
    }

    /** Bytes that memory is taken for before any has come. */
    private static final int FIRST_BYTES = 8192;

    private final InputStream in;
    private final IntUnaryOperator wordsOf;
    private final int hashEvery;
    private ByteBuffer content = ByteBuffer.allocate(0);
    private int type = LogFormat.CALLS;

    /** Bytes read. */
    private long position;

    /** Reads the header; does not close the stream. wordsOf gives the ints of a call by its number, negative if there is no such call. */
    public LogReader(InputStream in, IntUnaryOperator wordsOf) throws IOException {
        this.in = in;
        this.wordsOf = wordsOf;
        byte[] magic = readUpTo(Integer.BYTES);
        position = magic.length;
        require(
                magic.length == Integer.BYTES && littleEndian(magic).getInt() == LogFormat.MAGIC,
                "it does not begin as one");
        ByteBuffer header = read(LogFormat.HEADER - Integer.BYTES);
        int version = header.getInt();
        if (version != LogFormat.VERSION) {
            throw refused("its version is " + version + ", not " + LogFormat.VERSION);
        }
        hashEvery = header.getInt();
        require(hashEvery > 0, "its hashes have no distance");
    }

    /** Steps between two hashes. */
    public int hashEvery() {
        return hashEvery;
    }

    /** What comes next; reads a block if the last one is at its end. */
    public Next next() throws IOException {
        while (type == LogFormat.CALLS && !content.hasRemaining()) {
            readBlock();
        }
        return type == LogFormat.CALLS ? Next.CALL : type == LogFormat.SNAPSHOT ? Next.SNAPSHOT : Next.END;
    }

    private void readBlock() throws IOException {
        ByteBuffer head = read(LogFormat.BLOCK_HEAD);
        type = head.get();
        int length = head.getInt();
        require(type >= LogFormat.CALLS && type <= LogFormat.END, "it has a block of no known type");
        require(
                length >= 0
                        && (type == LogFormat.SNAPSHOT
                                || length <= (type == LogFormat.CALLS ? LogFormat.CALLS_BYTES : 0)),
                "a block is too long");
        content = read(length);
        if (Crc32c.of(content.array(), length) != head.getInt()) {
            throw new OfLog(
                    "this log is damaged: a check does not fit, in the " + length + " bytes before byte " + position);
        }
    }

    /** The number of the next call. */
    public int number() {
        return Byte.toUnsignedInt(content.get(content.position()));
    }

    /** The number of the next call; its ints go to words. */
    public int call(int[] words) {
        int number = Byte.toUnsignedInt(content.get());
        int count = wordsOf.applyAsInt(number);
        if (count < 0) {
            throw refused("no call has the number " + number);
        }
        require(content.remaining() >= Integer.BYTES * count, "a call is cut");
        for (int k = 0; k < count; k++) {
            words[k] = content.getInt();
        }
        return number;
    }

    public ByteBuffer snapshot() {
        type = LogFormat.CALLS;
        ByteBuffer snapshot = content;
        content = ByteBuffer.allocate(0);
        return snapshot;
    }

    private ByteBuffer read(int length) throws IOException {
        byte[] bytes = readUpTo(length);
        position += bytes.length;
        if (bytes.length < length) {
            throw new OfLog("this log is cut: it ends after " + position + " bytes");
        }
        return littleEndian(bytes);
    }

    /** Takes memory as bytes come. Android 12 has no InputStream.readNBytes, and TeaVM's readNBytes of bytes does not move on. */
    private byte[] readUpTo(int length) throws IOException {
        byte[] bytes = new byte[Math.min(length, FIRST_BYTES)];
        int size = 0;
        while (size < length) {
            if (size == bytes.length) {
                bytes = Arrays.copyOf(bytes, (int) Math.min(length, 2L * size));
            }
            int more = in.read(bytes, size, bytes.length - size);
            if (more < 0) {
                return Arrays.copyOf(bytes, size);
            }
            size += more;
        }
        return bytes;
    }

    private static ByteBuffer littleEndian(byte[] bytes) {
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static void require(boolean holds, String message) {
        if (!holds) {
            throw refused(message);
        }
    }

    /** What is thrown for bytes that are no log. */
    public static IllegalArgumentException refused(String message) {
        return new OfLog("this is no log of a world: " + message);
    }

    /** Whether an exception has been made here, so its message says that a log is wrong. */
    public static boolean isOfLog(IllegalArgumentException e) {
        return e instanceof OfLog;
    }

    private static final class OfLog extends IllegalArgumentException {
        private static final long serialVersionUID = 1;

        OfLog(String message) {
            super(message);
        }
    }
}
