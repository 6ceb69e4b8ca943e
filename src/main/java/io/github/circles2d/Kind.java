package io.github.circles2d;

import io.github.circles2d.world.changes.Kinds;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.SurfaceSettings;

/**
 * A kind of circles of a world, such as players, bullets or grains. It decides which other circles they meet, and how they move. A world
 * has 256 kinds, numbered from 0; {@link World#kind(int)} gives them. Each circle is of one kind, at first of kind 0. So is each piece of
 * {@link Terrain}. A kind that nobody has changed meets all others.
 *
 * <pre>{@code
 * static final int ENEMY = 1, BULLET = 2;
 *
 * world.kind(ENEMY).setCategory(0b01);
 * world.kind(BULLET).setCategory(0b10).setMask(~0b10); // bullets ignore bullets
 * long bullet = world.add(x, y, 0.1f, 0.01f, vx, vy, BULLET);
 * }</pre>
 *
 * <p><b>Which circles meet</b> is decided by the first of these that says something:
 *
 * <ol>
 *   <li>A <b>group</b> ({@link World#setGroup}), for single circles that never meet, whatever their kinds: a player and what he
 *       fires, the parts of one vehicle.
 *   <li>The <b>matrix</b> ({@link World#setResponse}), for two kinds at a time: the exceptions, or all rules of a game with a handful
 *       of kinds.
 *   <li><b>Category and mask</b>, for rules of many kinds at once. The category has the bits that say what a kind is; the mask has the
 *       bits of the categories that it meets. Two circles meet only if each one's mask has a bit of the other's category.
 * </ol>
 *
 * <p><img src="doc-files/kinds.svg" alt="Groups decide first, then the matrix, then masks, then sensors: ignore, sense or push">
 *
 * <p><b>What circles that meet do:</b> they push each other, unless one of them is of a <b>sensor</b> ({@link #setSensor}). Then they
 * pass through each other, and {@link Events} tells when they begin and end to touch, if {@link World#report} asks for it. Make a kind a
 * sensor if it pushes nobody: goals, triggers, fields of view, coins to pick up. Take {@link Response#SENSE} in the matrix if a kind
 * is solid for some and only notices others, such as a ghost that notices the player and stands on the floor. If nobody is to notice the
 * two, a mask or {@link Response#IGNORE} is enough.
 *
 * <p>Circles that ignore each other are dropped when pairs are searched, and cost nothing after that. A change acts from the next step
 * on. Circles that overlap and begin to ignore each other move freely. If they become solid again, they are pushed out slowly, as any
 * overlap is. Kinds are in snapshots and in the hash.
 *
 * <p><b>How circles move:</b> a kind scales gravity, damps velocities and limits the speed of its circles, unless they are static.
 * The initial values change no bit.
 *
 * <p><b>How circles grip and turn:</b> a kind has friction, rolling resistance and the speed of a belt, and says how hard its circles are
 * to turn; {@link World} says what a pair has. Static circles have these too.
 *
 * <p>A kind belongs to its world: the rules of threads and of {@link World#close()} are the world's. Each setter returns the kind.
 */
public final class Kind {
    private final Kinds kinds;
    private final int number;

    Kind(Kinds kinds, int number) {
        this.kinds = kinds;
        this.number = number;
    }

    /** {@return the number of the kind, 0 to 255} */
    public int number() {
        return number;
    }

    /**
     * Makes the kind what another kind is: all its values, and its rows of the matrix ({@link World#setResponse}). The two meet each other
     * as circles of the other kind meet each other. So a variant of a kind is one call and what differs:
     *
     * <pre>{@code
     * world.kind(GHOST).copyFrom(world.kind(ENEMY)).setMask(0);
     * world.setKind(enemy, GHOST);
     * }</pre>
     *
     * <p>Circles of this kind keep their restitution. A later change of the other kind does not change this one.
     *
     * @param other a kind of the same world; this kind itself changes nothing
     * @return this
     * @throws IllegalArgumentException if the kind is of another world
     */
    public Kind copyFrom(Kind other) {
        if (Limits.notNull("other", other).kinds != kinds) {
            throw new IllegalArgumentException(other + " is of another world");
        }
        kinds.copy(other.number, number);
        return this;
    }

    /**
     * Sets the categories of the kind, for the masks of others and of queries ({@link Queries#withMask}).
     *
     * @param category any bits; a kind without any is met by no mask
     * @return this
     */
    public Kind setCategory(int category) {
        return set(KindField.CATEGORY, category);
    }

    /** {@return the categories of the kind, for the masks of others: bits; 1 at first} */
    public int category() {
        return kinds.get(KindField.CATEGORY, number);
    }

    /**
     * Sets the categories that circles of the kind meet.
     *
     * @param mask the bits of the categories; the others must accept this kind's category too
     * @return this
     */
    public Kind setMask(int mask) {
        return set(KindField.MASK, mask);
    }

    /** {@return the categories that circles of the kind meet: bits; all at first} */
    public int mask() {
        return kinds.get(KindField.MASK, number);
    }

