package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.Cells;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import io.github.circles2d.world.model.PairTable;
import java.util.Arrays;

/**
 * Which circles there are, under a {@link Handle} each. The next circle gets the lowest free id; the generation
 * tells it from circles that had the id before. The table also knows what only calls change, the radius, the restitution and
 * the fields of {@link CircleField}, so that nobody has to ask a pipeline.
 */
public final class HandleTable {
    /** The base-two logarithm of the ids in a word of {@link #live}. */
    private static final int WORD_SHIFT = 6;

    private static final int IDS_IN_WORD = 1 << WORD_SHIFT;

    /** A bit for each id: id k is bit k % 64 of element k / 64. */
    private long[] live = new long[1];

    /** By word of live: circles in the words before. */
    private int[] livingBefore = new int[1];

    private boolean livingBeforeCurrent;

    /** As {@link #live}, a bit for each id: whether its circle is static. */
    private long[] isStatic = new long[1];

    private int statics;
    private final int[] staticsOfKind = new int[PairTable.KINDS];

    private int[] generation = new int[64];
    private float[] radius = new float[64];
    private float[] restitution = new float[64];
    private final CircleFields fields = new CircleFields(CircleField.ALL);

    /** The ids whose circles have stayed since {@link #markSurvivors}. */
    private final IdMask survivors = new IdMask();

    private int size;

    private int noneFreeBelow;

    /** One more than the greatest id ever used. */
    private int end;

    private float greatestRadius;
    private int withGreatestRadius;
    private boolean radiiChanged;
    private final int[] population = new int[GridLevels.COUNT];

    private static int word(int id) {
        return id >>> WORD_SHIFT;
    }

    private static long bit(int id) {
        return 1L << id;
    }

    public int size() {
        return size;
    }

    /** One more than the greatest id in use so far. */
    public int end() {
        return end;
    }

    public boolean lives(int id) {
        return (live[word(id)] & bit(id)) != 0;
    }

    /** A bit for each id: id k is bit k % 64 of element k / 64. Returns a new array if this one is too short. */
    public long[] copyLiving(long[] to) {
        int words = word(end + IDS_IN_WORD - 1);
        long[] copy = to.length < words ? new long[live.length] : to;
        System.arraycopy(live, 0, copy, 0, words);
        return copy;
    }

    /** Makes room for {@link #markSurvivors}. If there is none, nothing has changed. */
    public void makeRoomForSurvivors() {
        survivors.makeRoom(this);
    }

    /** From now on the circles of now count as survivors, until they are removed. */
    public void markSurvivors() {
        survivors.copy(this);
    }

    /** The ids whose circles have stayed since {@link #markSurvivors}; not those that another circle has now. */
    public IdMask survivors() {
        return survivors;
    }

    public long handle(int id) {
        return Handle.of(generation[id], id);
    }

    /** -1 if no living circle has the handle. */
    public int find(long handle) {
        long id = Handle.marked(handle);
        if (id >= end || !lives((int) id) || !Handle.hasGeneration(handle, generation[(int) id])) {
            return -1;
        }
        return (int) id;
    }

    /** How many circles have lower ids. */
    public int place(int id) {
        if (!livingBeforeCurrent) {
            int sum = 0;
            for (int word = 0; word < live.length; word++) {
                livingBefore[word] = sum;
                sum += Long.bitCount(live[word]);
            }
            livingBeforeCurrent = true;
        }
        return livingBefore[word(id)] + Long.bitCount(live[word(id)] & bit(id) - 1);
    }

    /** Makes room for more circles, so that adding them cannot fail. If there is none, nothing has changed. */
    public void ensure(int more) {
        ensureIds(size + more);
    }

    /** Makes room for a state, so that {@link #load} cannot fail. If there is none, nothing has changed. */
    public void makeRoom(SavedCircles from) {
        ensureIds(from.ids);
        fields.makeRoom(from.fields);
    }

    /** Makes room for ids. The array that is compared grows last: a growth that fails is tried again. */
    private void ensureIds(int ids) {
        if (ids > generation.length) {
            int c = Math.max(ids, generation.length + (generation.length >> 1));
            livingBeforeCurrent = false;
            livingBefore = new int[word(c) + 1];
            live = Arrays.copyOf(live, livingBefore.length);
            isStatic = Arrays.copyOf(isStatic, live.length);
            radius = Arrays.copyOf(radius, c);
            restitution = Arrays.copyOf(restitution, c);
            generation = Arrays.copyOf(generation, c);
        }
    }

    /** Under the lowest free id. */
    public int add(float r) {
        ensure(1);
        int id = firstFree();
        live[word(id)] |= bit(id);
        isStatic[word(id)] &= ~bit(id);
        livingBeforeCurrent = false;
        noneFreeBelow = id + 1;
        end = Math.max(end, id + 1);
        size++;
        radius[id] = r;
        enter(r);
        return id;
    }

    public void remove(int id) {
        live[word(id)] &= ~bit(id);
        livingBeforeCurrent = false;
        survivors.remove(id);
        generation[id] = Handle.next(generation[id]);
        noneFreeBelow = Math.min(noneFreeBelow, id);
        size--;
        countStatic(id, isStatic(id) ? -1 : 0);
        leave(radius[id]);
        fields.clear(id);
    }

    /** Strikes all circles off. */
    public void removeAll() {
        for (int id = 0; id < end; id++) {
            if (lives(id)) {
                remove(id);
            }
        }
    }

