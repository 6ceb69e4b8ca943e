package io.github.circles2d.world.jvm.solver;

import static io.github.circles2d.world.model.CircleRow.IMPULSE_X;
import static io.github.circles2d.world.model.CircleRow.IMPULSE_Y;
import static io.github.circles2d.world.model.CircleRow.INVERSE_MASS;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.SPIN_IMPULSE;
import static io.github.circles2d.world.model.CircleRow.SURFACE_SPEED;
import static io.github.circles2d.world.model.CircleRow.VX;
import static io.github.circles2d.world.model.CircleRow.VY;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.SharedInts;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.StepConstants;
import java.util.Arrays;

/**
 * The circles that are heavy in some cross contact, numbered in the order of their slots: how light circles see them in a pass, and what
 * the pass gives them. Each worker has sums of its own, so workers neither wait for each other nor exchange cache lines.
 */
final class HeavyCircles {
    /** Floats per circle of {@link #seen}. */
    private static final int STRIDE = 4;

    static final int SEEN_VX = 0;
    static final int SEEN_VY = 1;

    /** Units per 1 of a velocity. */
    static final int VELOCITY_SCALE = 2;

    /** Units per 1 of an impulse. */
    static final int IMPULSE_SCALE = 3;

    /** Longs per circle of {@link #sums}. */
    private static final int SUMS = 4;

    static final int GAIN_X = 0;
    static final int GAIN_Y = 1;
    static final int SUM_IMPULSE_X = 2;
    static final int SUM_IMPULSE_Y = 3;

    /** Longs per circle of {@link #spinSums}. */
    private static final int SPIN_SUMS = 2;

    static final int GAIN_SPIN = 0;
    static final int SUM_SPIN = 1;

    private final State state;
    private final Team team;

    int count;

    private int[] slot = new int[0];

    /** By number: the velocity in a pass, and the scales of the sums. */
    float[] seen = new float[0];

    /** By worker, by number: what its contacts give, as {@link CrossRule} counts it; 0 between the passes. */
    private final long[][] sums;

    /** By number, if circles can rotate: the surface speed in a pass. */
    float[] seenSurfaceSpeed = new float[0];

    /** As {@link #sums}, if circles can rotate. */
    private final long[][] spinSums;

    /** By number: of the light circles that wait to bounce off it, 1 + the highest id; 0 if there are none. */
    private int[] claim = new int[0];

    HeavyCircles(State state, Team team) {
        this.state = state;
        this.team = team;
        sums = new long[team.most()][0];
        spinSums = new long[team.most()][0];
    }

    static int row(int number) {
        return STRIDE * number;
    }

    static int sum(int number) {
        return SUMS * number;
    }

    static int spinSum(int number) {
        return SPIN_SUMS * number;
    }

    /** Makes room, also for one more, which is still and takes nothing: all that rest are alike. */
    void ensure(int heavy) {
        count = heavy;
        int circles = heavy + 1;
        if (slot.length < circles) {
            int c = circles + (circles >> 2);
            seen = new float[STRIDE * c];
            claim = new int[c];
            slot = new int[c];
        }
        for (int w = 0; w < team.size(); w++) {
            if (sums[w].length < SUMS * circles) {
                sums[w] = new long[SUMS * slot.length];
            }
        }
        Arrays.fill(seen, row(heavy), row(circles), 0f);
        if (state.turning != null) {
            ensureTurning(circles);
            seenSurfaceSpeed[heavy] = 0f;
        }
    }

    private void ensureTurning(int circles) {
        if (seenSurfaceSpeed.length < circles) {
            seenSurfaceSpeed = new float[slot.length];
        }
        for (int w = 0; w < team.size(); w++) {
            if (spinSums[w].length < SPIN_SUMS * circles) {
                spinSums[w] = new long[SPIN_SUMS * slot.length];
            }
        }
    }

    long bytes() {
        long sum = 4L * (slot.length + seen.length + claim.length + seenSurfaceSpeed.length);
        for (int w = 0; w < sums.length; w++) {
            sum += 8L * (sums[w].length + spinSums[w].length);
        }
        return sum;
    }

    void set(int number, int itsSlot) {
        slot[number] = itsSlot;
    }

    /** The number of the first heavy circle in a slot or behind it; how many there are, if there is none. */
    int firstFrom(int leastSlot) {
        int place = Arrays.binarySearch(slot, 0, count, leastSlot);
        return place < 0 ? -1 - place : place;
    }

    long[] sumsOf(int worker) {
        return sums[worker];
    }