    /**
     * Makes the kind a sensor, or solid. Circles and {@linkplain Bodies bodies} of a sensor push none and are pushed by none, except by kinds to
     * which the matrix makes them solid; walls stop them. A sensor and a circle of another kind sense each other if their masks let both meet. Two
     * sensors ignore each other; the matrix can make sensors {@link Response#SENSE} each other. Two static circles ignore each other, unless
     * a kind {@linkplain #setSensesStatic asks} for what is static. A piece of {@link Terrain} senses from both sides if it is a segment.
     *
     * @param sensor true for a sensor
     * @return this
     */
    public Kind setSensor(boolean sensor) {
        return set(KindField.SENSOR, sensor ? 1 : 0);
    }

    /** {@return whether the kind is a sensor; false at first} */
    public boolean isSensor() {
        return kinds.get(KindField.SENSOR, number) != 0;
    }

    /**
     * Says whether static circles of the kind sense static circles and pieces of a {@link TerrainBody}, too. A sensor that stays then notices a
     * static circle that the game moves, and a lift. One of the two kinds has to ask for it; whether the two sense each other is decided as for
     * circles that move ({@link #setSensor}, {@link Response#SENSE}). Pieces of a kind that asks sense static circles of any kind likewise.
     *
     * <p>Static circles never sense pieces that are fixed to the world: they would touch for ever. A body that stays counts as one that moves
     * does. Each static circle of a kind that asks takes part in all steps that report such pairs; other static circles cost nothing more.
     *
     * @param senses true to sense static circles and bodies
     * @return this
     */
    public Kind setSensesStatic(boolean senses) {
        return set(KindField.SENSES_STATIC, senses ? 1 : 0);
    }

    /** {@return whether static circles of the kind sense static circles and pieces of bodies; false at first} */
    public boolean sensesStatic() {
        return kinds.get(KindField.SENSES_STATIC, number) != 0;
    }

    /**
     * Sets the restitution that circles get with the kind: when they are added with it, or {@link World#setKind} gives it to them. A
     * circle keeps it, whatever becomes of the kind, until {@link World#setRestitution} or another kind gives it another. Pieces of
     * {@link Terrain} of the kind have it from the next step on; of a piece and a circle the greater one counts.
     *
     * @param restitution 0 (inelastic) to 1 (elastic), or {@link Float#NaN} for none: then new circles get the world's, and others
     *     keep theirs
     * @return this
     * @throws IllegalArgumentException if the value is out of range
     */
    public Kind setRestitution(float restitution) {
        return set(KindField.RESTITUTION, restitution);
    }

    /** {@return the restitution that circles get with the kind: 0 to 1, or NaN if it has none, as at first} */
    public float restitution() {
        return kinds.getFloat(KindField.RESTITUTION, number);
    }

    /**
     * Sets the factor of gravity for circles of the kind that have none of their own ({@link World#setGravityScale}). Which impacts are too slow to bounce depends on the world's gravity,
     * whatever the kind.
     *
     * @param scale -1000 to 1000: 0 for circles that do not fall, negative for circles that rise. Gravity times this is cut to 1e9
     *     along each axis
     * @return this
     * @throws IllegalArgumentException if the value is out of range
     */
    public Kind setGravityScale(float scale) {
        return set(KindField.GRAVITY_SCALE, scale);
    }

    /** {@return the factor of gravity for circles of the kind; 1 at first} */
    public float gravityScale() {
        return kinds.getFloat(KindField.GRAVITY_SCALE, number);
    }

    /**
     * Sets how fast circles of the kind that have no damping of their own ({@link World#setDamping}) lose their velocity, for example by the
     * drag of air. In t seconds they lose about the share
     * 1 - e^(-damping t) of it. A circle that a force drives comes to the speed force / (mass * damping).
     *
     * @param damping per second, 0 to 1e6
     * @return this
     * @throws IllegalArgumentException if the value is out of range
     */
    public Kind setDamping(float damping) {
        return set(KindField.DAMPING, damping);
    }

    /** {@return how fast circles of the kind lose their velocity, per second; 0 at first} */
    public float damping() {
        return kinds.getFloat(KindField.DAMPING, number);
    }

    /**
     * Sets the greatest speed of circles of the kind that have none of their own ({@link World#setGreatestSpeed}). A collision may make a circle faster for the rest of a sub-step. A velocity that is
     * set, or one that an impulse gives, is cut down in the next step.
     *
     * @param speed lengths per second, at least 0; infinite for none
     * @return this
     * @throws IllegalArgumentException if the value is out of range
     */
    public Kind setGreatestSpeed(float speed) {
        return set(KindField.GREATEST_SPEED, speed);
    }

    /** {@return the greatest speed of circles of the kind in lengths per second; infinite at first} */
    public float greatestSpeed() {
        return kinds.getFloat(KindField.GREATEST_SPEED, number);
    }

    /**
     * Sets the friction of circles of the kind that have none of their own ({@link World#setFriction}).
     *
     * @param friction 0 (slides) to 1,000, or {@link Float#NaN} for the world's, as at first
     * @return this
     * @throws IllegalArgumentException if the value is out of range
     */
    public Kind setFriction(float friction) {
        return set(KindField.FRICTION, friction + 0f);
    }

