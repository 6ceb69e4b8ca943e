package io.github.circles2d.world.device.plan;

/** How many work-groups a launch of {@link PersistentCpu} has at most, and how long they wait for each other. */
public class WorkGroups {
    /** How often a work-group looks for the others before it calls the launch off: about a second. */
    private static final int PATIENCE = 1 << 23;

    private static final System.Logger LOG = System.getLogger(WorkGroups.class.getName());

    private final Headcount headcount;
    private int most;

    /**
     * Work-groups that are expected to run at once.
     *
     * @param most number of compute units
     */
    public WorkGroups(int most) {
        this.most = most;
        headcount = new Headcount(most);
    }

    /** How many a launch has at most. */
    public int most() {
        return Math.min(most, headcount.most());
    }

    /** How long one waits in a launch before it leaves further steps to the host, in the unit of {@link Headcount}. */
    public int mostWaiting() {
        return Headcount.WINDOW;
    }

    /** Takes note of what steps took; see {@link Headcount#learn}. */
    public void learn(int groups, int useful, int steps, long took, long waited) {
        headcount.learn(groups, useful, steps, took, waited);
    }

    /** How many of a launch wait for each other, where there are so many. */
    public int awaited(int groups) {
        return groups;
    }

    /** How often one looks for the others before it calls the launch off. */
    public int patience() {
        return PATIENCE;
    }

    /** Takes note that a launch was called off: from now on there is one work-group alone. */
    public void calledOff() {
        LOG.log(
                System.Logger.Level.WARNING,
                "{0} work-groups of World did not run at once, as they should on so many compute units; it goes on with one",
                most);
        most = 1;
    }
}
