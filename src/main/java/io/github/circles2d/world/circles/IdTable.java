package io.github.circles2d.world.circles;

import java.util.Arrays;

/** Which ids are in use, of pieces or bodies of terrain or of joints, under a {@link Handle} each. The next one gets the lowest free id. */
public final class IdTable {
    private boolean[] live = new boolean[0];
    private int[] generation = new int[0];
    private int size;
    private int end;
    private int noneFreeBelow;

    /** Of the handles. */
    private final int mark;

    public IdTable(int mark) {
        this.mark = mark;
    }

    public int size() {
        return size;
    }

    /** One more than the greatest id ever used. */
    public int end() {
        return end;
    }

    public boolean lives(int id) {
        return live[id];
    }

    /** Whether something lives that has an id, which may be any number. */
    public boolean has(int id) {
        return id >= 0 && id < end && live[id];
    }

    public long handle(int id) {
        return Handle.of(generation[id], mark | id);
    }

    /** The handle of what has an id, or 0; the id comes from a caller. */
    public long handleOrNone(int id) {
        if (id < 0 || id >= end) {
            throw new IllegalArgumentException("the id is " + id + ", but must be at least 0 and less than " + end);
        }
        return live[id] ? handle(id) : 0;
    }

    /** -1 if nothing that lives has the handle. */
    public int find(long handle) {
        long id = Handle.marked(handle) ^ mark;
        if (id >= end || !live[(int) id] || !Handle.hasGeneration(handle, generation[(int) id])) {
            return -1;
        }
        return (int) id;
    }

    /** Ids that the arrays have room for. */
    public int room() {
        return generation.length;
    }

    public void setRoom(int ids) {
        live = Arrays.copyOf(live, ids);
        generation = Arrays.copyOf(generation, ids);
    }

    public void save(int[] generations) {
        System.arraycopy(generation, 0, generations, 0, end);
    }

    /** Whether a saved id has been used as often as it has been here. */
    public boolean isSame(int id, boolean lives, int generations) {
        return live[id] == lives && generation[id] == generations;
    }

    /** Begins to take over saved ids, none of which lives yet; there is room. */
    public void load(int[] generations, int ids) {
        Arrays.fill(live, false);
        Arrays.fill(generation, 0);
        System.arraycopy(generations, 0, generation, 0, ids);
        end = ids;
        size = 0;
        noneFreeBelow = 0;
    }

    /** A saved id lives. */
    public void revive(int id) {
        live[id] = true;
        size++;
    }

    /** There is room. */
    public int add() {
        int id = noneFreeBelow;
        while (id < end && live[id]) {
            id++;
        }
        live[id] = true;
        noneFreeBelow = id + 1;
        end = Math.max(end, id + 1);
        size++;
        return id;
    }

    public void remove(int id) {
        live[id] = false;
        generation[id] = Handle.next(generation[id]);
        noneFreeBelow = Math.min(noneFreeBelow, id);
        size--;
    }
}
