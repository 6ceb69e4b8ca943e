package io.github.circles2d.world.jvm.solver;

import static io.github.circles2d.world.jvm.solver.ContactRow.BASE_X;
import static io.github.circles2d.world.jvm.solver.ContactRow.BASE_Y;
import static io.github.circles2d.world.jvm.solver.ContactRow.FLIGHT_THRESHOLD;
import static io.github.circles2d.world.jvm.solver.ContactRow.INV_MASS_A;
import static io.github.circles2d.world.jvm.solver.ContactRow.INV_MASS_B;
import static io.github.circles2d.world.jvm.solver.ContactRow.MASS;
import static io.github.circles2d.world.jvm.solver.ContactRow.NORMAL_IMPULSE;
import static io.github.circles2d.world.jvm.solver.ContactRow.NORMAL_X;
import static io.github.circles2d.world.jvm.solver.ContactRow.NORMAL_Y;
import static io.github.circles2d.world.jvm.solver.ContactRow.RADII;
import static io.github.circles2d.world.jvm.solver.ContactRow.RESTITUTION;
import static io.github.circles2d.world.jvm.solver.ContactRow.RESTITUTION_THRESHOLD;

import io.github.circles2d.world.jvm.grid.Ahead;
import io.github.circles2d.world.jvm.grid.Candidates;
import io.github.circles2d.world.jvm.grid.Grid;
import io.github.circles2d.world.jvm.grid.Nearby;
import io.github.circles2d.world.jvm.state.ImpulseCache;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.Bounce;
import io.github.circles2d.world.model.Cells;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.CrossRule;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.snapshots.SavedState;

/**
 * Stage Contacts: lists the pairs of circles that may meet within the step, in the order of every sum: level, colour, group, lower
 * id, higher id; behind these, the contacts of circles of different levels ({@link CrossContacts}).
 *
 * <p>The group of a contact is the lesser column and the lesser row of the cells of its two circles, in the grid of their level. A
 * group touches circles of the 2 x 2 cells that begin there. So groups whose columns and rows have the same parities, which are its
 * colour, share no circle and can be solved in parallel.
 *
 * <p>In memory, contacts lie in rows of groups, as the circles lie in rows of cells. A row has the groups of even columns first,
 * then those of odd ones, which are two of the four colours. Even rows are the colours 0 and 1, odd rows 2 and 3.
 */
public final class Contacts {
    /** Pairs a circle for which a list has room, before it is given up. */
    private static final int ROOM_PER_CIRCLE = 24;

    private static final int LEAST_ROOM = 4096;

    /** Contacts that fit into one array. */
    private static final int MOST_CONTACTS = (Integer.MAX_VALUE - 8) / ContactRow.STRIDE;

    private final State state;
    private final Grid grid;
    private final GridLevels levels;
    private final Team team;
    private final ImpulseCache impulseCache;
    private final Candidates candidates;
    private final Pairs pairs;
    private final CrossContacts cross;
    private final NearResting resting;
    private final KeptPairs kept;

    /** The rows whose contacts each worker lists. */
    private final Bands bands;

    /** By worker: the pairs that it has found. */
    private final FoundPairs[] found;

    /** By worker: the circles around the one that it looks at. */
    private final Nearby[] nearby;

    private final Team.Work clearCandidates = this::clearCandidates;
    private final Team.Work countCandidates = this::countCandidates;
    private final Team.Work findPairs = this::findPairs;

    /** Whether all pairs are listed, however many they are. */
    private boolean all;

    /** Number of contacts: those of circles of one level, and behind them the cross contacts. */
    public int count;

    /** Number of contacts of the step before. */
    private int listedBefore;

    /** Number of the first cross contact. */
    int firstCross;

    /** Whether contacts have been listed in this step. */
    private boolean begun;

    /** Steps so far that have listed contacts. */
    private long steps;

    /** Whether there was a crowd in the last step. */
    private boolean wereCrowded;

    /** Number of circles when they were listed. */
    private int circles;

    /** By row of groups, of all levels: its first contact; one more element for the end. */
    int[] rowStart = new int[1];

    /** By contact: where the row of the circle of lower id begins, and that of the other. */
    int[] pair = new int[0];

    /** By cross contact: twice the number of its heavy circle; and 1 more if the light one has the higher id. */
    private int[] heavyAndSide = new int[0];

