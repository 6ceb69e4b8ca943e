package io.github.circles2d.world.snapshots;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Response;
import io.github.circles2d.World;
import io.github.circles2d.WorldScenes;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** The kinds in snapshots: what is refused of them. */
class KindSectionTest {
    /** Two values and two responses. */
    private static final int SECTION = 3 * 4 + 2 * 6 + 2 * 3;

    private static final int VALUES = -SECTION + 12;
    private static final int RESPONSES = -2 * 3;

    @Test
    void whatNoCallsLeadToIsRefused() {
        refused("number 999", b -> b.putInt(b.limit() - SECTION, 999));
        refused("3 values", b -> b.putInt(b.limit() - SECTION + 4, 3));
        refused("-1 values", b -> b.putInt(b.limit() - SECTION + 4, -1));
        refused("3 responses", b -> b.putInt(b.limit() - SECTION + 8, 3));
        refused("2147483647 responses", b -> b.putInt(b.limit() - SECTION + 8, Integer.MAX_VALUE));
        refused("do not fit", b -> b.putInt(b.limit() - SECTION + 8, 1));
        refused("not in order", b -> b.put(b.limit() + VALUES, (byte) 8));
        refused("not in order", b -> b.put(b.limit() + VALUES + 6, (byte) 5));
        refused("number 99", b -> b.put(b.limit() + VALUES + 1, (byte) 99));
        refused("initial value", b -> b.putInt(b.limit() + VALUES + 2, -1));
        refused("restitution", b -> b.putInt(b.limit() + VALUES + 8, Float.floatToIntBits(2)));
        refused("restitution", b -> b.putInt(b.limit() + VALUES + 8, Float.floatToIntBits(Float.NaN) + 1));
        refused("out of range", b -> b.put(b.limit() + RESPONSES, (byte) 8));
        refused("out of range", b -> b.put(b.limit() + RESPONSES + 2, (byte) 4));
        refused("out of range", b -> b.put(b.limit() + RESPONSES + 2, (byte) 0));
        refused("not in order", b -> b.put(b.limit() + RESPONSES + 3, (byte) 4));
        refused("ends early", b -> b.putInt(60, 2));
    }

    private static void refused(String message, Consumer<ByteBuffer> forge) {
        try (World world = WorldScenes.jvm().build()) {
            world.kind(6).setMask(3);
            world.kind(7).setRestitution(0.25f);
            world.setResponse(7, 5, Response.SENSE);
            world.setResponse(7, 7, Response.SOLID);
            ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes()).order(ByteOrder.LITTLE_ENDIAN);
            world.snapshot(bytes);
            bytes.flip();
            world.kind(7).setMask(0);
            world.restore(bytes.duplicate());
            assertThat(world.kind(7).mask()).isEqualTo(-1);
            long hash = world.hash();
            forge.accept(bytes);
            bytes.putLong(SnapshotCodec.CHECK_AT, SnapshotCodec.check(bytes, bytes.limit()));
            assertIllegalArgument(message, () -> world.restore(bytes));
            assertThat(world.hash()).isEqualTo(hash);
            assertThat(world.response(5, 7)).isEqualTo(Response.SENSE);
        }
    }
}
