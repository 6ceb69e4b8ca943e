package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import java.util.zip.CRC32C;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** What a replay repeats, how it says that it differs, and what it refuses. */
class RecordingTest {
    private static final int STEPS = 60;

    // The form of a log: a header, then blocks with a type, a length and a check before their bytes.
    private static final int HEADER = 12;
    private static final int BLOCK_HEAD = 9;
    private static final int CALLS = 1;

    /** In the log: the call of a step. */
    private static final byte STEP = 64;

    @OnEachBackend
    @Tag("each-jdk")
    void aLogOfAnyBackEndReplaysOnAnyOther(Backend backend) throws IOException {
        Scene scene = Scenes.packed(300, 4);
        byte[] log;
        ByteBuffer end;
        try (World world = WorldScenes.world(scene, WorldScenes.builder(scene).backend(backend))) {
            log = record(world, 7);
            end = snapshot(world);
        }
        for (Backend other : TestBackends.all()) {
            try (World player = World.builder().backend(other).build()) {
                Replay replay = replay(log, player).run();
                assertThat(replay.difference()).isEqualTo("no difference in " + replay.steps() + " steps");
                assertThat(replay.equalUpTo()).isEqualTo(replay.steps()).isEqualTo(STEPS);
                assertThat(snapshot(player)).isEqualTo(end);
            }
        }
    }

    /** Joints come and go. */
    private static void join(World world, long circle, long other, int call) {
        if (call % 5 == 1 && circle != other) {
            world.joints()
                    .add(
                            circle,
                            other,
                            Joint.spring(4, 0.5f).withLimits(0, 0.6f).breakingAt(300, 5));
            world.joints().add(circle, 0.5f, 0.5f, Joint.rope(0.9f));
        } else if (call % 10 == 4) {
            world.joints().clear();
        }
    }

    /** Sixty steps, in calls of one to three, with a change before each, a rewind and a restore. */
    private static byte[] record(World world, int hashEvery) throws IOException {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        Rewind rewind = new Rewind(world, 8);
        Random random = new Random(5);
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        world.setTag(handles[3], 9); // before the recording, and not yet made
        world.setVelocity(handles[4], 0.01f, 0);
        try (Recording recording = new Recording(world, log, hashEvery)) {
            for (int call = 0; recording.steps() < STEPS; call++) {
                rewind.save(call);
                long some = handles[random.nextInt(handles.length)];
                world.setTag(some, call);
                world.applyImpulse(some, 0.001f * random.nextFloat(), 0.001f);
                join(world, some, handles[call % handles.length], call);
                world.step(1 / 60f, (int) Math.min(1 + call % 3, STEPS - recording.steps()));
                if (call % 10 == 9) {
                    rewind.restore(call - 5);
                }
            }
            assertThat(recording.hasFailed()).isFalse();
            assertThat(recording.bytes()).isGreaterThanOrEqualTo(log.size());
        }
        return log.toByteArray();
    }

    private static Replay replay(byte[] log, World player) throws IOException {
        return new Replay(new ByteArrayInputStream(log), player);
    }

    private static World world() {
        World world = WorldScenes.jvm().gravity(0, -9).threads(1).build();
        for (int i = 0; i < 20; i++) {
            world.add(0.2f + 0.15f * (i % 5), 0.1f + 0.15f * (i / 5), 0.07f, 1 + i);
        }
        return world;
    }

    /** The calls make a log, whatever makes the steps, and whether somebody reads between them. */
    @Test
    @Tag("each-jdk")
    void aLogHasTheSameBytesWithAnyThreadsAndReads() throws IOException {
        byte[] expected = recordUnread(WorldScenes.jvm().threads(1), false);
        assertThat(recordUnread(WorldScenes.jvm().threads(1), true)).isEqualTo(expected);
        assertThat(recordUnread(WorldScenes.jvm().threads(2), true)).isEqualTo(expected);
        assertThat(recordUnread(WorldScenes.jvm().threads(3), false)).isEqualTo(expected);
    }

