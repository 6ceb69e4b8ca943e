package io.github.circles2d.fuzz;

import io.github.circles2d.Backend;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Recording;
import io.github.circles2d.Replay;
import io.github.circles2d.Rollback;
import io.github.circles2d.World;
import io.github.circles2d.WorldScenes;
import java.io.ByteArrayInputStream;
import java.lang.reflect.InvocationTargetException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;

/**
 * Runs a program in a world in which memory ends in calls, beside a twin that has memory. A call that ends in an OutOfMemoryError has changed
 * nothing and may be made again, or the world says that its state is lost; only what steps may lose it.
 */
final class MemorySession implements AutoCloseable {
    static final MemoryEnd NEVER = new MemoryEnd() {
        @Override
        public void begin(Random random, int attempt) {}

        @Override
        public boolean end() {
            return false;
        }
    };

    private final Program program;
    private final Random random;
    private final Reading reading;
    private final MemoryEnd memory;
    private final Counts counts;
    private final Player tested;
    private final Player twin;
    private int at;

    MemorySession(Api api, Program program, MemoryEnd memory, int threads, Counts counts) throws Throwable {
        this.program = program;
        this.memory = memory;
        this.counts = counts;
        random = Program.random(program.seed, 99);
        reading = new Reading(api);
        twin = new Player(api, program.setting, Backend.JVM, 1, 0, Ready.AS_NEEDED, null);
        tested = new Player(api, program.setting, Backend.JVM, threads, 0, Ready.AS_NEEDED, null);
    }

    @Override
    public void close() {
        tested.world.close();
        twin.world.close();
    }

    /** Runs some lines; returns what is wrong, or null. */
    Mismatch failure(BitSet kept) {
        try {
            boolean goesOn = true;
            for (at = kept.nextSetBit(0); at >= 0 && goesOn; at = kept.nextSetBit(at + 1)) {
                goesOn = run(program.lines.get(at));
            }
            if (goesOn) {
                end();
            }
            return null;
        } catch (Mismatch mismatch) {
            return mismatch.at(at);
        } catch (Throwable e) {
            return new Mismatch("an exception behind a call", e).at(at);
        }
    }

    /** What a call has given. */
    private static final class Answer {
        String text;
        Throwable thrown;
        boolean mayLackMemory;

        boolean lacksMemory() {
            return thrown instanceof OutOfMemoryError;
        }
    }

    /** Makes a call in both worlds; returns whether the program can go on. */
    private boolean run(Line line) throws Throwable {
        Class<?> type = line.method().getDeclaringClass();
        if (type == Recording.class) {
            return true; // a log ends early with a step that lacked memory
        }
        Object receiver = line.receiver() == null ? null : line.receiver().find(twin);
        Object[] arguments = Values.find(line.arguments(), twin);
        int snapshots = tested.snapshots.size();
        Answer answer = null;
        for (int attempt = 0; answer == null || answer.lacksMemory(); attempt++) {
            answer = answer(line, tested, receiver, arguments, at < program.built ? NEVER : memory, attempt);
            counts.calls++;
            if (answer.lacksMemory()) {
                counts.ended++;
                tested.snapshots.subList(snapshots, tested.snapshots.size()).clear();
                if (isLost()) {
                    if (!isStep(line)) {
                        throw new Mismatch("a call that lacked memory has lost the state", at(line, answer.thrown));
                    }
                    counts.stopped++;
                    return false;
                }
                if (isStep(line) && type != World.class) { // a frame ends early
                    counts.stopped++;
                    return type != Rollback.class && takeOver(line);
                }
                if (isStep(line) && !isOneStep(line)) {
                    takeOver(line);
                } else if (random.nextBoolean()) { // else changes still wait when the call is made again
                    requireUnchanged(line, answer.thrown);
                }
            }
        }
        compare(line, answer(line, twin, receiver, arguments, NEVER, 0).text, answer.text);
        if (type == FixedStep.class && answer.mayLackMemory) {
            showNow(); // a frame that finds no room for positions shows none between steps
        }
        return true;
    }

    /** Whether a call makes steps, which may lose the state. */
    static boolean isStep(Line line) {
        return Session.isStep(line.method()) && !line.method().getName().equals("restore");
    }

    private static boolean isOneStep(Line line) {
        return line.method().getName().equals("step") && line.arguments().length == 1;
    }

