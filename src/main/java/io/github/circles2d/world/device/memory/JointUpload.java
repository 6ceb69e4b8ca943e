package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.device.memory.JointArray.Count;
import io.github.circles2d.world.model.AnchorRow;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointSpring;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.model.Softness;
import io.github.circles2d.world.model.StepInput;
import java.nio.IntBuffer;
import java.util.Arrays;

/**
 * Sends what has changed of the tables of joints. They stay the host's, which may change them once steps have been enqueued: those that are
 * made once more find on the device what was sent with them, and here how many launches and work-items it takes.
 */
public final class JointUpload {
    private static final int NEVER = -1;

    /** Of what was taken down last; meaningless unless there are joints. */
    private JointStep tables;

    private int subSteps;
    private int version = NEVER;
    private int orderVersion = NEVER;
    private int springsVersion = NEVER;
    private int anchorsVersion = NEVER;
    private int partnersVersion = NEVER;
    private boolean parts;
    private final int[] starts = new int[JointStep.BATCH_STRIDE];
    private final Head head = new Head();

    // the same of what is on the device
    private int sentRoom = NEVER;
    private int sentRows = NEVER;
    private int sentOrder = NEVER;
    private int sentSprings = NEVER;
    private int sentAnchors = NEVER;
    private int sentPartners = NEVER;

    /** Whether all that was taken down last has been sent, but for what has no room. */
    private boolean sent;

    private final int[] needed = new int[Count.COUNT];
    private final int[] words = new int[Head.STRUCT.words()];
    private final int[] sentWords = new int[Head.STRUCT.words()];
    private final IntBuffer wordsView = IntBuffer.wrap(words);

    /** What comes is of another world. */
    void forget() {
        tables = null;
        head.any = 0;
        sentRoom = NEVER; // so all tables are sent anew
        sent = false;
    }

    /** Takes down what the next steps are made with. */
    void set(StepInput input) {
        head.any = input.constants.joints ? 1 : 0;
        if (any()) {
            tables = input.joints;
            subSteps = input.constants.subSteps;
            version = tables.version;
            orderVersion = tables.orderVersion;
            springsVersion = tables.springsVersion;
            anchorsVersion = tables.anchorsVersion;
            partnersVersion = tables.partnersVersion;
            parts = tables.parts;
            System.arraycopy(tables.starts, JointStep.BATCH_STRIDE * tables.batches, starts, 0, starts.length);
            describe(input.constants.jointSoftness);
        } else {
            head.count = 0;
            head.splitStart = 0;
            head.splitCircles = 0;
            head.batches = 0;
            head.colours = 0;
            head.partnered = 0;
        }
        sent = false;
    }

    private void describe(Softness softness) {
        head.count = tables.count;
        head.splitStart = tables.splitStart;
        head.splitCircles = tables.splitCircles;
        head.batches = tables.batches;
        head.colours = tables.colours;
        head.partnered = parts ? tables.partnered : 0;
        head.massScale = softness.massScale;
        head.biasRate = softness.biasRate;
        head.impulseScale = softness.impulseScale;
    }

    /** Whether what was taken down last is this. */
    boolean areOf(StepInput input) {
        JointStep j = input.joints;
        return any() == input.constants.joints
                && (!any()
                        || version == j.version
                                && orderVersion == j.orderVersion
                                && springsVersion == j.springsVersion
                                && anchorsVersion == j.anchorsVersion
                                && partnersVersion == j.partnersVersion
                                && parts == j.parts);
    }

    /** Whether the steps have joints. */
    public boolean any() {
        return head.any != 0;
    }

    /** Joints of the steps. */
    public int count() {
        return head.count;
    }

    public int batches() {
        return head.batches;
    }

    /** Colours in use. */
    public int colours() {
        return head.colours;
    }

    /** How many joints of a colour are in no batch. */
    public int ofColour(int colour) {
        return starts[colour + 1] - starts[colour];
    }

    /** Joints that are split. */
    public int split() {
        return head.count - head.splitStart;
    }

    /** Circles of these. */
    public int splitCircles() {
        return head.splitCircles;
    }

    /** Makes room for what was taken down last. */
    void ensureRoom(DeviceArrays arrays) {
        if (any()) {
            need(Count.JOINTS, tables.joints);
            need(Count.SPRINGS, tables.springCount);
            need(Count.ANCHORS, tables.anchorCount * (subSteps + 1));
            need(Count.ORDERED, head.count);
            need(Count.STARTS, JointStep.BATCH_STRIDE * (head.batches + 1));
            need(Count.SPLIT_CIRCLES, head.splitCircles);
            need(Count.SPLIT, split());
            need(Count.PARTNERED, head.partnered + 1);
            need(Count.PARTNERS, partners());
            arrays.ensureJoints(needed);
        }
    }

    private void need(Count count, int elements) {
        needed[count.ordinal()] = elements;
    }

    private int partners() {
        return parts ? tables.partnerStart[tables.partnered] : 0;
    }

    /** Sends what is not there yet, where there is memory for it. */
    void send(DeviceArrays arrays) {
        if (sent || !arrays.features().joints()) {
            return;
        }
        if (sentRoom != arrays.jointRoom().version()) {
            sentRows = NEVER;
            sentOrder = NEVER;
            sentSprings = NEVER;
            sentAnchors = NEVER;
            sentPartners = NEVER;
            sentRoom = arrays.jointRoom().version();
        }
        if (any()) {
            sendRows(arrays);
            sendOrder(arrays);
            sendSprings(arrays);
            sendPartners(arrays);
        }
        sendHead(arrays);
        sent = true;
    }