    @OnEachBackend
    @Tag("each-jdk")
    @Tag("long")
    void aLogHasTheSameBytesOnAnyBackEnd(Backend backend) throws IOException {
        byte[] expected = recordUnread(WorldScenes.jvm().threads(1), false);
        for (boolean read : new boolean[] {false, true}) {
            assertThat(recordUnread(World.builder().bounds(0, 0, 1, 1).backend(backend), read))
                    .isEqualTo(expected);
        }
    }

    /** Changes that wait when a state is restored, or all circles go, with or without a read between. */
    private static byte[] recordUnread(World.Builder builder, boolean read) throws IOException {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        try (World world = builder.build();
                World player = world()) {
            long circle = world.add(0.5f, 0.5f, 0.1f, 1);
            world.add(0.5f, 0.8f, 0.1f, 1);
            Rewind rewind = new Rewind(world, 2);
            try (Recording recording = new Recording(world, log, 3)) {
                for (int frame = 0; frame < 12; frame++) {
                    rewind.save(frame);
                    world.setRestitution(circle, 0.01f * frame);
                    world.setVelocity(circle, 0.1f, 0);
                    world.add(0.2f, 0.2f, 0.05f, 1);
                    if (read) {
                        world.hash();
                    }
                    if (frame % 3 == 0) {
                        rewind.restore(frame);
                    } else if (frame == 10) {
                        world.clear();
                        circle = world.add(0.5f, 0.5f, 0.1f, 1);
                    }
                    world.step(1 / 60f);
                }
                assertThat(recording.hasFailed()).isFalse();
            }
            assertThat(replay(log.toByteArray(), player).run().differs()).isFalse();
        }
        return log.toByteArray();
    }

    @Test
    @Tag("long")
    void aClosedChainOfAsManyPiecesAsThereMayBeIsRepeated() throws IOException {
        Chain chain = Chain.from(0, 0);
        int most = 1 << 20;
        while (chain.pieces() < most - 1) {
            chain.lineTo(0.1f + 0.1f * (chain.pieces() % 2), 0.1f);
        }
        chain.close();
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        try (World world = world()) {
            try (Recording recording = new Recording(world, log, 1)) {
                assertThat(world.terrain().addChain(chain)).isEqualTo(most);
                assertThat(recording.hasFailed()).isFalse();
            }
        }
        try (World player = world()) {
            assertThat(replay(log.toByteArray(), player).run().differs()).isFalse();
            assertThat(player.terrain().size()).isEqualTo(most);
        }
    }

