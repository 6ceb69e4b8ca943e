package io.github.circles2d.world.circles;

import io.github.circles2d.world.model.Cells;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.GridLevels;
import java.util.Arrays;

/**
 * Which circles there are. A handle is ((generation + 1) &lt;&lt; 32 | id). The next circle gets the lowest free id; the generation
 * tells it from circles that had the id before. The table also knows what only calls change, the radius, the restitution and
 * the fields of {@link CircleField}, so that nobody has to ask a pipeline.
 */
public final class HandleTable {
    /** The base-two logarithm of the ids in a word of {@link #live}. */
    private static final int WORD_SHIFT = 6;

    private static final int IDS_IN_WORD = 1 << WORD_SHIFT;

    /** In a handle: by how many bits the generation, plus one, is shifted. */
    private static final int GENERATION_SHIFT = 32;

    /** In a handle: the bits of the id. */
    private static final long ID_MASK = (1L << GENERATION_SHIFT) - 1;

    /** The generation that would make a handle 0 is left out. */
    static final int LAST_GENERATION = -2;

    /** A bit for each id: id k is bit k % 64 of element k / 64. */
    private long[] live = new long[1];

    /** By word of live: circles in the words before. */
    private int[] livingBefore = new int[1];

    private boolean livingBeforeCurrent;

    /** As {@link #live}, a bit for each id: whether its circle is static. */
    private long[] isStatic = new long[1];

    /** Number of static circles. */
    private int statics;

    private int[] generation = new int[64];
    private float[] radius = new float[64];
    private float[] restitution = new float[64];
    private final CircleFields fields = new CircleFields(CircleField.ALL);

    /** The ids whose circles have stayed since {@link #markSurvivors}. */
    private final IdMask survivors = new IdMask();

    private int size;

    /** No id below this one is free. */
    private int noneFreeBelow;

    /** One more than the greatest id ever used. */
    private int end;

    private float greatestRadius;
    private int withGreatestRadius;
    private boolean radiiChanged;
    private final int[] population = new int[GridLevels.COUNT];

    /** No circles. */
    public HandleTable() {}

    private static int word(int id) {
        return id >>> WORD_SHIFT;
    }

    private static long bit(int id) {
        return 1L << id;
    }

    /**
     * Number of circles.
     *
     * @return at least 0
     */
    public int size() {
        return size;
    }

    /**
     * One more than the greatest id in use so far.
     *
     * @return at least {@link #size()}
     */
    public int end() {
        return end;
    }

    /**
     * Whether an id belongs to a circle.
     *
     * @param id an id less than {@link #end()}
     * @return true where it does
     */
    public boolean lives(int id) {
        return (live[word(id)] & bit(id)) != 0;
    }

    /**
     * Copies which ids belong to circles.
     *
     * @param to takes a bit for each id less than {@link #end()}: id k is bit k % 64 of element k / 64
     * @return the array, or a new one where it was too short
     */
    public long[] copyLiving(long[] to) {
        int words = word(end + IDS_IN_WORD - 1);
        long[] copy = to.length < words ? new long[live.length] : to;
        System.arraycopy(live, 0, copy, 0, words);
        return copy;
    }

    /** From now on the circles of now count as survivors, until they are removed. */
    public void markSurvivors() {
        survivors.copy(this);
    }

    /**
     * The ids whose circles have stayed since {@link #markSurvivors}. An id that another circle has now is none of them.
     *
     * @return the ids; changes with the circles
     */
    public IdMask survivors() {
        return survivors;
    }

    /**
     * The handle of a circle.
     *
     * @param id its id
     * @return the handle
     */
    public long handle(int id) {
        return (long) (generation[id] + 1) << GENERATION_SHIFT | id;
    }

    /**
     * The id behind a handle.
     *
     * @param handle any number
     * @return the id, or -1 where no living circle has this handle
     */
    public int find(long handle) {
        long id = handle & ID_MASK;
        if (id >= end || !lives((int) id) || generation[(int) id] + 1 != (int) (handle >>> GENERATION_SHIFT)) {
            return -1;
        }
        return (int) id;
    }

    /**
     * The place of a circle in the order of the ids.
     *
     * @param id its id
     * @return how many circles have lower ids
     */
    public int place(int id) {
        if (!livingBeforeCurrent) {
            if (livingBefore.length < live.length) {
                livingBefore = new int[live.length];
            }
            int sum = 0;
            for (int word = 0; word < live.length; word++) {
                livingBefore[word] = sum;
                sum += Long.bitCount(live[word]);
            }
            livingBeforeCurrent = true;
        }
        return livingBefore[word(id)] + Long.bitCount(live[word(id)] & bit(id) - 1);
    }