    private void sendHead(DeviceArrays arrays) {
        for (JointArray table : JointArray.ALL) {
            head.at[table.ordinal()] = arrays.at(table) - DeviceArray.JOINTS_AT;
        }
        Head.STRUCT.pack(head, words);
        if (!Arrays.equals(words, sentWords)) {
            arrays.writeTable(DeviceArray.JOINTS_AT, wordsView);
            System.arraycopy(words, 0, sentWords, 0, words.length);
        }
    }

    private void sendRows(DeviceArrays arrays) {
        if (sentRows != version) {
            boolean some = sentRows != NEVER && sentRows == version - 1;
            int from = some ? tables.changedFrom : 0;
            int to = some ? tables.changedTo : tables.joints;
            arrays.write(JointArray.ROWS, tables.rows, JointRow.of(from), JointRow.of(to));
            arrays.write(JointArray.TRAITS, tables.traits, JointRow.traits(from), JointRow.traits(to));
            sentRows = version;
        }
    }

    private void sendOrder(DeviceArrays arrays) {
        if (sentOrder != orderVersion) {
            checkOrder(arrays.idCapacity());
            arrays.write(JointArray.ORDER, tables.order, 0, head.count);
            arrays.write(JointArray.STARTS, tables.starts, 0, JointStep.BATCH_STRIDE * (head.batches + 1));
            arrays.write(JointArray.SPLIT_IDS, tables.splitIds, 0, head.splitCircles);
            arrays.write(JointArray.SPLIT_ENDS, tables.splitEnds, 0, JointArray.SPLIT_ENDS.words() * split());
            sentOrder = orderVersion;
        }
    }

    /** A kernel does not look whether there are the joints of the order, and their circles. */
    private void checkOrder(int circleIds) {
        for (int k = 0; k < head.count; k++) {
            int joint = tables.order[k];
            boolean is = joint >= 0 && joint < tables.joints;
            int at = JointRow.traits(joint);
            int a = is ? tables.traits[at + JointRow.A] : JointRow.NONE;
            int b = is ? tables.traits[at + JointRow.B] : JointRow.NONE;
            if (a < 0 || a >= circleIds || b < JointRow.NONE || b >= circleIds) {
                throw new IllegalStateException("joint " + joint + " of " + tables.joints + " holds the circles " + a
                        + " and " + b + " of " + circleIds);
            }
        }
    }

    private void sendSprings(DeviceArrays arrays) {
        if (sentSprings != springsVersion) {
            arrays.write(JointArray.SPRINGS, tables.springs, 0, JointSpring.of(tables.springCount));
            sentSprings = springsVersion;
        }
        if (sentAnchors != anchorsVersion) {
            arrays.write(JointArray.ANCHORS, tables.anchors, 0, AnchorRow.of(tables.anchorCount, 0, subSteps));
            sentAnchors = anchorsVersion;
        }
    }

    private void sendPartners(DeviceArrays arrays) {
        if (parts && sentPartners != partnersVersion) {
            arrays.write(JointArray.PARTNER_STARTS, tables.partnerStart, 0, tables.partnered + 1);
            arrays.write(JointArray.PARTNERS, tables.partners, 0, JointArray.PARTNERS.words() * partners());
            sentPartners = partnersVersion;
        }
    }

    /** What kernels know of the joints of a step: the struct at {@link DeviceArray#JOINTS}. */
    static final class Head {
        static final String NAME = "JointHead";

        static final HostStruct<Head> STRUCT = struct();

        /** By table: words from {@link DeviceArray#JOINTS}. */
        final int[] at = new int[JointArray.ALL.length];

        /** 1 where the step has joints. */
        int any;

        int count;
        int splitStart;
        int splitCircles;
        int batches;
        int colours;
        int partnered;
        float massScale;
        float biasRate;
        float impulseScale;

        private static HostStruct<Head> struct() {
            HostStruct<Head> struct = new HostStruct<>(NAME);
            for (JointArray table : JointArray.ALL) {
                int k = table.ordinal();
                struct.field("int", table.kernelName(), (head, to) -> to.put(head.at[k]), table.comment());
            }
            return struct.field("int", "any", (head, to) -> to.put(head.any), "1 where the step has joints")
                    .field("int", "count", (head, to) -> to.put(head.count), "joints in the order")
                    .field(
                            "int",
                            "splitStart",
                            (head, to) -> to.put(head.splitStart),
                            "the first split one in the order")
                    .field("int", "splitCircles", (head, to) -> to.put(head.splitCircles), "circles of split joints")
                    .field("int", "batches", (head, to) -> to.put(head.batches), "batches of joints")
                    .field("int", "colours", (head, to) -> to.put(head.colours), "colours in use")
                    .field("int", "partnered", (head, to) -> to.put(head.partnered), "ids that partnerStarts knows")
                    .field("float", "massScale", (head, to) -> to.put(head.massScale), "of rigid joints")
                    .field("float", "biasRate", (head, to) -> to.put(head.biasRate), "the same")
                    .field("float", "impulseScale", (head, to) -> to.put(head.impulseScale), "the same");
        }
    }
}
