package io.github.circles2d;

import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.joints.JointSetting;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.Surface;

/**
 * What a joint does: the definition with which {@link Joints} add joints. It never changes; the methods that begin with "with" give another one.
 *
 * <pre>{@code
 * Joint link = Joint.distance(); // as long as the two are apart
 * Joint wheel = Joint.spring(5, 0.7f).withLimits(0.5f, 1.5f);
 * Joint twig = Joint.weld().breakingAt(200, 50);
 * }</pre>
 *
 * <p>A joint has a first circle or body ({@link World#bodies}), and another end: another circle or body; or an <em>anchor</em>, a place of the world or of a
 * {@link TerrainBody}; or the world without a place. It holds a circle by its centre and a body by a point of it. Lines of joints go between these and
 * anchors.
 *
 * <p>Lengths are up to 1e9; frequencies are in hertz, from 0, which is no spring, to 10,000; damping ratios are from 0 to 1,000, and by 1 a spring
 * does not swing. A spring has its frequency and its damping whatever the masses: it grows stiffer with them. Forces and torques are at least
 * 0 and may be infinite, which is no limit.
 */
public final class Joint {
    private static final JointType[] TYPES = JointType.values();

    private final JointForm form;

    /** The form is this joint's alone. */
    Joint(JointForm form) {
        this.form = form;
    }

    JointForm form() {
        return form;
    }

    // ---- along a line

    /**
     * Keeps two ends as far apart as they are when the joint is added.
     *
     * @return the definition
     */
    public static Joint distance() {
        return new Joint(new JointForm(JointRow.AXIAL | JointRow.RIGID));
    }

    /**
     * Keeps two ends at a distance.
     *
     * @param length the distance, 0 to 1e9
     * @return the definition
     * @throws IllegalArgumentException if the length is out of range
     */
    public static Joint distance(float length) {
        return distance().withLength(length);
    }

    /**
     * Holds two ends by a spring, whose length is their distance when the joint is added. Frequency and damping are exact up to 0.087 swings a
     * sub-step: 21 Hz with 4 sub-steps in 1/60 s. No spring swings faster than 0.159 times a sub-step: 38 Hz. More sub-steps allow more.
     *
     * @param hertz how often it swings in a second without damping, 0 to 10,000
     * @param dampingRatio 0 to 1,000
     * @return the definition
     * @throws IllegalArgumentException if a value is out of range
     */
    public static Joint spring(float hertz, float dampingRatio) {
        return spring(JointRow.AXIAL | JointRow.ELASTIC, hertz, dampingRatio);
    }

    private static Joint spring(int traits, float hertz, float dampingRatio) {
        return new Joint(new JointForm(traits).set(JointSetting.SPRING, hertz, dampingRatio));
    }

    /**
     * Keeps two ends from getting farther apart than a length.
     *
     * @param maxLength the length, at least 0
     * @return the definition
     * @throws IllegalArgumentException if the length is out of range
     */
    public static Joint rope(float maxLength) {
        return limits(0, maxLength);
    }

    /**
     * Keeps two ends at a distance between two lengths.
     *
     * @param minLength 0 to 1e9
     * @param maxLength at least the other one; may be infinite
     * @return the definition
     * @throws IllegalArgumentException if a length is out of range
     */
    public static Joint limits(float minLength, float maxLength) {
        return new Joint(new JointForm(JointRow.AXIAL).set(JointSetting.LIMITS, minLength, maxLength));
    }

    /**
     * Keeps two circles or bodies as they are to each other when the joint is added: their distance, the direction from one to the other as both turn,
     * and their angles. So they move as one. An anchor has no weld: two pins hold a body still.
     *
     * @return the definition
     */
    public static Joint weld() {
        return new Joint(new JointForm(JointRow.AXIAL | JointRow.RIGID | JointRow.ACROSS | JointRow.TURN_RIGID));
    }

    // ---- at a place

