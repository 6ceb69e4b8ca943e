package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

/** The calls of terrain: what they keep, and what they refuse. */
class WorldTerrainTest {
    private static final float PI = (float) Math.PI;

    private static World world() {
        return WorldScenes.jvm().bounds(0, 0, 100, 100).build();
    }

    @Test
    void piecesHaveHandlesKindsAndBodies() {
        try (World world = world()) {
            Terrain terrain = world.terrain();
            long a = terrain.addSegment(0, 0, 10, 0);
            TerrainBody lift = terrain.addBody(50, 50, 0);
            long b = lift.addArc(0, 0, 5, 0, PI, ArcSide.INNER, 7);
            assertThat(terrain.size()).isEqualTo(2);
            assertThat(terrain.idLimit()).isEqualTo(2);
            assertThat(terrain.handle(1)).isEqualTo(b);
            assertThat(terrain.kindOf(b)).isEqualTo(7);
            assertThat(terrain.bodyOf(a)).isSameAs(terrain.ground());
            assertThat(terrain.bodyOf(b)).isSameAs(lift).isSameAs(terrain.body(lift.handle()));
            terrain.remove(a);
            assertThat(terrain.contains(a)).isFalse();
            assertThat(terrain.handle(0)).isZero();
            long c = terrain.addSegment(0, 0, 10, 0);
            assertThat(Terrain.id(c)).isEqualTo(Terrain.id(a));
            assertThat(c).isNotEqualTo(a);
            lift.remove();
            assertThat(lift.exists()).isFalse();
            assertThat(terrain.contains(b)).isFalse();
            terrain.clear();
            assertThat(terrain.size()).isZero();
        }
    }

    @Test
    void noCallTakesTheHandleOfSomethingElse() {
        try (World world = world()) {
            Terrain terrain = world.terrain();
            long circle = world.add(20, 20, 1, 1);
            world.add(30, 20, 1, 1); // the ids of the piece and the body are those of circles
            long piece = terrain.addSegment(0, 0, 10, 0);
            long body = terrain.addBody(50, 50, 0).handle();
            long joint = world.joints().add(circle, Joint.friction(1, 1));
            refused(() -> world.remove(piece), "no circle has the handle " + piece + ": it is of a piece of terrain");
            refused(() -> world.x(body), "no circle has the handle " + body + ": it is of a body of terrain");
            String ofCircle = ": it is of a circle, or of nothing";
            refused(() -> terrain.remove(circle), "no piece of terrain has the handle " + circle + ofCircle);
            refused(
                    () -> terrain.remove(body),
                    "no piece of terrain has the handle " + body + ": it is of a body of terrain");
            refused(() -> terrain.kindOf(joint), "no piece of terrain has the handle " + joint + ": it is of a joint");
            refused(() -> terrain.body(circle), "no body of terrain has the handle " + circle + ofCircle);
            refused(
                    () -> terrain.body(piece),
                    "no body of terrain has the handle " + piece + ": it is of a piece of terrain");
            assertThat(world.contains(piece) || world.contains(body)).isFalse();
            assertThat(terrain.contains(circle) || terrain.contains(joint)).isFalse();
            assertThat(world.size()).isEqualTo(2);
            assertThat(terrain.size()).isOne();
        }
    }

    private static void refused(ThrowingCallable call, String message) {
        assertThatIllegalArgumentException().isThrownBy(call).withMessage(message);
    }

