package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceBuffer;
import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.opencl.OnEachDevice;
import io.github.circles2d.opencl.Session;
import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.memory.WorldSource;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Paths;
import io.github.circles2d.world.model.PieceGap;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.PieceSweep;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.SplittableRandom;

/** The formulas of pieces of terrain have the same bits on a device as in Java, for circles near them and far away, also in odd places. */
class PieceFormulasOnDevicesTest {
    private static final int PIECES = 500;

    /** Floats of an input: o, u (or a vertex), radius, side, thickness of the vertex, and what says whether it is free. */
    private static final int INPUT = 8;

    private static final int OUTPUT = 14;

    private static final String PROBE = """
            kernel void probe(global const float *rows, global const int *shapes, global const float *in, global int *out, int count) {
                int i = (int) get_global_id(0);
                if (i >= count) return;
                int piece = i % PROBED_PIECES;
                global const float *row = rows + PIECE_STRIDE * piece;
                int shape = shapes[piece];
                global const float *p = in + 8 * i;
                global int *to = out + 14 * i;
                PieceGap g;
                g.nx = g.ny = g.gap = g.curve = 0.0f;
                measurePiece(row, shape, p[0], p[1], p[4], p[5], &g);
                to[0] = g.feature;
                to[1] = as_int(g.nx);
                to[2] = as_int(g.ny);
                to[3] = as_int(g.gap);
                to[4] = as_int(g.curve);
                to[5] = formOf(shape) == PIECE_ARC ? 0 : as_int(g.height);
                to[6] = isInFront(row, shape, p[0], p[1]);
                to[7] = as_int(distanceOfPiece(row, shape, p[0], p[1]));
                to[8] = coversVertex(row, shape, p[0], p[1], p[5], p[2], p[3], p[6], p[7] < 0.05f, p[4]);
                to[9] = as_int(timeOfFace(row, shape, p[0], p[1], p[2], p[3], p[4], p[5]));
                to[10] = as_int(turnedWay(g.curve, p[2], p[3]));
                to[11] = as_int(sight(p[4], p[6]));
                to[12] = as_int(timeOfVertex(row, shape, true, p[0], p[1], p[2], p[3], p[4]));
                to[13] = as_int(timeOfVertex(row, shape, false, p[0], p[1], p[2], p[3], p[4]));
            }
            """;

    @OnEachDevice
    void formulasHaveTheSameBits(Device device) {
        SplittableRandom random = new SplittableRandom(1);
        TerrainTwins terrain = new TerrainTwins(new Bounds(-1, -1, 1, 1), 0.5f);
        terrain.make(PIECES, false, random);
        float[] rows = terrain.rows();
        int[] shapes = new int[PIECES];
        for (int piece = 0; piece < PIECES; piece++) {
            shapes[piece] = terrain.traits()[PieceRow.traits(piece) + PieceRow.SHAPE];
        }
        int count = TestScale.of(100_000, 1_000_000);
        float[] inputs = new float[INPUT * count];
        for (int i = 0; i < count; i++) {
            input(rows, PieceRow.of(i % PIECES), inputs, INPUT * i, random);
        }
        int[] onDevice = run(device, rows, shapes, inputs, count);
        int[] inJava = new int[OUTPUT];
        int faces = 0;
        int touches = 0;
        int covered = 0;
        for (int i = 0; i < count; i++) {
            int piece = i % PIECES;
            compute(rows, PieceRow.of(piece), shapes[piece], inputs, INPUT * i, inJava);
            faces += inJava[0] == PieceGap.FACE ? 1 : 0;
            touches += Float.intBitsToFloat(inJava[9]) < 1f ? 1 : 0;
            covered += inJava[8];
            for (int k = 0; k < OUTPUT; k++) {
                if (inJava[k] != onDevice[OUTPUT * i + k]) {
                    assertThat(onDevice[OUTPUT * i + k])
                            .as("number %s of input %s at piece %s of shape %s", k, i, piece, shapes[piece])
                            .isEqualTo(inJava[k]);
                }
            }
        }
        assertThat(faces).isBetween(count / 10, 9 * count / 10);
        assertThat(touches).isGreaterThan(count / 50);
        assertThat(covered).isBetween(count / 50, count / 2);
    }

