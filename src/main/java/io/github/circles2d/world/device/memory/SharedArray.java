package io.github.circles2d.world.device.memory;

/**
 * Arrays that lie in the memory of another {@link DeviceArray}, which is free at that time. A row gives the kernels a function,
 * {@code listedOf(w)} for {@link #LISTED}.
 */
enum SharedArray {
    CANDIDATES("int", "candidates", DeviceArray.RANK, "by working slot, if crowds are thinned out"),
    FOUND(
            "int4",
            "found",
            DeviceArray.CONTACT,
            "contacts in no order: the slot that looked, the slot it saw, group, how many the group had before"),
    LISTED(
            "ulong2",
            "listed",
            DeviceArray.BASE,
            "by tiles, like contacts in no order within a group: ids as in key, slots as in pair; together, since a store of 16 bytes"
                    + " takes no longer than one of 8"),
    STARTING("float4", "starting", DeviceArray.MASSES, "by tiles, as contacts are listed: contact as the step begins"),
    START_IMPULSES("float2", "startImpulses", DeviceArray.IMPULSE, "by tiles, as listed: impulse as the step begins"),
    NUMBERS("int", "numbers", DeviceArray.KEY, "by tiles, as contacts are listed: number for the passes"),
    MET(
            "uint",
            "met",
            DeviceArray.SHAPE,
            "by tiles, two a copy, of which the first half of a tile's is used: contacts as met"),
    WORKING_SLOT(
            "int",
            "workingSlot",
            DeviceArray.BUCKET_BEFORE,
            "if there are joints or circles sleep, by slot at home, once circles are sorted"),
    COPIES("float4", "copies", DeviceArray.CONTACT, "by tiles, by copy: normal x, y, separation, effective mass");

    private final String type;
    private final String kernelName;
    private final DeviceArray aliasOf;
    private final String comment;

    SharedArray(String type, String kernelName, DeviceArray aliasOf, String comment) {
        this.type = type;
        this.kernelName = kernelName;
        this.aliasOf = aliasOf;
        this.comment = comment;
    }

    /** The array whose memory it is. */
    DeviceArray aliasOf() {
        return aliasOf;
    }

    int elementBytes() {
        return DeviceArray.bytesOf(type);
    }

    /** The function of the kernels. */
    String text() {
        return "// " + comment + "\nglobal " + type + " *" + kernelName + "Of(const World *w) { return (global " + type
                + " *) w->" + aliasOf.kernelName() + "; }\n";
    }
}
