package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import java.util.Arrays;

/**
 * Works out what steps know of all joints together ({@link JointStep}): the order in which they visit them, which follows from the joints and their
 * colours; and, by circle, with which others it does not collide since a joint holds both.
 */
final class JointSchedule {
    private static final int NONE = -1;

    private final JointTable table;

    /** By circle: another one that joints connect it with, or itself. */
    private int[] parent = new int[0];

    /** By circle that stands for a component: its joints, and its batch. */
    private int[] sizes = new int[0];

    private int[] batchOf = new int[0];

    /** By place in starts: where the next joint goes. */
    private int[] next = new int[0];

    JointSchedule(JointTable table) {
        this.table = table;
    }

    /** Makes room for {@link #make} and {@link #makePartners}. If there is none, nothing has changed. */
    void makeRoom(JointStep step, int circleIds) {
        if (batchOf.length < circleIds) {
            int c = circleIds + (circleIds >> 1);
            parent = new int[c];
            sizes = new int[c];
            batchOf = new int[c];
        }
        int joints = table.ids.size();
        if (step.splitEnds.length < 2 * joints) {
            int c = joints + (joints >> 1);
            step.order = Arrays.copyOf(step.order, c);
            step.splitIds = Arrays.copyOf(step.splitIds, 2 * c);
            step.splitEnds = Arrays.copyOf(step.splitEnds, 2 * c);
        }
        if (step.rigidOrder.length < table.rigid.count()) {
            step.rigidOrder = Arrays.copyOf(step.rigidOrder, table.rigid.count() + (table.rigid.count() >> 1));
        }
        int starts = JointStep.BATCH_STRIDE * (mostBatches(step.order.length) + 1);
        if (step.starts.length < starts) {
            step.starts = Arrays.copyOf(step.starts, starts);
        }
        if (next.length < step.starts.length) {
            next = new int[step.starts.length];
        }
        if (step.partnerStart.length < circleIds + 1) {
            step.partnerStart = Arrays.copyOf(step.partnerStart, circleIds + (circleIds >> 1) + 1);
        }
        if (step.partners.length < 4 * joints) {
            step.partners = Arrays.copyOf(step.partners, 4 * (joints + (joints >> 1)));
        }
    }

    /** Of two batches that follow each other, one component has made the second one begin: together they have more joints than one may have. */
    private static int mostBatches(int joints) {
        return 2 * joints / JointStep.BATCH + 1;
    }

    /** Makes the order anew. */
    void make(JointStep step, int circleIds) {
        connect(circleIds);
        step.batches = pack();
        order(step);
        split(step, circleIds);
        listRigid(step);
        step.orderVersion++;
    }

    private boolean hasColour(int joint) {
        return table.ids.lives(joint) && table.colour(joint) != JointTable.SPLIT;
    }

    // ---- components

    private void connect(int circleIds) {
        for (int circle = 0; circle < circleIds; circle++) {
            parent[circle] = circle;
            sizes[circle] = 0;
            batchOf[circle] = NONE;
        }
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (hasColour(joint) && table.b(joint) != JointRow.NONE) {
                parent[root(table.b(joint))] = root(table.a(joint));
            }
        }
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (hasColour(joint)) {
                sizes[root(table.a(joint))]++;
            }
        }
    }

    private int root(int circle) {
        int at = circle;
        while (parent[at] != at) {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        return at;
    }

    /** Puts components together to batches, in the order of their first joints; returns how many. */
    private int pack() {
        int batches = 0;
        int room = 0;
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (!hasColour(joint)) {
                continue;
            }
            int component = root(table.a(joint));
            if (batchOf[component] == NONE && sizes[component] <= JointStep.BATCH) {
                if (sizes[component] > room) {
                    batches++;
                    room = JointStep.BATCH;
                }
                room -= sizes[component];
                batchOf[component] = batches - 1;
            }
        }
        return batches;
    }

    // ---- the order

    private void order(JointStep step) {
        int places = JointStep.BATCH_STRIDE * (step.batches + 1);
        Arrays.fill(next, 0, places, 0);
        int colours = 0;
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (hasColour(joint)) {
                next[place(joint, step)]++;
                colours = Math.max(colours, table.colour(joint) + 1);
            }
        }
        int sum = 0;
        for (int place = 0; place < places; place++) {
            int count = next[place];
            step.starts[place] = sum;
            next[place] = sum;
            sum += count;
        }
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (hasColour(joint)) {
                step.order[next[place(joint, step)]++] = joint;
            }
        }
        step.colours = colours;
        step.splitStart = sum;
    }

    /** Where in starts the colour of a joint is; that of the last place is no joint's. */
    private int place(int joint, JointStep step) {
        int batch = batchOf[root(table.a(joint))];
        return JointStep.BATCH_STRIDE * (batch == NONE ? step.batches : batch) + table.colour(joint);
    }

    // ---- split joints

    private void split(JointStep step, int circleIds) {
        int count = step.splitStart;
        int[] number = sizes; // by circle: its number; the sizes have served
        Arrays.fill(number, 0, circleIds, NONE);
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (table.ids.lives(joint) && !hasColour(joint) && !table.rigid.has(joint)) {
                step.order[count++] = joint;
                number[table.a(joint)] = 0;
                if (table.b(joint) != JointRow.NONE) {
                    number[table.b(joint)] = 0;
                }
            }
        }
        step.count = count;
        int circles = 0;
        for (int circle = 0; count > step.splitStart && circle < circleIds; circle++) {
            if (number[circle] != NONE) {
                number[circle] = circles;
                step.splitIds[circles++] = circle;
            }
        }
        step.splitCircles = circles;
        for (int k = step.splitStart; k < count; k++) {
            int at = 2 * (k - step.splitStart);
            int b = table.b(step.order[k]);
            step.splitEnds[at] = number[table.a(step.order[k])];
            step.splitEnds[at + 1] = b == JointRow.NONE ? NONE : number[b];
        }
    }

    /** Lists the joints of bodies that are pushed, which have no colour. */
    private void listRigid(JointStep step) {
        int count = 0;
        for (int joint = 0; table.rigid.count() > 0 && joint < table.ids.end(); joint++) {
            if (table.ids.lives(joint) && table.rigid.has(joint)) {
                step.rigidOrder[count++] = joint;
            }
        }
        step.rigidCount = count;
    }

    // ---- partners

    /** Lists all partners, of a circle in the order of the joints. */
    void makePartners(JointStep step) {
        int circles = 0;
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (parts(joint)) {
                circles = Math.max(circles, Math.max(table.a(joint), table.b(joint)) + 1);
            }
        }
        int[] start = step.partnerStart;
        Arrays.fill(start, 0, circles + 1, 0);
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (parts(joint)) {
                start[table.a(joint)]++;
                start[table.b(joint)]++;
            }
        }
        for (int circle = 1; circle <= circles; circle++) {
            start[circle] += start[circle - 1]; // where its partners end
        }
        for (int joint = table.ids.end() - 1; joint >= 0; joint--) {
            if (parts(joint)) {
                enter(step, table.a(joint), table.b(joint), joint);
                enter(step, table.b(joint), table.a(joint), joint);
            }
        }
        step.partnered = circles;
        step.partnersVersion++;
    }

    private boolean parts(int joint) {
        return table.ids.lives(joint) && table.isParting(joint);
    }

    private static void enter(JointStep step, int circle, int partner, int joint) {
        int at = --step.partnerStart[circle];
        step.partners[2 * at] = partner;
        step.partners[2 * at + 1] = joint;
    }

    long bytes() {
        return 4L * (parent.length + sizes.length + batchOf.length + next.length);
    }
}
