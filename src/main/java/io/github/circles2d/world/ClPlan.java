package io.github.circles2d.world;

import io.github.circles2d.opencl.Device;

/** How the steps of a World are put to a device. All plans give the same bits; they differ in how well they suit devices. */
enum ClPlan {
    /** A launch a colour of contacts: takes any world, and suits devices to which launches are cheap. */
    COLOURS,

    /** A launch a pass over all contacts, by {@link ClTiles}; colours where the world is not one for tiles. */
    TILES;

    private static final System.Logger LOG = System.getLogger(ClPlan.class.getName());

    /** The plan that suits a device, with the reason in the log. */
    static ClPlan choose(Device device) {
        ClPlan plan = device.kind() == Device.Kind.GPU && ClTiles.fit(device) ? TILES : COLOURS;
        LOG.log(
                System.Logger.Level.DEBUG,
                "World on {0}: {1} ({2}, {3} bytes of local memory)",
                device.name(),
                plan,
                device.kind(),
                device.localMemoryBytes());
        return plan;
    }
}
