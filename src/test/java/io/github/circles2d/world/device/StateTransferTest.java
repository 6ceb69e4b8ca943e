package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import io.github.circles2d.WorldScenes;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.TestDevices;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.snapshots.SnapshotCodec;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A crowd that several threads save is the one that a single thread saves, on the JVM and from a device. */
class StateTransferTest {
    private static final Scene CROWD = Scenes.packed(6_000, 7);

    private static final Features TURNING = Features.TURNING;

    private static SavedState saved(Pipeline from, boolean byId) {
        SavedState state = new SavedState();
        state.setIds(CROWD.size());
        from.saveIds(state);
        if (byId) {
            Arrays.sort(state.id, 0, state.circles);
        }
        from.save(state);
        return state;
    }

    /** The circles in another order, which becomes that of slots. */
    private static SavedState shuffled(Pipeline from) {
        SavedState state = saved(from, true);
        Random random = new Random(1);
        for (int k = state.circles - 1; k > 0; k--) {
            int other = random.nextInt(k + 1);
            int id = state.id[k];
            state.id[k] = state.id[other];
            state.id[other] = id;
        }
        from.save(state);
        return state;
    }

    private static void load(Pipeline into, SavedState state) {
        into.prepare(ContactSettings.DEFAULT, TURNING);
        into.makeRoom(state);
        into.load(state);
    }

    private static void assertSame(SavedState state, SavedState expected) {
        int n = expected.circles;
        int m = expected.impulses;
        assertThat(state.impulses).isEqualTo(m).isGreaterThan(n / 2);
        assertThat(Arrays.equals(state.id, 0, n, expected.id, 0, n)).isTrue();
        assertThat(Arrays.equals(state.circle, 0, 4 * n, expected.circle, 0, 4 * n))
                .isTrue();
        assertThat(Arrays.equals(state.motion, 0, 4 * n, expected.motion, 0, 4 * n))
                .isTrue();
        assertThat(Arrays.equals(state.traits, 0, 4 * n, expected.traits, 0, 4 * n))
                .isTrue();
        assertThat(Arrays.equals(state.angle, 0, n, expected.angle, 0, n)).isTrue();
        int walls = ContactRows.ofWalls(n);
        assertThat(Arrays.equals(state.wallRows, 0, walls, expected.wallRows, 0, walls))
                .isTrue();
        assertThat(Arrays.equals(state.lo, 0, m, expected.lo, 0, m)).isTrue();
        assertThat(Arrays.equals(state.hi, 0, m, expected.hi, 0, m)).isTrue();
        assertThat(Arrays.equals(state.normalImpulse, 0, m, expected.normalImpulse, 0, m))
                .isTrue();
        int rows = ContactRows.of(m);
        assertThat(Arrays.equals(state.rows, 0, rows, expected.rows, 0, rows)).isTrue();
    }

    @Test
    void aCrowdIsSavedByManyThreadsAsByOne() {
        try (World world = WorldScenes.world(
                        CROWD,
                        WorldScenes.builder(CROWD)
                                .backend(Backend.JVM)
                                .threads(3)
                                .friction(0.5f));
                Pipeline alone = new JvmPipeline(1, 1, 0, false);
                Pipeline together = new JvmPipeline(4, 1, 0, false)) {
            world.step(CROWD.timeStep(), 20);
            ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(bytes);
            SavedState state = new SavedState();
            SnapshotCodec.read(bytes.flip(), state);
            load(alone, state);
            load(together, shuffled(alone));
            assertSame(saved(together, true), saved(alone, true));
            assertSame(saved(together, true), state);
            for (Device device : TestDevices.all()) {
                try (Pipeline there = new DevicePipeline(device, 0, false, true)) {
                    load(there, saved(together, false));
                    assertThat(there.hash()).isEqualTo(alone.hash());
                    assertSame(saved(there, true), state);
                    load(together, saved(there, false));
                    assertThat(together.hash()).isEqualTo(alone.hash());
                }
            }
        }
    }
}
