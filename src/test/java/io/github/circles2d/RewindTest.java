package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Frames that come back, those that do not, and what they cost. */
@Tag("each-jdk")
class RewindTest {
    private static final int FRAMES = 90;
    private static final int BACK = 10;

    /** As in rollback netcode: each frame is made once without what is not known yet, and again when it is. */
    @OnEachBackend
    void rollingBackTenFramesInEachFrameGivesTheBitsOfRunningStraight(Backend backend) {
        Scene scene = Scenes.packed(300, 3);
        try (World rolling = WorldScenes.world(scene, WorldScenes.builder(scene).backend(backend))) {
            assertRollsBack(scene, rolling);
        }
    }

    @Test
    void soDoesAWorldThatMoves() {
        Scene scene = Scenes.packed(300, 3);
        try (World rolling = WorldScenes.world(scene, WorldScenes.builder(scene))) {
            RandomMoves.of(rolling, 5, 1);
            assertRollsBack(scene, rolling);
        }
    }

    private static void assertRollsBack(Scene scene, World rolling) {
        try (World straight =
                WorldScenes.world(scene, WorldScenes.builder(scene).backend(Backend.JVM))) {
            Rewind rewind = new Rewind(rolling, BACK + 1);
            for (int frame = 0; frame < FRAMES; frame++) {
                rewind.save(frame);
                makeFrame(rolling, scene, frame, frame - 1);
                int from = Math.max(0, frame - BACK + 1);
                rewind.restore(from);
                for (int k = from; k <= frame; k++) {
                    rewind.save(k);
                    makeFrame(rolling, scene, k, frame);
                }
                assertThat(rewind.oldest()).isEqualTo(Math.max(0, frame - BACK));
                assertThat(rewind.newest()).isEqualTo(frame);
                makeFrame(straight, scene, frame, frame);
                assertThat(rolling.hash()).as("frame %d", frame).isEqualTo(straight.hash());
            }
            assertThat(snapshot(rolling)).isEqualTo(snapshot(straight));
        }
    }

    /** Makes a frame with the inputs that are known: those of frames that are later are guessed wrong. */
    private static void makeFrame(World world, Scene scene, int frame, int known) {
        Random input = new Random(frame <= known ? frame : -1);
        long[] handles = new long[world.size()];
        world.readHandles(handles);
        long some = handles[input.nextInt(handles.length)];
        switch (input.nextInt(7)) {
            case 0 -> world.remove(some);
            case 1 -> world.add(scene.minX() + 0.4f * (scene.maxX() - scene.minX()), world.y(some), scene.radius(0), 2);
            case 2 -> world.setVelocity(some, input.nextFloat(), 0.2f);
            case 3 -> world.setGravity(0.1f * input.nextFloat(), -0.2f);
            case 4 -> world.setTag(some, frame);
            case 5 ->
                world.setBounds(scene.minX() - 0.01f * input.nextFloat(), scene.minY(), scene.maxX(), scene.maxY());
            default -> world.applyImpulse(some, 0, input.nextFloat());
        }
        world.step(frame % 5 == 0 ? 0.5f * scene.timeStep() : scene.timeStep());
    }

    @Test
    void framesOfAThousandCirclesTakeLessThan32MegabytesFor600() {
        try (World world =
                WorldScenes.jvm().bounds(0, 0, 40, 60).gravity(0, -10).build()) {
            for (int i = 0; i < 1000; i++) {
                world.add(1 + i % 38 + 0.3f * (i / 38 % 2), 1 + 1.5f * (i / 38), 0.5f, 1);
            }
            world.step(1 / 60f, 300);
            Rewind rewind = new Rewind(world, 600);
            for (int frame = 0; frame < 700; frame++) {
                world.step(1 / 60f);
                rewind.save(frame);
            }
            assertThat(rewind.size()).isEqualTo(600);
            assertThat(rewind.oldest()).isEqualTo(100);
            assertThat(rewind.bytes()).isBetween(600L * 1000 * 33, 32_000_000L);
        }
    }

    @Test
    void handlesAreThoseOfTheFrame() {
        try (World world = WorldScenes.jvm().build()) {
            Rewind rewind = new Rewind(world, 5);
            long a = world.add(0.2f, 0.2f, 0.1f, 1);
            long b = world.add(0.5f, 0.5f, 0.1f, 1);
            rewind.save(1);
            world.remove(a);
            long c = world.add(0.8f, 0.8f, 0.1f, 1);
            long d = world.add(0.2f, 0.8f, 0.1f, 1);
            rewind.save(2);
            rewind.restore(1);
            assertThat(world.contains(a)).isTrue();
            assertThat(world.contains(b)).isTrue();
            assertThat(world.contains(c)).isFalse();
            assertThat(world.contains(d)).isFalse();
            assertThatIllegalArgumentException().isThrownBy(() -> world.setVelocity(c, 1, 0));
            world.remove(a);
            assertThat(world.add(0.7f, 0.8f, 0.1f, 1)).as("given again").isEqualTo(c);
            rewind.restore(2);
            assertThat(world.contains(a)).isFalse();
            assertThat(world.x(c)).isEqualTo(0.8f);
            assertThat(world.x(d)).isEqualTo(0.2f);
        }
    }

