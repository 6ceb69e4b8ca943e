package io.github.circles2d;

import io.github.circles2d.opencl.OpenCl;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.scenes.Scenes;
import io.github.circles2d.world.device.DevicePipeline;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.shared.Mover;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.snapshots.SavedState;
import java.util.Arrays;
import java.util.Locale;
import java.util.Set;

/**
 * Measures worlds that move, on the best OpenCL device. A frame is a step and a read of all circles.
 *
 * <pre>
 * MovingFigures start 50000 30 AUTO  the first frames of a world by AUTO, for so many seconds; in another JVM the same with JVM
 * MovingFigures moves 10000 100000 1000000   what a move to the device and back takes, behind a rehearsal as a world by AUTO has it
 * MovingFigures unrehearsed 10000            the same without one
 * </pre>
 */
public final class MovingFigures {
    private static final int THREADS = World.Builder.defaultThreads();

    /** Frames behind which a start says what they took. */
    private static final Set<Integer> MEANS = Set.of(1, 10, 50, 100, 200, 400);

    private MovingFigures() {}

    public static void main(String[] arguments) throws InterruptedException {
        switch (arguments[0]) {
            case "start" ->
                start(Integer.parseInt(arguments[1]), Integer.parseInt(arguments[2]), Backend.valueOf(arguments[3]));
            case "moves", "unrehearsed" ->
                Arrays.stream(arguments)
                        .skip(1)
                        .mapToInt(Integer::parseInt)
                        .forEach(circles -> moves(circles, arguments[0].equals("moves")));
            default -> throw new IllegalArgumentException("start, moves or unrehearsed, not " + arguments[0]);
        }
    }

    private static void say(String format, Object... values) {
        System.out.println(String.format(Locale.ROOT, format, values));
    }

    // ---- the first frames

    private static void start(int circles, int seconds, Backend backend) {
        Scene scene = Scenes.packed(circles, Scenes.SEED);
        float[] read = new float[4 * circles];
        long begin = System.nanoTime();
        World world = WorldScenes.world(scene, WorldScenes.builder(scene).backend(backend));
        frame(world, scene, read);
        say(
                "%,d circles by %s: first frame %.3f s after the builder",
                circles, backend, (System.nanoTime() - begin) * 1e-9);
        long end = begin + seconds * 1_000_000_000L;
        double worst = 0;
        double sum = 0;
        int frames = 0;
        int moves = 0;
        while (System.nanoTime() < end) {
            double millis = frame(world, scene, read);
            worst = Math.max(worst, millis);
            sum += millis;
            frames++;
            WorldStats stats = frames % 10 == 0 ? world.stats() : null;
            boolean moved = stats != null && stats.moves() > moves;
            if (moved || MEANS.contains(frames)) {
                say(
                        "%.1f s: %s since the start %,d frames, mean %.2f ms, worst since the last line %.2f ms",
                        (System.nanoTime() - begin) * 1e-9, world.stats().backend(), frames, sum / frames, worst);
                worst = 0;
            }
            if (moved) {
                moves = stats.moves();
                say("moves took %.2f ms; %s", stats.moveMillis(), stats.reason());
            }
        }
        say("at the end %s: worst since the last line %.2f ms", world.stats(), worst);
        world.close();
    }

    /** Makes a frame, and returns its milliseconds. */
    private static double frame(World world, Scene scene, float[] read) {
        long begin = System.nanoTime();
        world.step(scene.timeStep());
        world.read(read);
        return (System.nanoTime() - begin) * 1e-6;
    }

    // ---- the cost of a move

    /** Moves before each fourth step, to the device and back. */
    private static final class ToAndFro implements Mover {
        private final Pipeline home;
        private final Pipeline device;
        private SavedState memory;
        private int calls;
        private final double[] least = {Double.MAX_VALUE, Double.MAX_VALUE};
        private final double[] first = {0, 0};

        ToAndFro(Pipeline home, Pipeline device, SavedState memory) {
            this.home = home;
            this.device = device;
            this.memory = memory;
        }

        @Override
        public SavedState takeMemory() {
            SavedState taken = memory;
            memory = null;
            return taken;
        }

        @Override
        public Pipeline choose(Pipeline now, Readiness wanted, int circles, int awake, double nanos) {
            device.compile(wanted);
            return calls++ / 4 % 2 == 0 ? home : device;
        }

        @Override
        public Pipeline home() {
            return home;
        }

        @Override
        public boolean isHome(Pipeline pipeline) {
            return pipeline == home;
        }

        @Override
        public void moved(Pipeline from, Pipeline to, long nanos, Throwable cause) {
            int way = to == device ? 0 : 1;
            first[way] = first[way] == 0 ? nanos * 1e-6 : first[way];
            least[way] = Math.min(least[way], nanos * 1e-6);
        }

        @Override
        public void refused(Pipeline chosen, Throwable why) {
            throw new IllegalStateException(why);
        }

        @Override
        public void lost(Pipeline failed, Throwable why) {
            throw new IllegalStateException(why);
        }

        @Override
        public void close() {
            home.close();
            device.close();
        }
    }

    private static void moves(int circles, boolean rehearsed) {
        Scene scene = Scenes.packed(circles, Scenes.SEED);
        Pipeline home = new JvmPipeline(THREADS, JvmPipeline.LEAST_SHARE, circles, false);
        Pipeline device = new DevicePipeline(OpenCl.bestDevice(), circles, false, true);
        device.compile(Readiness.USUAL);
        SavedState memory = rehearsed ? Rehearsal.of(device, Readiness.USUAL, circles + circles / 4, () -> true) : null;
        ToAndFro moves = new ToAndFro(home, device, memory);
        try (World world = new World(WorldScenes.builder(scene), new BackendChoice(Backend.JVM, home, "measured"))) {
            WorldScenes.load(scene, world);
            world.simulation().moves.by(moves);
            float[] read = new float[4 * circles];
            double[] behind = {Double.MAX_VALUE, Double.MAX_VALUE};
            double[] first = {0, 0};
            for (int frame = 0; frame < 80; frame++) {
                double millis = frame(world, scene, read);
                if (frame >= 4 && frame % 4 == 0) {
                    int way = frame / 4 % 2 == 1 ? 0 : 1;
                    first[way] = first[way] == 0 ? millis : first[way];
                    behind[way] = Math.min(behind[way], millis);
                }
            }
            say(
                    "%,d circles: to the device %.2f ms, the first %.2f; frames with it %.2f, the first %.2f;"
                            + " back %.2f ms, the first %.2f; frames with it %.2f, the first %.2f",
                    circles,
                    moves.least[0],
                    moves.first[0],
                    behind[0],
                    first[0],
                    moves.least[1],
                    moves.first[1],
                    behind[1],
                    first[1]);
        }
    }
}
