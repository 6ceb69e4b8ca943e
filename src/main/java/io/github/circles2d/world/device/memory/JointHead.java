package io.github.circles2d.world.device.memory;

/** What kernels know of the joints of a step: the struct at {@link DeviceArray#JOINTS}. */
final class JointHead {
    static final String NAME = "JointHead";

    static final HostStruct<JointHead> STRUCT = struct();

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

    private static HostStruct<JointHead> struct() {
        HostStruct<JointHead> struct = new HostStruct<>(NAME);
        for (JointArray table : JointArray.ALL) {
            int k = table.ordinal();
            struct.field("int", table.kernelName(), (head, to) -> to.put(head.at[k]), table.comment());
        }
        return struct.field("int", "any", (head, to) -> to.put(head.any), "1 where the step has joints")
                .field("int", "count", (head, to) -> to.put(head.count), "joints in the order")
                .field("int", "splitStart", (head, to) -> to.put(head.splitStart), "the first split one in the order")
                .field("int", "splitCircles", (head, to) -> to.put(head.splitCircles), "circles of split joints")
                .field("int", "batches", (head, to) -> to.put(head.batches), "batches of joints")
                .field("int", "colours", (head, to) -> to.put(head.colours), "colours in use")
                .field("int", "partnered", (head, to) -> to.put(head.partnered), "ids that partnerStarts knows")
                .field("float", "massScale", (head, to) -> to.put(head.massScale), "of rigid joints")
                .field("float", "biasRate", (head, to) -> to.put(head.biasRate), "the same")
                .field("float", "impulseScale", (head, to) -> to.put(head.impulseScale), "the same");
    }
}