    /**
     * Keeps the centre of a circle, or a point of a body, at an anchor; or a point of a body at a circle or at a point of another body: a hinge. Both may
     * turn.
     *
     * @return the definition
     */
    public static Joint pin() {
        return new Joint(new JointForm(JointRow.POINT | JointRow.RIGID));
    }

    /**
     * Draws by a spring what {@link #pin()} keeps.
     *
     * @param hertz how often it swings in a second without damping, 0 to 10,000
     * @param dampingRatio 0 to 1,000
     * @return the definition
     * @throws IllegalArgumentException if a value is out of range
     */
    public static Joint pin(float hertz, float dampingRatio) {
        return spring(JointRow.POINT | JointRow.ELASTIC, hertz, dampingRatio);
    }

    /**
     * Drags a circle, or a point of a body, to an anchor, which {@link Joints#setAnchor} moves, by a force that is not too great: the mouse, or a finger.
     *
     * @param hertz how fast it follows, 0 to 10,000; 5 is quick
     * @param dampingRatio 0 to 1,000; by 1 it does not overshoot
     * @param maxForce the greatest force; several times the weight of what it drags to lift it. More than 5,000 times its mass may pull it through
     *     terrain
     * @return the definition
     * @throws IllegalArgumentException if a value is out of range
     */
    public static Joint mouse(float hertz, float dampingRatio, float maxForce) {
        return pin(hertz, dampingRatio).withMaxForce(maxForce);
    }

    // ---- how circles and bodies turn

    /**
     * Turns a circle or body at a speed, against the world or against another circle or body. The other one gets the opposite torque. If joints hold that by
     * its centre alone, it turns, too, and takes a part of the speed; a {@link #servo} of it and the world keeps it upright. A motor holds nothing at a
     * place: a hinge with a motor is a {@link #pin} and a motor.
     *
     * @param speed radians per second, anticlockwise where y points up, up to 1e9 in magnitude
     * @param maxTorque the greatest torque
     * @return the definition
     * @throws IllegalArgumentException if a value is out of range
     */
    public static Joint motor(float speed, float maxTorque) {
        return new Joint(new JointForm(JointRow.TURN_SPEED)
                .set(JointSetting.SPEED, speed, 0)
                .set(JointSetting.MAX_TORQUE, maxTorque, 0));
    }

    /**
     * Turns a circle or body to an angle by a spring: its own angle, or how far it is turned against another one. The spring is as stiff as the inertia of
     * these asks for. What is welded to them counts for nothing there: to lift that, take a high frequency and a high damping ratio, such as 20 and 20.
     *
     * @param angle radians, up to 1e6 in magnitude
     * @param hertz how often it swings in a second without damping, 0 to 10,000
     * @param dampingRatio 0 to 1,000
     * @param maxTorque the greatest torque
     * @return the definition
     * @throws IllegalArgumentException if a value is out of range
     */
    public static Joint servo(float angle, float hertz, float dampingRatio, float maxTorque) {
        return new Joint(new JointForm(JointRow.ELASTIC | JointRow.TURN_ANGLE)
                .set(JointSetting.ANGLE, angle, 0)
                .set(JointSetting.SPRING, hertz, dampingRatio)
                .set(JointSetting.MAX_TORQUE, maxTorque, 0));
    }

    /**
     * Slows a circle or body down, and its turning, as the floor does in a world that is seen from above. Only for one of them and the world. {@link
     * Joints#addAll(long[], Joint, long[])} adds it to many circles.
     *
     * @param maxForce the greatest force: the friction times the weight
     * @param maxTorque the greatest torque: of a disc that lies flat, two thirds of the greatest force times the radius
     * @return the definition
     * @throws IllegalArgumentException if a value is out of range
     */
    public static Joint friction(float maxForce, float maxTorque) {
        return new Joint(new JointForm(JointRow.DRAG | JointRow.TURN_SPEED)
                .set(JointSetting.MAX_FORCE, maxForce, 0)
                .set(JointSetting.MAX_TORQUE, maxTorque, 0));
    }

