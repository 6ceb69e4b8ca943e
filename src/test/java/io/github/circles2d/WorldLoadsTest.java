package io.github.circles2d;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import org.junit.jupiter.api.Test;

/** By how many circles, walls, pieces and bodies a circle is pressed, and how hard. */
class WorldLoadsTest {
    private static final float GRAVITY = 10;

    private static World column() {
        World world = WorldScenes.jvm()
                .bounds(0, 0, 10, 20)
                .gravity(0, -GRAVITY)
                .restitution(0)
                .threads(1)
                .build();
        world.add(5, 1, 1, 2);
        world.add(5, 3, 1, 3);
        world.add(5, 5, 1, 4);
        return world;
    }

    @Test
    void aColumnAtRestBearsTheWeightOfWhatIsAboveEachOfItsCircles() {
        try (World world = column()) {
            world.step(1 / 60f, 600);
            float[] loads = new float[6];
            world.readLoadsById(loads, null);
            assertThat(loads[0]).as("the floor and the circle above").isEqualTo(2);
            assertThat(loads[2]).isEqualTo(2);
            assertThat(loads[4]).isEqualTo(1);
            assertThat(loads[1]).isCloseTo((9 + 7) * GRAVITY, within(0.2f));
            assertThat(loads[3]).isCloseTo((7 + 4) * GRAVITY, within(0.2f));
            assertThat(loads[5]).isCloseTo(4 * GRAVITY, within(0.2f));
        }
    }

    @Test
    void piecesOfTerrainBearAsWallsDo() {
        try (World world = column()) {
            float[] loads = new float[6];
            world.terrain().addChain(Chain.of(9, 10, 5, 6, 1, 10)); // a valley of 45 degrees
            world.remove(world.handle(0));
            world.remove(world.handle(1));
            world.setPosition(world.handle(2), 5, 8);
            world.step(1 / 60f, 600);
            world.readLoadsById(loads, null);
            assertThat(loads[4]).isEqualTo(2);
            assertThat(loads[5]).isCloseTo(2 * 4 * GRAVITY / (float) Math.sqrt(2), within(0.5f));
            world.terrain().remove(world.terrain().handle(0));
            world.readLoadsById(loads, null);
            assertThat(loads[4]).as("one is gone").isEqualTo(1);
        }
    }

    @Test
    void bodiesCount() {
        try (World world = column()) {
            float[] loads = new float[12];
            world.clear();
            long left = world.add(4, 1, 1, 2);
            long right = world.add(6.5f, 1, 1, 2);
            long plank = world.bodies().add(Outline.box(5, 0.5f), 5.25f, 2.25f, 0, 4);
            long above = world.add(5.25f, 3, 0.5f, 1);
            world.step(1 / 60f, 300);
            world.readLoadsById(loads, null);
            for (long circle : new long[] {left, right}) {
                assertThat(loads[2 * World.id(circle)])
                        .as("the floor and the plank")
                        .isEqualTo(2);
                assertThat(loads[2 * World.id(circle) + 1]).isCloseTo((4.5f + 2.5f) * GRAVITY, within(0.2f));
            }
            assertThat(loads[2 * World.id(above)]).isOne();
            assertThat(loads[2 * World.id(above) + 1]).isCloseTo(GRAVITY, within(0.1f));
            world.bodies().remove(plank);
            world.readLoadsById(loads, null);
            assertThat(loads[2 * World.id(left)]).isOne();
            assertThat(loads[2 * World.id(above)]).isZero();
        }
    }

    @Test
    void jointsDoNotCount() {
        try (World world = column()) {
            float[] loads = new float[8];
            long hung = world.add(2, 15, 0.5f, 1);
            world.joints().add(hung, 2, 18, Joint.distance(3));
            world.step(1 / 60f, 60);
            world.readLoadsById(loads, null);
            assertThat(loads[2 * World.id(hung)]).isZero();
            assertThat(loads[2 * World.id(hung) + 1]).isZero();
        }
    }

    @Test
    void nothingPressesACircleThatFliesOrThatNoStepHasMoved() {
        try (World world = column()) {
            float[] loads = new float[8];
            world.readLoadsById(loads, null);
            assertThat(loads).startsWith(0, 0, 0, 0, 0, 0);
            world.step(1 / 60f, 60);
            long flying = world.add(2, 18, 1, 1);
            world.step(1 / 60f);
            world.readLoadsById(loads, null);
            assertThat(loads[2 * World.id(flying)]).isZero();
            assertThat(loads[2 * World.id(flying) + 1]).isZero();
        }
    }

    @Test
    void gapsAreNaNAndTheMaskHasTheLiving() {
        try (World world = column()) {
            world.remove(world.handle(1));
            float[] loads = new float[8];
            long[] living = new long[1];
            world.readLoadsById(loads, living);
            assertThat(living[0]).isEqualTo(0b101);
            assertThat(loads).containsExactly(0, 0, Float.NaN, Float.NaN, 0, 0, Float.NaN, Float.NaN);
        }
    }

    @Test
    void anArrayThatIsTooShortIsRefused() {
        try (World world = column()) {
            assertIllegalArgument(
                    "loads has room for 5 elements, but needs 6", () -> world.readLoadsById(new float[5], null));
            assertIllegalArgument("living", () -> world.readLoadsById(new float[6], new long[0]));
        }
    }

    @OnEachOpenClBackend
    void loadsAreTheSameToTheBitOnEveryBackEnd(Backend backend) {
        Scene scene = Scenes.thesis(500, Scenes.SEED);
        try (World world = WorldScenes.world(
                        scene, WorldScenes.builder(scene).gravity(0, -1).backend(backend));
                World jvm = WorldScenes.world(
                        scene, WorldScenes.builder(scene).gravity(0, -1).backend(Backend.JVM))) {
            float[] loads = new float[2 * scene.size()];
            float[] expected = new float[2 * scene.size()];
            float pressing = 0;
            for (int frame = 0; frame < 20; frame++) {
                world.step(scene.timeStep(), 10);
                jvm.step(scene.timeStep(), 10);
                world.readLoadsById(loads, null);
                jvm.readLoadsById(expected, null);
                assertThat(loads).isEqualTo(expected);
                for (int k = 0; k < loads.length; k += 2) {
                    pressing += loads[k];
                }
            }
            assertThat(pressing).isGreaterThan(1000);
        }
    }
}
