package io.github.circles2d.world.jvm.bodies;

import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.threads.Team;
import java.util.Arrays;

/**
 * Which bodies may be near to each other: those whose wide boxes meet. They hold until a body leaves its wide box, so that most steps need no search.
 * They decide nothing: who asks looks at the boxes.
 */
final class RigidCandidates {
    /** How much wider a wide box is on each side, in half thicknesses of its body. */
    private static final float SLACK = 0.15f;

    /** The same by half of the body's part of a margin, which counts its way in a step. */
    private static final float WAYS = 4f;

    private final State state;
    private final RigidThings things;
    private final Team team;

    /** By body: least x and y, greatest x and y, with its part of margins. */
    float[] box = new float[0];

    /** Over the wide boxes. */
    private final RigidTree tree = new RigidTree();

    // by worker: the candidates that it has found
    private final RigidTree.Found[] images;
    private final int[][] found;
    private final int[] foundCount;

    // by body: which worker has found its candidates, and where they are
    private int[] worker = new int[0];
    private int[] from = new int[0];
    private int[] end = new int[0];

    // for what they hold
    private int[] ids = new int[0];
    private int count;
    private float periodX;
    private float periodY;

    private final Team.Work search = this::search;

    RigidCandidates(State state, RigidThings things, Team team) {
        this.state = state;
        this.things = things;
        this.team = team;
        images = new RigidTree.Found[team.most()];
        found = new int[team.most()][64];
        foundCount = new int[team.most()];
        for (int k = 0; k < images.length; k++) {
            images[k] = new RigidTree.Found();
        }
    }

    /** Makes room for the boxes of bodies. */
    void ensure(int bodies) {
        if (box.length < 4 * bodies) {
            box = new float[8 * bodies];
            worker = new int[2 * bodies];
            from = new int[2 * bodies];
            end = new int[2 * bodies];
            ids = new int[2 * bodies];
            count = -1;
        }
    }

    /** Searches if bodies have left their wide boxes, or are others. */
    void update() {
        if (!hold()) {
            widen();
            tree.build(things.bodies);
            Arrays.fill(foundCount, 0);
            team.together(search);
        }
    }

    private boolean hold() {
        if (things.bodies != count || state.periodX != periodX || state.periodY != periodY) {
            return false;
        }
        float[] wide = tree.box;
        for (int t = 0; t < count; t++) {
            int b = 4 * t;
            boolean inside = box[b] >= wide[b]
                    && box[b + 1] >= wide[b + 1]
                    && box[b + 2] <= wide[b + 2]
                    && box[b + 3] <= wide[b + 3];
            if (!inside || ids[t] != things.all[t].id) {
                return false;
            }
        }
        return true;
    }

    private void widen() {
        count = things.bodies;
        periodX = state.periodX;
        periodY = state.periodY;
        tree.makeRoom(count);
        float[] wide = tree.box;
        for (int t = 0; t < count; t++) {
            int b = 4 * t;
            float more = SLACK * things.all[t].thin + WAYS * things.all[t].near;
            wide[b] = box[b] - more;
            wide[b + 1] = box[b + 1] - more;
            wide[b + 2] = box[b + 2] + more;
            wide[b + 3] = box[b + 3] + more;
            ids[t] = things.all[t].id;
        }
    }

    private void search(int by) {
        RigidTree.Found met = images[by];
        for (int round = 0; round < team.rounds(); round++) {
            int last = team.to(count, by, round);
            for (int t = team.from(count, by, round); t < last; t++) {
                int b = 4 * t;
                look(tree.box, tree.box[b], tree.box[b + 1], tree.box[b + 2], tree.box[b + 3], met);
                worker[t] = by;
                from[t] = foundCount[by];
                for (int k = 0; k < met.count; k++) {
                    if (met.box[k] > t) {
                        add(by, from[t], met.box[k]);
                    }
                }
                end[t] = foundCount[by];
            }
        }
    }

    /** Adds a candidate in order to those from one on, once. */
    private void add(int by, int first, int other) {
        int n = foundCount[by];
        if (n == found[by].length) {
            found[by] = Arrays.copyOf(found[by], 2 * n);
        }
        int[] to = found[by];
        int k = n;
        while (k > first && to[k - 1] > other) {
            k--;
        }
        if (k == first || to[k - 1] != other) {
            System.arraycopy(to, k, to, k + 1, n - k);
            to[k] = other;
            foundCount[by]++;
        }
    }

    /** Those bodies behind a body of which its candidates are: in this array from {@link #first} to {@link #last}, in order. */
    int[] of(int t) {
        return found[worker[t]];
    }

    int first(int t) {
        return from[t];
    }

    int last(int t) {
        return end[t];
    }

    /** Finds the bodies whose boxes meet a box or one of its images. */
    void findNear(float minX, float minY, float maxX, float maxY, RigidTree.Found to) {
        look(box, minX, minY, maxX, maxY, to);
    }

    private void look(float[] boxes, float minX, float minY, float maxX, float maxY, RigidTree.Found to) {
        to.count = 0;
        for (int n = 0; n < state.images.count; n++) {
            float ax = state.images.x[n];
            float ay = state.images.y[n];
            tree.find(boxes, minX + ax, minY + ay, maxX + ax, maxY + ay, to);
        }
    }

    /** Whether the boxes of two bodies meet, or images of them. */
    boolean meet(int t, int other) {
        int a = 4 * t;
        int b = 4 * other;
        boolean meet = false;
        for (int n = 0; !meet && n < state.images.count; n++) {
            float ax = state.images.x[n];
            float ay = state.images.y[n];
            meet = box[b] <= box[a + 2] + ax
                    && box[b + 1] <= box[a + 3] + ay
                    && box[b + 2] >= box[a] + ax
                    && box[b + 3] >= box[a + 1] + ay;
        }
        return meet;
    }

    long bytes() {
        long sum = tree.bytes() + 4L * (box.length + worker.length + from.length + end.length + ids.length);
        for (int k = 0; k < images.length; k++) {
            sum += images[k].bytes() + 4L * found[k].length;
        }
        return sum;
    }
}
