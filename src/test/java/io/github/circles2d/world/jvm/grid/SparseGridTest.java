package io.github.circles2d.world.jvm.grid;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import java.util.Arrays;
import java.util.Random;
import java.util.TreeSet;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("each-jdk")
class SparseGridTest {
    private static final int MANY = 3000;
    private static final float RADIUS = 1e-4f;

    private final Random random = new Random(5);
    private final State state = new State();
    private final GridLevels levels = new GridLevels();
    private final Team team = new Team(1);
    private final Grid grid = new Grid(state, levels, team);
    private final SparseGrid sparse = new SparseGrid(state, grid, levels, team);
    private final float[] reach = new float[MANY];

    @AfterEach
    void close() {
        team.close();
    }

    /** Also circles outside of the walls, and rectangles that are. */
    @Test
    void findsInARectangleWhatATestOfAllCirclesFinds() {
        int found = 0;
        for (Bounds bounds :
                new Bounds[] {new Bounds(0, 0, 1, 1), new Bounds(-3, 2, 500, 2.01f), new Bounds(0, 0, 0.01f, 90)}) {
            build(bounds, 1.02f);
            assertThat(sparse.holds(0)).isTrue();
            for (int slot = 0; slot < MANY; slot++) {
                float x = state.circle[CircleRow.of(slot) + CircleRow.X];
                float y = state.circle[CircleRow.of(slot) + CircleRow.Y];
                float far = 2 * reach[slot] + 0.001f * random.nextInt(100);
                TreeSet<Integer> expected = new TreeSet<>();
                for (int other = 0; other < MANY; other++) {
                    float dx = state.circle[CircleRow.of(other) + CircleRow.X] - x;
                    float dy = state.circle[CircleRow.of(other) + CircleRow.Y] - y;
                    float sum = reach[slot] + reach[other];
                    if (Math.abs(dx) <= far && Math.abs(dy) <= far && dx * dx + dy * dy < sum * sum) {
                        expected.add(other);
                    }
                }
                int count = sparse.find(0, slot, 0, x - far, x + far, y - far, y + far, reach);
                TreeSet<Integer> seen = new TreeSet<>();
                for (int k = 0; k < count; k++) {
                    assertThat(seen.add(sparse.hits(0)[k])).as("found once").isTrue();
                }
                assertThat(seen).containsAll(expected);
                found += expected.size() - 1;
            }
        }
        assertThat(found).isGreaterThan(MANY);
    }

    /** All in few cells, so that threads meet at them; then far apart. */
    @Test
    void threadsFillTheSameCellsAsOneAndDecideAlike() {
        for (float share : new float[] {0.02f, 1}) {
            build(new Bounds(0, 0, 1, 1), share);
            boolean held = sparse.holds(0);
            TreeSet<Integer> expected = slotsOfAll(sparse);
            try (Team three = new Team(3)) {
                SparseGrid shared = new SparseGrid(state, grid, levels, three);
                shared.ensure();
                three.run(3, () -> {
                    three.all(shared::clear);
                    three.all(worker -> shared.add(worker, three.part(MANY, worker), three.part(MANY, worker + 1)));
                    shared.settle();
                });
                assertThat(shared.holds(0)).isEqualTo(held);
                assertThat(slotsOfAll(shared)).hasSize(MANY).isEqualTo(expected);
            }
        }
    }

    /** By a circle that reaches over all. */
    private TreeSet<Integer> slotsOfAll(SparseGrid cells) {
        float own = reach[0];
        reach[0] = 10;
        int count = cells.find(0, 0, 0, -1, 2, -1, 2, reach);
        reach[0] = own;
        TreeSet<Integer> slots = new TreeSet<>();
        for (int k = 0; k < count; k++) {
            assertThat(slots.add(cells.hits(0)[k])).as("found once").isTrue();
        }
        return slots;
    }

    @Test
    void holdsNoLevelWhoseCirclesLieClose() {
        build(new Bounds(0, 0, 1, 1), 0.02f);
        assertThat(sparse.holds(0)).isFalse();
    }

    @Test
    void holdsNoLevelWhereAnEdgeWraps() {
        build(new Bounds(0, 0, 1, 1, AxisEdge.WRAP, AxisEdge.WALL), 1);
        assertThat(sparse.holds(0)).isFalse();
        assertThat(sparse.bytes()).isLessThan(MANY);
    }

    /** Circles of one radius over a share of the arena. */
    private void build(Bounds bounds, float share) {
        int[] counts = new int[GridLevels.COUNT];
        counts[0] = MANY;
        levels.layOut(bounds, RADIUS, counts, false);
        assertThat(levels.folded[0]).isTrue();
        state.ensure(MANY);
        state.n = MANY;
        state.awake = MANY;
        grid.ensure();
        Arrays.fill(grid.level, (byte) 0);
        for (int slot = 0; slot < MANY; slot++) {
            int s = CircleRow.of(slot);
            state.circle[s + CircleRow.X] = place(bounds.minX(), bounds.maxX(), share);
            state.circle[s + CircleRow.Y] = place(bounds.minY(), bounds.maxY(), share);
            reach[slot] = 0.02f * random.nextFloat();
        }
        sparse.ensure();
        sparse.clear(0);
        sparse.add(0, 0, MANY);
        sparse.settle();
    }

    private float place(float min, float max, float share) {
        float middle = 0.5f * (min + max);
        return middle + share * (random.nextFloat() - 0.5f) * (max - min);
    }
}
