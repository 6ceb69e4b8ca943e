package io.github.circles2d.world.device.memory;

/** Counts that the kernels of a stage take as arguments, after the arrays. */
enum DeviceCount {
    SLOTS("slots", "slots at home, empty ones included"),
    CIRCLES("circles", "circles: working slots"),
    CONTACT_ROOM("contactRoom", "contacts that the contact arrays can hold"),
    ID_STRIDE("idStride", "elements from one array of a block to the next"),
    SLOT_STRIDE("slotStride", "elements from one array of a block to the next"),
    BUCKET_STRIDE("bucketStride", "elements from one array of a block to the next"),
    CONTACT_STRIDE("contactStride", "elements from one array of a block to the next"),
    COPY_ROOM("copyRoom", "copies of contacts that there is room for: elements from one array of a block to the next");

    static final int COUNT = values().length;

    private final String kernelName;
    private final String comment;

    DeviceCount(String kernelName, String comment) {
        this.kernelName = kernelName;
        this.comment = comment;
    }

    String kernelName() {
        return kernelName;
    }

    String comment() {
        return comment;
    }

    /** Position of the kernels' argument. */
    int position() {
        return DeviceArguments.COUNT + ordinal();
    }
}
