package io.github.circles2d;

import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.DeviceMemoryException;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.device.DevicePipeline;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.shared.Mover;
import io.github.circles2d.world.shared.Pipeline;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;

/** Moves a world at random steps: between pipelines on the JVM, some of which are new, and to a device and back. */
public final class RandomMoves implements Mover {
    /** A world moves before one call of step in so many. */
    private static final int SELDOM = 3;

    private static final int CIRCLES_OF_REHEARSALS = 40;

    private final Random random;
    private final int threads;
    private final Pipeline home;

    /** Null if the world stays on the JVM, or the device has failed. */
    private Pipeline device;

    /** How many variants of kernels the device may compile. */
    private int compilations;

    private final List<Pipeline> others = new ArrayList<>();

    private final Set<Pipeline> left = new HashSet<>();
    private int moves;
    private int movesToDevice;
    private int movesOfNeed;
    private int refusals;
    private int losses;
    private Pipeline chosen;

    private RandomMoves(long seed, int threads, Pipeline device, int compilations) {
        random = new Random(seed);
        this.threads = threads;
        this.compilations = compilations;
        this.device = device;
        home = jvm();
        others.add(home);
        others.add(jvm());
    }

    private Pipeline jvm() {
        return new JvmPipeline(threads, 1, 0, false);
    }

    /** Lets a world on the JVM move between pipelines there. */
    public static RandomMoves of(World world, long seed, int threads) {
        return of(world.simulation(), new RandomMoves(seed, threads, null, 0));
    }

    /**
     * Lets a world move to a device, too.
     *
     * @param compilations for how many worlds of different features kernels may be compiled; it stays on the JVM where others are needed
     */
    public static RandomMoves of(World world, long seed, Device device, int compilations) {
        return of(
                world.simulation(), new RandomMoves(seed, 1, new DevicePipeline(device, 0, false, true), compilations));
    }

    /** Lets a world move to a pipeline that may refuse what changes nothing. */
    static RandomMoves of(World world, long seed, Pipeline refusing) {
        return of(world.simulation(), new RandomMoves(seed, 1, refusing, 0));
    }

    private static RandomMoves of(Simulation simulation, RandomMoves moves) {
        simulation.moves.by(moves);
        return moves;
    }

    /** Makes the device ready for all that a world can have inside, so that worlds share kernels. */
    public RandomMoves readyForAll() {
        if (device != null) {
            device.prepare(
                    ContactSettings.DEFAULT.withPushOutSpeed(7),
                    Features.TURNING.and(Features.TERRAIN).and(Features.JOINTS));
        }
        return this;
    }

    /** How often the world has moved. */
    public int moves() {
        return moves;
    }

    /** How often it has moved to the device. */
    public int movesToDevice() {
        return movesToDevice;
    }

    /** How often it went home, since the device refused something or was not ready. */
    int movesOfNeed() {
        return movesOfNeed;
    }

    /** How often the device refused to take it over. */
    int refusals() {
        return refusals;
    }

    @Override
    public Pipeline choose(Pipeline now, Readiness wanted, int circles, int awake, double nanos) {
        chosen = random.nextInt(SELDOM) > 0 ? now : other(now, wanted);
        return chosen;
    }

    private Pipeline other(Pipeline now, Readiness wanted) {
        if (device != null && random.nextBoolean() && isReady(now, wanted)) {
            return device;
        }
        if (now != others.get(1) && random.nextInt(4) == 0) {
            others.set(1, jvm());
        }
        return others.get(random.nextInt(2));
    }

    /** As a world of AUTO does: what is made up leaves no bit there, even on a device that the world has left. */
    private void rehearse(Readiness wanted) {
        int[] rounds = {0};
        Rehearsal.of(device, wanted, CIRCLES_OF_REHEARSALS, () -> rounds[0]++ < 2);
    }

    private boolean isReady(Pipeline now, Readiness wanted) {
        if (!device.isReady(wanted) && compilations > 0) {
            compilations--;
            device.compile(wanted);
            if (now != device) {
                rehearse(wanted);
            }
        }
        return device.isReady(wanted);
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
        moves++;
        movesToDevice += to == device ? 1 : 0;
        movesOfNeed += from == device && to != chosen ? 1 : 0;
        left.add(from);
    }

    @Override
    public void refused(Pipeline chosen, Throwable why) {
        if (chosen != device || !(why instanceof OpenClException)) {
            throw new AssertionError("a move has been refused", why);
        }
        refusals++;
        device = why instanceof DeviceMemoryException ? device : null;
    }

    @Override
    public void lost(Pipeline failed, Throwable why) {
        losses++;
        device = null;
    }

    /** How often a device has lost the state. */
    int losses() {
        return losses;
    }

    @Override
    public void close() {
        left.addAll(others);
        left.forEach(Pipeline::close);
        if (device != null) {
            device.close();
        }
    }
}
