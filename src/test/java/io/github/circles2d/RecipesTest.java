package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The recipes of the guide do what they say. Their code stands here and in the guide, word for word. */
class RecipesTest {
    private static final float STEP = 1 / 60f;

    private World world;
    private long player;
    private float stickX;
    private float stickY;
    private final TreeMap<Integer, float[]> drawn = new TreeMap<>();

    private float stickX() {
        return stickX;
    }

    private float stickY() {
        return stickY;
    }

    private void draw(float x, float y) {
        drawn.put(drawn.size(), new float[] {x, y});
    }

    private World.Builder builder() {
        return WorldScenes.jvm().bounds(0, 0, 100, 100).gravity(0, -20).restitution(0);
    }

    private void open(World.Builder builder, float x, float y) {
        world = builder.build();
        player = world.add(x, y, 1, 2);
    }

    @AfterEach
    void close() {
        if (world != null) {
            world.close();
        }
    }

    /** Paragraphs of the code of the chapter, without regard to how lines are broken. */
    @Test
    void theGuideHasTheCodeThatIsTestedHere() throws IOException {
        String guide = Files.readString(Path.of("docs/guide.md"));
        String chapter = guide.substring(guide.indexOf("\n## Recipes\n"), guide.indexOf("\n## Save\n"));
        String here = plain(Files.readString(Path.of("src/test/java/io/github/circles2d/RecipesTest.java")));
        List<String> blocks = Pattern.compile("(?s)```java\n(.*?)```")
                .matcher(chapter)
                .results()
                .map(block -> block.group(1))
                .toList();
        assertThat(blocks).hasSize(11);
        for (String block : blocks) {
            for (String paragraph : block.split("\n\n")) {
                assertThat(here).contains(plain(paragraph));
            }
        }
    }

    private static String plain(String code) {
        return code.replaceAll("\\s+", "");
    }

    // ---- on the ground
    // -----------------------------------------------------------------------------------------------

    /** Makes steps, in each of which the player jumps if it can and the stick is up. Returns in how many steps it was on the ground. */
    private int walk(int steps) {
        int grounded = 0;
        long[] partners = new long[8];
        float[] contacts = new float[8 * World.CONTACT_STRIDE];
        int coyote = 0; // steps in which a jump still works, also just beyond an edge
        for (int step = 0; step < steps; step++) {
            // in each step
            coyote--;
            int touching = Math.min(8, world.contactsOf(player, partners, contacts));
            for (int k = 0; k < touching; k++) {
                if (contacts[World.CONTACT_STRIDE * k + World.NORMAL_Y]
                        > 0.7f) { // terrain, a circle or a wall, up to 45 degrees steep
                    coyote = 6;
                }
            }
            if (stickY() > 0 && coyote > 0) {
                world.setVelocity(player, world.vx(player), 12);
                coyote = 0;
            }
            grounded += coyote == 6 ? 1 : 0;
            world.step(STEP);
        }
        return grounded;
    }

    @ParameterizedTest
    @ValueSource(strings = {"segment", "chain", "circle", "wall", "one-way", "slope"})
    void whoStandsOnSomethingIsOnTheGround(String what) {
        open(builder().friction(1), 50, what.equals("wall") ? 1 : 11.01f);
        world.kind(8).setOneWay(true);
        world.joints().add(player, Joint.motor(0, 1000)); // stands on a slope
        switch (what) {
            case "segment" -> world.terrain().addSegment(40, 10, 60, 10);
            case "chain" -> world.terrain().addChain(Chain.of(60, 10, 40, 10));
            case "circle" -> world.add(50, 7, 3, Float.POSITIVE_INFINITY);
            case "one-way" -> world.terrain().addSegment(60, 10, 40, 10, 0, 8);
            case "slope" -> world.terrain().addSegment(40, 5, 60, 15);
            default -> {}
        }
        walk(30);
        assertThat(walk(30)).isGreaterThanOrEqualTo(28);
        assertThat(world.y(player)).isCloseTo(what.equals("wall") ? 1 : 11, within(0.5f));
    }

