package io.github.circles2d.world;

import java.util.Map;

/** The World engine in plain Java: the oracle that every other pipeline is compared with. */
public final class JvmPipeline implements Pipeline {
    private final JvmState state = new JvmState();
    private final Team team;
    private JvmGrid grid;
    private JvmContacts contacts;
    private JvmSolver solver;
    private Levels levels;

    /**
     * An empty world.
     *
     * @param threads number of threads of a step, at least 1
     * @param capacity number of circles to make room for
     * @param profiling whether to measure the time of each stage
     */
    public JvmPipeline(int threads, int capacity, boolean profiling) {
        team = new Team(1);
        state.ensure(capacity);
    }

    @Override
    public void apply(Commands commands) {
        state.apply(commands);
    }

    @Override
    public void step(StepConstants constants, Levels shape, int steps) {
        if (levels != shape) {
            levels = shape;
            grid = new JvmGrid(state, shape, team);
            contacts = new JvmContacts(state, grid, shape, team);
            solver = new JvmSolver(state, contacts, shape, team);
        }
        for (int step = 0; step < steps; step++) {
            grid.ensure();
            contacts.ensure();
            grid.build(0, constants);
            contacts.list(0);
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
        if (contacts != null) {
            for (int slot = 0; slot < state.n; slot++) {
                sum += contacts.hashOfMemory(slot);
            }
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
    public long candidatePairs() {
        return contacts == null ? 0 : contacts.candidatePairs();
    }

    @Override
    public int contacts() {
        return contacts == null ? 0 : contacts.count;
    }

    @Override
    public int greatestContacts() {
        return contacts == null ? 0 : contacts.greatest();
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