    long[] spinSumsOf(int worker) {
        return spinSums[worker];
    }

    /** Finds the scales of the sums. */
    void prepare(int from, int to, StepConstants k) {
        for (int n = from; n < to; n++) {
            int s = CircleRow.of(slot[n]);
            seen[row(n) + VELOCITY_SCALE] = CrossRule.scaleOf(velocityRange(s, k));
            seen[row(n) + IMPULSE_SCALE] = CrossRule.scaleOf(impulseRange(s, k));
        }
        for (int w = 0; w < team.size(); w++) {
            Arrays.fill(sums[w], sum(from), sum(to), 0L);
            if (state.turning != null) {
                Arrays.fill(spinSums[w], spinSum(from), spinSum(to), 0L);
            }
        }
        forgetClaims(from, to);
    }

    /** Claims the next bounce off a heavy circle for a light one. */
    void claim(int number, int idOfLight) {
        int before = SharedInts.get(claim, number);
        while (before <= idOfLight && !SharedInts.compareAndSet(claim, number, before, idOfLight + 1)) {
            before = SharedInts.get(claim, number);
        }
    }

    boolean isClaimedBy(int number, int idOfLight) {
        return claim[number] == idOfLight + 1;
    }

    /** Whether a circle has been claimed; a number below 0 stands for one that is not heavy in any contact. */
    boolean isClaimed(int number) {
        return number >= 0 && claim[number] != 0;
    }

    void forgetClaims(int from, int to) {
        Arrays.fill(claim, from, to, 0);
    }

    private float velocityRange(int s, StepConstants k) {
        return CrossRule.velocityRange(state.circle[s + RADIUS], k.inverseH);
    }

    private float impulseRange(int s, StepConstants k) {
        return CrossRule.impulseRange(state.circle[s + RADIUS], k.inverseH, state.traits[s + INVERSE_MASS]);
    }

    /** Notes the velocities that light circles are to see. */
    void look(int from, int to) {
        float[] m = state.motion;
        for (int n = from; n < to; n++) {
            int s = CircleRow.of(slot[n]);
            seen[row(n) + SEEN_VX] = m[s + VX];
            seen[row(n) + SEEN_VY] = m[s + VY];
            if (state.turning != null) {
                seenSurfaceSpeed[n] = state.turning.spin[s + SURFACE_SPEED];
            }
        }
    }

    /** Adds what a pass has given to the velocities. */
    void takeGains(int from, int to, StepConstants k) {
        for (int n = from; n < to; n++) {
            int s = CircleRow.of(slot[n]);
            long x = take(n, GAIN_X);
            long y = take(n, GAIN_Y);
            if (state.traits[s + INVERSE_MASS] != 0f) {
                float unit = CrossRule.unitOf(velocityRange(s, k));
                state.motion[s + VX] += CrossRule.fromFixed(x, unit);
                state.motion[s + VY] += CrossRule.fromFixed(y, unit);
            }
            if (state.turning != null) {
                takeSpin(n, GAIN_SPIN, SURFACE_SPEED, velocityRange(s, k));
            }
        }
    }

    /** Adds the impulses of a pass to those that the circles begin their next sub-step with. */
    void takeImpulses(int from, int to, StepConstants k) {
        for (int n = from; n < to; n++) {
            int s = CircleRow.of(slot[n]);
            long x = take(n, SUM_IMPULSE_X);
            long y = take(n, SUM_IMPULSE_Y);
            if (state.traits[s + INVERSE_MASS] != 0f) {
                float unit = CrossRule.unitOf(impulseRange(s, k));
                state.load[s + IMPULSE_X] += CrossRule.fromFixed(x, unit);
                state.load[s + IMPULSE_Y] += CrossRule.fromFixed(y, unit);
            }
            if (state.turning != null) {
                takeSpin(n, SUM_SPIN, SPIN_IMPULSE, impulseRange(s, k));
            }
        }
    }

    private void takeSpin(int number, int which, int element, float range) {
        int s = CircleRow.of(slot[number]);
        long sum = take(spinSums, spinSum(number) + which);
        if (state.traits[s + INVERSE_MASS] != 0f) {
            state.turning.spin[s + element] += CrossRule.fromFixed(sum, CrossRule.unitOf(range));
        }
    }

    private long take(int number, int which) {
        return take(sums, sum(number) + which);
    }

    private long take(long[][] of, int place) {
        long sum = 0;
        for (int w = 0; w < team.size(); w++) {
            sum += of[w][place];
            of[w][place] = 0L;
        }
        return sum;
    }
}
