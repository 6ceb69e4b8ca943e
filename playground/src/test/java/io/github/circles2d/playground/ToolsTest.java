package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.Backend;
import io.github.circles2d.Outline;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What each tool does to a world. */
class ToolsTest {
    private final Sandbox sandbox = new Sandbox(Stages.named("empty"), Backend.JVM);

    @AfterEach
    void close() {
        sandbox.close();
    }

    private World world() {
        return sandbox.world();
    }

    private void run(Tool tool, int steps) {
        for (int k = 0; k < steps; k++) {
            sandbox.stepOnce(() -> tool.beforeStep(sandbox));
        }
    }

    @Test
    void aGrabbedCircleGoesToTheMouseAndKeepsItsSpeedWhenItIsLetGo() {
        long ball = world().add(80, 2, 2, 4);
        Tool grab = new GrabTool();
        grab.press(sandbox, 80.5f, 2, 1);
        grab.drag(sandbox, 60.5f, 50);
        run(grab, 12);
        float speed = world().vy(ball);
        assertThat(speed).as("on its way").isGreaterThan(30);
        grab.release(sandbox);
        run(grab, 1);
        assertThat(world().vy(ball)).as("thrown").isBetween(speed - 2, speed);
        grab.press(sandbox, world().x(ball), world().y(ball), 1);
        grab.drag(sandbox, 60, 50);
        run(grab, 120);
        assertThat(world().x(ball)).isBetween(59.5f, 60.5f);
        assertThat(world().y(ball)).as("held against gravity").isBetween(49.5f, 50.5f);
    }

    @Test
    void aClickBesideACircleTakesTheNearestAndOneFarAwayNone() {
        long ball = world().add(80, 50, 2, 4);
        GrabTool grab = new GrabTool();
        grab.press(sandbox, 83, 50, 1);
        assertThat(grab.held()).isEqualTo(ball);
        grab.press(sandbox, 100, 50, 1);
        assertThat(grab.held()).isZero();
    }

    @Test
    void aStaticCircleIsMovedAndStaysWhereItIsLeft() {
        long post = world().add(80, 50, 2, Float.POSITIVE_INFINITY);
        Tool grab = new GrabTool();
        grab.press(sandbox, 80, 50, 1);
        grab.drag(sandbox, 90, 200);
        run(grab, 60);
        grab.release(sandbox);
        run(grab, 10);
        assertThat(world().x(post)).isBetween(80.5f, 90f);
        assertThat(world().y(post)).as("not beyond the wall").isEqualTo(100);
    }

    @Test
    void aCircleThatIsRemovedWhileItIsHeldIsNoTrouble() {
        long ball = world().add(80, 50, 2, 4);
        Tool grab = new GrabTool();
        grab.press(sandbox, 80, 50, 1);
        world().remove(ball);
        run(grab, 2);
        List<Mark> marks = new ArrayList<>();
        grab.mark(sandbox, marks);
        assertThat(marks).isEmpty();
    }

    @Test
    void inAWorldOfTheSmallestCirclesToolsAddNoneThatItRefuses() {
        float least = 0x1p-20f;
        try (Sandbox small = new Sandbox(smallest(least), Backend.JVM)) {
            Tool pour = new PourTool();
            pour.press(small, 0.5f, 0.5f, 1);
            for (int k = 0; k < 5; k++) {
                small.stepOnce(() -> pour.beforeStep(small));
            }
            int poured = small.world().size();
            assertThat(poured).isGreaterThan(1);
            Tool wall = new WallTool();
            wall.press(small, 0.25f, 0.5f, 0.25f);
            wall.release(small);
            assertThat(small.world().size()).isEqualTo(poured + 1);
            float[] circles = new float[4 * (poured + 1)];
            small.world().read(circles);
            for (int k = 0; k <= poured; k++) {
                assertThat(circles[4 * k + 2]).isBetween(least, 1.25f * least);
            }
        }
    }

    private static Stage smallest(float radius) {
        return new Stage("smallest", false, World::builder, world -> world.add(0.75f, 0.5f, radius, 1));
    }

