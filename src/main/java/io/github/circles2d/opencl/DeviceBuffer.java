package io.github.circles2d.opencl;

import com.nativelibs4java.opencl.CLBuffer;
import com.nativelibs4java.opencl.CLEvent;
import com.nativelibs4java.opencl.CLException;
import com.nativelibs4java.opencl.CLMem;
import com.nativelibs4java.opencl.CLQueue;
import java.lang.ref.Reference;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Objects;
import org.bridj.Pointer;

/**
 * Memory of a device. Transfers run in order with the session's kernels, are checked against the sizes of both sides,
 * and have ended when the call returns, but for {@link #copyTo}; a {@link CopyQueue} makes others.
 */
public final class DeviceBuffer implements AutoCloseable {
    private static final long SLICE_ALIGNMENT = 4096;
    private static final CLEvent[] WITHOUT_EVENT = {CLEvent.FIRE_AND_FORGET};

    private final Session session;
    private final String name;
    private final long bytes;
    private final CLBuffer<Byte> buffer;
    private final Handle handle;

    /** What is free again when it is closed: nothing if it is a slice. */
    private final long ownBytes;

    DeviceBuffer(Session session, String name, long bytes, CLBuffer<Byte> buffer) {
        this(session, name, bytes, buffer, bytes);
    }

    private DeviceBuffer(Session session, String name, long bytes, CLBuffer<Byte> buffer, long ownBytes) {
        this.session = session;
        this.name = name;
        this.bytes = bytes;
        this.ownBytes = ownBytes;
        this.buffer = buffer;
        handle = new Handle(buffer::release);
        session.own(handle);
    }

    /** {@return the size that was asked for, in bytes} */
    public long bytes() {
        return bytes;
    }

    /**
     * Writes floats to the start of this buffer.
     *
     * @param source its remaining floats are written; its position is left as it is
     */
    public void write(FloatBuffer source) {
        write(0, source);
    }

    /**
     * Writes floats.
     *
     * @param offset where in this buffer, in bytes
     * @param source its remaining floats are written; its position is left as it is
     */
    public void write(long offset, FloatBuffer source) {
        HostBuffer staging = checkedStaging(offset, 4L * source.remaining());
        for (int from = source.position(), count; from < source.limit(); from += count) {
            count = Math.min(source.limit() - from, staging.floats().capacity());
            staging.floats().put(0, source, from, count);
            write(offset + 4L * (from - source.position()), staging, 0, 4L * count);
        }
    }

    /**
     * Writes ints.
     *
     * @param offset where in this buffer, in bytes
     * @param source its remaining ints are written; its position is left as it is
     */
    public void write(long offset, IntBuffer source) {
        HostBuffer staging = checkedStaging(offset, 4L * source.remaining());
        for (int from = source.position(), count; from < source.limit(); from += count) {
            count = Math.min(source.limit() - from, staging.ints().capacity());
            staging.ints().put(0, source, from, count);
            write(offset + 4L * (from - source.position()), staging, 0, 4L * count);
        }
    }

    /**
     * Reads floats from the start of this buffer.
     *
     * @param target as many floats as remain in it are read; its position is left as it is
     */
    public void read(FloatBuffer target) {
        read(0, target);
    }

    /**
     * Reads floats.
     *
     * @param offset where in this buffer, in bytes
     * @param target as many floats as remain in it are read; its position is left as it is
     */
    public void read(long offset, FloatBuffer target) {
        HostBuffer staging = checkedStaging(offset, 4L * target.remaining());
        for (int to = target.position(), count; to < target.limit(); to += count) {
            count = Math.min(target.limit() - to, staging.floats().capacity());
            read(offset + 4L * (to - target.position()), staging, 0, 4L * count);
            target.put(to, staging.floats(), 0, count);
        }
    }

    /**
     * Reads ints from the start of this buffer.
     *
     * @param target as many ints as remain in it are read; its position is left as it is
     */
    public void read(IntBuffer target) {
        read(0, target);
    }

