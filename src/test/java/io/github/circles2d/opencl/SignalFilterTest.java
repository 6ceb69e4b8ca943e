package io.github.circles2d.opencl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.concurrent.atomic.AtomicBoolean;
import org.bridj.Pointer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

@EnabledOnOs(OS.LINUX)
@Tag("each-jdk")
class SignalFilterTest {
    private static final int USR1 = 10; // of no use to the Java virtual machine
    private static final long IGNORE = 1;

    @Test
    void aFilteredThreadCannotSetAHandlerAndIsNotToldSo() throws Exception {
        NativeAccess.prepare();
        SignalHandlers handlers = new SignalHandlers(new LoadedLibraries(LoadedLibraries.LIST));
        handlers.save();
        byte[] before = handlers.describe(USR1);

        AtomicBoolean installed = new AtomicBoolean();
        AtomicBoolean succeeded = new AtomicBoolean();
        Thread thread = new Thread(() -> {
            installed.set(SignalFilter.install());
            succeeded.set(setToIgnore());
        });
        thread.start();
        thread.join();
        byte[] after = handlers.describe(USR1);
        handlers.restore();

        assumeTrue(installed.get(), "the system does not allow filters");
        assertThat(succeeded).isTrue();
        assertThat(after).isEqualTo(before);
    }

    @Test
    void handlersThatWereSetArePutBackToTheLastByte() throws Exception {
        NativeAccess.prepare();
        SignalHandlers handlers = new SignalHandlers(new LoadedLibraries(LoadedLibraries.LIST));
        handlers.save();
        byte[] before = handlers.describe(USR1);
        assertThat(setToIgnore()).isTrue();
        assertThat(handlers.describe(USR1)).isNotEqualTo(before);
        handlers.restore();
        assertThat(handlers.describe(USR1)).isEqualTo(before);
    }

    private static boolean setToIgnore() {
        ByteBuffer handler = ByteBuffer.allocateDirect(32).order(ByteOrder.nativeOrder());
        if (Pointer.SIZE == Long.BYTES) {
            handler.putLong(0, IGNORE);
        } else {
            handler.putInt(0, (int) IGNORE);
        }
        Pointer<Byte> memory = Pointer.pointerToBytes(handler);
        boolean set = StandardC.systemCall(StandardC.LinuxAbi.HERE.rtSigaction(), USR1, memory.getPeer(), 0, 8) == 0;
        java.lang.ref.Reference.reachabilityFence(handler);
        return set;
    }
}