    /** What records contacts, and has to have room for them; null if nothing does. */
    public Touches touches;

    /** By contact: a {@link ContactRow}. */
    float[] contact = new float[0];

    /** If circles can rotate: the rows of contacts behind the normal ones. */
    final PairRows rows;

    public Contacts(State state, Grid grid, GridLevels levels, Team team, Ahead[] ahead) {
        this.state = state;
        this.grid = grid;
        this.levels = levels;
        this.team = team;
        impulseCache = new ImpulseCache(state);
        rows = new PairRows(state, impulseCache);
        candidates = new Candidates(state, grid, levels);
        resting = new NearResting(state, grid, levels, candidates, team);
        pairs = new Pairs(state, grid, levels, candidates, resting);
        nearby = Nearby.ofWorkers(grid, levels, team);
        cross = new CrossContacts(state, grid, levels, candidates, team, nearby, ahead, resting);
        bands = new Bands(grid, levels, team);
        found = new FoundPairs[team.most()];
        for (int worker = 0; worker < found.length; worker++) {
            found[worker] = new FoundPairs();
        }
        kept = new KeptPairs(state, grid, levels, team, bands, pairs, candidates, resting, found);
    }

    /** Begins a step. */
    public void ensure() {
        begun = false;
        candidates.ensure();
        resting.ensure();
        cross.ensure();
        if (rowStart.length <= levels.rows) {
            rowStart = new int[levels.rows + 1 + (levels.rows >> 2)];
        }
    }

    private void ensureContacts(long contacts) {
        if (contacts > MOST_CONTACTS) {
            throw new IllegalStateException(contacts + " contacts are more than the JVM back end can hold");
        }
        if (ContactRow.PAIR_STRIDE * contacts > pair.length) {
            int c = (int) Math.min(MOST_CONTACTS, Math.max(contacts + (contacts >> 2), 256));
            impulseCache.ensure(c);
            contact = new float[ContactRow.of(c)];
            pair = new int[ContactRow.a(c)];
        }
        int room = contact.length / ContactRow.STRIDE;
        if (state.turning != null && !rows.hasRoom(room)) {
            impulseCache.ensure(room);
            rows.ensure(room);
        }
        if (heavyAndSide.length < cross.count()) {
            heavyAndSide = new int[cross.count() + (cross.count() >> 2)];
        }
    }

    // ---- finding

    /** Finds the circles that rest near to others, before all pairs. */
    public void findResting() {
        if (resting.areAny()) {
            resting.find();
        }
    }

    /** Makes them ready for the pairs. */
    public void beginResting(StepConstants k) {
        if (resting.areAny()) {
            resting.begin(k);
        }
    }

    /**
     * Finds the pairs and makes room for their contacts. Where circles crowd, so that a list of all pairs would take too much
     * memory, it stops half-way: {@link #overflowed} then says so.
     */
    public void find() {
        team.all(clearCandidates);
        find(false);
    }

    private void clearCandidates(int worker) {
        candidates.clear(team.part(state.awake, worker), team.part(state.awake, worker + 1));
    }

    /** Whether there was a crowd in the step before: then it is as good as sure that there is one again. */
    public boolean wereCrowded() {
        return wereCrowded;
    }

    /** Finds the pairs, but only a share of those in a crowd. */
    public void findShare() {
        team.all(countCandidates);
        int most = resting.areAny() ? resting.countAll() : 0;
        for (int w = 0; w < team.size(); w++) {
            most = Math.max(most, found[w].most);
        }
        wereCrowded = most > Tuning.CROWD;
        candidates.thinOut();
        find(true);
    }

    private void countCandidates(int worker) {
        found[worker].most = candidates.countAll(
                nearby[worker], cross.near(worker), team.part(state.awake, worker), team.part(state.awake, worker + 1));
    }

    private void find(boolean listsAll) {
        all = listsAll;
        bands.divide(null, null, 0);
        cross.find(all);
        kept.begin(!all);
        team.all(findPairs);
        if (!overflowed()) {
            layOut();
        }
    }

    private void findPairs(int worker) {
        FoundPairs f = found[worker];
        f.reset(all ? Integer.MAX_VALUE : room(bands.circles(worker)));
        for (int l = 0; l < levels.usedCount && !cross.overflowed(); l++) {
            findInBand(worker, levels.used[l]);
            f.ofLevel[l + 1] = f.count;
        }
    }