    /** It says that the log is wrong, and not only which value of which call is. */
    @Test
    void aCallThatIsRefusedIsTheLogs() throws IOException {
        try (World world = world();
                World player = world()) {
            byte[] log = recordFalls(world, 1);
            ByteBuffer bytes = ByteBuffer.wrap(log).order(ByteOrder.LITTLE_ENDIAN);
            int block = HEADER + BLOCK_HEAD + bytes.getInt(HEADER + 1);
            bytes.putFloat(block + BLOCK_HEAD + 9 + 1, -1);
            fitChecks(bytes);
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> replay(log, player).run())
                    .withMessageStartingWith("this is no log of a world: the time step is -1.0")
                    .withMessageEndingWith(", after step 0");
        }
    }

    @Test
    void theFirstStepThatDiffersIsNamed() throws IOException {
        try (World world = world();
                World player = world()) {
            for (int hashEvery : new int[] {1, 10}) {
                byte[] log = recordFalls(world, hashEvery);
                change(log, 37);
                Replay replay = replay(log, player);
                int first = hashEvery == 1 ? 37 : 40;
                while (replay.step()) {
                    assertThat(replay.differs()).isEqualTo(replay.steps() >= first);
                }
                assertThat(replay.steps()).isEqualTo(STEPS);
                assertThat(replay.firstDifference()).isEqualTo(first);
                assertThat(replay.equalUpTo()).isEqualTo(hashEvery == 1 ? 36 : 30);
                assertThat(replay.difference())
                        .startsWith("step " + first + " differs: the hash is ")
                        .endsWith("the last equal hash is of step " + replay.equalUpTo());
            }
        }
    }

    private static byte[] recordFalls(World world, int hashEvery) throws IOException {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        try (Recording recording = new Recording(world, log, hashEvery)) {
            while (recording.steps() < STEPS) {
                world.step(1 / 60f);
            }
        }
        return log.toByteArray();
    }

    /** Makes a step of a log a little longer. */
    private static void change(byte[] log, int step) {
        ByteBuffer bytes = ByteBuffer.wrap(log).order(ByteOrder.LITTLE_ENDIAN);
        int block = HEADER;
        while (bytes.get(block) != CALLS) {
            block += BLOCK_HEAD + bytes.getInt(block + 1);
        }
        int at = block + BLOCK_HEAD;
        for (int before = bytes.get(at) == STEP ? 1 : 0; before < step; before += bytes.get(at) == STEP ? 1 : 0) {
            at += 9; // steps and hashes, the only calls, have two words
        }
        bytes.putFloat(at + 1, 1 / 59f);
        fitChecks(bytes);
    }

    private static void fitChecks(ByteBuffer bytes) {
        int block = HEADER;
        while (block + BLOCK_HEAD <= bytes.limit()) {
            int length = bytes.getInt(block + 1);
            if (length < 0 || length > bytes.limit() - block - BLOCK_HEAD) {
                return;
            }
            CRC32C check = new CRC32C();
            check.update(bytes.array(), block + BLOCK_HEAD, length);
            bytes.putInt(block + 5, (int) check.getValue());
            block += BLOCK_HEAD + length;
        }
    }

    @Test
    void aLogThatIsCutAnywhereSaysSoAndLeavesTheStateOfTheStepThatItNames() throws IOException {
        try (World world = world();
                World player = world()) {
            byte[] log = recordFalls(world, 5);
            assertThat(replay(log, player).run().differs()).isFalse();
            for (int length = 0; length < log.length; length += length < 100 || length > log.length - 100 ? 1 : 7) {
                byte[] cut = Arrays.copyOf(log, length);
                assertThatIllegalArgumentException()
                        .isThrownBy(() -> replay(cut, player).run())
                        .withMessageStartingWith(
                                length < 4
                                        ? "this is no log of a world: it does not begin as one"
                                        : "this log is cut: it ends after " + length + " bytes");
            }
            byte[] withoutEnd = Arrays.copyOf(log, log.length - 1);
            Replay replay = replay(withoutEnd, player);
            assertThatIllegalArgumentException()
                    .isThrownBy(replay::run)
                    .withMessage("this log is cut: it ends after " + withoutEnd.length + " bytes, after step " + STEPS);
            assertThat(player.hash()).isEqualTo(world.hash());
        }
    }

    @Test
    void damagedBytesAreFoundBeforeTheyAreUsed() throws IOException {
        try (World world = world();
                World player = world()) {
            byte[] log = recordFalls(world, 5);
            for (int at = 0; at < log.length; at++) {
                byte[] damaged = log.clone();
                damaged[at] ^= 8;
                if (at >= 8 && at < HEADER) {
                    continue; // the distance of hashes, which nothing depends on
                }
                assertThatIllegalArgumentException()
                        .isThrownBy(() -> replay(damaged, player).run())
                        .withMessageMatching("this (is no log of a world|log is damaged|log is cut): .*");
            }
        }
    }

    /** With checks that fit, a forged log is refused, or leads to a state as sound as any other. */
    @Test
    void forgedLogsAreRefusedOrDifferOrLeadToSoundStates() throws IOException {
        Random random = new Random(6);
        int refused = 0;
        try (World world = world();
                World player = world()) {
            byte[] log = record(world, 5);
            for (int k = 0; k < 3000; k++) {
                byte[] forged = log.clone();
                ByteBuffer bytes = ByteBuffer.wrap(forged).order(ByteOrder.LITTLE_ENDIAN);
                for (int changes = 1 + random.nextInt(3); changes > 0; changes--) {
                    int at = random.nextInt(forged.length - 3);
                    switch (random.nextInt(3)) {
                        case 0 -> bytes.put(at, (byte) random.nextInt());
                        case 1 -> bytes.putInt(at, random.nextInt(3) - 1 ^ random.nextInt(2) << 31);
                        default -> bytes.putFloat(at, random.nextBoolean() ? Float.NaN : 1e30f * random.nextFloat());
                    }
                }
                fitChecks(bytes);
                try {
                    Replay replay = replay(forged, player);
                    while (replay.step() && replay.steps() < 2 * STEPS) {
                        assertThat(replay.steps()).isPositive();
                    }
                } catch (IllegalArgumentException e) {
                    refused++;
                    assertThat(e.getMessage()).matches("this (is no log of a world|log is damaged|log is cut): .*");
                }
                float[] circles = new float[4 * player.size()];
                player.read(circles);
                for (int i = 0; i < circles.length; i++) {
                    assertThat(i % 4 == 3 || Float.isFinite(circles[i])).isTrue();
                }
            }
        }
        assertThat(refused).isBetween(300, 3000);
    }

    @Test
    @Tag("each-jdk")
    void aForgedLengthTakesNoMemory() {
        ByteBuffer head = ByteBuffer.allocate(HEADER + BLOCK_HEAD).order(ByteOrder.LITTLE_ENDIAN);
        head.putInt(0x4C324443).putInt(1).putInt(60).put((byte) 2).putInt(Integer.MAX_VALUE);
        try (World player = world()) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> new Replay(slow(head.array()), player))
                    .withMessage("this log is cut: it ends after 21 bytes, after step 0");
            head.putInt(4, 2);
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> new Replay(slow(head.array()), player))
                    .withMessage("this is no log of a world: its version is 2, not 1");
        }
    }

    /** A stream that does not know its length. */
    private static InputStream slow(byte[] bytes) {
        ByteArrayInputStream in = new ByteArrayInputStream(bytes);
        return new InputStream() {
            @Override
            public int read() {
                return in.read();
            }
        };
    }

    @Test
    void theGameGoesOnIfTheStreamFails() throws IOException {
        try (World world = world();
                World same = world()) {
            ByteArrayOutputStream written = new ByteArrayOutputStream();
            OutputStream full = new OutputStream() {
                @Override
                public void write(int b) throws IOException {
                    if (written.size() == 100_000) {
                        throw new IOException("the disk is full");
                    }
                    written.write(b);
                }
            };
            Recording recording = new Recording(world, full, 1);
            for (int k = 0; k < 8000; k++) {
                world.step(1 / 60f);
            }
            same.step(1 / 60f, 8000);
            assertThat(recording.hasFailed()).isTrue();
            long steps = recording.steps();
            assertThat(steps).isBetween(3000L, 4000L); // those of one block
            assertThat(world.hash()).isEqualTo(same.hash());
            assertThatIllegalStateException()
                    .isThrownBy(() -> new Recording(world, OutputStream.nullOutputStream(), 1))
                    .withMessage("this World is being recorded already");
            assertThatExceptionOfType(IOException.class)
                    .isThrownBy(recording::close)
                    .withMessage("the log ends early: the disk is full");
            recording.close();
            new Recording(world, OutputStream.nullOutputStream(), 1).close();
            assertThat(recording.hasFailed()).isTrue();
            assertThat(recording.steps()).isEqualTo(steps);
            assertThat(recording.bytes()).isLessThanOrEqualTo(100_000);
            Replay replay = replay(written.toByteArray(), same);
            assertThatIllegalArgumentException()
                    .isThrownBy(replay::run)
                    .withMessage("this log is cut: it ends after 100000 bytes, after step " + steps);
            assertThat(replay.steps()).isEqualTo(steps);
        }
    }

    @Test
    void aStreamThatFailsAtOnceLeavesAWorldThatCanBeRecorded() throws IOException {
        try (World world = world()) {
            OutputStream closed = OutputStream.nullOutputStream();
            closed.close();
            assertThatExceptionOfType(IOException.class).isThrownBy(() -> new Recording(world, closed, 1));
            assertIllegalArgument(
                    "the number of steps between two hashes",
                    () -> new Recording(world, OutputStream.nullOutputStream(), 0));
            assertThat(recordFalls(world, 1)).isNotEmpty();
        }
    }

    /** A stream that throws as soon as it has taken so many bytes, when it is flushed, or when it is closed. */
    private static final class Failing extends OutputStream {
        private final Exception failure;
        private long left;

        Failing(Exception failure, long left) {
            this.failure = failure;
            this.left = left;
        }

        private void fail() throws IOException {
            if (failure instanceof IOException e) {
                throw e;
            }
            throw (RuntimeException) failure;
        }

        @Override
        public void write(int b) throws IOException {
            if (left-- == 0) {
                fail();
            }
        }

        @Override
        public void flush() throws IOException {
            fail();
        }

        @Override
        public void close() throws IOException {
            fail();
        }
    }

    @Test
    @Tag("each-jdk")
    void aFailureOfTheStreamIsToldAsAnIoExceptionWithATextWhateverWasThrownAndWhenever() throws IOException {
        Map<Exception, String> failures = new LinkedHashMap<>();
        failures.put(new IOException("no room"), "no room");
        failures.put(new IOException(), "java.io.IOException");
        failures.put(new IllegalStateException("not now"), "not now");
        failures.put(new UnsupportedOperationException(), "java.lang.UnsupportedOperationException");
        failures.put(new IllegalArgumentException(" "), "java.lang.IllegalArgumentException");
        try (World world = world()) {
            for (Map.Entry<Exception, String> failure : failures.entrySet()) {
                Exception thrown = failure.getKey();
                for (int left : new int[] {0, HEADER - 1, HEADER, HEADER + BLOCK_HEAD + 5}) {
                    assertThatExceptionOfType(IOException.class)
                            .isThrownBy(() -> new Recording(world, new Failing(thrown, left), 1))
                            .withMessage("the log cannot begin: " + failure.getValue())
                            .withCause(thrown);
                }
                Recording recording = new Recording(world, new Failing(thrown, Long.MAX_VALUE), 1);
                world.step(1 / 60f);
                assertThatExceptionOfType(IOException.class)
                        .isThrownBy(recording::close)
                        .withMessage("the log ends early: " + failure.getValue())
                        .withCause(thrown)
                        .satisfies(e -> assertThat(e.getSuppressed())
                                .singleElement()
                                .extracting(Throwable::getMessage)
                                .isEqualTo("the stream of the log cannot be closed: " + failure.getValue()));
                assertThat(recording.hasFailed()).isTrue();
                assertThat(recordFalls(world, 1))
                        .as("the world can be recorded")
                        .isNotEmpty();
            }
        }
    }

    @Test
    void aRecordingThatIsClosedStillTellsWhatItsLogHas() throws IOException {
        try (World world = world()) {
            ByteArrayOutputStream log = new ByteArrayOutputStream();
            Recording recording = new Recording(world, log, 5);
            world.step(1 / 60f, 12);
            recording.close();
            try (Recording next = new Recording(world, OutputStream.nullOutputStream(), 5)) {
                world.step(1 / 60f, 3);
                assertThat(next.steps()).isEqualTo(3);
            }
            assertThat(recording.steps()).isEqualTo(12);
            assertThat(recording.bytes()).isEqualTo(log.size());
            assertThat(recording.hasFailed()).isFalse();
        }
    }

    @Test
    void aClosedWorldIsNotRecordedAndPlaysNothing() throws IOException {
        try (World world = world()) {
            ByteArrayInputStream log = new ByteArrayInputStream(recordFalls(world, 5));
            int length = log.available();
            World closed = world();
            closed.close();
            assertThatIllegalStateException()
                    .isThrownBy(() -> new Recording(closed, OutputStream.nullOutputStream(), 1))
                    .withMessage("this World has been closed");
            assertThatIllegalStateException()
                    .isThrownBy(() -> new Replay(log, closed))
                    .withMessage("this World has been closed");
            assertThat(log.available()).as("nothing has been read").isEqualTo(length);
        }
    }

    @Test
    void aRecordingMayBeClosedAfterItsWorld() throws IOException {
        ByteArrayOutputStream log = new ByteArrayOutputStream();
        World world = world();
        Recording recording = new Recording(world, log, 5);
        world.step(1 / 60f, 12);
        long hash = world.hash();
        world.close();
        recording.close();
        try (World player = world()) {
            Replay replay = replay(log.toByteArray(), player).run();
            assertThat(replay.steps()).isEqualTo(12);
            assertThat(replay.equalUpTo()).isEqualTo(12);
            assertThat(player.hash()).isEqualTo(hash);
        }
    }
}
