package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The shots that every player knows, in a game that somebody writes from the Javadoc. */
class BilliardsTest {
    private static final float R = BilliardsGame.RADIUS;
    private static final float E = BilliardsGame.RESTITUTION;

    private final BilliardsGame game = new BilliardsGame(Backend.JVM);
    private final World world = game.world;
    private long object;

    @AfterEach
    void close() {
        game.close();
    }

    /** A straight shot at a ball that lies right in front of the cue ball, up to a step after they have met. */
    private void shoot(float speed, float roll, float english) {
        object = game.ball(world.x(game.cue) + 2.5f * R, world.y(game.cue));
        game.strike(speed, 0, roll, 0, english);
        for (int k = 0; k < 60 && world.vx(object) == 0; k++) {
            game.step();
        }
        assertThat(world.vx(object)).isGreaterThan(0);
    }

    private void steps(int count) {
        for (int k = 0; k < count; k++) {
            game.step();
        }
    }

    @Test
    void aStunShotGivesTheSpeedAwayAndTheCueBallStaysThere() {
        shoot(2, 0, 0);
        assertThat(world.vx(object)).isCloseTo((1 + E) * 2 / 2, within(0.05f));
        float at = world.x(game.cue);
        steps(120);
        assertThat(world.x(game.cue)).isCloseTo(at, within(0.05f));
        assertThat(world.vy(game.cue)).isZero();
    }

    @Test
    void aFollowShotGoesOnBehindTheObjectBall() {
        shoot(2, 2, 0);
        float at = world.x(game.cue);
        float v = world.vx(game.cue);
        assertThat(v).isCloseTo((1 - E) * 2 / 2, within(0.03f));
        steps(96); // until it rolls: the slip of 1.9 ends after 1.9 / 3.5 / (mu g) = 0.277 s
        assertThat(world.vx(game.cue)).isCloseTo((5 * v + 2 * 2) / 7, within(0.04f));
        steps(60);
        assertThat(world.x(game.cue)).isGreaterThan(at + 0.25f);
        assertThat(world.vy(game.cue)).isZero();
    }

    @Test
    void aDrawShotComesBack() {
        shoot(2, -2.5f, 0);
        float at = world.x(game.cue);
        float v = world.vx(game.cue);
        steps(110);
        assertThat(world.vx(game.cue)).isNegative().isCloseTo((5 * v - 2 * 2.5f) / 7, within(0.1f));
        steps(60);
        assertThat(world.x(game.cue)).isLessThan(at - 0.2f);
        assertThat(world.x(object)).isGreaterThan(at + 0.5f);
    }

    /** The surfaces slip, so the object ball gets friction times the impulse of the bounce, sideways. */
    @Test
    void muchEnglishThrowsTheObjectBallByTheFrictionOfBalls() {
        shoot(2, 0, 100);
        float thrown = world.vy(object) / world.vx(object);
        assertThat(thrown).isCloseTo(BilliardsGame.BALL_FRICTION, within(0.002f));
        assertThat(world.vy(game.cue)).isCloseTo(-world.vy(object), within(1e-4f));
        assertThat(world.angularVelocity(object) * R)
                .as("the object ball turns the other way, by twice what it moves")
                .isCloseTo(-2 * world.vy(object), within(0.005f));
    }

    /** The surfaces grip, so the object ball gets a sixth of the speed of the surface, however fast the shot is. */
    @Test
    void aLittleEnglishThrowsItLess() {
        shoot(2, 0, 10);
        assertThat(world.vy(object)).isCloseTo(10 * R / 6, within(0.02f * 10 * R / 6));
    }

    @Test
    void withoutEnglishABallComesStraightBackFromACushion() {
        game.strike(3, 0, 3, 0, 0);
        steps(240);
        assertThat(world.vx(game.cue)).isNegative();
        assertThat(world.vy(game.cue)).isZero();
        assertThat(world.angularVelocity(game.cue)).isZero();
    }

    @Test
    void aCushionTurnsEnglishIntoAngle() {
        world.setPosition(game.cue, BilliardsGame.LENGTH - 1.5f * R, BilliardsGame.WIDTH / 2);
        world.step(BilliardsGame.STEP);
        game.strike(2, 0, 0, 0, 30);
        for (int k = 0; k < 20 && world.vx(game.cue) > 0; k++) {
            game.step();
        }
        float surface = 30 * R;
        assertThat(world.vx(game.cue)).isCloseTo(-2 * E, within(0.05f));
        assertThat(world.vy(game.cue)).isCloseTo(-surface / 3, within(0.03f * surface / 3));
        assertThat(world.angularVelocity(game.cue) * R).isCloseTo(surface / 3, within(0.03f * surface / 3));
    }

    /** Much english, so that the cushion slips: friction times the impulse of the bounce. */
    @Test
    void aCushionGivesNoMoreThanItsFriction() {
        world.setPosition(game.cue, BilliardsGame.LENGTH - 1.5f * R, BilliardsGame.WIDTH / 2);
        world.step(BilliardsGame.STEP);
        game.strike(2, 0, 0, 0, -200);
        for (int k = 0; k < 20 && world.vx(game.cue) > 0; k++) {
            game.step();
        }
        float most = BilliardsGame.CUSHION_FRICTION * (1 + E) * 2;
        assertThat(world.vy(game.cue)).isCloseTo(most, within(0.03f * most));
    }

    @Test
    void aRollingBallStopsByTheClothAlone() {
        game.strike(0.5f, 0, 0.5f, 0, 0);
        float from = world.x(game.cue);
        game.stepsToRest();
        float way = 0.5f * 0.5f / (2 * BilliardsGame.ROLLING * BilliardsGame.GRAVITY);
        assertThat(world.x(game.cue) - from).isCloseTo(way, within(0.01f * way));
    }

    @Test
    void aBreakLosesEnergyInEachStepAndEndsWithAllBallsOnTheTable() {
        game.rack();
        game.strike(7, 0.05f, 0, 0, 20);
        game.step();
        double energy = game.energy();
        int steps = 0;
        for (double next; energy > 1e-6; energy = next) {
            game.step();
            next = game.energy();
            assertThat(next).as("step %d", steps).isLessThanOrEqualTo(energy * (1 + 1e-4));
            assertThat(steps++).isLessThan(240 * 60);
        }
        int moved = 0;
        for (int id = 0; id < world.idLimit(); id++) {
            long ball = world.handle(id);
            assertThat(world.x(ball)).isBetween(0.99f * R, BilliardsGame.LENGTH - 0.99f * R);
            assertThat(world.y(ball)).isBetween(0.99f * R, BilliardsGame.WIDTH - 0.99f * R);
            moved += Math.abs(world.x(ball) - 1.85f) > 0.2f || Math.abs(world.y(ball) - BilliardsGame.WIDTH / 2) > 0.2f
                    ? 1
                    : 0;
        }
        assertThat(moved).as("the rack is open").isGreaterThan(10);
    }
}