    /** Number of contacts of so many circles for which a list has room, before it is given up. */
    static int room(int circles) {
        return (int) Math.min(Integer.MAX_VALUE, LEAST_ROOM + (long) ROOM_PER_CIRCLE * circles);
    }

    private void findInBand(int worker, int level) {
        FoundPairs f = found[worker];
        int columns = levels.columnCount[level];
        int end = bands.first(level, worker + 1);
        for (int row = bands.first(level, worker); row < end && !f.overflowed; row++) {
            rowStart[levels.firstRow[level] + row] = f.count;
            if (kept.has(level)) {
                kept.find(worker, level, row);
                continue;
            }
            for (int odd = 0; odd < 2; odd++) {
                for (int column = odd; column < columns; column += 2) {
                    pairs.find(f, level, column, row);
                    f.endGroup();
                }
                f.flush();
            }
        }
    }

    /** Whether the list was given up because there are too many pairs. */
    public boolean overflowed() {
        boolean some = cross.overflowed();
        for (int w = 0; w < team.size(); w++) {
            some |= found[w].overflowed;
        }
        return some;
    }

    /** Whether a circle has so many candidates that pairs are to be thinned out. Valid once all contacts are filled. */
    public boolean crowded() {
        int most = candidates.thinned() ? 0 : cross.mostFound();
        for (int w = 0; w < team.size(); w++) {
            most = Math.max(most, found[w].most);
        }
        return most > Tuning.CROWD;
    }

    /** Numbers the contacts: level after level, row after row. */
    private void layOut() {
        long sum = 0;
        for (int l = 0; l < levels.usedCount; l++) {
            int level = levels.used[l];
            for (int w = 0; w < team.size(); w++) {
                FoundPairs f = found[w];
                int to = levels.firstRow[level] + bands.first(level, w + 1);
                for (int row = levels.firstRow[level] + bands.first(level, w); row < to; row++) {
                    rowStart[row] += (int) sum - f.ofLevel[l];
                }
                sum += f.ofLevel[l + 1] - f.ofLevel[l];
            }
        }
        ensureContacts(sum + cross.count());
        if (!begun) {
            begun = true;
            steps++;
            listedBefore = count;
            impulseCache.begin();
            if (touches != null) {
                touches.begin(steps);
            }
        }
        rowStart[levels.rows] = (int) sum;
        firstCross = (int) sum;
        count = firstCross + cross.count();
        impulseCache.hold(count);
        if (touches != null) {
            touches.ensure(count);
        }
        circles = state.n;
    }

    // ---- filling

    /** Begins to fill contacts. */
    void beginToFill(int worker) {
        resting.beginContacts(worker);
    }

    /** The start into a sub-step of circles that rest and have contacts of some range, as {@link CirclePasses} does with others. */
    void startResting(int from, int to, StepConstants k) {
        if (!resting.areAny()) {
            return;
        }
        int awake = CircleRow.of(state.awake);
        for (int place = ContactRow.a(from); place < ContactRow.a(to); place++) {
            if (pair[place] >= awake) {
                state.load[pair[place] + CircleRow.BEFORE_X] = 0f;
                state.load[pair[place] + CircleRow.BEFORE_Y] = 0f;
                if (k.turning) {
                    state.turning.startStatic(CircleRow.slot(pair[place]));
                }
            }
        }
    }

    /** Once all contacts are filled. */
    public void settleResting() {
        if (resting.areAny()) {
            resting.settle();
        }
    }

    /** First row whose contacts a worker has found, and fills; of the number of workers: the end. */
    int firstRow(int level, int worker) {
        return bands.first(level, worker);
    }