    @Test
    void pouringAddsCirclesInsideTheWallsThatOverlapNothing() {
        world().add(80, 60, 2, 4);
        Tool pour = new PourTool();
        pour.press(sandbox, 80, 60, 1);
        sandbox.stepOnce(() -> {
            pour.beforeStep(sandbox);
            assertNothingOverlaps();
        });
        pour.drag(sandbox, 159.5f, 1);
        run(pour, 200);
        int poured = world().size();
        assertThat(poured).isGreaterThan(30);
        pour.release(sandbox);
        run(pour, 10);
        assertThat(world().size()).isEqualTo(poured);
    }

    private void assertNothingOverlaps() {
        float[] circles = new float[4 * world().size()];
        world().read(circles);
        assertThat(circles.length).isGreaterThan(4);
        for (int a = 0; a < circles.length; a += 4) {
            for (int b = 0; b < a; b += 4) {
                double distance = Math.hypot(circles[a] - circles[b], circles[a + 1] - circles[b + 1]);
                assertThat(distance).isGreaterThan(circles[a + 2] + circles[b + 2] - 1e-4);
            }
        }
    }

    @Test
    void anExplosionPushesAwayWhatIsNearAndShowsARingForAWhile() {
        long near = world().add(84, 50, 1, 1);
        long far = world().add(20, 50, 1, 1);
        Tool explode = new ExplodeTool();
        explode.press(sandbox, 80, 50, 1);
        assertThat(world().vx(near)).isGreaterThan(10);
        assertThat(world().vx(far)).isZero();
        List<Mark> marks = new ArrayList<>();
        explode.mark(sandbox, marks);
        assertThat(marks).hasSize(1);
        for (int frame = 0; frame < 60; frame++) {
            marks.clear();
            explode.mark(sandbox, marks);
        }
        assertThat(marks).isEmpty();
    }

    @Test
    void aLineThatIsDrawnHoldsWhatFallsOnIt() {
        Tool wall = new WallTool();
        wall.press(sandbox, 20, 50, 1);
        wall.drag(sandbox, 100, 53);
        wall.drag(sandbox, 140, 50);
        wall.drag(sandbox, 200, 50);
        wall.release(sandbox);
        assertThat(world().terrain().size()).isEqualTo(3);
        assertThat(world().size()).as("a click alone gives a circle").isZero();
        long[] balls = new long[12];
        for (int k = 0; k < balls.length; k++) {
            balls[k] = world().add(30 + 8 * k, 80, 0.6f, 1);
        }
        run(wall, 30);
        for (long ball : balls) {
            assertThat(world().y(ball)).isGreaterThan(50);
        }
    }

    @Test
    void anArcThatIsDrawnToTheRightIsABowl() {
        Tool arc = new ShapeTool(ShapeTool.ARC);
        arc.press(sandbox, 60, 50, 1);
        arc.drag(sandbox, 70, 55);
        arc.drag(sandbox, 100, 50); // in place of the one before
        arc.release(sandbox);
        assertThat(world().terrain().size()).isEqualTo(1);
        long ball = world().add(65, 70, 0.6f, 1);
        run(arc, 600);
        assertThat(world().x(ball)).isBetween(60f, 100f);
        assertThat(world().y(ball)).isBetween(30f, 50f);
    }

    @Test
    void aChainThatIsDrawnToTheLeftCarriesAndOneToTheRightDoesNot() {
        long[] balls = {world().add(30, 60, 0.6f, 1), world().add(110, 60, 0.6f, 1)};
        Tool chain = new ChainTool();
        chain.press(sandbox, 60, 50, 1);
        for (int x = 59; x >= 10; x--) {
            chain.drag(sandbox, x, 50);
        }
        chain.release(sandbox);
        chain.press(sandbox, 90, 50, 1);
        for (int x = 91; x <= 130; x++) {
            chain.drag(sandbox, x, 50);
        }
        chain.release(sandbox);
        run(chain, 120);
        assertThat(world().y(balls[0])).isBetween(50.5f, 50.7f);
        assertThat(world().y(balls[1])).isLessThan(45);
    }

