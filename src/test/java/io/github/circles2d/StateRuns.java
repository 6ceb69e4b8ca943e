package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Worlds that take another way to a state: they roll back, play a log, or make many steps in one call. */
final class StateRuns {
    private static final float STEP = 1 / 60f;

    private StateRuns() {}

    /** Changes a world before the step of a frame, as far as what is known at another frame. */
    @FunctionalInterface
    interface Play {
        void before(World world, int frame, int known);
    }

    /** Rolls back ten frames in each frame, which gives the bits of running straight. */
    static void rollBack(Supplier<World> worlds, int frames, Play play) {
        try (World straight = worlds.get();
                World rolling = worlds.get()) {
            Rewind rewind = new Rewind(rolling, 11);
            for (int frame = 0; frame < frames; frame++) {
                rewind.save(frame);
                play.before(rolling, frame, frame - 1);
                rolling.step(STEP);
                int from = Math.max(0, frame - 9);
                rewind.restore(from);
                for (int k = from; k <= frame; k++) {
                    rewind.save(k);
                    play.before(rolling, k, frame);
                    rolling.step(STEP);
                }
                play.before(straight, frame, frame);
                straight.step(STEP);
                assertThat(rolling.hash()).as("frame %d", frame).isEqualTo(straight.hash());
            }
            assertThat(snapshot(rolling)).isEqualTo(snapshot(straight));
        }
    }

    /** Records some frames and an end, and plays the log. */
    static void replay(World recorded, World replaying, int frames, Play play, Consumer<World> end) throws IOException {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        try (World world = recorded;
                World player = replaying) {
            try (Recording recording = new Recording(world, log, 1)) {
                for (int frame = 0; frame < frames; frame++) {
                    play.before(world, frame, frame);
                    world.step(STEP, 1 + frame % 2);
                }
                end.accept(world);
                world.step(STEP, 3);
                assertThat(recording.hasFailed()).isFalse();
            }
            Replay replay = new Replay(new ByteArrayInputStream(log.toByteArray()), player);
            assertThat(replay.run().differs()).as(replay.difference()).isFalse();
            assertThat(snapshot(player)).isEqualTo(snapshot(world));
        }
    }

    /** Makes steps in one call, and in a call each. */
    static void manySteps(Supplier<World> worlds, int steps) {
        try (World many = worlds.get();
                World one = worlds.get()) {
            many.step(STEP, steps);
            for (int k = 0; k < steps; k++) {
                one.step(STEP);
            }
            assertThat(snapshot(many)).isEqualTo(snapshot(one));
        }
    }
}
