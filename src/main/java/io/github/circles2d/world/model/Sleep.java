package io.github.circles2d.world.model;

/**
 * Which circles fall asleep, and which wake. A circle sleeps as long as gravity, its force and all impulses on it add up to what they did when it
 * fell asleep, and nobody is about to push it. It knows no more than those that it touches: there are no islands. {@code Sleep.cl} has the
 * same formulas.
 *
 * <p>The rest of a circle that is awake is how many steps in a row it has been near to where it came to rest; that of one that sleeps is
 * {@link #ASLEEP} minus the steps in a row in which it was out of balance.
 *
 * <p>A circle that falls asleep does not need its drift and turn any more. Their place takes the acceleration by gravity and its force that it
 * knows, and its offset: what the solver left it out of balance, which is nearly nothing for most. It is a fixed number of {@link #PARTS} of the
 * gain along each axis, in 16 bits each.
 */
public final class Sleep {
    public static final int ASLEEP = -1;

    /** Seconds for which a circle is where it was before it falls asleep. */
    public static final float TIME = 1f;

    /** How far it may drift meanwhile, in radii. */
    public static final float DRIFT = 0.003f;

    /** The same by how far it would fall. */
    public static final float SHARE_OF_FALL = 0.001f;

    /** How far a circle may be out of balance, in what gravity adds to its speed in a sub-step. */
    public static final float FLOOR = 0.01f;

    /** The same once gravity or the circle's force has changed. */
    public static final float STRICT = 0.0005f;

    /** By how much they have to change, of what they are. Smaller changes add up. */
    public static final float CHANGE = 0.001f;

    /** Parts of the gain in an offset. */
    public static final float PARTS = 16384f;

    /** Parts of the greatest offset: who has just lost what held it on a slope must not take that for rest. */
    public static final float MOST_PARTS = 328f;

    /** The offset of a circle that has just fallen asleep: it is not known yet. */
    public static final int NO_OFFSET = Integer.MIN_VALUE;

    /** How much more it may be, by what presses it. */
    public static final float MOST_BY_LOAD = 1f;

    /** Of what presses it, beyond {@link #FREE_WEIGHTS}. */
    public static final float SHARE_OF_LOAD = 0.05f;

    public static final float FREE_WEIGHTS = 2f;

    /** How many times what a spring carries counts in what presses a circle: it carries another share once its other end sleeps. */
    public static final float SPRING_LOADS = 4f;

    /** How much the balance of a surface counts that joints turn. */
    public static final float SHARE_OF_SPIN = 0.5f;

    /** Radii a step. */
    public static final float ROUNDING = 1e-7f;

    /** A circle out of balance wakes once that times the square of the steps in a row is so many gains. */
    public static final float PATIENCE = 2f;

    /** How fast somebody has to push a circle that he presses, in what gravity adds to its speed in a step. */
    public static final float PUSH = 0.5f;

    /** The same of a circle that he does not press. */
    public static final float HIT = 0.02f;

    /** Radii a step. */
    public static final float LEAST_HIT = 1e-6f;

    /** Radii a step. */
    public static final float LEAST_WAKING = 2e-6f;

    /** How far a step wakes from circle to circle. */
    public static final int RINGS = 16;

    /** How near a circle is to another one that a call changes, by the sum of radii. */
    public static final float NEIGHBOURS = 1.05f;

    /** How far a circle may turn in a step, in radians. */
    public static final float TURN_OF_STEP = 1f;

    /** Radians of a unit of angles. */
    public static final float RADIANS = 1.4629180792671596e-9f;

    private Sleep() {}

    public static boolean isAsleep(int rest) {
        return rest < 0;
    }

    /** How far a circle may drift: gain is what gravity and its force add to its speed in a sub-step. */
    public static float drift(float radius, float gain, float inverseH, float damping) {
        float drift = DRIFT * radius;
        return gain > 0f
                ? CircleMath.min(drift, SHARE_OF_FALL * (gain * inverseH) * (TIME * TIME))
                : drift * CircleMath.min(damping * TIME, 1f);
    }

    /** Whether a circle is where it came to rest. */
    public static boolean rests(float driftX, float driftY, int turned, float radius, float drift) {
        return driftX * driftX + driftY * driftY <= drift * drift
                && Math.abs((float) turned) * RADIANS * radius <= drift;
    }

    /** Whether gravity and the force of a circle are others than it knows: what they add to its speed in a sub-step, and the acceleration. */
    public static boolean changes(
            float gainX, float gainY, float knownX, float knownY, float h, float gain, float radius, float dt) {
        float change = CircleMath.length(gainX - knownX * h, gainY - knownY * h);
        return change > CHANGE * gain + ROUNDING * radius / dt;
    }

