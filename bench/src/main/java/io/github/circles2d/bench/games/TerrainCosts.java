package io.github.circles2d.bench.games;

import io.github.circles2d.Backend;
import io.github.circles2d.Chain;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/**
 * What terrain costs: two worlds make their steps in turn, of which the second has what the first is compared with. The main method prints a
 * line of a CSV file for each.
 *
 * <p>This class and {@link InTurn} need the library and no other class, so that they run on a machine with nothing but a JVM and the library.
 */
public final class TerrainCosts {
    /** What is compared. */
    public static final List<String> CASES = List.of("lie", "cave", "moving", "floor");

    static final String HEADER =
            "case,machine,n,pieces,contacts,other_contacts,ms,other_ms,ratio,ratio_of_minima,more_ms,"
                    + "asked_ratio,asked_more_ms";

    private static final float RADIUS = 0.49f;
    private static final int PER_PIECE = 15;
    private static final int PIECES_PER_CIRCLE_OF_CAVE = 10;
    private static final int MOVING = 1000;
    private static final int SETTLING = 200;

    private TerrainCosts() {}

    /**
     * Prints what terrain costs.
     *
     * @param arguments as {@link #run}
     */
    public static void main(String[] arguments) {
        InTurn.main(arguments, TerrainCosts::run);
    }

    /**
     * Prints what terrain costs.
     *
     * @param arguments a name of {@link Backend}, numbers of circles and cases; by default JVM, 15000, and all cases
     * @param out takes the lines of a CSV file
     * @throws IllegalArgumentException where the arguments are others
     */
    public static void run(List<String> arguments, PrintStream out) {
        InTurn.Arguments asked = InTurn.Arguments.read(arguments, 15_000, CASES);
        out.println(HEADER);
        for (int n : asked.sizes()) {
            for (String each : asked.cases()) {
                compare(each, asked.backend(), n, InTurn.WARM_ROUNDS, InTurn.ROUNDS, out);
            }
        }
    }

    static void compare(String what, Backend backend, int n, int warm, int rounds, PrintStream out) {
        try (World with = world(what, true, backend, n);
                World other = world(what, false, backend, n)) {
            InTurn times = InTurn.measure(with, other, SETTLING, warm, rounds);
            out.printf(
                    Locale.ROOT,
                    "%s,\"%s\",%d,%d,%d,%d,%.4f,%.4f,%.3f,%.3f,%.4f,%s,%s%n",
                    what,
                    with.stats().device(),
                    with.size(),
                    with.terrain().size(),
                    contacts(with),
                    contacts(other),
                    times.median(),
                    times.otherMedian(),
                    times.ratio(),
                    times.ratioOfMinima(),
                    times.median() - times.otherMedian(),
                    askedRatio(what),
                    what.equals("moving") ? "0.2" : "");
            out.flush();
        }
    }

    private static String askedRatio(String what) {
        return what.equals("lie") ? "1.25" : what.equals("cave") ? "1.5" : what.equals("floor") ? "1.0" : "";
    }

    /** Contacts of circles, near ones as well, and pieces that touch circles within the same margin. */
    static int contacts(World world) {
        float[] circles = new float[4 * world.size()];
        float[] discs = new float[3 * world.size()];
        world.read(circles);
        for (int k = 0; k < world.size(); k++) {
            discs[3 * k] = circles[4 * k];
            discs[3 * k + 1] = circles[4 * k + 1];
            discs[3 * k + 2] = 1.05f * circles[4 * k + 2];
        }
        long[] pieces = new long[16 * world.size()];
        int[] ends = new int[world.size()];
        int found = world.terrain().size() == 0
                ? 0
                : world.queries().terrain().overlapCircle(discs, world.size(), ends, pieces);
        return world.stats().contacts() + found;
    }

    static World world(String what, boolean first, Backend backend, int n) {
        switch (what) {
            case "lie":
                return first ? shelves(backend, n) : pile(backend, n);
            case "cave":
                return first ? cave(backend, n * 2 / 3) : pile(backend, n * 2 / 3);
            case "moving":
                return paddles(backend, n / 3, first);
            case "floor":
                return floor(backend, n, first);
            default:
                throw new IllegalArgumentException("there is no case '" + what + "'; there are " + CASES);
        }
    }

