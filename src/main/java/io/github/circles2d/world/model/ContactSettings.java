package io.github.circles2d.world.model;

/** Of walls, too: a speed, or {@link #BY_GRAVITY}; hertz; a ratio; mean radii a second. */
public record ContactSettings(float restitutionThreshold, float frequency, float damping, float pushOutSpeed) {
    /** The threshold follows from gravity and radii. */
    public static final float BY_GRAVITY = -1f;

    public static final ContactSettings DEFAULT =
            new ContactSettings(BY_GRAVITY, Tuning.FREQUENCY, Tuning.DAMPING, 2f * Tuning.PUSH);

    public ContactSettings {
        if (restitutionThreshold != BY_GRAVITY) {
            Limits.within("the restitution threshold", restitutionThreshold, 0f, Limits.SPEED);
        }
        Limits.within("the contact frequency", frequency, Limits.LEAST_FREQUENCY, Limits.GREATEST_FREQUENCY);
        Limits.within("the contact damping", damping, 0f, Limits.DAMPING);
        Limits.within("the greatest push-out speed", pushOutSpeed, 0f, Limits.PUSH_OUT_SPEED);
    }

    /** No {@code equals}, as {@link Bounds#differs}. */
    public boolean isDefault() {
        return restitutionThreshold == DEFAULT.restitutionThreshold
                && frequency == DEFAULT.frequency
                && damping == DEFAULT.damping
                && pushOutSpeed == DEFAULT.pushOutSpeed;
    }

    /** Whether constants of kernels change. */
    public boolean areTuned() {
        return restitutionThreshold != BY_GRAVITY || pushOutSpeed != DEFAULT.pushOutSpeed;
    }

    public ContactSettings withRestitutionThreshold(float speed) {
        return new ContactSettings(speed, frequency, damping, pushOutSpeed);
    }

    public ContactSettings withFrequency(float hertz) {
        return new ContactSettings(restitutionThreshold, hertz, damping, pushOutSpeed);
    }

    public ContactSettings withDamping(float ratio) {
        return new ContactSettings(restitutionThreshold, frequency, ratio, pushOutSpeed);
    }

    public ContactSettings withPushOutSpeed(float speed) {
        return new ContactSettings(restitutionThreshold, frequency, damping, speed);
    }
}
