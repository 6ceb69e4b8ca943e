package io.github.circles2d;

import io.github.circles2d.MemoryCalls.Call;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Ends memory at each allocation of each call, and compares what is left with a world that never met the error. {@link AllocationLimitLoader} loads it. */
public final class MemoryEndsAnywhere {
    private static final int MOST_REPORTS = 20;

    /** Calls of a program. */
    private static final int CALLS = 40;

    private static final List<Call> ALL = MemoryCalls.all();
    private static final List<Call> STEPS = ALL.stream().filter(Call::steps).toList();

    /** Few circles or a rich world; and whether changes wait. */
    private static final int VARIANTS = 4;

    private final List<String> wrong = new ArrayList<>();
    private int ended;
    private final ByteBuffer more = MemoryScene.snapshot(true);
    private final ByteBuffer fewer = MemoryScene.snapshot(false);
    private final boolean verbose;

    private MemoryEndsAnywhere(boolean verbose) {
        this.verbose = verbose;
    }

    /**
     * Prints what is wrong, and where memory ended.
     *
     * @param args {@code each}, the threads, the stride and a part of the names of calls; or {@code programs}, the first seed and the number
     */
    public static void main(String[] args) {
        MemoryEndsAnywhere run = new MemoryEndsAnywhere(true);
        int first = Integer.parseInt(args[1]);
        int second = Integer.parseInt(args[2]);
        if (args[0].equals("each")) {
            run.eachCall(first, second, args.length > 3 ? args[3] : "");
        } else {
            run.programsFrom(first, second);
        }
        System.out.println(run.wrong.size() + " wrong, ended " + run.ended + " times");
    }

    private MemoryScene scene(boolean rich, int threads) {
        return new MemoryScene(rich, threads, false, more.duplicate(), fewer.duplicate());
    }

    private void report(String what) {
        if (wrong.size() < MOST_REPORTS) {
            wrong.add(what);
        }
        if (verbose) {
            System.out.println(what);
        }
    }

    // ---- each call alone

    /**
     * Ends memory at allocations of each call in each scene. Returns what is wrong.
     *
     * @param stride 1 for each allocation, else the distance of those that are tried
     */
    public static List<String> each(int threads, int stride) {
        MemoryEndsAnywhere run = new MemoryEndsAnywhere(false);
        run.eachCall(threads, stride, "");
        run.requireEnds();
        return run.wrong;
    }

    /** So that no test passes since nothing fails. */
    private void requireEnds() {
        if (ended == 0) {
            report("memory has never ended");
        }
    }

    private void eachCall(int threads, int stride, String part) {
        int first = 0;
        for (Call call : ALL) {
            // other threads work in steps alone
            boolean counts = call.name().contains(part) && (threads == 1 || call.steps());
            for (int variant = 0; variant < VARIANTS && counts; variant++) {
                each(call, (variant & 1) != 0, (variant & 2) != 0, threads, first++ % stride, stride);
            }
        }
    }

    private MemoryScene prepared(boolean rich, boolean waiting, int threads) {
        MemoryScene scene = scene(rich, threads);
        if (waiting) {
            Random random = new Random(7);
            scene.addAnywhere(random, 70);
            scene.world.remove(scene.world.handle(2));
            scene.world.joints().add(scene.world.handle(0), scene.world.handle(3), Joint.spring(1, 1));
            scene.world.step(1 / 60f);
            if (rich) {
                scene.world.requestPositions();
                scene.world.takePositionsById(null);
                scene.world.requestPositions();
            } else {
                scene.fixed.radii();
                scene.fixed.angles();
                scene.fixed.pieces(new float[0], null);
            }
            scene.world.requestEvents();
            scene.world.step(1 / 60f);
            scene.addAnywhere(random, 30);
            scene.world.terrain().addSegment(3, 2, 5, 2);
            scene.world.grow(scene.world.handle(1), 0.3f, 3);
            scene.world.applyForce(scene.world.handle(1), 1, 2);
        }
        return scene;
    }

