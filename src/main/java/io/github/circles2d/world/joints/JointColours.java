package io.github.circles2d.world.joints;

import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import java.util.Arrays;

/** The colours of joints, and which ones the joints of a circle have. */
final class JointColours {
    private static final int ALL = (1 << JointStep.COLOURS) - 1;

    /** By joint. */
    private byte[] colour = new byte[0];

    /** By circle: a bit for each colour that one of its joints has. */
    private int[] ofCircle = new int[0];

    /** By circle: its joints with other circles. */
    private int[] partners = new int[0];

    void setRoom(int joints) {
        colour = Arrays.copyOf(colour, joints);
    }

    /** Makes room for circles. If there is none, nothing has changed. */
    void ensure(int circleIds) {
        if (partners.length < circleIds) {
            int c = Math.max(circleIds, partners.length * 3 / 2);
            int[] newOfCircle = Arrays.copyOf(ofCircle, c);
            int[] newPartners = Arrays.copyOf(partners, c);
            ofCircle = newOfCircle;
            partners = newPartners;
        }
    }

    int get(int joint) {
        return colour[joint];
    }

    void set(int joint, int to) {
        colour[joint] = (byte) to;
    }

    /** The least colour that is free at a circle and at another one, which may be none. */
    int free(int a, int b) {
        int free = ~(ofCircle[a] | (b == JointRow.NONE ? 0 : ofCircle[b])) & ALL;
        return free == 0 ? JointTable.SPLIT : Integer.numberOfTrailingZeros(free);
    }

    /** 0 of a split joint. */
    private int bit(int joint) {
        return 1 << colour[joint] & ALL;
    }

    /** A joint comes. */
    void enter(int joint, int a, int b) {
        ofCircle[a] |= bit(joint);
        if (b != JointRow.NONE) {
            ofCircle[b] |= bit(joint);
            partners[a]++;
            partners[b]++;
        }
    }

    /** A joint goes. */
    void leave(int joint, int a, int b) {
        ofCircle[a] &= ~bit(joint);
        if (b != JointRow.NONE) {
            ofCircle[b] &= ~bit(joint);
            partners[a]--;
            partners[b]--;
        }
    }

    /** Whether a circle has become a hub by its last joint. */
    boolean becomesHub(int circle) {
        return partners[circle] == JointStep.HUB + 1;
    }

    boolean isHub(int circle) {
        return partners[circle] > JointStep.HUB;
    }

    /** A joint of two circles, which is there, has no colour from now on. */
    void split(int joint, int a, int b) {
        ofCircle[a] &= ~bit(joint);
        ofCircle[b] &= ~bit(joint);
        set(joint, JointTable.SPLIT);
    }

    /** No joints. */
    void clear() {
        Arrays.fill(ofCircle, 0);
        Arrays.fill(partners, 0);
    }

    long bytes() {
        return colour.length + 4L * (ofCircle.length + partners.length);
    }
}