    /** A place near the piece, far away, or one of its own points. */
    private static void input(float[] rows, int row, float[] to, int at, SplittableRandom random) {
        float scale = random.nextInt(4) == 0 ? 100f : 1f;
        float x = scale * between(random);
        float y = scale * between(random);
        switch (random.nextInt(8)) {
            case 0 -> {
                x = rows[row + PieceRow.START_X];
                y = rows[row + PieceRow.START_Y];
            }
            case 1 -> {
                x = rows[row + PieceRow.END_X];
                y = rows[row + PieceRow.END_Y];
            }
            case 2 -> {
                x = 0f;
                y = -0f;
            }
            default -> {}
        }
        to[at] = x;
        to[at + 1] = y;
        to[at + 2] = random.nextInt(8) == 0 ? 0f : 2 * between(random);
        to[at + 3] = random.nextInt(8) == 0 ? -0f : 2 * between(random);
        to[at + 4] = 0.2f * Math.abs(between(random));
        to[at + 5] = random.nextBoolean() ? 1f : -1f;
        to[at + 6] = 0.1f * Math.abs(between(random));
        to[at + 7] = 0.1f * Math.abs(between(random));
    }

    private static float between(SplittableRandom random) {
        return 2f * (float) random.nextDouble() - 1f;
    }

    private static void compute(float[] rows, int row, int shape, float[] p, int at, int[] to) {
        PieceGap g = new PieceGap();
        g.measure(rows, row, shape, p[at], p[at + 1], p[at + 4], p[at + 5]);
        to[0] = g.feature;
        to[1] = Float.floatToRawIntBits(g.nx);
        to[2] = Float.floatToRawIntBits(g.ny);
        to[3] = Float.floatToRawIntBits(g.gap);
        to[4] = Float.floatToRawIntBits(g.curve);
        to[5] = Float.floatToRawIntBits(PieceRow.form(shape) == PieceRow.ARC ? 0f : g.height);
        to[6] = PieceGap.isInFront(rows, row, shape, p[at], p[at + 1]) ? 1 : 0;
        to[7] = Float.floatToRawIntBits(PieceGap.distance(rows, row, shape, p[at], p[at + 1]));
        boolean free = p[at + 7] < 0.05f;
        to[8] = PieceGap.covers(
                        rows, row, shape, p[at], p[at + 1], p[at + 5], p[at + 2], p[at + 3], p[at + 6], free, p[at + 4])
                ? 1
                : 0;
        to[9] = Float.floatToRawIntBits(
                PieceSweep.timeOfFace(rows, row, shape, p[at], p[at + 1], p[at + 2], p[at + 3], p[at + 4], p[at + 5]));
        to[10] = Float.floatToRawIntBits(PieceGap.turned(g.curve, p[at + 2], p[at + 3]));
        to[11] = Float.floatToRawIntBits(Paths.sight(p[at + 4], p[at + 6]));
        for (int end = 0; end < 2; end++) {
            to[12 + end] = Float.floatToRawIntBits(PieceSweep.timeOfVertex(
                    rows, row, shape, end == 0, p[at], p[at + 1], p[at + 2], p[at + 3], p[at + 4]));
        }
    }

    private static int[] run(Device device, float[] rows, int[] shapes, float[] inputs, int count) {
        KernelSource source = WorldSource.tables()
                .define("TERRAIN", 1)
                .define("PROBED_PIECES", PIECES)
                .and("world/shared/Paths.cl", "world/shared/PieceSweep.cl")
                .and(KernelSource.ofText("probe", PROBE));
        try (Session session = Session.open(device);
                DeviceBuffer ofRows = session.allocate("rows", 4L * rows.length);
                DeviceBuffer ofShapes = session.allocate("shapes", 4L * shapes.length);
                DeviceBuffer in = session.allocate("inputs", 4L * inputs.length);
                DeviceBuffer out = session.allocate("results", 4L * OUTPUT * count)) {
            ofRows.write(FloatBuffer.wrap(rows));
            ofShapes.write(0, IntBuffer.wrap(shapes));
            in.write(FloatBuffer.wrap(inputs));
            session.build(source, StageKernels.options(device))
                    .kernel("probe")
                    .arg(0, ofRows)
                    .arg(1, ofShapes)
                    .arg(2, in)
                    .arg(3, out)
                    .arg(4, count)
                    .run(count);
            int[] results = new int[OUTPUT * count];
            out.read(IntBuffer.wrap(results));
            return results;
        }
    }
}
