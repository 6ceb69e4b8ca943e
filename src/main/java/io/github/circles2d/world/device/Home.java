package io.github.circles2d.world.device;

/** How many circles, slots and cached impulses the device has at home: in the arrays that stay between steps. */
final class Home {
    /** Slots; circles that have gone may have left some of them empty. */
    int slots;

    int circles;

    /** Contacts of the last step, which cached impulses are numbered by. */
    int cachedContacts;
}