    /** {@return the friction of circles of the kind that have none of their own: 0 to 1,000, or NaN if the world's counts, as at first} */
    public float friction() {
        return kinds.getFloat(KindField.FRICTION, number);
    }

    /**
     * Sets the rolling resistance of circles of the kind that have none of their own ({@link World#setRollingResistance}).
     *
     * @param resistance 0 (rolls on) to 1,000, or {@link Float#NaN} for the world's, as at first
     * @return this
     * @throws IllegalArgumentException if the value is out of range
     */
    public Kind setRollingResistance(float resistance) {
        return set(KindField.ROLLING_RESISTANCE, resistance + 0f);
    }

    /** {@return the rolling resistance of circles of the kind that have none of their own: 0 to 1,000, or NaN if the world's counts, as at first} */
    public float rollingResistance() {
        return kinds.getFloat(KindField.ROLLING_RESISTANCE, number);
    }

    /**
     * Sets the speed of the surface of circles and pieces of the kind, as that of a belt which runs around what is solid: it carries what
     * grips it, as the surface of a circle that turns does, but the circle does not turn. It carries nothing without friction.
     *
     * <p>A positive speed carries to the right of the normal, which leads out of the surface: what lies on a floor goes to greater x, where
     * y points up. So a belt runs clockwise around a circle, and anticlockwise along the walls of a room and the inside of a drum. This
     * holds for circles, for all {@link Terrain} and for {@linkplain World#setWallSurface walls}.
     *
     * <p><img src="doc-files/belts.svg" alt="A positive belt carries to the right on a floor, up on the right wall, to the left on a ceiling, down on the left wall, and clockwise around a circle">
     *
     * @param speed lengths per second, up to 1e9 in magnitude
     * @return this
     * @throws IllegalArgumentException if the value is out of range
     */
    public Kind setBeltSpeed(float speed) {
        return set(KindField.BELT_SPEED, SurfaceSettings.beltOfKind(speed));
    }

    /**
     * {@return the speed of the surface of circles and pieces of the kind in lengths per second, with the sign of {@link #setBeltSpeed}; 0 at first}
     */
    public float beltSpeed() {
        return SurfaceSettings.beltOfKind(kinds.getFloat(KindField.BELT_SPEED, number));
    }

    /**
     * Sets how the mass of circles of the kind lies in them. It does nothing to {@linkplain Bodies#setInertia bodies}, nor to the angular velocity
     * that a circle has.
     *
     * @param inertia how it lies
     * @return this
     */
    public Kind setInertia(Inertia inertia) {
        return set(KindField.INERTIA, Limits.notNull("inertia", inertia).ordinal());
    }

    /** {@return how the mass of circles of the kind lies in them; {@link Inertia#DISC} at first} */
    public Inertia inertia() {
        return World.inertia(kinds.get(KindField.INERTIA, number));
    }

    /**
     * Sets how fast circles of the kind lose their angular velocity, as {@link #setDamping} does for velocities.
     *
     * @param damping per second, 0 to 1e6
     * @return this
     * @throws IllegalArgumentException if the value is out of range
     */
    public Kind setAngularDamping(float damping) {
        return set(KindField.ANGULAR_DAMPING, damping + 0f);
    }

    /** {@return how fast circles of the kind lose their angular velocity, per second; 0 at first} */
    public float angularDamping() {
        return kinds.getFloat(KindField.ANGULAR_DAMPING, number);
    }

    /**
     * Makes pieces of {@link Terrain} of the kind one-way: circles pass them from behind. A contact begins only if the circle was wholly in
     * front of the piece before the step. The front of a line is its right, that of an arc the side that circles touch; the front of a segment
     * is its right, too, as seen from its first end to its second. Circles of the kind take no notice. This holds for {@link Bodies}, too: what is
     * added a little deep in a one-way floor falls through it.
     *
     * @param oneWay true for one-way pieces
     * @return this
     */
    public Kind setOneWay(boolean oneWay) {
        return set(KindField.ONE_WAY, oneWay ? 1 : 0);
    }

    /** {@return whether circles pass pieces of the kind from behind; false at first} */
    public boolean isOneWay() {
        return kinds.get(KindField.ONE_WAY, number) != 0;
    }

    /**
     * Says whether circles and bodies of the kind may fall asleep, if those of the world do ({@link World.Builder#sleep}).
     *
     * @param sleeps false if they are always awake, as a hero should be
     * @return this
     */
    public Kind setSleeps(boolean sleeps) {
        return set(KindField.AWAKE, sleeps ? 0 : 1);
    }

    /** {@return whether circles and bodies of the kind may fall asleep; true at first} */
    public boolean sleeps() {
        return kinds.get(KindField.AWAKE, number) == 0;
    }

    private Kind set(KindField field, int value) {
        kinds.set(field, number, value);
        return this;
    }

    private Kind set(KindField field, float value) {
        kinds.set(field, number, value);
        return this;
    }

    @Override
    public String toString() {
        return "kind " + number;
    }
}
