package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Device;

/** How the steps of a World are put to a device. All plans give the same bits; they differ in how well they suit devices. */
enum Plan {
    /** A launch a colour of contacts: takes any world, and suits devices to which launches are cheap. */
    COLOURS,

    /** A launch a pass over all contacts, by {@link Tiles}; colours where the world is not one for tiles. */
    TILES,

    /** One launch for many steps of worlds that are not too large, by {@link PersistentGpu}; else tiles. */
    RESIDENT,

    /** One launch for many steps of worlds of one level on a processor, by {@link PersistentCpu}; else colours. */
    LANES;

    private static final System.Logger LOG = System.getLogger(Plan.class.getName());

    /** The plan that suits a device, with the reason in the log. */
    static Plan choose(Device device) {
        Plan plan = COLOURS;
        String reason = "it is neither a GPU nor a processor";
        if (PersistentCpu.fits(device)) {
            plan = LANES;
            reason = "a processor of " + device.computeUnits() + " threads";
        } else if (device.kind() == Device.Kind.GPU) {
            plan = TILES;
            reason = "a GPU with " + device.localMemoryBytes() + " bytes of local memory";
            if (!Tiles.fit(device)) {
                plan = COLOURS;
                reason += ", too few for tiles";
            } else if (PersistentGpu.fits(device)) {
                plan = RESIDENT;
                reason += ", of a vendor whose work-groups can wait for each other";
            }
        }
        LOG.log(System.Logger.Level.DEBUG, "World on {0} uses plan {1}: {2}", device.name(), plan, reason);
        return plan;
    }
}