    private static World build(Backend backend, float width, float height) {
        World.Builder builder =
                World.builder().bounds(0, 0, width, height).gravity(0, -10).backend(backend);
        return (backend == Backend.JVM ? builder.threads(2) : builder).build();
    }

    /** Circles lie in rows on segments, {@value #PER_PIECE} on each: as many contacts with pieces as circles, and nearly as many of circles. */
    private static World shelves(Backend backend, int n) {
        int shelves = (n + PER_PIECE - 1) / PER_PIECE;
        int columns = (int) Math.ceil(Math.sqrt(shelves / 2.0));
        float width = PER_PIECE + 2;
        World world = build(backend, columns * width + 2, (shelves / columns + 1) * 3f + 5);
        for (int i = 0; i < shelves; i++) {
            float x = 1 + i % columns * width;
            float y = 1 + i / columns * 3f;
            world.terrain().addSegment(x, y, x + width - 0.5f, y);
            for (int k = 0; k < PER_PIECE && i * PER_PIECE + k < n; k++) {
                world.add(x + 0.75f + k, y + 0.5f, RADIUS, 1);
            }
        }
        return world;
    }

    /** A lattice that stands on the lowest wall: a circle has four neighbours, so there are two contacts a circle. */
    private static World pile(Backend backend, int n) {
        int columns = (int) (2 * Math.sqrt(n));
        World world = build(backend, columns, n / columns * 2f + 10);
        for (int i = 0; i < n; i++) {
            world.add(0.5f + i % columns, 0.5f + i / columns, RADIUS, 1);
        }
        return world;
    }

    /** Rough floors of chains; circles lie in rows on the lowest ones. */
    private static World cave(Backend backend, int n) {
        int floors = (int) Math.sqrt(n);
        int each = PIECES_PER_CIRCLE_OF_CAVE * n / floors;
        float width = 2f * each + 40;
        World world = build(backend, width, 20f * floors + 40);
        Random random = new Random(1);
        for (int floor = 0; floor < floors; floor++) {
            float[] points = new float[2 * each + 2];
            for (int i = 0; i <= each; i++) {
                points[2 * i] = width - 20 - 2f * i;
                points[2 * i + 1] = 20 * floor + 5 + 2 * random.nextFloat();
            }
            world.terrain().addChain(Chain.of(points));
        }
        int row = (int) ((width - 80) / 1.05f);
        for (int i = 0; i < n; i++) {
            world.add(40 + i % row * 1.05f, 9 + 20 * (i / row), RADIUS, 1);
        }
        return world;
    }

    /** Short segments on bodies, which turn or rest, in an arena with loose circles. */
    private static World paddles(Backend backend, int n, boolean turn) {
        float size = (float) (6 * Math.sqrt(Math.max(n, MOVING)));
        World world = build(backend, size, size);
        int columns = (int) Math.ceil(Math.sqrt(MOVING));
        float apart = size / (columns + 1);
        for (int i = 0; i < MOVING; i++) {
            TerrainBody body = world.terrain().addBody((1 + i % columns) * apart, (1 + i / columns) * apart, i);
            body.addSegment(-2, 0, 2, 0);
            if (turn) {
                body.setAngularVelocity(1);
            }
        }
        Random random = new Random(2);
        for (int i = 0; i < n; i++) {
            world.add(1 + random.nextFloat() * (size - 2), 1 + random.nextFloat() * (size - 2), 0.3f, 1);
        }
        return world;
    }

    /** Half of the circles on a floor that is one piece, or many; half on short pieces above it. */
    private static World floor(Backend backend, int n, boolean onePiece) {
        int half = n / 2;
        float width = half + 10;
        World world = build(backend, width, 30);
        float step = onePiece ? width - 4 : 7.5f;
        for (float x = 2; x + step <= width - 1.9f; x += step) {
            world.terrain().addSegment(x, 5, x + step, 5);
        }
        int shorts = Math.max(1, half / 8);
        for (int i = 0; i < shorts; i++) {
            world.terrain().addSegment(4 + 8f * i, 15, 11.5f + 8f * i, 15);
        }
        for (int i = 0; i < half; i++) {
            world.add(4.5f + i, 5.5f, RADIUS, 1);
            world.add(4.5f + i % (8 * shorts), 15.5f, RADIUS, 1);
        }
        return world;
    }
}
