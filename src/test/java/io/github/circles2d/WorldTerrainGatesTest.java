package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** A piece with a front that only senses counts who comes from there, once, and nobody from behind. */
class WorldTerrainGatesTest {
    private static final float STEP = 1 / 60f;
    private static final int GATE = 5;
    private static final float PI = (float) Math.PI;

    /** Gates on the y axis, whose front is on the left. */
    private enum Form {
        LINE,
        ONE_WAY,
        OUTER,
        INNER;

        void addTo(TerrainBody body) {
            switch (this) {
                case LINE -> body.addChain(Chain.of(0, 3, 0, -3), GATE, null);
                case ONE_WAY -> body.addSegment(0, 3, 0, -3, 0, GATE);
                case OUTER -> body.addArc(10, 0, 10, PI - 0.3f, PI + 0.3f, ArcSide.OUTER, GATE);
                default -> body.addArc(-10, 0, 10, -0.3f, 0.3f, ArcSide.INNER, GATE);
            }
        }
    }

    private final Form[] forms = Form.values();

    private static World world() {
        World world = WorldScenes.jvm()
                .bounds(-100, -100, 100, 100)
                .edges(Edge.OPEN, Edge.OPEN)
                .build();
        world.kind(GATE).setSensor(true).setOneWay(true);
        world.report(Events.BEGIN | Events.END);
        return world;
    }

    private static World withGate(Form form) {
        World world = world();
        if (form == Form.LINE) {
            world.kind(GATE).setOneWay(false);
        }
        form.addTo(world.terrain().addBody(0, 0, 0));
        return world;
    }

    /** Counts the begins, after which there are as many ends. */
    private static int begins(World world) {
        int begins = 0;
        int ends = 0;
        Events events = world.events();
        for (int i = 0; i < events.size(); i++) {
            begins += events.type(i) == Events.BEGIN ? 1 : 0;
            ends += events.type(i) == Events.END ? 1 : 0;
        }
        assertThat(ends).isEqualTo(begins);
        return begins;
    }

    @ParameterizedTest
    @CsvSource({"0.5, 0.7", "0.5, 3", "0.1, 60", "0.5, 60", "0.02, 200", "0.5, 200", "0.5, 1000"})
    void passesFromTheFrontCountOnceAndFromBehindNever(float r, float speed) {
        for (Form form : forms) {
            for (int k = 0; k < 9; k++) {
                int steps = (int) (2 * (1.6f + r) / speed * 60) + 4;
                float from = 1.2f + r + 0.037f * k * Math.max(1, speed / 60);
                steps += (int) (from / speed * 60);
                assertThat(passes(form, r, -from, 0.1f * k, speed, steps))
                        .as("%s from the front, %d", form, k)
                        .isEqualTo(1);
                assertThat(passes(form, r, from, 0.1f * k, -speed, steps))
                        .as("%s from behind, %d", form, k)
                        .isZero();
            }
        }
    }

    private static int passes(Form form, float r, float x, float y, float vx, int steps) {
        try (World world = withGate(form)) {
            long ball = world.add(x, y, r, 1, vx, 0);
            world.step(STEP, steps);
            assertThat(world.x(ball) * x).as("it has passed").isNegative();
            return begins(world);
        }
    }

    /** Who turns round on the line has come from where it came from. */
    @ParameterizedTest
    @EnumSource(Form.class)
    void whoCreepsOnTheLineAndTurnsRoundIsCountedByWhereItCameFrom(Form form) {
        for (int k = 0; k < 11; k++) {
            float turn = -0.45f + 0.09f * k; // where its centre turns round
            for (int side = -1; side <= 1; side += 2) {
                try (World world = withGate(form)) {
                    long ball = world.add(side * 0.7f, 0, 0.5f, 1, 0, 0);
                    for (int pass = 0; pass < 6; pass++) {
                        boolean out = pass % 2 == 0;
                        float to = out ? turn : side * (pass < 5 ? 0.49f : 0.8f); // touches it all the time
                        world.setVelocity(ball, (to - world.x(ball)) / 2, 0);
                        world.step(STEP, 120);
                        world.setVelocity(ball, 0, 0);
                        world.step(STEP, 5);
                    }
                    assertThat(begins(world))
                            .as("side %d, turns round at %s", side, turn)
                            .isEqualTo(side < 0 ? 1 : 0);
                    world.setVelocity(ball, -side * 3, 0);
                    world.step(STEP, 60);
                    assertThat(begins(world)).as("goes through").isEqualTo(side < 0 ? 1 : 0);
                }
            }
        }
    }