    @Test
    void theColumnsOfPiecesHaveNames() {
        try (World world = world()) {
            Terrain terrain = world.terrain();
            world.kind(7);
            terrain.addSegment(1, 2, 3, 5, 0.5f, 7);
            terrain.addChain(Chain.from(20, 10).lineTo(12, 10).lineTo(12, 20));
            terrain.addArc(40, 30, 6, 1, 2.5f, ArcSide.INNER, 7);
            terrain.addArc(60, 30, 5, -1, 1, ArcSide.OUTER);
            float[] pieces = new float[5 * Terrain.PIECE_STRIDE];
            assertThat(terrain.readPieces(pieces, null)).isEqualTo(5);

            assertThat(pieces[Terrain.FORM]).isEqualTo(Terrain.SEGMENT);
            assertThat(pieces[Terrain.KIND]).isEqualTo(7);
            assertThat(pieces[Terrain.X1]).isEqualTo(1);
            assertThat(pieces[Terrain.Y1]).isEqualTo(2);
            assertThat(pieces[Terrain.X2]).isEqualTo(3);
            assertThat(pieces[Terrain.Y2]).isEqualTo(5);
            assertThat(pieces[Terrain.THICKNESS]).isEqualTo(0.5f);
            assertThat(pieces[Terrain.INSIDE]).isZero();

            int row = Terrain.PIECE_STRIDE;
            assertThat(pieces[row + Terrain.FORM]).isEqualTo(Terrain.LINE);
            assertThat(pieces[row + Terrain.X1]).isEqualTo(20);
            assertThat(pieces[row + Terrain.X2]).isEqualTo(12);
            assertThat(pieces[row + Terrain.THICKNESS]).isZero();

            row = 3 * Terrain.PIECE_STRIDE;
            assertThat(pieces[row + Terrain.FORM]).isEqualTo(Terrain.ARC);
            assertThat(pieces[row + Terrain.KIND]).isEqualTo(7);
            assertThat(pieces[row + Terrain.CENTRE_X]).isEqualTo(40);
            assertThat(pieces[row + Terrain.CENTRE_Y]).isEqualTo(30);
            assertThat(pieces[row + Terrain.RADIUS]).isEqualTo(6);
            assertThat(pieces[row + Terrain.FROM]).isCloseTo(1, within(1e-6f));
            assertThat(pieces[row + Terrain.TO]).isCloseTo(2.5f, within(1e-6f));
            assertThat(pieces[row + Terrain.INSIDE]).isEqualTo(1);
            assertThat(pieces[row + Terrain.PIECE_STRIDE + Terrain.INSIDE]).isZero();
        }
    }

    @Test
    void aColumnOfAPieceThatHasNoSuchThingIsZero() {
        int[] ofAll = {Terrain.FORM, Terrain.KIND};
        int[] ofLines = {Terrain.X1, Terrain.Y1, Terrain.X2, Terrain.Y2, Terrain.THICKNESS};
        int[] ofArcs = {Terrain.CENTRE_X, Terrain.CENTRE_Y, Terrain.RADIUS, Terrain.FROM, Terrain.TO, Terrain.INSIDE};
        assertThat(Stream.of(ofAll, ofLines, ofArcs).flatMapToInt(IntStream::of))
                .as("a column each")
                .containsExactlyElementsOf(
                        IntStream.range(0, Terrain.PIECE_STRIDE).boxed().toList());
        try (World world = world()) {
            world.terrain().addSegment(1, 2, 3, 5, 0.5f, 7);
            world.terrain().addArc(40, 30, 6, 1, 2.5f, ArcSide.INNER, 7);
            float[] pieces = new float[2 * Terrain.PIECE_STRIDE];
            Arrays.fill(pieces, Float.NaN);
            world.terrain().readPieces(pieces, null);
            for (int column : ofLines) {
                assertThat(pieces[column]).isNotZero();
                assertThat(pieces[Terrain.PIECE_STRIDE + column]).isZero();
            }
            for (int column : ofArcs) {
                assertThat(pieces[column]).isZero();
                assertThat(pieces[Terrain.PIECE_STRIDE + column]).isNotZero();
            }
        }
    }

    @Test
    void aBodyMovesByItsVelocities() {
        try (World world = world()) {
            TerrainBody body = world.terrain().addBody(10, 20, 0);
            body.addSegment(0, 0, 2, 0);
            body.setVelocity(6, -3);
            body.setAngularVelocity(PI);
            world.add(50, 50, 1, 1);
            world.step(1f / 60, 30);
            assertThat(body.x()).isCloseTo(13, within(1e-4f));
            assertThat(body.y()).isCloseTo(18.5f, within(1e-4f));
            assertThat(body.angle()).isCloseTo(PI / 2, within(1e-4f));
            float[] piece = new float[Terrain.PIECE_STRIDE];
            assertThat(world.terrain().readPieces(piece, null)).isEqualTo(1);
            assertThat(piece[Terrain.X1]).isEqualTo(body.x());
            assertThat(piece[Terrain.X2]).isCloseTo(13, within(1e-4f));
            assertThat(piece[Terrain.Y2]).isCloseTo(20.5f, within(1e-4f));
        }
    }

    @Test
    void aBodyTravelsThereInOneStepAndGoesOnWithItsVelocity() {
        try (World world = world()) {
            TerrainBody body = world.terrain().addBody(10, 20, 0);
            body.setVelocity(60, 0);
            body.moveTo(15, 15, 1);
            world.step(1f / 60);
            assertThat(body.x()).isEqualTo(15);
            assertThat(body.y()).isEqualTo(15);
            assertThat(body.angle()).isCloseTo(1, within(1e-6f));
            world.step(1f / 60);
            assertThat(body.x()).isCloseTo(16, within(1e-5f));
            body.teleport(1, 2, 3);
            assertThat(body.x()).isEqualTo(1);
            assertThat(body.angle()).isCloseTo(3, within(1e-6f));
        }
    }

