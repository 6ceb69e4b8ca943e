package io.github.circles2d.world.jvm.grid;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import java.util.Random;
import java.util.TreeSet;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@Tag("each-jdk")
class ReachGridTest {
    private static final int MANY = 600;
    private static final float RADIUS = 1;

    private final Random random = new Random(6);
    private final State state = new State();
    private final GridLevels levels = new GridLevels();
    private final Team team = new Team(1);
    private final Grid grid = new Grid(state, levels, team);
    private final ReachGrid reaches = new ReachGrid(state, grid, levels, team);

    @AfterEach
    void close() {
        team.close();
    }

    /** Circles that fly through the whole arena, or through a part of it, and some that rest. */
    @ParameterizedTest
    @CsvSource({
        "WALL, WALL, 100, 60",
        "WRAP, WALL, 100, 60",
        "WRAP, WRAP, 100, 60",
        "WRAP, OPEN, 300, 60",
        "WRAP, WRAP, 300, 40",
        "OPEN, WALL, 1000, 60",
        "WALL, WRAP, 400, 20"
    })
    void findsEachPairInWhichOneReachesFarAboutOnce(AxisEdge x, AxisEdge y, float side, float longest) {
        build(new Bounds(-7, 3, side - 7, side + 3, x, y), longest);
        TreeSet<Integer> seen = new TreeSet<>();
        int found = 0;
        for (int slot = 0; slot < MANY; slot++) {
            boolean looks = grid.path[slot] > 0;
            int count = reaches.find(0, slot, looks);
            for (int k = 0; k < count; k++) {
                int other = reaches.hits(0)[k];
                seen.add(pair(slot, other));
                found += other == slot ? 0 : 1;
            }
        }
        TreeSet<Integer> missed = new TreeSet<>();
        int expected = 0;
        for (int slot = 0; slot < MANY; slot++) {
            for (int other = 0; other < slot; other++) {
                if (areNear(slot, other) && (isFar(slot) || isFar(other))) {
                    expected++;
                    if (!seen.contains(pair(slot, other))) {
                        missed.add(pair(slot, other));
                    }
                }
            }
        }
        assertThat(missed).isEmpty();
        assertThat(expected).isGreaterThan(MANY);
        assertThat(found).isLessThan(expected + expected / 4);
    }

    private boolean isFar(int slot) {
        return grid.path[slot] > 0 && reaches.reaches()[slot] > reaches.farIn(0);
    }

    private boolean areNear(int slot, int other) {
        float dx = state.differenceX(slot, other);
        float dy = state.differenceY(slot, other);
        float sum = reaches.reaches()[slot] + reaches.reaches()[other];
        return dx * dx + dy * dy < sum * sum;
    }

    private static int pair(int a, int b) {
        return Math.min(a, b) * MANY + Math.max(a, b);
    }

    private void build(Bounds bounds, float longest) {
        int[] counts = new int[GridLevels.COUNT];
        counts[0] = MANY;
        levels.layOut(bounds, RADIUS, counts, false);
        state.ensure(MANY);
        state.n = MANY;
        state.awake = MANY;
        state.wraps = bounds.wraps();
        state.periodX = bounds.periodX();
        state.periodY = bounds.periodY();
        grid.ensure();
        for (int slot = 0; slot < MANY; slot++) {
            int s = CircleRow.of(slot);
            state.circle[s + CircleRow.X] = bounds.minX() + random.nextFloat() * (bounds.maxX() - bounds.minX());
            state.circle[s + CircleRow.Y] = bounds.minY() + random.nextFloat() * (bounds.maxY() - bounds.minY());
            state.circle[s + CircleRow.RADIUS] = RADIUS;
            state.traits[s + CircleRow.INVERSE_MASS] = 1;
            grid.path[slot] = slot % 5 == 0 ? 0 : longest * (1 - 0.7f * random.nextFloat());
        }
        reaches.ensure();
        reaches.clear(0);
        reaches.add(0, MANY);
    }
}
