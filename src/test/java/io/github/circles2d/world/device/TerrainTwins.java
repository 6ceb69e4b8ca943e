package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactRows;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.terrain.SavedPieceContacts;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/** Random tables of terrain, which pipelines are given in place of those of their simulations: also such as no world has. */
final class TerrainTwins {
    private static final int BODIES = 4;

    private final TerrainStep tables = new TerrainStep();
    private final Bounds bounds;
    private final float length;
    private final int subSteps = 4;
    private Pipeline[] pipelines;

    /** Pieces are about as long as that. */
    TerrainTwins(Bounds bounds, float length) {
        this.bounds = bounds;
        this.length = length;
    }

    float[] rows() {
        return tables.rows;
    }

    int[] traits() {
        return tables.traits;
    }

    /** The same pipelines, in steps with these tables. */
    Pipeline[] on(Pipeline... all) {
        pipelines = all;
        return Pipelines.with(Features.TERRAIN, this::prepare, all);
    }

    /** Compares the contacts of circles with pieces; returns their number. */
    int assertSameContacts(String when) {
        List<String> expected = contacts(pipelines[0]);
        for (Pipeline pipeline : pipelines) {
            assertThat(contacts(pipeline)).as(when + " on " + pipeline.device()).isEqualTo(expected);
        }
        return expected.size();
    }

    private static List<String> contacts(Pipeline pipeline) {
        SavedPieceContacts saved = new SavedState().pieceContacts;
        pipeline.savePieceContacts(saved);
        List<String> contacts = new ArrayList<>();
        for (int k = 0; k < saved.count; k++) {
            contacts.add(saved.circle[k] + " " + saved.piece[k] + " " + saved.serial[k] + " " + saved.side[k] + " "
                    + saved.impulse[k]
                    + Arrays.toString(Arrays.copyOfRange(saved.rows, ContactRows.of(k), ContactRows.of(k + 1))));
        }
        return contacts;
    }

    private void prepare(StepInput input) {
        input.constants.terrain = tables.pieces > 0;
        TerrainStep to = input.terrain;
        to.pieces = tables.pieces;
        to.rows = tables.rows;
        to.traits = tables.traits;
        to.version = tables.version;
        to.changedFrom = tables.changedFrom;
        to.changedTo = tables.changedTo;
        to.nodes = tables.nodes;
        to.boxes = tables.boxes;
        to.links = tables.links;
        to.treeVersion = tables.treeVersion;
        to.linksVersion = tables.linksVersion;
        to.boxesFrom = tables.boxesFrom;
        to.bodies = tables.bodies;
        to.motion = tables.motion;
        to.motionVersion = tables.motionVersion;
        System.arraycopy(tables.kinds.rows, 0, to.kinds.rows, 0, to.kinds.rows.length);
        to.kinds.version = tables.kinds.version;
    }

    /** Makes so many pieces in place of those before; some go on under their serial numbers. */
    void make(int pieces, boolean moving, SplittableRandom random) {
        float[] rows = new float[PieceRow.of(pieces)];
        int[] traits = new int[PieceRow.traits(pieces)];
        for (int piece = 0; piece < pieces; piece++) {
            if (piece < tables.pieces && random.nextInt(3) > 0) {
                System.arraycopy(tables.rows, PieceRow.of(piece), rows, PieceRow.of(piece), PieceRow.STRIDE);
                System.arraycopy(
                        tables.traits, PieceRow.traits(piece), traits, PieceRow.traits(piece), PieceRow.TRAITS);
            } else {
                piece(rows, PieceRow.of(piece), traits, PieceRow.traits(piece), random);
            }
            traits[PieceRow.traits(piece) + PieceRow.MOTION] =
                    moving && random.nextBoolean() ? 1 + random.nextInt(BODIES - 1) : 0;
        }
        tables.rows = rows;
        tables.traits = traits;
        tables.pieces = pieces;
        tables.version++;
        tables.bodies = BODIES;
        for (int kind = 0; kind < PairTable.KINDS; kind++) {
            tables.kinds.rows[KindTerrain.of(kind) + KindTerrain.RESTITUTION] = random.nextInt(3) == 0 ? 0.7f : 0f;
            tables.kinds.rows[KindTerrain.of(kind) + KindTerrain.ONE_WAY] = random.nextInt(4) == 0 ? 1f : 0f;
        }
        tables.kinds.version++;
        move(random);
        // not by one, so all is new
        tables.version++;
        tables.linksVersion++;
    }

