package io.github.circles2d.bench.jmh;

import com.nativelibs4java.opencl.CLBuffer;
import com.nativelibs4java.opencl.CLContext;
import com.nativelibs4java.opencl.CLDevice;
import com.nativelibs4java.opencl.CLEvent;
import com.nativelibs4java.opencl.CLMem;
import com.nativelibs4java.opencl.CLPlatform;
import com.nativelibs4java.opencl.CLQueue;
import com.nativelibs4java.opencl.JavaCL;
import io.github.circles2d.opencl.Device;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.bridj.Pointer;

/**
 * Transfers as a program has them that uses JavaCL by itself: to and from memory that the driver knows nothing of. The room
 * {@code opencl} has none of these, which is why this class goes past it.
 */
final class PlainTransfer implements AutoCloseable {
    private final CLContext context;
    private final CLQueue queue;
    private final CLBuffer<Byte> buffer;
    private final Pointer<Byte> host;
    private final long bytes;

    /** Memory outside the Java heap, as malloc gives it. */
    final ByteBuffer memory;

    /** Call it only once the room has found its devices: it prepares the process for OpenCL. */
    PlainTransfer(Device device, int bytes) {
        this.bytes = bytes;
        context = JavaCL.createContext(null, find(device));
        queue = context.createDefaultQueue();
        buffer = context.createByteBuffer(CLMem.Usage.InputOutput, bytes);
        memory = ByteBuffer.allocateDirect(bytes).order(ByteOrder.nativeOrder());
        host = Pointer.pointerToBytes(memory);
    }

    private static CLDevice find(Device device) {
        for (CLPlatform platform : JavaCL.listPlatforms()) {
            for (CLDevice candidate : platform.listAllDevices(false)) {
                if (platform.getName().trim().equals(device.platform())
                        && candidate.getName().trim().equals(device.name())) {
                    return candidate;
                }
            }
        }
        throw new IllegalStateException("JavaCL does not list " + device);
    }

    void read() {
        buffer.read(queue, 0, bytes, host, true, CLEvent.FIRE_AND_FORGET);
    }

    void write() {
        buffer.write(queue, 0, bytes, host, true, CLEvent.FIRE_AND_FORGET);
    }

    @Override
    public void close() {
        buffer.release();
        queue.release();
        context.release();
    }
}
