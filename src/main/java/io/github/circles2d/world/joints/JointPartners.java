package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.JointStep;
import java.util.Arrays;

/** Works out, by circle, with which others it does not collide since a joint holds both. */
final class JointPartners {
    private final JointTable table;

    JointPartners(JointTable table) {
        this.table = table;
    }

    /** Makes room for {@link #make}. If there is none, nothing has changed. */
    void makeRoom(JointStep step, int circleIds) {
        if (step.partnerStart.length < circleIds + 1) {
            step.partnerStart = Arrays.copyOf(step.partnerStart, circleIds + (circleIds >> 1) + 1);
        }
        int joints = table.ids.size();
        if (step.partners.length < 4 * joints) {
            step.partners = Arrays.copyOf(step.partners, 4 * (joints + (joints >> 1)));
        }
    }

    /** Lists all partners anew, of a circle in the order of the joints. */
    void make(JointStep step) {
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
}