    public void setRadius(int id, float r) {
        leave(radius[id]);
        radius[id] = r;
        enter(r);
    }

    /** A circle's radius, as taken down last. */
    public float radius(int id) {
        return radius[id];
    }

    /** Keeps only whether it is infinite. */
    public void setMass(int id, float mass) {
        boolean infinite = mass == Float.POSITIVE_INFINITY;
        countStatic(id, (infinite ? 1 : 0) - (isStatic(id) ? 1 : 0));
        isStatic[word(id)] = isStatic[word(id)] & ~bit(id) | (infinite ? bit(id) : 0);
    }

    public boolean isStatic(int id) {
        return (isStatic[word(id)] & bit(id)) != 0;
    }

    /** How many circles are static. */
    public int statics() {
        return statics;
    }

    public boolean hasStatics() {
        return statics > 0;
    }

    /** Whether a static circle has a kind. */
    public boolean hasStatics(int kind) {
        return staticsOfKind[kind] > 0;
    }

    private void countStatic(int id, int more) {
        statics += more;
        staticsOfKind[fields.getInt(CircleField.KIND, id)] += more;
    }

    /** Sets a field of a circle, for which there is room. */
    public void setField(CircleField field, int id, long value) {
        boolean counts = field == CircleField.KIND && isStatic(id);
        if (counts) {
            countStatic(id, -1);
        }
        fields.set(field, id, value);
        if (counts) {
            countStatic(id, 1);
        }
    }

    public void setRestitution(int id, float e) {
        restitution[id] = e;
    }

    public float restitution(int id) {
        return restitution[id];
    }

    public CircleFields fields() {
        return fields;
    }

    private int firstFree() {
        int word = word(noneFreeBelow);
        long free = ~live[word] & -1L << noneFreeBelow;
        while (free == 0) {
            free = ~live[++word];
        }
        return (word << WORD_SHIFT) + Long.numberOfTrailingZeros(free);
    }

    private void enter(float r) {
        if (r > greatestRadius) {
            greatestRadius = r;
            withGreatestRadius = 1;
            radiiChanged = true;
        } else {
            if (r == greatestRadius) {
                withGreatestRadius++;
            }
            population[Cells.sizeClass(r, greatestRadius)]++;
        }
    }

    private void leave(float r) {
        population[Cells.sizeClass(r, greatestRadius)]--;
        if (r == greatestRadius && --withGreatestRadius == 0) {
            radiiChanged = true;
        }
    }

    /** 0 without circles. */
    public float greatestRadius() {
        recount();
        return greatestRadius;
    }

    /** Infinite without circles. Looks at each of them. */
    public float leastRadius() {
        float least = Float.POSITIVE_INFINITY;
        for (int id = 0; id < end; id++) {
            if (lives(id)) {
                least = Math.min(least, radius[id]);
            }
        }
        return least;
    }

    /** By {@link Cells#sizeClass}; valid until the next change. */
    public int[] population() {
        recount();
        return population;
    }

    /** Ids, generations and fields. */
    public void save(SavedCircles into) {
        into.setIds(end);
        into.setCircles(size);
        System.arraycopy(generation, 0, into.generation, 0, end);
        into.fields.copy(fields);
        int k = 0;
        for (int id = 0; id < end; id++) {
            if (lives(id)) {
                into.id[k++] = id;
            }
        }
    }

    /** Room has been made. The state is not kept. */
    public void load(SavedCircles from) {
        for (int id = 0; id < survivors.end(); id++) {
            if (id >= from.ids || from.generation[id] != generation[id]) {
                survivors.remove(id);
            }
        }
        Arrays.fill(live, 0);
        Arrays.fill(isStatic, 0);
        statics = 0;
        Arrays.fill(staticsOfKind, 0);
        Arrays.fill(generation, 0);
        System.arraycopy(from.generation, 0, generation, 0, from.ids);
        fields.copy(from.fields);
        for (int k = 0; k < from.circles; k++) {
            int id = from.id[k];
            live[word(id)] |= bit(id);
            setMass(id, from.circle[CircleRow.STRIDE * k + CircleRow.MASS]);
            radius[id] = from.circle[CircleRow.STRIDE * k + CircleRow.RADIUS];
            restitution[id] = from.traits[CircleRow.STRIDE * k + CircleRow.RESTITUTION];
        }
        end = from.ids;
        for (int id = 0; id < survivors.end(); id++) {
            if (id >= end || !lives(id)) {
                survivors.remove(id);
            }
        }
        size = from.circles;
        noneFreeBelow = 0;
        livingBeforeCurrent = false;
        radiiChanged = true;
    }

    private void recount() {
        if (!radiiChanged) {
            return;
        }
        greatestRadius = 0;
        withGreatestRadius = 0;
        for (int id = 0; id < end; id++) {
            if (lives(id)) {
                if (radius[id] > greatestRadius) {
                    greatestRadius = radius[id];
                    withGreatestRadius = 0;
                }
                if (radius[id] == greatestRadius) {
                    withGreatestRadius++;
                }
            }
        }
        Arrays.fill(population, 0);
        for (int id = 0; id < end; id++) {
            if (lives(id)) {
                population[Cells.sizeClass(radius[id], greatestRadius)]++;
            }
        }
        radiiChanged = false;
    }
}
