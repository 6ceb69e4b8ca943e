package io.github.circles2d.world;

/** The threads of a step. All run the same method; {@link #sync} is where they wait for each other. */
final class Team {
    private final int size;

    Team(int size) {
        this.size = size;
    }

    int size() {
        return size;
    }

    /** Where the share of a worker begins, of n equal items; the share of the last ends at part(n, size). */
    int part(int n, int worker) {
        return (int) ((long) n * worker / size);
    }

    void sync(int worker) {}
}