    @Test
    void aLineIsMovedAndTurnedByTheMouse() {
        Tool line = new ShapeTool(ShapeTool.LINE);
        line.press(sandbox, 60, 50, 1);
        line.drag(sandbox, 80, 50);
        line.release(sandbox);
        TerrainBody body = world().terrain().bodyOf(world().queries().terrain().pick(65, 50, 1));
        GrabTool grab = new GrabTool();
        assertThat(grab.turn(1)).as("nothing is held").isFalse();
        grab.press(sandbox, 65, 50, 1);
        assertThat(grab.held()).isZero();
        assertThat(grab.turn(2)).isTrue();
        grab.drag(sandbox, 75, 60);
        run(grab, 60);
        List<Mark> marks = new ArrayList<>();
        grab.mark(sandbox, marks);
        assertThat(marks).hasSize(2);
        grab.release(sandbox);
        run(grab, 10);
        assertThat(body.x()).isCloseTo(80, within(0.01f));
        assertThat(body.y()).isCloseTo(60, within(0.01f));
        assertThat(body.angle()).isCloseTo((float) Math.toRadians(30), within(0.001f));
    }

    @Test
    void theHandIsAJointThatGoesWhenItLetsGoAndThePastHasNone() {
        long ball = world().add(80, 50, 2, 4);
        GrabTool grab = new GrabTool();
        grab.press(sandbox, 80, 50, 1);
        run(grab, 3);
        assertThat(world().joints().size()).isEqualTo(1);
        grab.release(sandbox);
        assertThat(world().joints().size()).isZero();
        run(grab, 3);
        for (int k = 0; k < 5; k++) {
            assertThat(sandbox.back()).isTrue();
            grab.wentBack(sandbox);
            assertThat(world().joints().size()).isZero();
        }
        grab.press(sandbox, world().x(ball), world().y(ball), 1);
        run(grab, 2);
        assertThat(sandbox.back()).isTrue();
        grab.wentBack(sandbox);
        run(grab, 1);
        assertThat(world().joints().size()).as("it still holds").isEqualTo(1);
    }

    @Test
    void aRopeHoldsABallAndDoesNotStretch() {
        long ball = world().add(80, 60, 2, 4);
        Tool rope = new JointTool(JointTool.ROPE);
        rope.press(sandbox, 80, 90, 1);
        rope.drag(sandbox, 80.5f, 61);
        List<Mark> marks = new ArrayList<>();
        rope.mark(sandbox, marks);
        assertThat(marks).hasSize(1);
        rope.release(sandbox);
        assertThat(world().size()).as("it has links").isGreaterThan(10);
        assertThat(world().joints().size()).isEqualTo(world().size() + 1);
        world().setVelocity(ball, 40, 0);
        for (int k = 0; k < 300; k++) {
            run(rope, 1);
            double length = Math.hypot(world().x(ball) - 80, world().y(ball) - 90);
            assertThat(length).isLessThan(30.3);
        }
    }

    @Test
    void aSpringJoinsTwoCirclesAndACircleAndItselfNot() {
        long left = world().add(60, 50, 2, 4);
        long right = world().add(90, 50, 2, 4);
        Tool spring = new JointTool(JointTool.SPRING);
        spring.press(sandbox, 60, 50, 1);
        spring.drag(sandbox, 60.5f, 50);
        spring.release(sandbox);
        assertThat(world().joints().size()).isZero();
        spring.press(sandbox, 60, 50, 1);
        spring.drag(sandbox, 90, 50);
        spring.release(sandbox);
        assertThat(world().joints().size()).isEqualTo(1);
        world().setVelocity(left, -20, 0);
        world().setVelocity(right, 20, 0);
        run(spring, 15);
        assertThat(world().vx(right)).as("pulled back").isLessThan(10);
    }

    @Test
    void aSpringOnTerrainThatMovesPullsABallAlong() {
        TerrainBody lift = world().terrain().addBody(40, 80, 0.5f);
        lift.addSegment(-5, 0, 5, 0, 0.5f, 0);
        long ball = world().add(60, 60, 2, 4);
        Tool spring = new JointTool(JointTool.SPRING);
        spring.press(sandbox, 60, 60, 1);
        spring.drag(sandbox, 43, 81.5f);
        spring.release(sandbox);
        assertThat(world().joints().size()).isEqualTo(1);
        lift.setVelocity(20, 0);
        run(spring, 180);
        assertThat(world().x(ball)).isGreaterThan(75);
        assertThat(world().y(ball)).isGreaterThan(30);
    }

