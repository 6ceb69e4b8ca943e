package io.github.circles2d.fuzz;

import io.github.circles2d.Backend;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Rollback;
import java.lang.reflect.InvocationTargetException;
import java.nio.ByteBuffer;
import java.util.BitSet;
import java.util.Random;

/**
 * Runs a program in a world whose heap is nearly full at most calls, beside a twin that has memory. A call that ends in an OutOfMemoryError has
 * changed nothing, or the world says that its state is lost; only what steps may lose it.
 */
final class MemorySession implements AutoCloseable {
    private static final int MOST_SPARE = 18;

    private final Program program;
    private final Random random;
    private final Reading reading;
    private final Ballast ballast;
    private final Counts counts;
    private final Player tested;
    private final Player twin;
    private int at;

    MemorySession(Api api, Program program, Ballast ballast, int threads, Counts counts) throws Throwable {
        this.program = program;
        this.ballast = ballast;
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

        boolean lacksMemory() {
            return thrown instanceof OutOfMemoryError;
        }
    }

    /** Makes a call in both worlds; returns whether the program can go on. */
    private boolean run(Line line) throws Throwable {
        Class<?> type = line.method().getDeclaringClass();
        boolean isAny = type != io.github.circles2d.Recording.class || twin.recording != null;
        if (!isAny) {
            return true;
        }
        Object receiver = line.receiver() == null ? null : line.receiver().find(twin);
        Object[] arguments = Values.find(line.arguments(), twin);
        ByteBuffer before = random.nextBoolean() ? tested.snapshot() : null;
        boolean isShort = random.nextInt(3) == 0;
        Answer answer = answer(line, tested, receiver, arguments, isShort ? 1 << random.nextInt(MOST_SPARE) : -1);
        counts.calls++;
        if (!answer.lacksMemory()) {
            Answer expected = answer(line, twin, receiver, arguments, -1);
            compare(line, expected.text, answer.text);
            return true;
        }
        counts.ended++;
        boolean steps = Session.isStep(line.method());
        if (isLost()) {
            if (!steps) {
                throw new Mismatch("a call that lacked memory has lost the state", line + " " + answer.thrown);
            }
            return false;
        }
        if (type == FixedStep.class || type == Rollback.class) {
            return false; // some steps may have been made
        }
        if (line.method().getName().equals("step")) {
            return takeOver();
        }
        if (before != null && !before.equals(tested.snapshot())) {
            throw new Mismatch("a call that lacked memory has changed something", line + " " + answer.thrown);
        }
        compare(line, Long.toString(twin.world.hash()), Long.toString(tested.world.hash()));
        return true;
    }

    /** Some of the steps of a call may have been made. The twin goes on from there. */
    private boolean takeOver() {
        ByteBuffer now = tested.snapshot();
        tested.world.restore(now.duplicate());
        twin.world.restore(now);
        return twin.world.hash() == tested.world.hash();
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

    /** Makes a call while the heap is full but for some bytes; -1: while it is not. */
    private Answer answer(Line line, Player player, Object receiver, Object[] found, int spare) throws Throwable {
        Answer answer = new Answer();
        Object of = null;
        Object[] arguments = null;
        Object result = null;
        try {
            of = line.receiver() == null ? null : line.receiver().on(player, receiver);
            arguments = Values.on(line.arguments(), player, found);
            if (spare >= 0) {
                ballast.fill(spare);
            }
            result = line.method().invoke(of, arguments); // nothing else, which would take memory, too
        } catch (InvocationTargetException e) {
            answer.thrown = e.getCause();
        } catch (OutOfMemoryError | IllegalArgumentException | IllegalStateException e) {
            answer.thrown = e;
        } finally {
            ballast.release();
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

    /** The classes that a program loads only once; memory that ends there would end them for good. */
    static void warmUp(Api api, Ballast ballast, Counts counts, int programs) throws Throwable {
        for (long seed = 0; seed < programs; seed++) {
            Program program = new Program(-1 - seed);
            try (Session session =
                    new Session(api, program, new int[] {1, 2}, new Backend[0], Ready.AS_NEEDED, counts)) {
                Mismatch mismatch = session.failure(program.all());
                if (mismatch != null) {
                    throw mismatch;
                }
            }
        }
        ballast.fill(0);
        ballast.release();
    }
}
