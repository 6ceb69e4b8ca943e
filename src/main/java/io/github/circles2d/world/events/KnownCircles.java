package io.github.circles2d.world.events;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.model.PairTable;
import java.util.Arrays;

/** What events know of circles, by id: as of the last commands that were applied, which the table of handles may be ahead of. */
final class KnownCircles {
    private static final int KIND_BITS = PairTable.KINDS - 1;
    private static final int FIELD_OF_KIND = CircleField.OF_STEPS.indexOf(CircleField.KIND);

    /** By id: the handle as of the last step. */
    private long[] handleOf = new long[0];

    /** By id: the kind, as of the last commands. */
    private byte[] kindOf = new byte[0];

    /** By id: the last batch of commands that removed its circle; negative if it only added one. */
    private int[] changedIn = new int[0];

    private int batch;

    /** By kind: how many circles there are. */
    private final int[] population = new int[PairTable.KINDS];

    /** Counts how often there came to be circles of a kind, or none. */
    private int kindsVersion;

    /** Makes room. The array that is compared grows last: a growth that fails is tried again. */
    void ensure(int ids) {
        if (ids > handleOf.length) {
            int c = Math.max(ids, handleOf.length + (handleOf.length >> 1));
            changedIn = Arrays.copyOf(changedIn, c);
            kindOf = Arrays.copyOf(kindOf, c);
            handleOf = Arrays.copyOf(handleOf, c);
        }
    }

    /** Learns all handles and kinds. */
    void read(HandleTable handles) {
        Arrays.fill(population, 0);
        kindsVersion++;
        for (int id = 0; id < handles.end(); id++) {
            handleOf[id] = handles.lives(id) ? handles.handle(id) : 0;
            kindOf[id] = (byte) handles.fields().getInt(CircleField.KIND, id);
            population[kind(id)] += handles.lives(id) ? 1 : 0;
        }
    }

    long handle(int id) {
        return handleOf[id];
    }

    int kind(int id) {
        return kindOf[id] & KIND_BITS;
    }

    void setKind(int id, int kind) {
        leave(kind(id));
        kindOf[id] = (byte) kind;
        enter(kind);
    }

    private void enter(int kind) {
        kindsVersion += population[kind]++ == 0 ? 1 : 0;
    }

    private void leave(int kind) {
        kindsVersion += --population[kind] == 0 ? 1 : 0;
    }

    boolean has(int kind) {
        return population[kind] > 0;
    }

    /** Counts the changes of {@link #has}. */
    int kindsVersion() {
        return kindsVersion;
    }

    static boolean isKind(Commands commands, int c) {
        return commands.operation(c) == Commands.FIELD && commands.first(c) == FIELD_OF_KIND;
    }

    /** Begins a batch of commands: no circle has been removed or added in it. */
    void beginBatch() {
        if (batch == Integer.MAX_VALUE) {
            Arrays.fill(changedIn, 0);
            batch = 0;
        }
        batch++;
    }

    /** Takes note that the batch removes a circle. */
    void remove(int id) {
        changedIn[id] = batch;
    }

    /** Takes note that the batch adds a circle. One that it has removed under the same id still counts as removed. */
    void add(int id) {
        if (changedIn[id] != batch) {
            changedIn[id] = -batch;
        }
    }

    /** Whether the batch has removed a circle. */
    boolean isRemoved(int id) {
        return changedIn[id] == batch;
    }

    /** Whether the batch has neither removed nor added a circle. */
    boolean hasStayed(int id) {
        return Math.abs(changedIn[id]) != batch;
    }

    /** Begins a batch of commands, and takes note of all that they remove. Returns whether they remove any. */
    boolean markRemoved(Commands commands) {
        beginBatch();
        boolean some = false;
        for (int c = 0; c < commands.count(); c++) {
            if (commands.operation(c) == Commands.REMOVE) {
                remove(commands.id(c));
                some = true;
            }
        }
        return some;
    }

    void learn(Commands commands, HandleTable handles) {
        for (int c = 0; c < commands.count(); c++) {
            int id = commands.id(c);
            if (commands.operation(c) == Commands.ADD) {
                handleOf[id] = handles.handle(id);
                kindOf[id] = 0;
                enter(0);
            } else if (commands.operation(c) == Commands.REMOVE) {
                leave(kind(id));
            } else if (isKind(commands, c)) {
                setKind(id, commands.second(c));
            }
        }
    }

    long bytes() {
        return 13L * handleOf.length;
    }
}