    @Test
    void whoFallsOrLeansOnAWallOrPassesAOneWayPieceIsNotOnTheGround() {
        open(builder(), 1, 90);
        assertThat(walk(60)).as("falls").isZero();
        world.setForce(player, -50, 0);
        assertThat(walk(20)).as("is pressed to the left wall").isZero();
        world.terrain().addSegment(0, 2, 4, 8); // 56 degrees
        world.setForce(player, 0, 0);
        world.kind(8).setOneWay(true);
        world.terrain().addSegment(60, 10, 40, 10, 0, 8);
        world.setPosition(player, 50, 5);
        world.setVelocity(player, 0, 18);
        assertThat(walk(30)).as("rises through the platform").isZero();
        walk(60);
        assertThat(walk(20)).as("stands on it").isGreaterThan(18);
        world.terrain().clear();
        world.terrain().addSegment(80, 40, 90, 60, 0.1f, 0);
        world.setPosition(player, 84, 60);
        assertThat(walk(60)).as("slides down a steep slope").isZero();
    }

    @Test
    void aJumpWorksJustBeyondAnEdgeButNotInTheAir() {
        open(builder(), 50, 11);
        world.terrain().addSegment(40, 10, 60, 10);
        walk(10);
        world.setVelocity(player, 12, 0);
        while (world.x(player) < 60.2f) {
            walk(1);
        }
        stickY = 1;
        walk(3);
        assertThat(world.vy(player)).as("three steps beyond the edge").isLessThan(0); // walk begins without coyote time
        world.setPosition(player, 50, 11.001f);
        world.setVelocity(player, 0, 0);
        stickY = 0;
        walk(5);
        stickY = 1;
        assertThat(walk(1)).isZero();
        assertThat(world.vy(player)).isGreaterThan(11);
        walk(20);
        assertThat(world.vy(player)).as("no second jump in the air").isLessThan(8);
    }

    // ---- a loop
    // ------------------------------------------------------------------------------------------------------

    @Test
    void aBallGoesRoundALoopAndLeavesIt() {
        open(builder(), 90, 90);
        float pi = (float) Math.PI;
        int entering = 11, leaving = 12, right = 13, left = 14; // kinds: of the ball, and of the halves of the loop
        world.setResponse(entering, left, Response.IGNORE);
        world.setResponse(leaving, right, Response.IGNORE);
        Terrain terrain = world.terrain();
        terrain.addChain(Chain.of(100, 0, 0, 0));
        terrain.addArc(50, 8, 8, -pi / 2, 0.7f * pi, ArcSide.INNER, right); // the halves overlap at the top
        terrain.addArc(50, 8, 8, 0.3f * pi, 1.5f * pi, ArcSide.INNER, left);
        long ball = world.add(20, 1, 1, 1, 40, 0, entering);
        float highest = 0;
        for (int step = 0; step < 240 && world.x(ball) < 80; step++) {
            chooseHalf(ball, entering, leaving);
            world.step(STEP);
            highest = Math.max(highest, world.y(ball));
        }
        assertThat(highest).isCloseTo(15, within(0.1f));
        assertThat(world.kindOf(ball)).isEqualTo(leaving);
        assertThat(world.x(ball)).isGreaterThanOrEqualTo(80);
        assertThat(world.vx(ball)).as("as fast as before").isCloseTo(40, within(1f));
    }

