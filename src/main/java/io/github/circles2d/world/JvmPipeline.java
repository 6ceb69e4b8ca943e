package io.github.circles2d.world;

import java.util.Map;

/** The World engine in plain Java: the oracle that every other pipeline is compared with. */
public final class JvmPipeline implements Pipeline {
    private final JvmState state = new JvmState();
    private final Levels levels = new Levels();
    private final Team team;
    private final JvmGrid grid;
    private final JvmContacts contacts;
    private final JvmSweep sweep;
    private final JvmSolver solver;

    /**
     * An empty world.
     *
     * @param threads number of threads of a step, at least 1
     * @param capacity number of circles to make room for
     * @param profiling whether to measure the time of each stage
     */
    public JvmPipeline(int threads, int capacity, boolean profiling) {
        team = new Team(1);
        grid = new JvmGrid(state, levels, team);
        contacts = new JvmContacts(state, grid, levels, team);
        sweep = new JvmSweep(state, grid, levels, team);
        solver = new JvmSolver(state, contacts, levels, team);
        state.ensure(capacity);
    }

    @Override
    public void apply(Commands commands) {
        state.apply(commands);
    }

    @Override
    public void step(StepConstants constants, Levels shape, int steps) {
        levels.copy(shape);
        for (int step = 0; step < steps; step++) {
            grid.ensure();
            contacts.ensure();
            sweep.ensure();
            grid.build(0, constants);
            sweep.sweep(0);
            contacts.list(0, false);
            boolean overflowed = contacts.overflowed();
            if (!overflowed) {
                solver.prepare(0, constants);
            }
            if (overflowed) {
                contacts.countCandidates(0);
            }
            if (overflowed || contacts.crowded()) {
                contacts.list(0, true);
                solver.prepare(0, constants);
            }
            solver.solve(0, constants);
            constants.warmScale = 1f;
        }
    }

    @Override
    public void confine(Bounds bounds) {
        state.confine(bounds);
    }

    @Override
    public long hash() {
        long sum = state.hash();
        for (int slot = 0; slot < state.n; slot++) {
            sum += contacts.hashOfMemory(slot);
        }
        return sum;
    }

    @Override
    public void readCircles(Roster roster, float[] to) {
        int k = 0;
        for (int id = 0; id < roster.end(); id++) {
            if (roster.lives(id)) {
                System.arraycopy(state.circle, 4 * state.slotOf[id], to, 4 * k++, 4);
            }
        }
    }

    @Override
    public void readVelocities(Roster roster, float[] to) {
        int k = 0;
        for (int id = 0; id < roster.end(); id++) {
            if (roster.lives(id)) {
                int s = 4 * state.slotOf[id];
                to[2 * k] = state.motion[s + 2];
                to[2 * k + 1] = state.motion[s + 3];
                k++;
            }
        }
    }

    @Override
    public void save(SavedState into) {
        into.impulses = 0;
        for (int k = 0; k < into.circles; k++) {
            int slot = state.slotOf[into.id[k]];
            state.save(slot, into, k);
            contacts.save(slot, into);
        }
    }

    @Override
    public void load(SavedState from) {
        state.load(from);
        contacts.load(from);
    }

    @Override
    public long candidatePairs() {
        return contacts.candidatePairs();
    }

    @Override
    public int contacts() {
        return contacts.count;
    }

    @Override
    public int greatestContacts() {
        return contacts.greatest();
    }

    @Override
    public long bytesHeld() {
        return 0;
    }

    @Override
    public Map<String, Double> stageMillis() {
        return Map.of();
    }

    @Override
    public String device() {
        return "Java " + System.getProperty("java.version") + ", " + team.size() + " threads";
    }

    @Override
    public void close() {}
}