    /** The call, and where in the library memory ended. */
    private static String at(Line line, Throwable thrown) {
        return Arrays.stream(thrown.getStackTrace())
                .filter(place -> place.getClassName().startsWith(World.class.getPackageName()))
                .skip(1) // who lets it end
                .limit(5)
                .map(StackTraceElement::toString)
                .collect(Collectors.joining(" < ", line + " at ", ""));
    }

    private void requireUnchanged(Line line, Throwable thrown) {
        if (!Session.state(tested).equals(Session.state(twin))) {
            throw new Mismatch("a call that lacked memory has changed something", at(line, thrown));
        }
    }

    /** Some of the steps of a call may have been made. Both go on from there. */
    private boolean takeOver(Line line) {
        ByteBuffer now = tested.snapshot();
        for (Player player : new Player[] {tested, twin}) {
            player.world.restore(now.duplicate());
        }
        showNow();
        compare(line, Long.toString(twin.world.hash()), Long.toString(tested.world.hash()));
        return true;
    }

    /** Loops show what is there, and wait for the same request. */
    private void showNow() {
        for (Player player : new Player[] {tested, twin}) {
            player.fixedStep.reset();
            player.world.requestPositions();
        }
    }

    private boolean isLost() {
        try {
            tested.world.size();
            return false;
        } catch (IllegalStateException e) {
            return true;
        }
    }

    private void compare(Line line, String expected, String found) {
        if (!expected.equals(found)) {
            throw new Mismatch(
                    line.method().getName() + " differs behind calls that lacked memory",
                    line + "\nwith memory: " + expected + "\nwithout: " + found);
        }
    }

    /** Makes a call in which memory may end. */
    private Answer answer(Line line, Player player, Object receiver, Object[] found, MemoryEnd ends, int attempt)
            throws Throwable {
        Answer answer = new Answer();
        Object of = null;
        Object[] arguments = null;
        Object result = null;
        try {
            of = line.receiver() == null ? null : line.receiver().on(player, receiver);
            arguments = Values.on(line.arguments(), player, found);
            ends.begin(random, attempt);
            result = line.method().invoke(of, arguments); // nothing else, which would take memory, too
        } catch (InvocationTargetException e) {
            answer.thrown = e.getCause();
        } catch (OutOfMemoryError | IllegalArgumentException | IllegalStateException e) {
            answer.thrown = e;
        } finally {
            answer.mayLackMemory = ends.end();
        }
        if (answer.thrown == null) {
            player.keep(result);
            StringBuilder text = new StringBuilder(isOwn(line) ? "" : reading.of(result));
            for (Object argument : arguments) {
                text.append('\n').append(isOwn(line) ? "" : reading.of(argument));
            }
            answer.text = text.toString();
        } else if (answer.thrown instanceof IllegalArgumentException
                || answer.thrown instanceof IllegalStateException) {
            answer.text = String.valueOf(answer.thrown);
        } else if (!answer.lacksMemory()) {
            throw new Mismatch("without memory, " + line.method().getName(), answer.thrown);
        }
        return answer;
    }

    private static boolean isOwn(Line line) {
        String name = line.method().getName();
        return name.equals("bytes") || name.equals("stats");
    }

    /** Worlds go on alike, and so do their logs, unless one ended early with a step or a hash that lacked memory. */
    private void end() throws Throwable {
        if (!Session.state(tested).equals(Session.state(twin)) || !next(tested).equals(next(twin))) {
            throw new Mismatch(
                    "a world goes on otherwise behind calls that lacked memory", program.text(program.all()));
        }
        if (tested.recording != null && !tested.recording.hasFailed()) {
            for (Player player : new Player[] {tested, twin}) {
                player.recording.close();
                try (World world = WorldScenes.jvm().threads(1).build()) {
                    Replay replay = new Replay(new ByteArrayInputStream(player.log.toByteArray()), world).run();
                    if (replay.differs()) {
                        throw new Mismatch("a replay differs", replay.difference());
                    }
                }
            }
        }
    }

    /** What is seen after some more steps. */
    private List<Object> next(Player player) throws Throwable {
        World world = player.world;
        world.step(1 / 60f, 2);
        player.fixedStep.advance(1 / 60f, null);
        float[] loads = new float[2 * world.idLimit()];
        world.readLoadsById(loads, null);
        return List.of(
                Session.state(player),
                reading.of(world.events()),
                reading.of(world.joints().events()),
                reading.of(world.bodies().events()),
                reading.of(Session.forces(player)),
                reading.of(loads),
                reading.of(player.fixedStep.positions(null)),
                player.rewind.size());
    }
}