    /**
     * Reads ints.
     *
     * @param offset where in this buffer, in bytes
     * @param target as many ints as remain in it are read; its position is left as it is
     */
    public void read(long offset, IntBuffer target) {
        HostBuffer staging = checkedStaging(offset, 4L * target.remaining());
        for (int to = target.position(), count; to < target.limit(); to += count) {
            count = Math.min(target.limit() - to, staging.ints().capacity());
            read(offset + 4L * (to - target.position()), staging, 0, 4L * count);
            target.put(to, staging.ints(), 0, count);
        }
    }

    /**
     * Writes from transfer memory.
     *
     * @param offset where in this buffer, in bytes
     * @param source transfer memory of the same session
     * @param sourceOffset where in it, in bytes
     * @param length number of bytes
     */
    public void write(long offset, HostBuffer source, long sourceOffset, long length) {
        check("write", offset, length, source, sourceOffset);
        if (length == 0) {
            return;
        }
        try {
            buffer.write(session.queue(), offset, length, source.at(sourceOffset), true);
        } catch (CLException e) {
            throw session.failed("write " + length + " bytes to buffer '" + name + "'", e);
        }
    }

    /**
     * Reads into transfer memory.
     *
     * @param offset where in this buffer, in bytes
     * @param target transfer memory of the same session
     * @param targetOffset where in it, in bytes
     * @param length number of bytes
     */
    public void read(long offset, HostBuffer target, long targetOffset, long length) {
        read(session.queue(), offset, target, targetOffset, length, true, WITHOUT_EVENT);
    }

    /**
     * Enqueues a read of the first bytes and does not wait: they are there once a later call waits, as a read does. Until then, keep the
     * target open and untouched.
     *
     * @param target transfer memory of the same session; takes the bytes at its start
     * @param length number of bytes
     */
    public void readLater(HostBuffer target, long length) {
        read(session.queue(), 0, target, 0, length, false, WITHOUT_EVENT);
    }

    /** Enqueues a read of the first bytes on another queue, behind an event, and does not wait. */
    void readBehind(CLEvent event, CLQueue queue, HostBuffer target, long length) {
        read(queue, 0, target, 0, length, false, event, CLEvent.FIRE_AND_FORGET);
    }

    private void read(
            CLQueue queue,
            long offset,
            HostBuffer target,
            long targetOffset,
            long length,
            boolean blocking,
            CLEvent... events) {
        check("read", offset, length, target, targetOffset);
        if (length == 0) {
            return;
        }
        try {
            buffer.read(queue, offset, length, target.at(targetOffset), blocking, events);
        } catch (CLException e) {
            throw session.failed("read " + length + " bytes of buffer '" + name + "'", e);
        }
    }

    /**
     * Reads the first bytes straight into memory that the driver knows nothing of, as a plain use of OpenCL does. A driver
     * that page-locks takes longer for it than for a {@link HostBuffer}: the benchmarks compare the two.
     *
     * @param target direct memory; as many bytes as remain in it are read; its position is left as it is
     */
    public void readPageable(ByteBuffer target) {
        if (target.isReadOnly()) {
            throw new IllegalArgumentException("the target is read-only");
        }
        int length = checkedPageable(target);
        if (length > 0) {
            try {
                Pointer<Byte> memory = Pointer.pointerToBytes(target.slice());
                buffer.read(session.queue(), 0, length, memory, true, WITHOUT_EVENT);
            } catch (CLException e) {
                throw session.failed("read " + length + " bytes of buffer '" + name + "'", e);
            } finally {
                Reference.reachabilityFence(target);
            }
        }
    }

    /**
     * Writes the first bytes straight from memory that the driver knows nothing of; see {@link #readPageable}.
     *
     * @param source direct memory; its remaining bytes are written; its position is left as it is
     */
    public void writePageable(ByteBuffer source) {
        int length = checkedPageable(source);
        if (length > 0) {
            try {
                Pointer<Byte> memory = Pointer.pointerToBytes(source.slice());
                buffer.write(session.queue(), 0, length, memory, true);
            } catch (CLException e) {
                throw session.failed("write " + length + " bytes to buffer '" + name + "'", e);
            } finally {
                Reference.reachabilityFence(source);
            }
        }
    }