    @Test
    void soItDoesOnItsWayBackAndAfterAHill() {
        open(builder(), 90, 90);
        float pi = (float) Math.PI;
        int entering = 11, leaving = 12, right = 13, left = 14;
        world.setResponse(entering, left, Response.IGNORE);
        world.setResponse(leaving, right, Response.IGNORE);
        Terrain terrain = world.terrain();
        terrain.addChain(Chain.of(70, 0, 30, 0));
        terrain.addArc(30, 30, 30, pi, 1.5f * pi, ArcSide.INNER, 0); // a hill at each side
        terrain.addArc(70, 30, 30, -pi / 2, 0, ArcSide.INNER, 0);
        terrain.addArc(50, 8, 8, -pi / 2, 0.7f * pi, ArcSide.INNER, right);
        terrain.addArc(50, 8, 8, 0.3f * pi, 1.5f * pi, ArcSide.INNER, left);
        long ball = world.add(1.1f, 29, 1, 1, 0, 0, entering);
        int rounds = 0;
        boolean above = false;
        for (int step = 0; step < 900; step++) {
            chooseHalf(ball, entering, leaving);
            world.step(STEP);
            boolean isAbove = world.y(ball) > 14 && Math.abs(world.x(ball) - 50) < 4;
            rounds += isAbove && !above ? 1 : 0;
            above = isAbove;
        }
        assertThat(rounds).isGreaterThanOrEqualTo(2);
    }

    private void chooseHalf(long ball, int entering, int leaving) {
        // in each step
        float dx = world.x(ball) - 50, dy = world.y(ball) - 8; // from the middle of the loop
        int kind = world.kindOf(ball);
        if (dy > 0 && dx * dx + dy * dy < 8 * 8) {
            kind = dx < 0 ? leaving : entering; // over the top, to either side
        } else if (Math.abs(dx) > 8) {
            kind = dx < 0 ? entering : leaving; // beside the loop: it may come again, from either side
        }
        if (kind != world.kindOf(ball)) {
            world.setKind(ball, kind);
        }
    }

    // ---- soft ground
    // -------------------------------------------------------------------------------------------------

    @Test
    void theGroundDecidesHowHighABallBounces() {
        open(builder(), 10, 90);
        int ball = 15, grass = 16, rubber = 17;
        world.kind(ball).setRestitution(0); // the greater restitution of the two counts, so the ground decides
        world.kind(grass).setRestitution(0.2f);
        world.kind(rubber).setRestitution(0.9f);
        world.terrain().addSegment(0, 10, 50, 10, 0, grass);
        world.terrain().addSegment(50, 10, 100, 10, 0, rubber);
        long onGrass = world.add(20, 31, 1, 1, 0, 0, ball);
        long onRubber = world.add(80, 31, 1, 1, 0, 0, ball);
        float grassHeight = 0;
        float rubberHeight = 0;
        for (int step = 0; step < 180; step++) {
            world.step(STEP);
            grassHeight = step > 87 ? Math.max(grassHeight, world.y(onGrass) - 11) : 0;
            rubberHeight = step > 87 ? Math.max(rubberHeight, world.y(onRubber) - 11) : 0;
        }
        assertThat(grassHeight).isCloseTo(0.04f * 20, within(0.2f));
        assertThat(rubberHeight).isCloseTo(0.81f * 20, within(0.8f));
    }

    // ---- a lift
    // ------------------------------------------------------------------------------------------------------

    @Test
    void aBallStandsOnALiftThatGoesToAndFroAndWalksOnIt() {
        open(builder().friction(0.9f), 50, 11);
        TerrainBody lift = world.terrain().addBody(50, 10, 0);
        lift.addSegment(-9, 0, 9, 0);
        long legs = world.joints().add(player, Joint.motor(0, 100 * world.mass(player)));
        float most = 0;
        float greatest = 0;
        for (int step = 0; step < 600; step++) {
            // in each step
            world.joints().setSpeed(legs, -8 * stickX()); // at 0 it is a brake, so the lift takes the ball along
            lift.moveTo(60 - 10 * (float) Math.cos(step * STEP), 10, 0);
            world.step(STEP);
            most = Math.max(most, Math.abs(world.x(player) - lift.x()));
            greatest = Math.max(greatest, Math.abs(lift.vxAt(lift.x(), lift.y())));
        }
        assertThat(greatest).isCloseTo(10, within(0.1f));
        assertThat(most).as("it stays where it stood").isLessThan(0.5f);
        world.step(STEP, 60); // the lift stands, and so does the ball
        float before = world.x(player);
        stickX = 1;
        for (int step = 0; step < 30; step++) {
            world.joints().setSpeed(legs, -8 * stickX());
            world.step(STEP);
        }
        assertThat(world.x(player) - before).as("it walks to the right").isBetween(1.8f, 4.1f);
    }

