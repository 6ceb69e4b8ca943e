package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.ContactRows;

/**
 * The fields of arrays whose elements have several numbers. Kernels name them in place of the components of a vector:
 * {@code w->motion[slot].VELOCITY} is {@code w->motion[slot].zw}. A vector, and not a struct, since a device reads it at once.
 *
 * <p>A field of two meanings has a row for each; the second row says whose memory it shares.
 */
enum ElementField {
    RADIUS(DeviceArray.CIRCLE, CircleRow.RADIUS, 1),
    MASS(DeviceArray.CIRCLE, CircleRow.MASS, 1),

    DX(DeviceArray.MOTION, CircleRow.DX, 1),
    DY(DeviceArray.MOTION, CircleRow.DY, 1),
    VX(DeviceArray.MOTION, CircleRow.VX, 1),
    VY(DeviceArray.MOTION, CircleRow.VY, 1),
    DISPLACEMENT(DeviceArray.MOTION, CircleRow.DX, 2),
    VELOCITY(DeviceArray.MOTION, CircleRow.VX, 2),
    /** By tiles, from a circle's start into a sub-step to its move; the velocity is in drive. */
    WALL_TARGETS(VELOCITY),

    INVERSE_MASS(DeviceArray.TRAITS, CircleRow.INVERSE_MASS, 1),
    RESTITUTION(DeviceArray.TRAITS, CircleRow.RESTITUTION, 1),
    WALL_X(DeviceArray.TRAITS, CircleRow.WALL_X, 1),
    WALL_Y(DeviceArray.TRAITS, CircleRow.WALL_Y, 1),
    WALLS(DeviceArray.TRAITS, CircleRow.WALL_X, 2),
    /** Of a static circle that travels, which has no impulses of walls: the velocity that it gets back. */
    KEPT_VELOCITY(WALLS),

    /** Up to the biased pass: velocity before any impulse. */
    BEFORE(DeviceArray.LOAD, CircleRow.BEFORE_X, 2),
    LOADED(DeviceArray.LOAD, CircleRow.LOADED, 1),
    LOADED_NEXT(DeviceArray.LOAD, CircleRow.LOADED_NEXT, 1),
    /** From the circle's move on: sum of contact impulses. */
    IMPULSES(BEFORE),
    /** While contacts are filled: how many the circle has. */
    CANDIDATES(LOADED),

    PATH_X(DeviceArray.MOTION_CLAMP, CircleRow.PATH_X, 1),
    PATH_Y(DeviceArray.MOTION_CLAMP, CircleRow.PATH_Y, 1),
    PATH(DeviceArray.MOTION_CLAMP, CircleRow.PATH_X, 2),
    ALLOWANCE(DeviceArray.MOTION_CLAMP, CircleRow.ALLOWANCE, 1),
    PATH_LENGTH(DeviceArray.MOTION_CLAMP, CircleRow.LIMIT, 1),
    /** Once continuous collision has set the clamp. */
    FREE_SHARE(PATH_LENGTH),

    SIGHT_DISTANCE(DeviceArray.SIGHT, 2, 1),
    SIGHT_INVERSE_MASS(DeviceArray.SIGHT, 3, 1),

    CONTACT_SHARE(DeviceArray.NEAR, 0, 1),
    CONTACT_ALLOWANCE(DeviceArray.NEAR, 1, 1),

    REACH(DeviceArray.REACH, 2, 1),
    LOOKS(DeviceArray.REACH, 3, 1),

    MIN_PATH_X(DeviceArray.BLOCK_RANGE, 0, 1),
    MAX_PATH_X(DeviceArray.BLOCK_RANGE, 1, 1),
    MIN_PATH_Y(DeviceArray.BLOCK_RANGE, 2, 1),
    MAX_PATH_Y(DeviceArray.BLOCK_RANGE, 3, 1),

    LISTED_ID(DeviceArray.ORDER, 0, 1),
    LISTED_SLOT(DeviceArray.ORDER, 1, 1),

    START_VELOCITY(DeviceArray.DRIVE, 0, 2),
    START_BEFORE(DeviceArray.DRIVE, 2, 2),

    LOWER(DeviceArray.PAIR, 0, 1),
    HIGHER(DeviceArray.PAIR, 1, 1),

    BASE_X(DeviceArray.BASE, 0, 1),
    BASE_Y(DeviceArray.BASE, 1, 1),
    RADII(DeviceArray.BASE, 2, 1),
    PAIR_RESTITUTION(DeviceArray.BASE, 3, 1),

    INVERSE_MASS_A(DeviceArray.MASSES, 0, 1),
    INVERSE_MASS_B(DeviceArray.MASSES, 1, 1),
    EFFECTIVE_MASS(DeviceArray.MASSES, 2, 1),
    BOUNCE(DeviceArray.MASSES, 3, 1),

