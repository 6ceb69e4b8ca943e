package io.github.circles2d.world.snapshots;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.World;
import io.github.circles2d.WorldScenes;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HexFormat;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** The fields of circles in snapshots: what is refused of them, and snapshots of the time before there were any. */
class FieldSectionsTest {
    /** Where the header has the number of sections. */
    private static final int SECTIONS_AT = 60;

    /** The only section of a snapshot with one tag: number, count, the id's varint, the value. */
    private static final int SECTION = 4 + 4 + 1 + 8;

    @Test
    void whatNoCallsLeadToIsRefused() {
        refused("number 99", b -> b.putInt(b.limit() - SECTION, 99));
        refused("not in order", b -> b.putInt(b.limit() - SECTION, 0));
        refused("2 values", b -> b.putInt(b.limit() - SECTION + 4, 2));
        refused("0 values", b -> b.putInt(b.limit() - SECTION + 4, 0));
        refused("has no circle", b -> b.put(b.limit() - 9, (byte) 2));
        refused("has no circle", b -> b.put(b.limit() - 9, (byte) 0));
        refused("initial value", b -> b.putLong(b.limit() - 8, 0));
        refused("ends early", b -> b.putInt(SECTIONS_AT, 2));
        refused("do not fit", b -> b.putInt(SECTIONS_AT, 0));
        refused("-1 sections", b -> b.putInt(SECTIONS_AT, -1));
    }

    private static void refused(String message, Consumer<ByteBuffer> forge) {
        try (World world = WorldScenes.jvm().build()) {
            long first = world.add(0.5f, 0.5f, 0.1f, 1);
            world.remove(world.add(0.6f, 0.5f, 0.1f, 1));
            world.setTag(first, 5);
            ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes()).order(ByteOrder.LITTLE_ENDIAN);
            world.snapshot(bytes);
            bytes.flip();
            world.setTag(first, 6);
            world.restore(bytes.duplicate());
            assertThat(world.tag(first)).isEqualTo(5);
            forge.accept(bytes);
            bytes.putLong(SnapshotCodec.CHECK_AT, SnapshotCodec.check(bytes, bytes.limit()));
            assertIllegalArgument(message, () -> world.restore(bytes));
            assertThat(world.tag(first)).isEqualTo(5);
        }
    }

    /** Taken before fields existed: two circles with a contact, the ids 1 and 2, and the free id 0. */
    private static final String OLD =
            "4344325701000000990000000200000003000000010000000000000000000000000080400000804000000000000020c1"
                    + "0000003f040000008988883c00000000fe85f63bea2c47130201315d0ced3f0000003f0000003f0000803f000024b300"
                    + "000000ad4974bf867d743b1012b73d013b8f4d3d094f230b405b29b93f0000003f0000004000002eb3000000b2ad49f4"
                    + "3efa75f7be00000080";

    @Test
    void snapshotsFromBeforeThereWereFieldsAreRead() {
        byte[] old = HexFormat.of().parseHex(OLD);
        try (World world = WorldScenes.jvm().build()) {
            long tagged = world.add(0.5f, 0.5f, 0.1f, 1);
            world.setTag(tagged, 9);
            world.restore(ByteBuffer.wrap(old));
            assertThat(world.size()).isEqualTo(2);
            assertThat(world.hash()).isEqualTo(3371164840132454390L);
            long[] handles = new long[2];
            world.readHandles(handles);
            assertThat(world.tag(handles[0])).isZero();
            ByteBuffer again = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(again);
            assertThat(again.array()).isEqualTo(old);
        }
    }
}