    // ---- swallowing
    // --------------------------------------------------------------------------------------------------

    @Test
    void whoseCentreIsInsideIsSwallowed() {
        open(builder().gravity(0, 0), 50, 50);
        world.setRadius(player, 5);
        world.setResponse(0, 0, Response.IGNORE);
        long inside = world.add(53, 50, 1, 1);
        long touching = world.add(55.5f, 50, 1, 1);
        long large = world.add(48, 50, 4.8f, 1);
        int swallowed = swallow(10);
        assertThat(swallowed).isEqualTo(1);
        assertThat(world.contains(inside)).isFalse();
        assertThat(world.contains(touching)).isTrue();
        assertThat(world.contains(large)).isTrue();
        assertThat(world.mass(player)).isEqualTo(3);
        assertThat(world.radius(player)).isCloseTo((float) Math.sqrt(26), within(1e-4f));
    }

    @Test
    void mealsAddUpAlsoWhileItGrows() {
        open(builder().gravity(0, 0), 50, 50);
        world.setRadius(player, 4);
        world.setResponse(0, 0, Response.IGNORE);
        for (int k = 0; k < 4; k++) {
            world.add(56 + 2.5f * k, 50, 2, 1, -20, 0);
        }
        assertThat(swallow(60)).isEqualTo(4);
        assertThat(world.radius(player)).isCloseTo((float) Math.sqrt(32), within(1e-4f));
    }

    private int swallow(int steps) {
        int before = world.size();
        Queries others = world.queries().without(player); // keep it
        long[] near = new long[64];
        float size = world.radius(player); // to which it grows: keep it, too

        for (int step = 0; step < steps; step++) {
            // in each step
            float reach = world.radius(player);
            int count = Math.min(near.length, others.overlapCircle(world.x(player), world.y(player), reach, near));
            for (int k = 0; k < count; k++) {
                float dx = world.x(near[k]) - world.x(player);
                float dy = world.y(near[k]) - world.y(player);
                float r = world.radius(near[k]);
                if (dx * dx + dy * dy < reach * reach && r < 0.9f * reach) { // its centre is inside, and it is smaller
                    world.setMass(player, world.mass(player) + world.mass(near[k]));
                    world.remove(near[k]);
                    size = (float) Math.sqrt(size * size + r * r); // areas add up
                    world.grow(player, size, 10);
                }
            }
            world.step(STEP);
        }
        return before - world.size();
    }

    // ---- owners
    // ------------------------------------------------------------------------------------------------------

    @Test
    void shotsPassTheirOwnerAndHitAllOthersOfHundreds() {
        world = builder().gravity(0, 0).build();
        long[] owners = new long[300];
        for (int k = 0; k < owners.length; k++) {
            owners[k] = world.add(5 + 6 * (k % 15), 3 + 4.5f * (k / 15), 1, 1);
        }
        for (long owner : owners) {
            player = owner;
            int bullet = 22;
            world.setGroup(player, 1 + World.id(player)); // a group for each owner, as there are but 256 kinds
            long shot = world.add(world.x(player), world.y(player), 0.2f, 0.1f, 60, 0, bullet);
            world.setGroup(shot, world.group(player)); // it passes its owner, and the owner's other shots
            world.setTag(shot, player); // whose points these are
        }
        world.report(22, 0, Events.BEGIN);
        int[] points = new int[owners.length];
        for (int step = 0; step < 20; step++) {
            world.step(STEP);
            Events events = world.events();
            for (int i = 0; i < events.size(); i++) {
                long shot = world.kindOf(events.a(i)) == 22 ? events.a(i) : events.b(i);
                long hit = events.other(i, shot);
                assertThat(world.tag(shot)).isNotEqualTo(hit);
                points[World.id(world.tag(shot))]++;
            }
        }
        for (int k = 0; k < owners.length; k++) {
            assertThat(points[k]).as("owner %d", k).isEqualTo(k % 15 == 14 ? 0 : 1);
        }
    }

