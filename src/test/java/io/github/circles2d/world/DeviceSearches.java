package io.github.circles2d.world;

/** Has simulations answer queries on their device, where they would choose the host. */
public final class DeviceSearches {
    private DeviceSearches() {}

    /** From now on, if the device can. */
    public static Simulation always(Simulation simulation) {
        simulation.searches.alwaysOnDevice();
        return simulation;
    }

    /** How many calls the device has answered. */
    public static int answered(Simulation simulation) {
        return simulation.searches.answeredOnDevice();
    }
}