    /**
     * Makes room, so that adding circles does not run out of memory. Where this fails, nothing has changed.
     *
     * @param more number of circles to come
     */
    public void ensure(int more) {
        ensureIds(size + more);
    }

    /**
     * Makes room for a saved state, so that {@link #load} does not run out of memory. Where this fails, nothing has changed.
     *
     * @param from the state
     */
    public void makeRoom(SavedState from) {
        ensureIds(from.ids);
        fields.makeRoom(from.fields);
    }

    /** Makes room for ids. The length of the array that grows last tells whether there is room. */
    private void ensureIds(int ids) {
        if (ids > generation.length) {
            int c = Math.max(ids, generation.length + (generation.length >> 1));
            live = Arrays.copyOf(live, word(c) + 1);
            isStatic = Arrays.copyOf(isStatic, live.length);
            radius = Arrays.copyOf(radius, c);
            restitution = Arrays.copyOf(restitution, c);
            generation = Arrays.copyOf(generation, c);
        }
    }

    /**
     * Enters a circle under the lowest free id.
     *
     * @param r its radius
     * @return the id
     */
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

    /**
     * Strikes a circle off; its handle is stale from now on.
     *
     * @param id its id
     */
    public void remove(int id) {
        live[word(id)] &= ~bit(id);
        livingBeforeCurrent = false;
        survivors.remove(id);
        generation[id] = generation[id] == LAST_GENERATION ? 0 : generation[id] + 1;
        noneFreeBelow = Math.min(noneFreeBelow, id);
        size--;
        statics -= isStatic(id) ? 1 : 0;
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

    /**
     * Takes a circle's new radius down.
     *
     * @param id its id
     * @param r the radius
     */
    public void setRadius(int id, float r) {
        leave(radius[id]);
        radius[id] = r;
        enter(r);
    }

    /** A circle's radius, as taken down last. */
    public float radius(int id) {
        return radius[id];
    }

    /**
     * Takes a circle's mass down, of which only whether it is infinite is kept.
     *
     * @param id its id, of a circle that lives
     * @param mass the mass
     */
    public void setMass(int id, float mass) {
        boolean infinite = mass == Float.POSITIVE_INFINITY;
        statics += (infinite ? 1 : 0) - (isStatic(id) ? 1 : 0);
        isStatic[word(id)] = isStatic[word(id)] & ~bit(id) | (infinite ? bit(id) : 0);
    }

    /**
     * Whether a circle is static.
     *
     * @param id its id
     * @return whether the mass taken down last is infinite
     */
    public boolean isStatic(int id) {
        return (isStatic[word(id)] & bit(id)) != 0;
    }

    /**
     * Whether any circle is static.
     *
     * @return whether there is one of infinite mass
     */
    public boolean hasStatics() {
        return statics > 0;
    }

    /**
     * Takes a circle's restitution down.
     *
     * @param id its id
     * @param e the restitution
     */
    public void setRestitution(int id, float e) {
        restitution[id] = e;
    }

    /**
     * A circle's restitution.
     *
     * @param id its id
     * @return what was taken down last
     */
    public float restitution(int id) {
        return restitution[id];
    }

    /**
     * The fields of the circles, by id.
     *
     * @return the values as of the last call
     */
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

    /**
     * The greatest radius of all circles.
     *
     * @return a length; 0 where there is no circle
     */
    public float greatestRadius() {
        recount();
        return greatestRadius;
    }

    /**
     * The least radius of all circles. Looks at each of them.
     *
     * @return a length; positive infinity where there is no circle
     */
    public float leastRadius() {
        float least = Float.POSITIVE_INFINITY;
        for (int id = 0; id < end; id++) {
            if (lives(id)) {
                least = Math.min(least, radius[id]);
            }
        }
        return least;
    }

    /**
     * The number of circles of each size class, by {@link Cells#sizeClass}.
     *
     * @return the numbers; valid until the next change
     */
    public int[] population() {
        recount();
        return population;
    }

    /**
     * Saves which ids are in use, their generations, and the fields of circles.
     *
     * @param into takes ids, generations and fields
     */
    public void save(SavedState into) {
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

    /**
     * Takes over the ids, generations, radii, restitutions and fields of a saved state instead of its own.
     *
     * @param from the state, for which room has been made; not kept
     */
    public void load(SavedState from) {
        for (int id = 0; id < survivors.end(); id++) {
            if (id >= from.ids || from.generation[id] != generation[id]) {
                survivors.remove(id);
            }
        }
        Arrays.fill(live, 0);
        Arrays.fill(isStatic, 0);
        statics = 0;
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