    /** A gate comes to a circle that lies there. */
    @ParameterizedTest
    @CsvSource({"1", "30", "300"})
    void gatesThatMoveCountToo(float speed) {
        for (Form form : forms) {
            for (int side = -1; side <= 1; side += 2) {
                try (World world = withGate(form)) {
                    TerrainBody gate = world.terrain().bodyOf(world.terrain().handle(0));
                    world.add(side * 2, 0.3f, 0.5f, 1, 0, 0);
                    gate.setVelocity(side * speed, 0);
                    world.step(STEP, (int) (4 / speed * 60) + 3);
                    assertThat(begins(world)).as(form + " side " + side).isEqualTo(side < 0 ? 1 : 0);
                }
            }
        }
    }

    /** A door turns over a circle, and back. */
    @ParameterizedTest
    @CsvSource({"0.5", "5", "60"})
    void gatesThatTurnCountToo(float omega) {
        try (World world = world()) {
            TerrainBody door = world.terrain().addBody(0, 0, 0);
            door.addSegment(0, 0, 0, 5, 0, GATE); // its right, and front, is at x > 0
            world.add(1, 3, 0.5f, 1, 0, 0);
            int steps = (int) (1.2 / omega * 60) + 1;
            for (int k = 0; k < 3; k++) {
                door.setAngularVelocity(-omega);
                world.step(STEP, steps);
                assertThat(begins(world)).as("over it, %d", k).isEqualTo(1);
                door.setAngularVelocity(omega);
                world.step(STEP, steps);
                assertThat(begins(world)).as("back, %d", k).isZero();
            }
        }
    }

    /** Who flies through a ring in a step comes to its inner side from within, and to its outer side from without. */
    @ParameterizedTest
    @CsvSource({"3", "60", "400", "1500"})
    void aRingCountsWhoGoesThroughIt(float speed) {
        for (ArcSide side : ArcSide.values()) {
            try (World world = world()) {
                world.terrain().addArc(0, 0, 3, 0, 2 * PI, side, GATE);
                world.add(-4, 0.3f, 0.5f, 1, speed, 0);
                world.step(STEP, (int) (8.5 / speed * 60) + 3);
                assertThat(begins(world)).as(side.name()).isEqualTo(1);
            }
        }
    }

    /** A change of what a circle is finds it on its way, too. */
    @Test
    void whoGetsAnotherMassOnTheLineIsNotCountedFromBehind() {
        for (float x : new float[] {-0.3f, -0.1f, 0.2f}) {
            try (World world = withGate(Form.LINE)) {
                long ball = world.add(1, 0, 0.5f, 1, -3, 0);
                while (world.x(ball) > x) {
                    world.step(STEP);
                }
                world.setMass(ball, 2);
                world.step(STEP, 60);
                assertThat(begins(world)).isZero();
            }
        }
    }

    /** At the corner of a closed chain who comes from outside is noticed by one of two sides at least, and from within by none. */
    @Test
    void aClosedChainNoticesFromOutsideAlone() {
        for (int k = 0; k < 60; k++) {
            double a = 2 * Math.PI * (k + 0.5) / 60;
            float x = (float) Math.cos(a);
            float y = (float) Math.sin(a);
            for (int way : List.of(1, -1)) {
                try (World world = world()) {
                    world.kind(GATE).setOneWay(false);
                    world.terrain()
                            .addChain(Chain.of(-2, -2, 2, -2, 2, 2, -2, 2).close(), GATE, null);
                    float far = way > 0 ? 0 : 4;
                    long ball = world.add(far * x, far * y, 0.4f, 1, way * 5 * x, way * 5 * y);
                    world.step(STEP, 48);
                    assertThat(Math.hypot(world.x(ball), world.y(ball))).isGreaterThan(way > 0 ? 3.9 : -1);
                    int begins = begins(world);
                    if (way > 0) {
                        assertThat(begins).as("from within, %d", k).isZero();
                    } else {
                        assertThat(begins).as("from outside, %d", k).isBetween(1, 2);
                    }
                }
            }
        }
    }
}