    /** A speed in parts of the gain. */
    public static int parts(float x, float gain) {
        return (int) CircleMath.clamp(x / gain * PARTS, -MOST_PARTS, MOST_PARTS);
    }

    /** The offset of a circle that is out of balance by a speed. */
    public static int offset(float x, float y, float gain) {
        return gain > 0f ? parts(x, gain) & 0xffff | parts(y, gain) << 16 : 0;
    }

    public static float offsetX(int offset, float gain) {
        return (float) (short) offset / PARTS * gain;
    }

    public static float offsetY(int offset, float gain) {
        return (float) (offset >> 16) / PARTS * gain;
    }

    /** Whether a step leaves a coordinate and its displacement as they are, to the bit, if the circle does not move. */
    public static boolean stays(float base, float displacement) {
        return Float.floatToRawIntBits(base + displacement) == Float.floatToRawIntBits(base)
                && Float.floatToRawIntBits(0f + displacement) == Float.floatToRawIntBits(displacement);
    }

    public static boolean fallsAsleep(int rest, float dt) {
        return (float) rest * dt >= TIME;
    }

    /** A speed that wakes for sure; gainOfStep is what gravity and its force add to a circle's speed in a step. */
    public static float strong(float gainOfStep, float radius, float dt) {
        return CircleMath.max(gainOfStep, LEAST_WAKING * radius / dt);
    }

    /** What a circle that is awake is about to add to the speed of one that sleeps; 0 if too little. */
    public static float hit(
            float approach,
            float separation,
            float inverseMass,
            float otherInverseMass,
            float restitution,
            float impulse,
            float gainOfStep,
            float radius,
            float dt) {
        if (!(approach > 0f) || !(separation < approach * dt)) {
            return 0f;
        }
        float share = inverseMass / (inverseMass + otherInverseMass);
        float speed = share * (1f + restitution) * approach;
        float most = (impulse > 0f ? PUSH : HIT) * gainOfStep;
        return speed > most && speed > LEAST_HIT * radius / dt ? speed : 0f;
    }

    /** By how much a circle may be out of balance; load: the normal impulses on it, as a speed. */
    public static float tolerance(boolean strict, float gain, float load, float radius, float dt) {
        float byLoad = SHARE_OF_LOAD * CircleMath.max(load - FREE_WEIGHTS * gain, 0f);
        float most = gain > 0f ? CircleMath.min(byLoad, MOST_BY_LOAD * gain) : byLoad;
        return (strict ? STRICT * gain : FLOOR * gain + most) + ROUNDING * radius / dt;
    }

    /** Whether a circle wakes that has been out of balance for some steps in a row, and is now by a speed. */
    public static boolean losesPatience(boolean strict, float gain, float imbalance, int steps) {
        return strict || gain == 0f || imbalance * (float) (steps * steps) >= PATIENCE * gain;
    }

    /** The speed that wakes a circle by what it is out of balance in a sub-step. */
    public static float imbalanceOfStep(float imbalance, int subSteps, float radius, float dt) {
        return CircleMath.max(imbalance * (float) subSteps, LEAST_WAKING * radius / dt);
    }

    /** Whether a joint moves its circles whatever they do: by a motor, or since its anchor moves. */
    public static boolean drives(int angular, float speed, float maxTorque, int anchor) {
        return angular == JointRow.TURN_SPEED && speed != 0f && maxTorque > 0f || anchor != 0;
    }

    /** An impulse that a joint has summed up in a step, as that of a sub-step of the next one. */
    public static float ofSubStep(float sum, float warmScale, int subSteps) {
        return sum * warmScale / (float) subSteps;
    }

    /** What a joint counts in what presses a circle, by its impulse of a sub-step. */
    public static float loadOfJoint(float x, float y, boolean elastic) {
        return (elastic ? SPRING_LOADS : 1f) * CircleMath.length(x, y);
    }

    /** What of the speed that woke a circle reaches one that it presses; 0 if too little. */
    public static float passedOn(
            float speed, float impulse, float load, float inverseMass, float otherInverseMass, float gainOfStep) {
        float passed =
                speed * CircleMath.min(2f * impulse / load, 1f) * CircleMath.min(inverseMass / otherInverseMass, 1f);
        return passed > PUSH * gainOfStep ? passed : 0f;
    }

    /** The same of one that it does not press. */
    public static float passedFreely(
            float speed, float separation, float inverseMass, float otherInverseMass, float gainOfStep, float dt) {
        float passed = speed * (2f * inverseMass / (inverseMass + otherInverseMass));
        return separation < speed * dt && passed > HIT * gainOfStep ? passed : 0f;
    }
}