    private int checkedPageable(ByteBuffer host) {
        requireOpen();
        if (!host.isDirect()) {
            throw new IllegalArgumentException("the memory must be direct: an array may move during the transfer");
        }
        if (host.remaining() > bytes) {
            throw new IndexOutOfBoundsException(
                    host.remaining() + " bytes are more than buffer '" + name + "' has: " + bytes);
        }
        return host.remaining();
    }

    /**
     * Enqueues a copy of the first bytes to the start of another buffer of the same session, and does not wait.
     *
     * @param target where to
     * @param length number of bytes
     */
    public void copyTo(DeviceBuffer target, long length) {
        copyTo(0, target, 0, length);
    }

    /**
     * Enqueues a copy to another buffer of the same session, and does not wait.
     *
     * @param offset where in this buffer, in bytes
     * @param target where to
     * @param targetOffset where in it, in bytes
     * @param length number of bytes
     */
    public void copyTo(long offset, DeviceBuffer target, long targetOffset, long length) {
        requireOpen();
        boolean isWithin = offset >= 0 && targetOffset >= 0 && length >= 0;
        if (!isWithin || offset > bytes - length || targetOffset > target.bytes - length) {
            throw new IndexOutOfBoundsException("cannot copy " + length + " bytes at " + offset + " of buffer '" + name
                    + "', which has " + bytes + ", to " + targetOffset + " of buffer '" + target.name + "', which has "
                    + target.bytes);
        }
        if (target.session != session) {
            throw new IllegalArgumentException("buffer '" + target.name + "' belongs to another session");
        }
        if (length == 0) {
            return;
        }
        try {
            buffer.copyBytesTo(session.queue(), target.buffer(), offset, targetOffset, length, WITHOUT_EVENT);
        } catch (CLException e) {
            throw session.failed("copy " + length + " bytes of buffer '" + name + "'", e);
        }
    }

    /**
     * Returns a part of this buffer as a buffer, which shares its memory. The memory is given back when both are closed.
     *
     * @param sliceName for messages
     * @param offset where it begins, in bytes: a multiple of 4,096, which suits any device
     * @param length its bytes, at least 1
     * @return the part
     */
    public DeviceBuffer slice(String sliceName, long offset, long length) {
        requireOpen();
        if (offset < 0 || offset % SLICE_ALIGNMENT != 0 || length < 1 || offset > bytes - length) {
            throw new IndexOutOfBoundsException("buffer '" + name + "', which has " + bytes + " bytes, has no part of "
                    + length + " bytes at " + offset + "; parts begin at multiples of " + SLICE_ALIGNMENT);
        }
        try {
            CLBuffer<Byte> part = buffer.createSubBuffer(CLMem.Usage.InputOutput, offset, length);
            return new DeviceBuffer(session, sliceName, length, part, 0);
        } catch (CLException e) {
            throw session.failed("take " + length + " bytes of buffer '" + name + "'", e);
        }
    }

    /** Gives the memory back to the device once the commands that use it have ended. Later calls do nothing. */
    @Override
    public void close() {
        session.release(handle, ownBytes);
    }

    /** Returns the OpenCL object for a kernel's argument list. */
    CLBuffer<Byte> buffer() {
        requireOpen();
        return buffer;
    }

    Session session() {
        return session;
    }

    private HostBuffer checkedStaging(long offset, long length) {
        Objects.checkFromIndexSize(offset, length, bytes);
        return session.staging();
    }

    private void requireOpen() {
        if (handle.isReleased()) {
            throw new IllegalStateException("buffer '" + name + "' is closed");
        }
    }

    /** OpenCL checks its own side of a transfer, JavaCL none: an unchecked one would write past the host's memory. */
    private void check(String verb, long offset, long length, HostBuffer host, long hostOffset) {
        requireOpen();
        if (offset < 0 || length < 0 || offset > bytes - length) {
            throw new IndexOutOfBoundsException("cannot " + verb + " bytes " + offset + " to " + (offset + length)
                    + " of buffer '" + name + "', which has " + bytes);
        }
        if (hostOffset < 0 || hostOffset > host.size() - length) {
            throw new IndexOutOfBoundsException("cannot " + verb + " " + length + " bytes at " + hostOffset
                    + " of transfer memory that has " + host.size());
        }
        if (host.session() != session) {
            throw new IllegalArgumentException("the transfer memory belongs to another session");
        }
    }
}
