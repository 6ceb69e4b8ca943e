package io.github.circles2d.bench.games;

import io.github.circles2d.Backend;
import io.github.circles2d.Joint;
import io.github.circles2d.World;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * What joints cost: two worlds make their steps in turn, with the same circles at the same places, of which the second has no joints. The
 * main method prints a line of a CSV file for each.
 *
 * <p>This class and {@link InTurn} need the library and no other class, so that they run on a machine with nothing but a JVM and the library.
 */
public final class JointCosts {
    /** What is compared. */
    public static final List<String> CASES = List.of("blobs", "bridge");

    static final String HEADER =
            "case,machine,n,joints,contacts,other_contacts,ms,other_ms,ratio,ratio_of_minima,asked_ratio";

    /** Circles and springs of a blob. */
    static final int RING = 24;

    static final int SPRINGS = RING + RING + RING / 2;
    private static final float BLOB = 2;
    private static final float SKIN = 0.24f;
    private static final float PITCH = 4.6f;

    private static final int LINKS = 100;
    private static final float RADIUS = 0.49f;
    private static final int SETTLING = 300;

    private JointCosts() {}

    /**
     * Prints what joints cost.
     *
     * @param arguments as {@link #run}
     */
    public static void main(String[] arguments) {
        InTurn.main(arguments, JointCosts::run);
    }

    /**
     * Prints what joints cost.
     *
     * @param arguments a name of {@link Backend}, numbers of circles and cases; by default JVM, 24000 circles of blobs and 15000 beside a bridge
     * @param out takes the lines of a CSV file
     * @throws IllegalArgumentException where the arguments are others
     */
    public static void run(List<String> arguments, PrintStream out) {
        InTurn.Arguments asked = InTurn.Arguments.read(arguments, 0, CASES);
        out.println(HEADER);
        for (int n : asked.sizes()) {
            for (String each : asked.cases()) {
                int usual = each.equals("blobs") ? 24_000 : 15_000;
                compare(each, asked.backend(), n == 0 ? usual : n, InTurn.WARM_ROUNDS, InTurn.ROUNDS, out);
            }
        }
    }

    static void compare(String what, Backend backend, int n, int warm, int rounds, PrintStream out) {
        try (World with = world(what, true, backend, n);
                World other = world(what, false, backend, n)) {
            InTurn times = InTurn.measure(with, other, SETTLING, warm, rounds);
            out.printf(
                    Locale.ROOT,
                    "%s,\"%s\",%d,%d,%d,%d,%.4f,%.4f,%.3f,%.3f,%s%n",
                    what,
                    with.stats().device(),
                    with.size(),
                    with.joints().size(),
                    with.stats().contacts(),
                    other.stats().contacts(),
                    times.median(),
                    times.otherMedian(),
                    times.ratio(),
                    times.ratioOfMinima(),
                    what.equals("bridge") ? "1.1" : with.stats().backend() == Backend.JVM ? "1.6" : "2.5");
            out.flush();
        }
    }

    static World world(String what, boolean joined, Backend backend, int n) {
        switch (what) {
            case "blobs":
                return blobs(backend, n / RING, joined);
            case "bridge":
                return bridge(backend, n, joined);
            default:
                throw new IllegalArgumentException("there is no case '" + what + "'; there are " + CASES);
        }
    }

    private static World build(Backend backend, float width, float height, int n) {
        World.Builder builder = World.builder()
                .bounds(0, 0, width, height)
                .gravity(0, -10)
                .capacity(n)
                .backend(backend);
        return (backend == Backend.JVM ? builder.threads(2) : builder).build();
    }

    /** Soft rings in rows and columns, which fall onto each other; or their circles alone, which make a pile. */
    static World blobs(Backend backend, int blobs, boolean joined) {
        int columns = (int) Math.ceil(Math.sqrt(2.5 * blobs));
        int rows = (blobs + columns - 1) / columns;
        World world = build(backend, PITCH * columns + 1, PITCH * rows + 5, RING * blobs);
        float[] circles = new float[4 * RING];
        long[] ring = new long[RING];
        for (int i = 0; i < blobs; i++) {
            for (int k = 0; k < RING; k++) {
                double angle = 2 * Math.PI * k / RING;
                circles[4 * k] = 0.5f + PITCH * (i % columns + 0.5f) + BLOB * (float) Math.cos(angle);
                circles[4 * k + 1] = 0.5f + PITCH * (i / columns + 0.5f) + BLOB * (float) Math.sin(angle);
                circles[4 * k + 2] = SKIN;
                circles[4 * k + 3] = 1;
            }
            world.addAll(circles, ring);
            if (joined) {
                join(world, ring, 1, RING, Joint.spring(10, 0.7f));
                join(world, ring, 2, RING, Joint.spring(10, 0.7f));
                join(world, ring, RING / 2, RING / 2, Joint.spring(4, 0.7f));
            }
        }
        return world;
    }

    /** Joins the first circles of a ring to those so many places on. */
    private static void join(World world, long[] ring, int places, int count, Joint joint) {
        long[] others = new long[count];
        for (int k = 0; k < count; k++) {
            others[k] = ring[(k + places) % RING];
        }
        world.joints().addAll(Arrays.copyOf(ring, count), others, joint, null);
    }

    /** A lattice on the lowest wall, and a row of circles above it: a bridge between two places of the world, or loose. */
    private static World bridge(Backend backend, int n, boolean joined) {
        int loose = Math.max(n - LINKS, LINKS);
        int columns = Math.max((int) (2 * Math.sqrt(loose)), LINKS + 20);
        int height = loose / columns + 1;
        World world = build(backend, columns, 2f * height + 40, loose + LINKS);
        for (int i = 0; i < loose; i++) {
            world.add(0.5f + i % columns, 0.5f + i / columns, RADIUS, 1);
        }
        float left = (columns - LINKS) / 2f - 1;
        float y = height + 25f;
        long[] links = new long[LINKS];
        for (int k = 0; k < LINKS; k++) {
            links[k] = world.add(left + k + 1, y, RADIUS, 1);
        }
        if (joined) {
            Joint link = Joint.distance();
            world.joints().add(links[0], left, y, link);
            world.joints().add(links[LINKS - 1], left + LINKS + 1, y, link);
            long[] first = Arrays.copyOf(links, LINKS - 1);
            world.joints().addAll(first, Arrays.copyOfRange(links, 1, LINKS), link, null);
        }
        return world;
    }
}