    /** Lets bodies move in some way in the next step. */
    void move(SplittableRandom random) {
        float[] motion = new float[BodyRow.of(BODIES, subSteps)];
        float most = 0f;
        for (int body = 1; body < BODIES; body++) {
            int row = BodyRow.of(body, subSteps);
            float dx = between(random, -1, 1) * length;
            float dy = between(random, -1, 1) * length;
            float turn = between(random, -1, 1);
            float h = 1 / 240f;
            motion[row + BodyRow.PIVOT_X] = between(random, bounds.minX(), bounds.maxX());
            motion[row + BodyRow.PIVOT_Y] = between(random, bounds.minY(), bounds.maxY());
            motion[row + BodyRow.VX] = dx / (subSteps * h);
            motion[row + BodyRow.VY] = dy / (subSteps * h);
            motion[row + BodyRow.OMEGA] = turn / (subSteps * h);
            for (int i = 0; i <= subSteps; i++) {
                int pose = row + BodyRow.pose(i);
                float part = (float) i / subSteps;
                motion[pose + BodyRow.DX] = part * dx;
                motion[pose + BodyRow.DY] = part * dy;
                motion[pose + BodyRow.COS] = (float) Math.cos(part * turn);
                motion[pose + BodyRow.SIN] = (float) Math.sin(part * turn);
            }
            most = Math.max(most, 2 * length + 2 * (bounds.maxX() - bounds.minX() + bounds.maxY() - bounds.minY()));
        }
        tables.motion = motion;
        tables.motionVersion++;
        tables.changedFrom = tables.pieces;
        tables.changedTo = 0;
        for (int piece = 0; piece < tables.pieces; piece++) {
            int row = PieceRow.of(piece);
            boolean moves = tables.traits[PieceRow.traits(piece) + PieceRow.MOTION] != 0;
            tables.rows[row + PieceRow.MOST] = moves ? 0.1f * most : 0f;
            if (moves) {
                float shift = between(random, -0.1f, 0.1f) * length;
                tables.rows[row + PieceRow.X] += shift;
                tables.rows[row + PieceRow.MID_X] += shift;
                int body = BodyRow.of(tables.traits[PieceRow.traits(piece) + PieceRow.MOTION], subSteps);
                tables.rows[row + PieceRow.PIVOT_X] = motion[body + BodyRow.PIVOT_X] - tables.rows[row + PieceRow.X];
                tables.rows[row + PieceRow.PIVOT_Y] = motion[body + BodyRow.PIVOT_Y] - tables.rows[row + PieceRow.Y];
                tables.changedFrom = Math.min(tables.changedFrom, piece);
                tables.changedTo = piece + 1;
            }
        }
        tables.version++;
        plant(0.1f * most);
        tables.boxesFrom = tables.changedFrom;
    }

    /** A tree that is a list. */
    private void plant(float most) {
        tables.nodes = tables.pieces;
        tables.boxes = new float[4 * tables.nodes];
        tables.links = new int[2 * tables.nodes];
        for (int piece = 0; piece < tables.pieces; piece++) {
            float x = tables.rows[PieceRow.of(piece) + PieceRow.MID_X];
            float y = tables.rows[PieceRow.of(piece) + PieceRow.MID_Y];
            boolean moves = tables.traits[PieceRow.traits(piece) + PieceRow.MOTION] != 0;
            float reach = 3 * length + (moves ? most : 0);
            tables.boxes[4 * piece] = x - reach;
            tables.boxes[4 * piece + 1] = y - reach;
            tables.boxes[4 * piece + 2] = x + reach;
            tables.boxes[4 * piece + 3] = y + reach;
            tables.links[2 * piece] = piece + 1;
            tables.links[2 * piece + 1] = piece;
        }
        tables.treeVersion++;
    }

    private void piece(float[] rows, int row, int[] traits, int trait, SplittableRandom random) {
        int form = PieceRow.SEGMENT + random.nextInt(3);
        float x = between(random, bounds.minX(), bounds.maxX());
        float y = between(random, bounds.minY(), bounds.maxY());
        double angle = between(random, -3.1415f, 3.1415f);
        if (row > 0 && random.nextInt(3) == 0) {
            // where the one before ends, and in its direction, so that faces cover vertices
            int before = row - PieceRow.STRIDE;
            x = rows[before + PieceRow.X] + rows[before + PieceRow.END_X];
            y = rows[before + PieceRow.Y] + rows[before + PieceRow.END_Y];
            angle = Math.atan2(rows[before + PieceRow.TY], rows[before + PieceRow.TX]);
        }
        float tx = (float) Math.cos(angle);
        float ty = (float) Math.sin(angle);
        float size = between(random, 0.2f, 1) * length;
        boolean arc = form == PieceRow.ARC;
        boolean outside = arc && random.nextBoolean();
        double half = random.nextInt(4) == 0 ? Math.PI : between(random, 0.3f, 2.5f);
        rows[row + PieceRow.X] = x;
        rows[row + PieceRow.Y] = y;
        rows[row + PieceRow.TX] = tx;
        rows[row + PieceRow.TY] = ty;
        rows[row + PieceRow.LENGTH] = size;
        rows[row + PieceRow.SPREAD] = !arc ? 0f : half == Math.PI ? PieceRow.ALL_AROUND : (float) Math.cos(half);
        rows[row + PieceRow.THICKNESS] =
                form == PieceRow.SEGMENT && random.nextBoolean() ? 0.1f * random.nextInt(3) * length : 0f;
        double start = outside ? half : -half;
        rows[row + PieceRow.START_X] = arc ? (float) (size * Math.cos(angle + start)) : 0f;
        rows[row + PieceRow.START_Y] = arc ? (float) (size * Math.sin(angle + start)) : 0f;
        rows[row + PieceRow.END_X] = arc ? (float) (size * Math.cos(angle - start)) : size * tx;
        rows[row + PieceRow.END_Y] = arc ? (float) (size * Math.sin(angle - start)) : size * ty;
        double next = between(random, -3.1415f, 3.1415f);
        rows[row + PieceRow.NEXT_X] = (float) Math.cos(next);
        rows[row + PieceRow.NEXT_Y] = (float) Math.sin(next);
        rows[row + PieceRow.MID_X] = arc ? x : x + 0.5f * size * tx;
        rows[row + PieceRow.MID_Y] = arc ? y : y + 0.5f * size * ty;
        int joints = form == PieceRow.SEGMENT
                ? 0
                : random.nextInt(3) << PieceRow.START_LOG | random.nextInt(3) << PieceRow.END_LOG;
        traits[trait + PieceRow.SHAPE] = form | (outside ? PieceRow.SOLID_OUTSIDE : 0) | joints;
        traits[trait + PieceRow.KIND] = random.nextInt(3);
        traits[trait + PieceRow.SERIAL] = random.nextInt();
    }

    private static float between(SplittableRandom random, float low, float high) {
        return low + (float) random.nextDouble() * (high - low);
    }
}