    @Test
    void aPinHoldsACircleWhereItIsAndCuttingLetsItFall() {
        long ball = world().add(80, 50, 2, 4);
        long other = world().add(100, 50, 2, 4);
        Tool pin = new PinTool();
        pin.press(sandbox, 80.5f, 50, 1);
        pin.press(sandbox, 100, 50, 1);
        pin.press(sandbox, 20, 50, 1); // where nothing is
        run(pin, 60);
        assertThat(world().y(ball)).isCloseTo(50, within(0.05f));
        Tool cut = new CutTool();
        cut.press(sandbox, 60, 50, 1);
        cut.drag(sandbox, 90, 50);
        assertThat(world().joints().size()).isEqualTo(1);
        run(cut, 30);
        assertThat(world().y(ball)).isLessThan(45);
        assertThat(world().y(other)).isCloseTo(50, within(0.05f));
    }

    private void readBodies() {
        sandbox.bodies().read(world(), sandbox.loop(), new Shades(), PaintMode.PLAIN);
    }

    @Test
    void aShapeThatIsDrawnAroundFallsAsABodyAndAClickGivesACrate() {
        Tool tool = new BodyTool();
        tool.press(sandbox, 60, 50, 1);
        for (int k = 1; k <= 40; k++) { // a circle, nearly
            double angle = k * 2 * Math.PI / 41;
            tool.drag(sandbox, (float) (50 + 10 * Math.cos(angle)), (float) (50 + 10 * Math.sin(angle)));
        }
        List<Mark> marks = new ArrayList<>();
        tool.mark(sandbox, marks);
        assertThat(marks).hasSize(40);
        tool.release(sandbox);
        long disc = world().bodies().handle(0);
        assertThat(world().bodies().x(disc)).isCloseTo(50, within(0.3f));
        assertThat(world().bodies().outline(disc).area()).isBetween(290f, 314f);
        tool.press(sandbox, 100, 20, 2);
        tool.release(sandbox);
        assertThat(world().bodies().size()).isEqualTo(2);
        run(tool, 200);
        assertThat(world().bodies().y(disc)).as("it lies").isBetween(9f, 11f);
    }

    @Test
    void aLineThatEnclosesNothingIsNoBodyAndTheReasonIsSaid() {
        Tool tool = new BodyTool();
        tool.press(sandbox, 20, 50, 1);
        for (int k = 1; k <= 30; k++) {
            tool.drag(sandbox, 20 + k, 50);
        }
        tool.release(sandbox);
        assertThat(world().bodies().size()).isZero();
        assertThat(sandbox.takeNews()).startsWith("no body: ");
        assertThat(sandbox.takeNews()).isEmpty();
    }

    @Test
    void aBodyIsGrabbedThrownAndErased() {
        Outline crate = Outline.box(8, 8);
        long body = world().bodies().add(crate, 80, 4, 0, crate.area());
        readBodies();
        assertThat(sandbox.bodyAt(83, 7)).isEqualTo(body);
        assertThat(sandbox.bodyAt(85, 7)).isZero();
        Tool grab = new GrabTool();
        grab.press(sandbox, 83, 7, 1);
        grab.drag(sandbox, 40, 60);
        run(grab, 200);
        assertThat(world().bodies().x(body)).as("hangs below the mouse").isBetween(35f, 45f);
        assertThat(world().bodies().y(body)).isBetween(50f, 60f);
        grab.release(sandbox);
        run(grab, 200);
        assertThat(world().bodies().y(body)).isBetween(3.9f, 6f);
        readBodies();
        Tool eraser = new EraseTool();
        eraser.press(sandbox, world().bodies().x(body), world().bodies().y(body), 1);
        assertThat(world().bodies().contains(body)).isFalse();
    }

    @Test
    void theEraserRemovesAllThatItsWayTouchesAndNothingElse() {
        world().terrain().addSegment(60, 45, 60, 55);
        long kept = world().terrain().addSegment(60, 60, 60, 70);
        for (int k = 0; k < 40; k++) {
            world().add(10 + 3 * k, 50, 1, k % 2 == 0 ? 1 : Float.POSITIVE_INFINITY);
            world().add(10 + 3 * k, 80, 1, 1);
        }
        Tool erase = new EraseTool();
        erase.press(sandbox, 40, 50, 1);
        erase.drag(sandbox, 100, 50);
        assertThat(world().queries().overlapBox(40, 49, 100, 51, new long[0])).isZero();
        assertThat(world().queries().overlapBox(0, 79, 160, 81, new long[0])).isEqualTo(40);
        assertThat(world().size()).isBetween(50, 62);
        assertThat(world().terrain().size()).isEqualTo(1);
        assertThat(world().terrain().contains(kept)).isTrue();
    }
}