    /** Fills the contacts of a row that this worker has found. No other thread has any of the same circles. */
    void fillRow(int worker, int l, int row, StepConstants constants) {
        FoundPairs f = found[worker];
        int level = levels.used[l];
        int from = rowStart[levels.firstRow[level] + row];
        int to = rowStart[levels.firstRow[level] + row + 1];
        int shift = f.ofLevel[l] - rowStart[levels.firstRow[level] + bands.first(level, worker)];
        int entry = from;
        for (int c = from; c < to; c++) {
            long slots = f.slots[c + shift];
            fill(c, f.ids[c + shift], slots, constants);
            int found = impulseCache.fill(c, entry, (int) (slots >>> 32), (int) slots, f.ids[c + shift]);
            entry = found < 0 ? entry : found + 1;
            contact[ContactRow.of(c) + NORMAL_IMPULSE] = impulseCache.impulse(found) * constants.warmScale;
            if (constants.turning) {
                rows.fill(c, lowerSlot(c), higherSlot(c), 1f);
                rows.warmStart(c, found, constants.warmScale);
            }
            if (touches != null) {
                touches.follow(worker, c, found < listedBefore ? found : -1);
            }
            if ((int) (slots >>> 32) >= state.awake) {
                resting.noteLower(worker, (int) (slots >>> 32));
            }
        }
        if (!candidates.thinned()) {
            for (int c = from; c < to; c++) {
                f.most = Math.max(f.most, candidates.countContact(lowerSlot(c), higherSlot(c)));
            }
        }
    }

    /** Fills some cross contacts. */
    void fillCross(int worker, int from, int to, StepConstants constants) {
        int entry = from;
        for (int c = from; c < to; c++) {
            int light = cross.lightSlot(c - firstCross);
            int heavy = cross.heavySlot(c - firstCross);
            boolean isLightLower = state.id[light] < state.id[heavy];
            int lower = isLightLower ? light : heavy;
            int higher = isLightLower ? heavy : light;
            long ids = (long) state.id[lower] << 32 | state.id[higher];
            fill(c, ids, (long) lower << 32 | higher, constants);
            int found = impulseCache.fill(c, entry, lower, higher, ids);
            entry = found < 0 ? entry : found + 1;
            contact[ContactRow.of(c) + NORMAL_IMPULSE] = impulseCache.impulse(found) * constants.warmScale;
            if (touches != null) {
                touches.follow(worker, c, found < listedBefore ? found : -1);
            }
            if (lower >= state.awake) {
                resting.noteLower(worker, lower);
            }
            heavyAndSide[c - firstCross] = 2 * cross.heavyNumber(c - firstCross) + (isLightLower ? 0 : 1);
            int o = ContactRow.of(c);
            contact[o + INV_MASS_A] = inverseMass(light);
            contact[o + INV_MASS_B] = inverseMass(heavy);
            float share = cross.share(c - firstCross);
            contact[o + MASS] = CrossRule.crossMass(pushedMass(light), pushedMass(heavy), share);
            if (constants.turning) {
                rows.fill(c, light, heavy, share);
                rows.warmStart(c, found, constants.warmScale);
            }
        }
    }

    /** The inverse mass by which a circle is pushed: one that sleeps as if it would give way, else what lies on it would push the heap. */
    private float pushedMass(int slot) {
        return state.ownInverseMass(slot);
    }

    private float inverseMass(int slot) {
        return state.traits[CircleRow.of(slot) + CircleRow.INVERSE_MASS];
    }

    /** The number of the heavy circle of a cross contact. */
    int heavy(int c) {
        return heavyAndSide[c - firstCross] >> 1;
    }

    /** 1 if the light circle of a cross contact has the higher id, else 0. */
    int isLightB(int c) {
        return heavyAndSide[c - firstCross] & 1;
    }

    private void fill(int c, long ids, long slots, StepConstants constants) {
        int lower = (int) (slots >>> 32);
        int higher = (int) slots;
        int a = CircleRow.of(lower);
        int b = CircleRow.of(higher);
        float[] circle = state.circle;
        float[] traits = state.traits;
        int o = ContactRow.of(c);
        pair[ContactRow.a(c)] = a;
        pair[ContactRow.b(c)] = b;
        float radii = circle[a + CircleRow.RADIUS] + circle[b + CircleRow.RADIUS];
        float dx = state.differenceX(lower, higher);
        float dy = state.differenceY(lower, higher);
        float restitution = CircleMath.max(traits[a + CircleRow.RESTITUTION], traits[b + CircleRow.RESTITUTION]);
        float invMassA = traits[a + CircleRow.INVERSE_MASS];
        float invMassB = traits[b + CircleRow.INVERSE_MASS];
        contact[o + BASE_X] = dx;
        contact[o + BASE_Y] = dy;
        contact[o + RADII] = radii;
        contact[o + RESTITUTION] = restitution;
        contact[o + RESTITUTION_THRESHOLD] = Bounce.bounceThreshold(
                radii, restitution, constants.thresholdRate, constants.restRate, constants.fixedThreshold);
        contact[o + INV_MASS_A] = invMassA;
        contact[o + INV_MASS_B] = invMassB;
        contact[o + MASS] = 1f / (invMassA + invMassB);
        if (state.sleepers != null && (invMassA == 0f || invMassB == 0f)) {
            contact[o + MASS] = 1f / (pushedMass(lower) + pushedMass(higher));
        }
        contact[o + FLIGHT_THRESHOLD] = Bounce.flightThreshold(
                radii, restitution, constants.thresholdRate, constants.flightRestRate, constants.fixedThreshold);
        if (!(dx * dx + dy * dy > 0.25f * (radii * radii))) {
            part(o, Cells.pairHash((int) (ids >>> 32), (int) ids));
        }
    }