    NORMAL_X(DeviceArray.CONTACT, 0, 1),
    NORMAL_Y(DeviceArray.CONTACT, 1, 1),
    NORMAL(DeviceArray.CONTACT, 0, 2),
    SEPARATION(DeviceArray.CONTACT, 2, 1),
    NORMAL_IMPULSE(DeviceArray.CONTACT, 3, 1),
    /** Of a tile's copy of a contact. */
    COPIED_MASS(NORMAL_IMPULSE),

    SHAPE_RADII(DeviceArray.SHAPE, 0, 1),
    SHAPE_RESTITUTION(DeviceArray.SHAPE, 1, 1),

    STORED_IMPULSE(DeviceArray.IMPULSE, 0, 1),
    STORED_BOUNCE(DeviceArray.IMPULSE, 1, 1),

    PLACED_CONTACT(DeviceArray.PLACED, 0, 1),
    PLACED_CIRCLES(DeviceArray.PLACED, 1, 1),

    ANGLE(DeviceArray.TURN, 0, 1),
    ANGULAR_VELOCITY(DeviceArray.TURN, 1, 1),

    OWN_GRAVITY_SCALE(DeviceArray.OWN_MOTION, FieldsStruct.motionPlace(CircleField.GRAVITY_SCALE), 1),
    OWN_DAMPING(DeviceArray.OWN_MOTION, FieldsStruct.motionPlace(CircleField.DAMPING), 1),
    OWN_GREATEST_SPEED(DeviceArray.OWN_MOTION, FieldsStruct.motionPlace(CircleField.GREATEST_SPEED), 1),
    OWN_TORQUE(DeviceArray.OWN, FieldsStruct.turningPlace(CircleField.TORQUE), 1),

    PAIR_FRICTION(DeviceArray.PAIR_SURFACE, 0, 1),
    TANGENT_MASS(DeviceArray.PAIR_SURFACE, 1, 1),

    PAIR_BELT(DeviceArray.PAIR_REST, 0, 1),
    ROLLING_REACH(DeviceArray.PAIR_REST, 1, 1),
    ROLLING_MASS(DeviceArray.PAIR_REST, 2, 1),

    FRICTION_IMPULSE(DeviceArray.ROW_IMPULSES, ContactRows.FRICTION, 1),
    ROLLING_IMPULSE(DeviceArray.ROW_IMPULSES, ContactRows.ROLLING, 1),

    PIECES_FIRST(DeviceArray.PIECES, 0, 1),
    PIECES_COUNT(DeviceArray.PIECES, 1, 1),

    TOUCHED_PIECE(DeviceArray.PIECE, 0, 1),
    TOUCHED_SERIAL(DeviceArray.PIECE, 1, 1),
    TOUCHED(DeviceArray.PIECE, 0, 2),
    TOUCHED_RESPONSE(DeviceArray.PIECE, 2, 1),
    TOUCHED_FEATURE(DeviceArray.PIECE, 3, 1),

    PUSH_SIDE(DeviceArray.PUSH, 0, 1),
    PUSH_NORMAL(DeviceArray.PUSH, 1, 1),

    MEASURED_X(DeviceArray.MEASURED, 0, 1),
    MEASURED_Y(DeviceArray.MEASURED, 1, 1),
    MEASURED_GAP(DeviceArray.MEASURED, 2, 1),
    MEASURED_CURVE(DeviceArray.MEASURED, 3, 1),

    REST(DeviceArray.SLEEP, 0, 1),
    DRIFT_X(DeviceArray.SLEEP, 1, 1),
    DRIFT_Y(DeviceArray.SLEEP, 2, 1),
    UNITS_TURNED(DeviceArray.SLEEP, 3, 1),

    // of one that sleeps
    KNOWN_X(DRIFT_X),
    KNOWN_Y(DRIFT_Y),
    OFFSET(UNITS_TURNED),

    WAKING_SPEED(DeviceArray.WAKING, 0, 1),
    PRESSING(DeviceArray.WAKING, 1, 1),

    STANDING_PLACE(DeviceArray.STANDING, 0, 2),
    STANDING_BOUNCE(DeviceArray.STANDING, 2, 1),
    STANDING_ALLOWED(DeviceArray.STANDING, 3, 1);

    private static final String COMPONENTS = "xyzw";

    private final DeviceArray array;
    private final int at;
    private final int width;
    private final ElementField aliasOf;

    ElementField(DeviceArray array, int at, int width) {
        this.array = array;
        this.at = at;
        this.width = width;
        aliasOf = null;
    }

    ElementField(ElementField aliasOf) {
        this.aliasOf = aliasOf;
        array = aliasOf.array;
        at = aliasOf.at;
        width = aliasOf.width;
    }

    /** An array that has it; so have those that say that they are as this one. */
    DeviceArray array() {
        return array;
    }

    /** The field whose memory it shares, with another meaning at another time; or null. */
    ElementField aliasOf() {
        return aliasOf;
    }

    /** The place of its first component, for kernels that must not touch the others: {@code VELOCITY_AT}. */
    int at() {
        return at;
    }

    /** The components of the vector, such as {@code zw}. */
    String components() {
        return COMPONENTS.substring(at, at + width);
    }
}
