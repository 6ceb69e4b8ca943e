package io.github.circles2d.world.model;

/**
 * What is a matter of taste in contacts and walls, in physical units.
 *
 * @param restitutionThreshold speed up to which impacts do not bounce; {@link #BY_GRAVITY} for one that follows from gravity and radii
 * @param frequency stiffness, hertz
 * @param damping damping ratio
 * @param pushOutSpeed speed at which overlaps that are not deep are pushed out, in mean radii of the pair a second
 */
public record ContactSettings(float restitutionThreshold, float frequency, float damping, float pushOutSpeed) {
    /** No fixed restitution threshold. */
    public static final float BY_GRAVITY = -1f;

    /** What worlds have if they are not told otherwise. */
    public static final ContactSettings DEFAULT =
            new ContactSettings(BY_GRAVITY, Tuning.FREQUENCY, Tuning.DAMPING, 2f * Tuning.PUSH);

    /** Checks each number. */
    public ContactSettings {
        if (restitutionThreshold != BY_GRAVITY) {
            Limits.within("the restitution threshold", restitutionThreshold, 0f, Limits.SPEED);
        }
        Limits.within("the contact frequency", frequency, Limits.LEAST_FREQUENCY, Limits.GREATEST_FREQUENCY);
        Limits.within("the contact damping", damping, 0f, Limits.DAMPING);
        Limits.within("the greatest push-out speed", pushOutSpeed, 0f, Limits.PUSH_OUT_SPEED);
    }

    /** Whether all are as by default. A record's own equals would keep its class loader from being collected for long. */
    public boolean isDefault() {
        return restitutionThreshold == DEFAULT.restitutionThreshold
                && frequency == DEFAULT.frequency
                && damping == DEFAULT.damping
                && pushOutSpeed == DEFAULT.pushOutSpeed;
    }

    /** Whether formulas of contacts need numbers that are constants by default. */
    public boolean areTuned() {
        return restitutionThreshold != BY_GRAVITY || pushOutSpeed != DEFAULT.pushOutSpeed;
    }

    /** The same with another restitution threshold. */
    public ContactSettings withRestitutionThreshold(float speed) {
        return new ContactSettings(speed, frequency, damping, pushOutSpeed);
    }

    /** The same with another frequency. */
    public ContactSettings withFrequency(float hertz) {
        return new ContactSettings(restitutionThreshold, hertz, damping, pushOutSpeed);
    }

    /** The same with another damping ratio. */
    public ContactSettings withDamping(float ratio) {
        return new ContactSettings(restitutionThreshold, frequency, ratio, pushOutSpeed);
    }

    /** The same with another push-out speed. */
    public ContactSettings withPushOutSpeed(float speed) {
        return new ContactSettings(restitutionThreshold, frequency, damping, speed);
    }
}
