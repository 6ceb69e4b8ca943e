package io.github.circles2d.fuzz;

import io.github.circles2d.Backend;
import io.github.circles2d.BodyQueries;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Queries;
import io.github.circles2d.RandomMoves;
import io.github.circles2d.Replay;
import io.github.circles2d.Rollback;
import io.github.circles2d.TerrainQueries;
import io.github.circles2d.World;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/** Runs a program in worlds on several back ends side by side, and compares all that they say. */
final class Session implements AutoCloseable {
    private static final Set<Class<?>> STEPPING = Set.of(World.class, FixedStep.class, Rollback.class);
    private static final Set<String> STEPS = Set.of("step", "advance", "reconcile", "restore");

    /** Of so many programs one has a world that moves to a device, which compiles for it alone. */
    private static final int SELDOM_ON_DEVICE = 4;

    private final Api api;
    private final Program program;
    private final Reading reading;
    private final List<Player> players = new ArrayList<>();

    /** The line that runs. */
    private int at;

    /** How many steps, calls and refusals there have been. */
    private final Counts counts;

    /** Worlds on the JVM with such numbers of threads, on devices, and one that moves between those. */
    Session(Api api, Program program, int[] threads, Backend[] devices, Ready ready, Counts counts) throws Throwable {
        this.api = api;
        this.program = program;
        this.counts = counts;
        reading = new Reading(api);
        try {
            for (int n : threads) {
                add(Backend.JVM, n, ready, null);
            }
            Backend[] beside = devices;
            for (Backend device : beside) {
                add(device, 0, ready, null);
            }
            add(Backend.JVM, 2, ready, world -> move(world, beside, ready));
            for (int k = 0; k < players.size(); k++) {
                players.get(k).next = players.get((k + 1) % players.size());
            }
        } catch (Throwable e) {
            close();
            throw e;
        }
    }

    private void add(Backend backend, int threads, Ready ready, Consumer<World> moving) throws Throwable {
        players.add(new Player(api, program.setting, backend, threads, players.size(), ready, moving));
    }

    private void move(World world, Backend[] devices, Ready ready) {
        if (devices.length == 0 || program.seed % SELDOM_ON_DEVICE != 0) {
            RandomMoves.of(world, program.seed, 2);
            return;
        }
        RandomMoves moves = RandomMoves.of(world, program.seed, Player.device(devices[0]), Integer.MAX_VALUE);
        if (ready == Ready.FOR_ALL) {
            moves.readyForAll();
        }
    }

    @Override
    public void close() throws IOException {
        for (Player player : players) {
            player.close();
        }
    }

    /** Runs some of the lines; returns what is wrong, or null. */
    Mismatch failure(BitSet kept) {
        try {
            for (at = kept.nextSetBit(0); at >= 0; at = kept.nextSetBit(at + 1)) {
                Line line = program.lines.get(at);
                if (run(line) && isStep(line.method())) {
                    counts.steps++;
                    observe();
                }
            }
            at = program.lines.size();
            end();
            return null;
        } catch (Mismatch mismatch) {
            return mismatch.at(at);
        } catch (Throwable e) {
            return new Mismatch("an exception behind a call", e).at(at);
        }
    }

    /** Whether a method makes steps, or takes their place. */
    static boolean isStep(Method method) {
        return STEPPING.contains(method.getDeclaringClass()) && STEPS.contains(method.getName());
    }

    // ---- a call

    /** Makes a call in each world; returns whether it has been taken. */
    private boolean run(Line line) throws Throwable {
        Player first = players.get(0);
        if (line.method().getDeclaringClass() == io.github.circles2d.Recording.class && first.recording == null) {
            return false;
        }
        Object receiver = line.receiver() == null ? null : line.receiver().find(first);
        Object[] arguments = Values.find(line.arguments(), first);
        Player checked = line.checked() ? players.get(at % players.size()) : null;
        List<Object> before = checked == null ? null : stateAndLog(checked);
        String expected = null;
        boolean taken = true;
        for (Player player : players) {
            Answer answer = answer(line, player, receiver, arguments);
            counts.calls++;
            taken = answer.taken;
            if (player == first) {
                expected = answer.text;
            } else if (!answer.text.equals(expected)) {
                throw differs(line.method().getName(), line.toString(), first, expected, player, answer.text);
            }
        }
        if (!taken) {
            counts.refused++;
            if (before != null && !before.equals(stateAndLog(checked))) {
                throw new Mismatch("a refused call has changed something", checked.name + ": " + line + " " + expected);
            }
        }
        return taken;
    }

    private record Answer(boolean taken, String text) {}

    private Answer answer(Line line, Player player, Object receiver, Object[] found) {
        try {
            Object of = line.receiver() == null ? null : line.receiver().on(player, receiver);
            Object[] arguments = Values.on(line.arguments(), player, found);
            Object result = api.call(line.method(), of, arguments);
            player.keep(result);
            StringBuilder text = new StringBuilder(isOwn(line) ? "" : reading.of(result));
            for (Object argument : arguments) {
                text.append('\n').append(isOwn(line) ? "" : reading.of(argument));
            }
            return new Answer(true, text.toString());
        } catch (IllegalArgumentException | IllegalStateException e) {
            if (e.getMessage() == null || e.getMessage().contains("lost its state")) {
                throw new Mismatch(player.name + " in " + line.method().getName(), e);
            }
            return new Answer(false, e.getClass().getSimpleName() + ": " + e.getMessage());
        } catch (Throwable e) {
            throw new Mismatch(player.name + " in " + line.method().getName(), e);
        }
    }