    @Test
    void restoringKeepsFramesAndSavingDropsThoseFromItsNumberOn() {
        try (World world = WorldScenes.jvm().build()) {
            long ball = world.add(0.5f, 0.5f, 0.1f, 1, 0.01f, 0);
            Rewind rewind = new Rewind(world, 4);
            for (int frame = 10; frame < 20; frame += 2) {
                world.setTag(ball, frame);
                rewind.save(frame);
            }
            assertThat(rewind.size()).isEqualTo(4);
            for (int frame : new int[] {12, 18, 14, 16, 12}) {
                rewind.restore(frame);
                assertThat(world.tag(ball)).isEqualTo(frame);
            }
            assertThat(rewind.has(18)).isTrue();
            assertThat(rewind.has(13)).isFalse();
            world.setTag(ball, 15);
            rewind.save(15);
            assertThat(rewind.size()).isEqualTo(3);
            assertThat(rewind.newest()).isEqualTo(15);
            rewind.restore(14);
            rewind.restore(15);
            assertThat(world.tag(ball)).isEqualTo(15);
            rewind.save(-3);
            assertThat(rewind.oldest()).isEqualTo(-3);
            assertThat(rewind.size()).isEqualTo(1);
        }
    }

    @Test
    void afterAClearNoFrameIsThereAndTheNextSaveBeginsAnew() {
        try (World world = WorldScenes.jvm().build()) {
            long ball = world.add(0.5f, 0.5f, 0.1f, 1);
            world.setTag(ball, 9);
            Rewind rewind = new Rewind(world, 3);
            rewind.clear();
            for (int frame = 0; frame < 5; frame++) {
                rewind.save(frame);
            }
            long bytes = rewind.bytes();
            rewind.clear();
            assertThat(rewind.size()).isZero();
            for (int frame = 0; frame < 5; frame++) {
                assertThat(rewind.has(frame)).isFalse();
            }
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> rewind.restore(4))
                    .withMessage("frame 4 is not there: no frame has been saved");
            assertThatIllegalStateException().isThrownBy(rewind::oldest);
            for (int frame = 1; frame < 6; frame++) {
                world.setTag(ball, frame);
                rewind.save(frame);
            }
            assertThat(rewind.size()).isEqualTo(3);
            assertThat(rewind.oldest()).isEqualTo(3);
            rewind.restore(3);
            assertThat(world.tag(ball)).isEqualTo(3);
            assertThat(rewind.bytes()).as("the memory is used again").isEqualTo(bytes);
        }
    }

    @Test
    void aFrameThatIsNotThereIsRefusedWithTheRangeAndChangesNothing() {
        try (World world = WorldScenes.jvm().build()) {
            Rewind rewind = new Rewind(world, 3);
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> rewind.restore(0))
                    .withMessage("frame 0 is not there: no frame has been saved");
            assertThatIllegalStateException().isThrownBy(rewind::oldest).withMessage("no frame has been saved");
            assertThatIllegalStateException().isThrownBy(rewind::newest);
            for (int frame = 0; frame < 7; frame++) {
                world.add(0.1f + 0.1f * frame, 0.5f, 0.04f, 1);
                rewind.save(frame);
            }
            long hash = world.hash();
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> rewind.restore(3))
                    .withMessage("frame 3 is not there: there are the frames from 4 to 6");
            rewind.save(9);
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> rewind.restore(7))
                    .withMessage("frame 7 is not there: there are 3 of the frames from 5 to 9");
            assertThat(world.hash()).isEqualTo(hash);
            assertIllegalArgument("the number of frames", () -> new Rewind(world, 0));
        }
    }

    @Test
    void aClosedWorldIsRefused() {
        World world = WorldScenes.jvm().build();
        Rewind rewind = new Rewind(world, 3);
        rewind.save(1);
        world.close();
        assertThatIllegalStateException().isThrownBy(() -> rewind.save(2));
        assertThatIllegalStateException().isThrownBy(() -> rewind.restore(1));
        assertThatIllegalStateException()
                .isThrownBy(() -> new Rewind(world, 3))
                .withMessage("this World has been closed");
    }
}