    private static String result(Call call, MemoryScene scene, long seed) {
        try {
            return MemoryScene.text(call.body().run(scene, new Random(seed)));
        } catch (IllegalArgumentException | IllegalStateException e) {
            return e.toString();
        }
    }

    private void each(Call call, boolean rich, boolean waiting, int threads, int first, int stride) {
        String title = call.name() + (rich ? ", rich" : "") + (waiting ? ", waiting" : "") + ", allocation ";
        Outcome unseen = outcome(call, rich, waiting, threads, false);
        Outcome seen = unseen.allocations() > first ? outcome(call, rich, waiting, threads, true) : null;
        for (int k = first; k < unseen.allocations(); k += stride) {
            try (MemoryScene scene = prepared(rich, waiting, threads)) {
                end(call, scene, k, title + k, k % 2 == 0 ? unseen : seen);
            } catch (RuntimeException | Error e) {
                AllocationLimit.end();
                report(title + k + " threw " + e + at(e));
            }
        }
    }

    /** What is seen of a scene before a call, or null, what the call returns, what is seen after it, and how many allocations it has. */
    private record Outcome(String before, String result, String after, int allocations) {}

    /** That of a call in which memory does not end. */
    private Outcome outcome(Call call, boolean rich, boolean waiting, int threads, boolean looks) {
        try (MemoryScene same = prepared(rich, waiting, threads)) {
            String before = looks ? same.look() : null;
            AllocationLimit.after(Integer.MAX_VALUE);
            String result = result(call, same);
            AllocationLimit.end();
            return new Outcome(before, result, later(same), AllocationLimit.count());
        }
    }

    private static String result(Call call, MemoryScene scene) {
        return result(call, scene, call.name().hashCode());
    }

    /** Ends memory in a call, and makes the call again. A call may do without what it found no room for, as for a hash in a log. */
    private void end(Call call, MemoryScene scene, int allocation, String name, Outcome wanted) {
        if (allocation % 3 == 0) {
            AllocationLimit.onceAfter(allocation);
        } else {
            AllocationLimit.after(allocation);
        }
        String result = null;
        OutOfMemoryError thrown = null;
        try {
            result = result(call, scene);
        } catch (OutOfMemoryError e) {
            thrown = e;
        }
        ended += AllocationLimit.end() ? 1 : 0;
        String place = thrown == null ? name : name + at(thrown);
        if (thrown != null && isLost(scene)) {
            if (!call.steps()) {
                report(place + " lost the state");
            }
        } else if (thrown == null) {
            check(place + " result", wanted.result(), result);
        } else if (wanted.before() == null || check(place + " before", wanted.before(), scene.look())) {
            check(place + " result", wanted.result(), result(call, scene));
            check(place + " after", wanted.after(), later(scene));
        }
    }

    private static boolean isLost(MemoryScene scene) {
        try {
            scene.world.gravityX();
            return false;
        } catch (IllegalStateException e) {
            return e.getMessage().contains("lost its state");
        }
    }

    private String at(Throwable e) {
        if (!verbose) {
            return "";
        }
        StringBuilder at = new StringBuilder(" [");
        for (StackTraceElement place : e.getStackTrace()) {
            String name = place.getClassName();
            if (name.startsWith("io.github.circles2d")
                    && !name.contains("AllocationLimit")
                    && !name.contains("Memory")) {
                at.append(name.substring(name.lastIndexOf('.') + 1))
                        .append('.')
                        .append(place.getMethodName())
                        .append(':')
                        .append(place.getLineNumber())
                        .append(' ');
            }
        }
        return at + "]";
    }

    /** What is seen now, and after some steps. */
    private static String later(MemoryScene scene) {
        String now = scene.look();
        scene.world.step(1 / 60f, 2);
        scene.fixed.advance(1 / 60f, null);
        return now + scene.look() + MemoryScene.list(scene.fixed.positions(null));
    }

