package io.github.circles2d.reference;

/**
 * What a joint is made of.
 *
 * @param kind what it is
 * @param numbers of the kind, as the caller gives them
 * @param length that is set; not a number if it is that of the ends
 * @param leastLength 0 if there is none
 * @param greatestLength infinite if there is none
 * @param breakForce infinite if it never breaks
 * @param breakTorque likewise
 * @param collides whether its circles collide
 */
public record JointPlan(
        Kind kind,
        float[] numbers,
        float length,
        float leastLength,
        float greatestLength,
        float breakForce,
        float breakTorque,
        boolean collides) {
    /** Who it holds to what, and the numbers that it takes. */
    public enum Kind {
        DISTANCE,
        /** Frequency, damping ratio. */
        SPRING,
        LIMITS,
        PIN,
        /** Frequency, damping ratio. */
        SOFT_PIN,
        /** Frequency, damping ratio, greatest force. */
        MOUSE,
        /** Speed, greatest torque. */
        MOTOR,
        /** Angle, frequency, damping ratio, greatest torque. */
        SERVO,
        /** Greatest force, greatest torque. */
        FRICTION,
        WELD
    }

    /** That never breaks; a length is that of the ends. */
    public static JointPlan of(Kind kind, float... numbers) {
        float none = Float.POSITIVE_INFINITY;
        return new JointPlan(kind, numbers, Float.NaN, 0f, none, none, none, false);
    }

    public JointPlan withLength(float its) {
        return new JointPlan(kind, numbers, its, leastLength, greatestLength, breakForce, breakTorque, collides);
    }

    public JointPlan withLimits(float least, float greatest) {
        return new JointPlan(kind, numbers, length, least, greatest, breakForce, breakTorque, collides);
    }

    public JointPlan breakingAt(float force, float torque) {
        return new JointPlan(kind, numbers, length, leastLength, greatestLength, force, torque, collides);
    }

    public JointPlan colliding(boolean collide) {
        return new JointPlan(kind, numbers, length, leastLength, greatestLength, breakForce, breakTorque, collide);
    }
}