    @Test
    void aBodyTellsHowFastItHasCarriedAPlaceInTheLastStep() {
        try (World world = world()) {
            TerrainBody body = world.terrain().addBody(10, 20, 0);
            body.setVelocity(3, -2);
            assertThat(body.vxAt(10, 20)).as("before the first step").isZero();
            world.step(1f / 50);
            assertThat(body.vxAt(10.06f, 19.96f)).isEqualTo(3);
            assertThat(body.vyAt(10.06f, 19.96f)).isEqualTo(-2);
            int bytes = world.snapshotBytes();
            world.step(1f / 50);
            assertThat(world.snapshotBytes()).as("even motion takes none").isEqualTo(bytes);
            body.teleport(10, 20, 0);
            world.step(1f / 50);
            body.setVelocity(0, 0);
            body.moveTo(11.06f, 18.96f, 0.1f);
            world.step(1f / 50);
            assertThat(body.vx()).isZero();
            assertThat(body.vxAt(11.06f, 18.96f)).isCloseTo(50, within(1e-3f));
            assertThat(body.vyAt(11.06f, 18.96f)).isCloseTo(-50, within(1e-3f));
            assertThat(body.vxAt(11.06f, 20.96f)).as("above the pivot").isCloseTo(50 - 2 * 5, within(1e-3f));
            assertThat(body.vyAt(13.06f, 18.96f)).as("beside it").isCloseTo(-50 + 2 * 5, within(1e-3f));
            java.nio.ByteBuffer saved = java.nio.ByteBuffer.allocate(world.snapshotBytes());
            world.snapshot(saved);
            world.step(1f / 50);
            assertThat(body.vyAt(13, 18)).as("it has stopped").isZero();
            world.restore(saved.flip());
            assertThat(body.vxAt(11.06f, 18.96f)).isCloseTo(50, within(1e-3f));
            world.step(1f / 50);
            assertThat(body.vxAt(11.06f, 18.96f)).isZero();
            body.moveTo(50, 50, 0);
            world.step(1f / 50, 1);
            body.teleport(1, 2, 0);
            assertThat(body.vxAt(1, 2)).isZero();
            assertThat(world.terrain().ground().vyAt(3, 4)).isZero();
            assertThatThrownBy(() -> body.vxAt(Float.NaN, 0)).hasMessageStartingWith("x is NaN, but must be from");
            body.remove();
            assertThatThrownBy(() -> body.vyAt(0, 0)).hasMessageContaining("no body of terrain has the handle");
        }
    }