    /** Gives a contact a normal for the case that its circles turn out to have one centre. */
    private void part(int o, int hash) {
        float px = Cells.partingX(hash);
        float py = Cells.partingY(hash);
        float norm = CircleMath.length(px, py);
        contact[o + NORMAL_X] = px / norm;
        contact[o + NORMAL_Y] = py / norm;
    }

    private int lowerSlot(int c) {
        return CircleRow.slot(pair[ContactRow.a(c)]);
    }

    private int higherSlot(int c) {
        return CircleRow.slot(pair[ContactRow.b(c)]);
    }

    /** What half a sub-step of gravity adds to the normal speed of a contact, of which one circle is static; else 0. */
    float halfFall(int c, StepConstants k) {
        int o = ContactRow.of(c);
        float invMassA = inverseMass(lowerSlot(c));
        // Of the circle that is not static; if neither is, halfFall is 0.
        int falling = invMassA == 0f ? higherSlot(c) : lowerSlot(c);
        float fall = CircleMath.dot(
                contact[o + NORMAL_X], contact[o + NORMAL_Y], state.gainX(falling, k), state.gainY(falling, k));
        return Bounce.halfFall(fall, invMassA, inverseMass(higherSlot(c)));
    }

    /** The circles that rest near to others. */
    public NearResting nearResting() {
        return resting;
    }

    /** The contacts of circles of different levels. */
    CrossContacts cross() {
        return cross;
    }

    /** The impulses that the contacts of the step before ended with. */
    public ImpulseCache impulseCache() {
        return impulseCache;
    }

    /** Stores a contact's impulse for the step to come. Other workers may do so for cross contacts of the same circle. */
    void storeImpulse(int c, float normalImpulse) {
        if (c < firstCross) {
            impulseCache.store(c, lowerSlot(c), state.id[higherSlot(c)], normalImpulse);
        } else {
            impulseCache.storeShared(c, lowerSlot(c), state.id[higherSlot(c)], normalImpulse);
        }
    }

    /** Takes over saved impulses, for which there is room, in place of contacts; the circles have been taken over before. */
    public void load(SavedState from) {
        count = 0;
        impulseCache.load(from);
    }

    /** Pairs whose distance was tested. */
    public long candidatePairs() {
        long sum = cross.tested() + resting.tested();
        for (int w = 0; w < team.size(); w++) {
            sum += found[w].tested;
        }
        return sum;
    }

    /** Ids of the two circles of a contact, the lower one above the higher. */
    public long ids(int c) {
        return (long) state.id[lowerSlot(c)] << 32 | state.id[higherSlot(c)];
    }

    public long bytes() {
        long sum = 4L * (rowStart.length + pair.length + contact.length + heavyAndSide.length)
                + rows.bytes()
                + candidates.bytes()
                + kept.bytes()
                + resting.bytes()
                + cross.bytes();
        for (FoundPairs f : found) {
            sum += f.bytes();
        }
        return sum + impulseCache.bytes();
    }

    /** Greatest number of contacts of one circle. */
    public int greatest() {
        int[] degree = new int[circles];
        int greatest = 0;
        for (int k = 0; k < ContactRow.a(count); k++) {
            greatest = Math.max(greatest, ++degree[CircleRow.slot(pair[k])]);
        }
        return greatest;
    }
}