    // ---- the seam
    // ----------------------------------------------------------------------------------------------------

    @Test
    void whatIsNearTheSeamIsDrawnBesideTheCamera() {
        open(builder().gravity(0, 0).edges(Edge.WRAP, Edge.WRAP), 98, 2);
        world.add(3, 97, 1, 1);
        world.add(90, 50, 1, 1);
        drawAll();
        assertThat(drawn.get(0)).containsExactly(98, 2);
        assertThat(drawn.get(1)).containsExactly(103, -3);
        assertThat(drawn.get(2)).containsExactly(90, 50);
        assertThat(world.shortestX(3, 98)).isEqualTo(-5);
        assertThat(world.shortestX(-1, 101)).isEqualTo(2);
    }

    private void drawAll() {
        float cameraX = world.x(player), cameraY = world.y(player);
        FloatBuffer at = world.positionsById(null);
        for (int id = 0; id < world.idLimit(); id++) {
            if (world.handle(id) != 0) {
                draw(
                        cameraX + world.shortestX(cameraX, at.get(2 * id)),
                        cameraY + world.shortestY(cameraY, at.get(2 * id + 1)));
            }
        }
    }

    // ---- filling
    // -----------------------------------------------------------------------------------------------------

    @Test
    void groundIsFilledWithinATolerance() {
        open(builder(), 30, 22);
        Chain island = Chain.from(20, 10)
                .lineTo(40, 10)
                .lineTo(40, 14)
                .arcTo(30, 14, (float) Math.PI)
                .close();
        world.terrain().addChain(island);
        float[] points = island.points(0.05f); // x and y; lines are at most 0.05 from an arc
        var shape = new java.awt.geom.Path2D.Float();
        shape.moveTo(points[0], points[1]);
        for (int k = 2; k < points.length; k += 2) {
            shape.lineTo(points[k], points[k + 1]);
        }
        shape.closePath(); // to be filled

        assertThat(points.length / 2).isBetween(16, 40);
        assertThat(shape.contains(30, 23.9)).isTrue();
        assertThat(shape.contains(30, 24.1)).isFalse();
        for (int k = 0; k < 180; k++) {
            double angle = Math.toRadians(k + 0.5);
            assertThat(shape.contains(30 + 9.94 * Math.cos(angle), 14 + 9.94 * Math.sin(angle)))
                    .isTrue();
        }
        world.terrain().clear();
        world.terrain().addChain(island.reversed()); // a cave of the same outline: circles are inside
        long inside = world.add(30, 14, 1, 1);
        for (int step = 0; step < 300; step++) {
            world.step(STEP);
        }
        assertThat(world.y(inside)).as("lies on the floor of the cave").isCloseTo(11, within(0.05f));
        assertThat(island.reversed().isClosed()).isTrue();
        assertThat(island.reversed().pieces()).isEqualTo(island.pieces());
    }

    // ---- planets
    // -----------------------------------------------------------------------------------------------------

    /** Returns by how much the radius of an orbit differs after some turns, as a share. */
    private float orbit(boolean byForce) {
        open(builder().gravity(0, 0).edges(Edge.OPEN, Edge.OPEN), 70, 50);
        world.setVelocity(player, 0, (float) Math.sqrt(8000 / 20f));
        float most = 0;
        for (int step = 0; step < 60 * 60 * 3; step++) {
            if (byForce) {
                float dx = 50 - world.x(player), dy = 50 - world.y(player);
                float d = (float) Math.sqrt(dx * dx + dy * dy);
                float pull = 8000 * world.mass(player) / (d * d);
                world.applyForce(player, pull * dx / d, pull * dy / d);
            } else {
                pull();
            }
            world.step(STEP);
            double r = Math.hypot(world.x(player) - 50, world.y(player) - 50);
            most = Math.max(most, (float) Math.abs(r / 20 - 1));
        }
        world.close();
        return most;
    }