    // ---- changed a little

    private Joint with(JointSetting setting, float a, float b) {
        return new Joint(form.copy().set(setting, a, b));
    }

    /**
     * With another length, of a distance joint or a spring.
     *
     * @param length 0 to 1e9
     * @return another definition
     * @throws IllegalArgumentException if the length is out of range, or a joint of this type has none
     */
    public Joint withLength(float length) {
        return with(JointSetting.LENGTH, length, 0);
    }

    /**
     * With a least and a greatest length, of a spring or a joint with limits.
     *
     * @param minLength 0 to 1e9
     * @param maxLength at least the other one; may be infinite
     * @return another definition
     * @throws IllegalArgumentException if a length is out of range, or a joint of this type has none
     */
    public Joint withLimits(float minLength, float maxLength) {
        return with(JointSetting.LIMITS, minLength, maxLength);
    }

    /**
     * With a greatest force, of a pin, also one that {@link #mouse} has made, or of friction.
     *
     * @param maxForce at least 0; may be infinite
     * @return another definition
     * @throws IllegalArgumentException if the force is out of range, or a joint of this type has no greatest one
     */
    public Joint withMaxForce(float maxForce) {
        return with(JointSetting.MAX_FORCE, maxForce, 0);
    }

    /**
     * That breaks: at the end of a step in which its force or its torque was greater than these, the joint is gone.
     *
     * @param force at least 0; infinite if it does not break by a force
     * @param torque likewise
     * @return another definition
     * @throws IllegalArgumentException if a value is out of range
     */
    public Joint breakingAt(float force, float torque) {
        return with(JointSetting.BREAKING, force, torque);
    }

    /**
     * Whose two circles or bodies collide, or do not. Sensors notice them in any case.
     *
     * @param collide whether they do; at first they do not
     * @return another definition
     */
    public Joint colliding(boolean collide) {
        return with(JointSetting.COLLIDING, collide ? 1 : 0, 0);
    }

    // ---- what it is

    /** {@return what the joint is, never null} */
    public JointType type() {
        return TYPES[form.kind()];
    }

    /**
     * {@return the length of a distance joint, a spring or a weld; NaN if it is that of the ends when the joint is added; 0 if a joint of this type
     * has none}
     */
    public float length() {
        return form.value(JointRow.LENGTH);
    }

    /** {@return the least length, at least 0} */
    public float minLength() {
        return form.value(JointRow.MIN_LENGTH);
    }

    /** {@return the greatest length; infinite if there is none} */
    public float maxLength() {
        return form.value(JointRow.MAX_LENGTH);
    }

    /** {@return how often its spring swings in a second without damping; 0 if it has none} */
    public float hertz() {
        return form.frequency();
    }

    /** {@return the damping ratio of its spring, at least 0} */
    public float dampingRatio() {
        return form.dampingRatio();
    }

    /** {@return the speed of a motor in radians per second; 0 if it is none} */
    public float speed() {
        return form.value(JointRow.SPEED);
    }

    /** {@return the angle of a servo in radians, at least -pi and less than pi; 0 if it is none} */
    public float angle() {
        return Surface.radians(form.angle());
    }

    /** {@return the greatest force; infinite if there is no limit} */
    public float maxForce() {
        return form.value(JointRow.MAX_FORCE);
    }

    /** {@return the greatest torque; infinite if there is no limit} */
    public float maxTorque() {
        return form.value(JointRow.MAX_TORQUE);
    }

    /** {@return the force by which it breaks; infinite if none does} */
    public float breakForce() {
        return form.value(JointRow.BREAK_FORCE);
    }

    /** {@return the torque by which it breaks; infinite if none does} */
    public float breakTorque() {
        return form.value(JointRow.BREAK_TORQUE);
    }

    /** {@return whether its two circles or bodies collide; false at first} */
    public boolean collides() {
        return (form.traits() & JointRow.COLLIDE) != 0;
    }

    @Override
    public String toString() {
        return form.name();
    }
}