    private boolean check(String name, String wanted, String got) {
        if (wanted.equals(got)) {
            return true;
        }
        int k = 0;
        int line = 0;
        while (k < Math.min(wanted.length(), got.length()) && wanted.charAt(k) == got.charAt(k)) {
            line = wanted.charAt(k) == '\n' ? k + 1 : line;
            k++;
        }
        report(name + ": not as without the error\n   " + part(wanted, line) + "\n   " + part(got, line));
        return false;
    }

    private static String part(String of, int from) {
        int to = of.indexOf('\n', from);
        String line = of.substring(from, to < 0 ? of.length() : to);
        return line.length() > 150 ? line.substring(0, 150) + "..." : line;
    }

    // ---- programs

    /** Runs programs of random calls in two worlds, in one of which memory ends at random allocations. Returns what is wrong. */
    public static List<String> programs(int firstSeed, int count) {
        MemoryEndsAnywhere run = new MemoryEndsAnywhere(false);
        run.programsFrom(firstSeed, count);
        run.requireEnds();
        return run.wrong;
    }

    private void programsFrom(int firstSeed, int count) {
        for (Call call : ALL) {
            outcome(call, true, false, 1, false); // a class that memory ends in as it begins is of no use from then on
        }
        for (int seed = firstSeed; seed < firstSeed + count; seed++) {
            program(seed);
        }
    }

    private void program(int seed) {
        Random random = new Random(seed);
        boolean rich = random.nextBoolean();
        boolean records = random.nextInt(3) == 0;
        String name = "program " + seed;
        try (MemoryScene scene =
                        new MemoryScene(rich, seed % 4 == 0 ? 2 : 1, records, more.duplicate(), fewer.duplicate());
                MemoryScene same = new MemoryScene(rich, 1, records, more.duplicate(), fewer.duplicate())) {
            boolean goesOn = true;
            for (int k = 0; k < CALLS && goesOn; k++) {
                List<Call> some = random.nextInt(4) == 0 ? STEPS : ALL;
                Call call = some.get(random.nextInt(some.size()));
                goesOn = call(call, random, scene, same, name + ", call " + k + ": " + call.name());
            }
            if (records && goesOn) {
                String replay = scene.replay();
                if (!replay.startsWith("the log ends early")) { // as it does behind a step that was not made
                    check(name + " log", same.replay(), replay);
                }
            }
        } catch (RuntimeException | Error e) {
            AllocationLimit.end();
            report(name + " threw " + e + at(e));
        }
    }

    /** Makes a call in two worlds, in one of which memory may end. Returns whether both are alike. */
    private boolean call(Call call, Random random, MemoryScene scene, MemoryScene same, String name) {
        long seed = random.nextLong();
        int limit = random.nextInt(3) == 0 ? Integer.MAX_VALUE : random.nextInt(1 << random.nextInt(6));
        boolean repeats = random.nextBoolean() | call.isOfLoop();
        boolean looks = random.nextBoolean();
        AllocationLimit.after(limit);
        Throwable thrown = null;
        String got = null;
        try {
            got = result(call, scene, seed);
        } catch (OutOfMemoryError e) {
            thrown = e;
        }
        boolean endedNow = AllocationLimit.end();
        ended += endedNow ? 1 : 0;
        String place = thrown == null ? name : name + at(thrown);
        if (thrown != null && isLost(scene)) {
            if (!call.steps()) {
                report(place + " lost the state");
            }
            return false;
        }
        boolean alike = true;
        if (thrown == null || repeats) {
            got = thrown == null ? got : result(call, scene, seed);
            alike = check(place, result(call, same, seed), got);
        }
        if (endedNow && call.steps()) {
            for (MemoryScene each :
                    List.of(scene, same)) { // a frame that ends early leaves other positions, and a request
                each.fixed.reset();
                each.world.requestPositions();
            }
        }
        return alike && (!looks || check(place, same.look(), scene.look()));
    }
}
