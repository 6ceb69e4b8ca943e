package io.github.circles2d.world.model;

/**
 * What steps need compiled kernels for.
 *
 * @param tuned contacts of any settings
 * @param reporting whether steps report something
 * @param recording whether they also record what contacts do
 */
public record Readiness(boolean tuned, Features features, boolean reporting, boolean recording) {
    /** A walled world of circles that do not turn, with the usual contacts, which reports nothing. */
    public static final Readiness USUAL = new Readiness(false, Features.NONE, false, false);

    /** The same without what steps report. */
    public Readiness silent() {
        return reporting ? new Readiness(tuned, features, false, false) : this;
    }

    /** Whether it is this, without an object to compare with. */
    public boolean is(boolean isTuned, Features ofWorld, boolean reports, boolean records) {
        return tuned == isTuned && features == ofWorld && reporting == reports && recording == records;
    }
}