    private void pull() {
        float dx = 50 - world.x(player), dy = 50 - world.y(player); // to the sun
        float d = (float) Math.sqrt(dx * dx + dy * dy);
        float impulse = 1 / 60f * 8000 * world.mass(player) / (d * d); // the length of the step times the force
        world.applyImpulse(player, impulse * dx / d, impulse * dy / d);
    }

    @Test
    void aPlanetThatImpulsesPullKeepsItsOrbitAndOneThatForcesPullDoesNot() {
        assertThat(orbit(false)).isLessThan(0.02f);
        assertThat(orbit(true)).isGreaterThan(0.1f);
    }

    // ---- frozen
    // ------------------------------------------------------------------------------------------------------

    @Test
    void aFrozenCircleStaysUntilItIsLetGo() {
        open(builder(), 50, 50);
        world.setVelocity(player, 3, 4);
        long other = world.add(50, 60, 1, 2);
        float mass = world.mass(player), vx = world.vx(player), vy = world.vy(player);
        world.setVelocity(player, 0, 0);
        world.setMass(player, Float.POSITIVE_INFINITY); // frozen: nothing moves it, and others bounce off it

        world.step(STEP, 120);
        assertThat(world.x(player)).isEqualTo(50);
        assertThat(world.y(player)).isEqualTo(50);
        assertThat(world.y(other)).isCloseTo(52, within(0.1f));
        world.setMass(player, mass); // let go
        world.setVelocity(player, vx, vy);

        world.step(STEP);
        assertThat(world.x(player)).isCloseTo(50.05f, within(0.01f));
        assertThat(world.mass(player)).isEqualTo(2);
    }

    // ---- fields
    // ------------------------------------------------------------------------------------------------------

    @Test
    void aSunPullsAndWaterCarriesAndSlows() {
        open(builder().gravity(0, -10), 20, 5);
        long light = world.add(60, 10, 1, 1);
        world.add(80, 80, 1, Float.POSITIVE_INFINITY);
        float[] circles = new float[4 * world.idLimit()], velocities = new float[2 * world.idLimit()];
        float[] impulses = new float[2 * world.idLimit()];
        long[] pushed = new long[world.idLimit()]; // longer ones once circles have come
        for (int step = 0; step < 600; step++) {
            // in each step
            world.readById(circles, null);
            world.readVelocitiesById(velocities, null);
            int n = 0;
            for (int id = 0; id < world.idLimit(); id++) {
                float mass = circles[4 * id + 3];
                if (mass < Float.POSITIVE_INFINITY) { // neither static nor NaN, as where there is no circle
                    float x = circles[4 * id], y = circles[4 * id + 1];
                    float dx = 50 - x, dy = 80 - y; // an attractor at (50, 80), by the inverse square
                    float square = dx * dx + dy * dy + 1; // the 1 keeps it finite
                    float pull = 900 / (square * (float) Math.sqrt(square));
                    float ax = pull * dx, ay = pull * dy;
                    if (y < 20) { // water up to 20: it carries what is light, and slows all
                        ay += 10 * Math.min(1, 20 - y) * 3.5f / mass;
                        ax -= 2 * (velocities[2 * id] - 1); // a current to the right
                        ay -= 2 * velocities[2 * id + 1];
                    }
                    pushed[n] = world.handle(id);
                    impulses[2 * n] = mass * ax / 60;
                    impulses[2 * n + 1] = mass * ay / 60; // times the length of the step
                    n++;
                }
            }
            world.applyImpulses(pushed, n, impulses, StaleHandles.REFUSE);
            world.step(STEP);
        }
        assertThat(world.y(light)).as("floats").isBetween(19f, 20.5f);
        assertThat(world.x(light)).as("the current has taken it along").isGreaterThan(64);
        assertThat(Math.abs(world.vy(light))).isLessThan(0.2f);
    }
}