    @Test
    void acrossTheSeamABodyCarriesTheShortWay() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 100, 100)
                .edges(Edge.WRAP, Edge.WRAP)
                .build()) {
            TerrainBody body = world.terrain().addBody(99, 99, 0);
            body.setAngularVelocity(2);
            world.step(1f / 50);
            assertThat(body.vxAt(99, 2)).isCloseTo(-6, within(1e-4f));
            assertThat(body.vyAt(102, 99)).isCloseTo(6, within(1e-4f));
            body.moveTo(1, 99, 0);
            world.step(1f / 50);
            assertThat(body.vxAt(1, 99)).as("the short way").isCloseTo(100, within(1e-3f));
        }
    }

    @Test
    void placesOfABodyAreThoseOfTheWorldAndBack() {
        try (World world = world()) {
            Terrain terrain = world.terrain();
            TerrainBody body = terrain.addBody(30, 40, PI / 2);
            assertThat(body.worldX(2, 1)).isCloseTo(29, within(1e-5f));
            assertThat(body.worldY(2, 1)).isCloseTo(42, within(1e-5f));
            assertThat(body.localX(29, 42)).isCloseTo(2, within(1e-5f));
            assertThat(body.localY(29, 42)).isCloseTo(1, within(1e-5f));
            body.setVelocity(3, -2);
            body.setAngularVelocity(1);
            long circle = world.add(70, 70, 1, 1);
            long joint = world.joints().add(circle, body, 2, 1, Joint.rope(90));
            world.step(1f / 60, 50);
            assertThat(body.worldX(2, 1)).isEqualTo(world.joints().anchorX(joint));
            assertThat(body.worldY(2, 1)).isEqualTo(world.joints().anchorY(joint));
            float x = body.worldX(-7, 5);
            float y = body.worldY(-7, 5);
            assertThat(body.localX(x, y)).isCloseTo(-7, within(1e-4f));
            assertThat(body.localY(x, y)).isCloseTo(5, within(1e-4f));
            assertThat(terrain.ground().localX(95.1f, 7)).isEqualTo(95.1f);
            assertThat(terrain.ground().worldY(95.1f, 7)).isEqualTo(7);
            assertThatThrownBy(() -> body.localX(Float.NaN, 0)).hasMessageStartingWith("x is NaN, but must be from");
            assertThatThrownBy(() -> body.worldY(0, 2e9f)).hasMessageStartingWith("y is 2.0E9, but must be from");
            body.remove();
            assertThatThrownBy(() -> body.localY(0, 0)).hasMessageContaining("no body of terrain has the handle");
        }
    }

    @Test
    void onAnAxisThatWrapsAPlaceOfABodyIsInsideAndTheShortWayFromItsPivot() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 100, 100)
                .edges(Edge.WRAP, Edge.WALL)
                .build()) {
            TerrainBody body = world.terrain().addBody(98, 50, 0);
            assertThat(body.worldX(5, 0)).isEqualTo(3);
            for (float x : new float[] {3, 103, -97}) {
                assertThat(body.localX(x, 50)).isEqualTo(5);
            }
            assertThat(world.terrain().ground().localX(99, 50)).isEqualTo(99);
        }
    }

    @Test
    void aRopeHangsOnTheMovingBodyThatARayHasHit() {
        try (World world =
                WorldScenes.jvm().bounds(0, 0, 100, 100).gravity(0, -10).build()) {
            TerrainBody lift = world.terrain().addBody(50, 60, 0.3f);
            lift.addSegment(-20, 0, 20, 0);
            lift.setVelocity(5, 3);
            world.step(1f / 60, 30);
            long player = world.add(55, 20, 1, 1);
            float[] hit = new float[Queries.HIT_STRIDE];
            long piece = world.queries().terrain().rayCast(55, 20, 0, 70, hit);
            TerrainBody body = world.terrain().bodyOf(piece);
            assertThat(body).isSameAs(lift);
            float x = body.localX(hit[Queries.X], hit[Queries.Y]);
            float y = body.localY(hit[Queries.X], hit[Queries.Y]);
            assertThat(y).as("it lies on the piece").isCloseTo(0, within(1e-4f));
            long rope = world.joints().add(player, body, x, y, Joint.rope(hit[Queries.DISTANCE]));
            assertThat(world.joints().anchorX(rope)).isCloseTo(hit[Queries.X], within(1e-4f));
            assertThat(world.joints().anchorY(rope)).isCloseTo(hit[Queries.Y], within(1e-4f));
            float before = world.y(player);
            world.step(1f / 60, 120);
            assertThat(world.y(player)).as("the lift takes it along").isGreaterThan(before + 5);
        }
    }

    @Test
    void badValuesAreRefusedWithTheirIndexAndNothingChanges() {
        try (World world = world()) {
            Terrain terrain = world.terrain();
            assertThatThrownBy(() -> terrain.addSegment(1, 1, 1, 1)).hasMessageContaining("longer");
            assertThatThrownBy(() -> terrain.addSegment(Float.NaN, 1, 1, 1)).hasMessageContaining("x1 is NaN");
            assertThatThrownBy(() -> terrain.addSegment(0, 1, 1, 2e9f)).hasMessageContaining("y2 is 2.0E9");
            assertThatThrownBy(() -> terrain.addSegment(0, 0, 1, 0, -1, 0)).hasMessageContaining("thickness is -1");
            assertThatThrownBy(() -> terrain.addSegment(0, 0, 1, 0, 0, 256)).hasMessageContaining("kind is 256");
            assertThatThrownBy(() -> terrain.addArc(0, 0, 0, 0, 1, ArcSide.INNER))
                    .hasMessageContaining("radius");
            assertThatThrownBy(() -> terrain.addArc(0, 0, 1, 1, 1, ArcSide.INNER))
                    .hasMessageContaining("greater");
            assertThatThrownBy(() -> terrain.addArc(0, 0, 1, 0, 7, ArcSide.INNER))
                    .hasMessageContaining("2 pi, in radians");
            assertThatThrownBy(() -> terrain.addSegments(new float[] {0, 0, 1, 0, 5, 5, 5, 5}, 0, null))
                    .hasMessageContaining("segment 1");
            assertThatThrownBy(() -> Chain.of(0, 0, 1, 0, 1, 0)).hasMessageContaining("point 2");
            assertThatThrownBy(() -> Chain.of(0, 0)).hasMessageContaining("two points");
            assertThatThrownBy(() -> Chain.from(0, 0).arcTo(1, 0, 0)).hasMessageContaining("point 1");
            assertThatThrownBy(() -> terrain.addChain(Chain.from(0, 0))).hasMessageContaining("at least 2");
            assertThatThrownBy(() -> terrain.addChain(Chain.of(0, 0, 1, 0, 2, 0), 0, new long[1]))
                    .hasMessageContaining("handles");
            assertThatThrownBy(() -> terrain.ground().setVelocity(1, 0)).hasMessageContaining("ground");
            assertThatThrownBy(() -> terrain.ground().remove()).hasMessageContaining("ground");
            assertThat(terrain.size()).isZero();
            long gone = terrain.addSegment(0, 0, 1, 0);
            terrain.remove(gone);
            assertThatThrownBy(() -> terrain.remove(gone)).hasMessageContaining("no piece");
            assertThatThrownBy(() -> terrain.kindOf(gone)).hasMessageContaining("no piece");
        }
    }

    @Test
    void onAnAxisThatWrapsAPieceIsAtMostHalfAPeriodLong() {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 100, 100)
                .edges(Edge.WRAP, Edge.OPEN)
                .build()) {
            Terrain terrain = world.terrain();
            terrain.addSegment(80, 0, 130, 0);
            assertThatThrownBy(() -> terrain.addSegment(80, 0, 131, 0)).hasMessageContaining("wraps");
            assertThatThrownBy(() -> terrain.addChain(Chain.of(0, 0, 10, 0, 70, 0)))
                    .hasMessageContaining("piece 1");
            assertThatThrownBy(() -> terrain.addArc(0, 0, 26, 0, 3, ArcSide.INNER))
                    .hasMessageContaining("wraps");
            assertThatThrownBy(() -> terrain.addChain(Chain.from(26, 0).arcTo(0, 0, 3)))
                    .hasMessageContaining("wraps");
            float[] piece = new float[Terrain.PIECE_STRIDE];
            terrain.readPieces(piece, null);
            assertThat(piece[Terrain.X1]).isEqualTo(-20);
            assertThat(piece[Terrain.X2]).isEqualTo(30);
            terrain.addArc(0, 0, 1000, 1, 1.04f, ArcSide.INNER); // a slight bend, 40 long
            TerrainBody body = terrain.addBody(199, 0, 0);
            assertThat(body.x()).isEqualTo(99);
            body.setVelocity(2, 0);
            world.step(1);
            assertThat(body.x()).isEqualTo(1);
            body.moveTo(98, 0, 0);
            world.step(1);
            assertThat(body.x()).isEqualTo(98);
        }
    }

    /** A box with paddles turns around a pivot at the seam as around one in the middle. */
    @Test
    void aBodyAcrossTheSeamCarriesCirclesAsElsewhere() {
        float[] middle = ridden(20);
        float[] seam = ridden(0.5f);
        assertThat(middle[0]).isGreaterThan(-1);
        assertThat(seam[0]).isCloseTo(middle[0], within(1e-3f));
        assertThat(seam[1]).isCloseTo(middle[1], within(1e-3f));
    }

    private static float[] ridden(float pivot) {
        try (World world = WorldScenes.jvm()
                .bounds(0, 0, 40, 40)
                .edges(Edge.WRAP, Edge.WALL)
                .friction(0.8f)
                .gravity(0, -10)
                .build()) {
            TerrainBody table = world.terrain().addBody(pivot, 20, 0);
            table.addSegment(-6, 1, 6, 1, 0.2f, 0);
            table.addSegment(-6, 1, -6, 5);
            table.addSegment(6, 1, 6, 5);
            table.setAngularVelocity(-0.3f);
            table.setVelocity(1, 0);
            long ball = world.add((pivot + 38) % 40, 21.71f, 0.5f, 1);
            world.step(1 / 60f, 90);
            float x = world.x(ball) - pivot;
            return new float[] {x > 20 ? x - 40 : x < -20 ? x + 40 : x, world.y(ball)};
        }
    }

    @Test
    void anArcOfAWholeTurnButForRoundingIsACircle() {
        try (World world = world()) {
            float[] piece = new float[Terrain.PIECE_STRIDE];
            for (float from : new float[] {0, -3, 100, -1000}) {
                long circle = world.terrain().addArc(50, 50, 5, from, from + 2 * PI, ArcSide.INNER);
                world.terrain().readPieces(piece, null);
                assertThat(piece[Terrain.TO] - piece[Terrain.FROM]).isCloseTo(2 * PI, within(1e-6f));
                world.terrain().remove(circle);
            }
        }
    }
}