    /** Whether what a method gives depends on the room that a world has, or on the reads of it so far: a log is written late. */
    private static boolean isOwn(Line line) {
        return line.method().getName().equals("bytes");
    }

    private static Mismatch differs(
            String what, String where, Player first, String expected, Player player, String found) {
        int k = 0;
        while (k < Math.min(expected.length(), found.length()) && expected.charAt(k) == found.charAt(k)) {
            k++;
        }
        int from = Math.max(0, k - 80);
        return new Mismatch(
                what + " differs",
                where + "\n" + first.name + " gives ..." + cut(expected, from) + "\n" + player.name + " gives ..."
                        + cut(found, from));
    }

    private static String cut(String text, int from) {
        return text.substring(from, Math.min(text.length(), from + 400));
    }

    /** What a call that is refused must not change. */
    private static List<Object> stateAndLog(Player player) {
        return List.of(state(player), player.recording == null ? 0L : player.recording.bytes());
    }

    /** What a call that lacks memory must not change: its row in the log may be there already. */
    static List<Object> state(Player player) {
        return List.of(
                player.snapshot(),
                player.world.hash(),
                player.world.idLimit(),
                player.world.joints().idLimit(),
                player.world.bodies().idLimit(),
                player.world.terrain().idLimit());
    }

    // ---- after a step

    /** Compares what can be read after a step. Reads settle a world, so each but the hash is left out at times. */
    private void observe() throws Throwable {
        Draw draw = new Draw(Program.random(program.seed, 100_000 + at), program.setting);
        compare("the hash", player -> player.world.hash());
        if (draw.oneOf(2)) {
            compare("the snapshot", Session::bytes);
        }
        if (draw.oneOf(3)) {
            compare("events", player -> Soundness.require(player.world.events()));
            compare("body events", player -> player.world.bodies().events());
            compare("joint events", player -> player.world.joints().events());
        }
        if (draw.oneOf(3)) {
            compare("forces of joints", Session::forces);
        }
        if (draw.oneOf(6)) {
            Soundness.require(players.get(0).world, line());
            compare("bytes of the log", player -> player.recording == null ? 0 : player.recording.bytes());
            for (Entry entry : Table.ALL) {
                Class<?> of = entry.method().getDeclaringClass();
                boolean isRead = of == Queries.class
                        || of == TerrainQueries.class
                        || of == BodyQueries.class
                        || isFrame(of, entry);
                if (isRead || entry.method().getName().equals("readLoadsById")) {
                    run(entry.draw(draw));
                }
            }
        }
    }

    private static boolean isFrame(Class<?> of, Entry entry) {
        return of == FixedStep.class
                && entry.weight() > 2
                && !entry.method().getName().equals("advance");
    }

    @FunctionalInterface
    private interface Look {
        Object at(Player player) throws Throwable;
    }

    private void compare(String what, Look look) throws Throwable {
        Player first = players.get(0);
        String expected = reading.of(look.at(first));
        for (Player player : players) {
            String found = reading.of(look.at(player));
            if (player != first && !found.equals(expected)) {
                throw differs(what, "after line " + at + ", " + line(), first, expected, player, found);
            }
        }
    }

    private String line() {
        return at >= 0 && at < program.lines.size() ? program.lines.get(at).toString() : "the end";
    }

    private static Object bytes(Player player) {
        byte[] bytes = player.snapshot().array();
        int[] ints = new int[bytes.length];
        for (int k = 0; k < ints.length; k++) {
            ints[k] = bytes[k];
        }
        return ints;
    }

    static Object forces(Player player) {
        io.github.circles2d.Joints joints = player.world.joints();
        float[] forces = new float[4 * joints.idLimit()];
        for (int id = 0; id < joints.idLimit(); id++) {
            long joint = joints.handle(id);
            if (joint != 0) {
                forces[4 * id] = joints.forceX(joint);
                forces[4 * id + 1] = joints.forceY(joint);
                forces[4 * id + 2] = joints.force(joint);
                forces[4 * id + 3] = joints.torque(joint);
            }
        }
        return forces;
    }

    // ---- at the end

    private void end() throws Throwable {
        compare("the hash at the end", player -> player.world.hash());
        compare("the snapshot at the end", Session::bytes);
        if (program.setting.recorded) {
            for (Player player : players) {
                api.named(player.recording, "close");
            }
            compare("the log", player -> ByteBuffer.wrap(player.log.toByteArray())
                    .position(player.log.size()));
            Object hash = players.get(0).world.hash();
            compare("the replay", this::replay);
            for (Player player : players) {
                if (!hash.equals(player.world.hash())) {
                    throw new Mismatch("a replay ends elsewhere", player.name);
                }
            }
        }
        for (Player player : players) {
            api.named(player.world, "close");
        }
    }

    /** Plays the log of another world. */
    private Object replay(Player player) throws Throwable {
        Replay replay = new Replay(new ByteArrayInputStream(player.next.log.toByteArray()), player.world);
        api.named(replay, "step");
        api.named(player.fixedStep, "advanceReplay", 0.02f, replay);
        api.named(replay, "run");
        Object said = api.named(replay, "difference");
        if ((Boolean) api.named(replay, "differs")) {
            throw new Mismatch("a replay differs", player.name + ": " + said);
        }
        return Arrays.toString(new Object[] {
            api.named(replay, "steps"),
            api.named(replay, "hasEnded"),
            api.named(replay, "firstDifference"),
            api.named(replay, "equalUpTo")
        });
    }
}
