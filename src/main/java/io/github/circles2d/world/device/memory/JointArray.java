package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointState;

/** The tables of joints on a device: those of the host's {@code JointStep}, what joints keep, and what they need within a step. */
enum JointArray implements TableRoom.Table {
    ROWS("rows", Count.JOINTS, JointRow.STRIDE, "by joint: three float4"),
    TRAITS("traits", Count.JOINTS, JointRow.TRAITS, "by joint: two int4"),
    STATE("state", Count.JOINTS, JointState.STRIDE, "by joint: two float4, kept from step to step"),
    SERIAL(
            "serial",
            Count.JOINTS,
            1,
            "by joint: that of the joint that the state is of; its complement if it has broken"),
    BROKEN("broken", Count.JOINTS, 2, "joints that have broken, in no order: steps made before, joint"),
    SPRINGS("springs", Count.SPRINGS, JointSpring.STRIDE, "a float4 a spring"),
    ANCHORS("anchors", Count.ANCHORS, 4, "a float4 an anchor that moves and a boundary of sub-steps"),
    ORDER("order", Count.ORDERED, 1, "joints in the order of visits"),
    STARTS("starts", Count.STARTS, 1, "of each batch, and of the joints in none: where colours begin"),
    SPLIT_IDS("splitIds", Count.SPLIT_CIRCLES, 1, "circles of split joints"),
    SPLIT_ENDS("splitEnds", Count.SPLIT, 2, "by split joint: the numbers of its circles, or NONE"),
    PARTNER_STARTS("partnerStarts", Count.PARTNERED, 1, "by id of a circle: its first partner"),
    PARTNERS("partners", Count.PARTNERS, 2, "id of the other circle, joint"),

    // within a step
    ENDS("ends", Count.ORDERED, 2, "by place in the order: working slots of A and B, or NONE"),
    WORK("work", Count.ORDERED, 12, "by place in the order: three float4, see JointVisit.cl"),
    SHARES("shares", Count.SPLIT_CIRCLES, 1, "by number of a circle: how many of its split joints act"),
    SUMS("sums", Count.SPLIT_CIRCLES, 12, "by number of a circle: six longs, what it gets as speeds and as impulses");

    /** What there is one element each of. */
    enum Count {
        JOINTS,
        SPRINGS,
        ANCHORS,
        ORDERED,
        STARTS,
        SPLIT_CIRCLES,
        SPLIT,
        PARTNERED,
        PARTNERS;

        static final int COUNT = values().length;
    }

    static final JointArray[] ALL = values();

    private final String kernelName;
    private final Count count;
    private final int words;
    private final String comment;

    JointArray(String kernelName, Count count, int words, String comment) {
        this.kernelName = kernelName;
        this.count = count;
        this.words = words;
        this.comment = comment;
    }

    /** Of no tables. */
    static TableRoom room() {
        return new TableRoom("joints", 0, Count.COUNT, ALL);
    }

    String kernelName() {
        return kernelName;
    }

    @Override
    public Count count() {
        return count;
    }

    @Override
    public int words() {
        return words;
    }

    String comment() {
        return comment;
    }

    /** Whether what is there stays when room grows. */
    boolean kept() {
        return this == STATE || this == SERIAL || this == BROKEN;
    }
}
