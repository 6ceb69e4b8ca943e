package io.github.circles2d.world.joints;

import io.github.circles2d.world.circles.IdTable;
import io.github.circles2d.world.circles.SavedJointStates;
import io.github.circles2d.world.circles.SavedJoints;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;
import io.github.circles2d.world.terrain.BodyTable;
import java.util.Arrays;

/**
 * The joints: of each its rows for steps ({@link JointRow}), its spring, its colour, and where its anchor is on a body of terrain. Changes have been
 * checked, and there is room.
 */
public final class JointTable {
    /** In place of a body: that of an anchor in the world, and of joints without one. */
    public static final int WORLD = BodyTable.GROUND;

    /** The colour of a split joint. */
    public static final int SPLIT = JointStep.COLOURS;

    // the ends of a joint
    private static final int ENDS = 2;
    private static final int A = 0;
    private static final int B = 1;

    private static final int ALL_COLOURS = (1 << JointStep.COLOURS) - 1;

    public final IdTable ids = new IdTable();

    final SpringTable springs = new SpringTable();

    float[] rows = new float[0];
    int[] traits = new int[0];
    private byte[] colour = new byte[0];

    /** By joint: the body of terrain of its anchor, or {@link #WORLD}; and where it is in the body's coordinates. */
    private int[] body = new int[0];

    private float[] onBody = new float[0];

    private final JointLists ofCircles = new JointLists();

    /** By circle: a bit for each colour that one of its joints has. */
    private int[] coloursOfCircle = new int[0];

    /** By circle: its joints with other circles. */
    private int[] partnersOfCircle = new int[0];

    private int lastSerial;

    // joints by what they have
    private int turning;
    private int breakable;
    private int parting;
    private int anchoredOnBodies;

    /** Rows and traits that have changed since the step was told of them: from the first one to before the last one. */
    private int changedFrom = Integer.MAX_VALUE;

    private int changedTo;

    /** Whether joints have come or gone since the step was told of their order. */
    boolean orderChanged;

    /** Whether circles have become partners, or have ceased to be, since the step was told of them. */
    boolean partnersChanged;

    /** Makes room for more joints, between circles of ids below a limit. If there is none, nothing has changed. */
    public void ensure(int more, int circleIds) {
        int needed = ids.size() + more;
        if (needed > ids.room()) {
            setRoom(Math.max(Math.max(needed, 16), ids.room() + (ids.room() >> 1)));
        }
        ensureCircles(circleIds);
    }

    private void setRoom(int c) {
        rows = Arrays.copyOf(rows, JointRow.of(c));
        traits = Arrays.copyOf(traits, JointRow.traits(c));
        colour = Arrays.copyOf(colour, c);
        body = Arrays.copyOf(body, c);
        onBody = Arrays.copyOf(onBody, 2 * c);
        ids.setRoom(c);
    }

    private void ensureCircles(int circleIds) {
        ofCircles.ensure(circleIds, ENDS * ids.room());
        if (coloursOfCircle.length < circleIds) {
            partnersOfCircle = Arrays.copyOf(partnersOfCircle, Math.max(circleIds, coloursOfCircle.length * 3 / 2));
            coloursOfCircle = Arrays.copyOf(coloursOfCircle, partnersOfCircle.length);
        }
    }

    /** Makes room for one more spring. */
    public void ensureSpring() {
        springs.ensure(1);
    }

    // ---- what there is
    // -----------------------------------------------------------------------------------------------

    public int a(int joint) {
        return traits[JointRow.traits(joint) + JointRow.A];
    }

    /** {@link JointRow#NONE} if it holds a circle to no other. */
    public int b(int joint) {
        return traits[JointRow.traits(joint) + JointRow.B];
    }

    /** {@link JointRow#FORM} */
    public int form(int joint) {
        return traits[JointRow.traits(joint) + JointRow.FORM];
    }

    public int serial(int joint) {
        return traits[JointRow.traits(joint) + JointRow.SERIAL];
    }

    /** {@link JointRow#REFERENCE_A} or {@code REFERENCE_B}. */
    public int reference(int joint, int which) {
        return traits[JointRow.traits(joint) + which];
    }

    /** A number of {@link JointRow}. */
    public float value(int joint, int which) {
        return rows[JointRow.of(joint) + which];
    }

    public int colour(int joint) {
        return colour[joint];
    }

    public int body(int joint) {
        return body[joint];
    }

    /** In the body's coordinates, if the anchor is on one. */
    public float onBodyX(int joint) {
        return onBody[2 * joint];
    }

    public float onBodyY(int joint) {
        return onBody[2 * joint + 1];
    }

    /** Hertz; 0 without a spring. */
    public float frequency(int joint) {
        return springs.frequency(spring(joint));
    }

    public float dampingRatio(int joint) {
        return springs.dampingRatio(spring(joint));
    }

    private int spring(int joint) {
        return traits[JointRow.traits(joint) + JointRow.SPRING];
    }

    /** What a joint does. */
    public JointForm formOf(int joint) {
        JointForm form = new JointForm(form(joint));
        for (int k = JointRow.LENGTH; k <= JointRow.BREAK_TORQUE; k++) { // not where the anchor is, nor the direction
            form.row[k] = value(joint, k);
        }
        form.frequency = frequency(joint);
        form.dampingRatio = dampingRatio(joint);
        form.angle = form.kind() == JointForm.SERVO ? reference(joint, JointRow.REFERENCE_A) : 0;
        return form;
    }

    /** Whether joints turn circles. */
    public boolean turns() {
        return turning > 0;
    }

    /** Whether a joint may break. */
    public boolean breaks() {
        return breakable > 0;
    }

    /** How many may break. */
    public int breakable() {
        return breakable;
    }

    /** Whether a joint keeps two circles from colliding. */
    boolean parts() {
        return parting > 0;
    }

    /** How many have an anchor on a body of terrain. */
    public int anchoredOnBodies() {
        return anchoredOnBodies;
    }

    boolean isParting(int joint) {
        return b(joint) != JointRow.NONE && !JointForm.has(form(joint), JointRow.COLLIDE);
    }

    // ---- the joints of a circle, in any order
    // -------------------------------------------------------------------------

    /** The first place in its list, or a negative number. */
    public int firstOfCircle(int circle) {
        return ofCircles.first(circle);
    }

    public int nextOfCircle(int place) {
        return ofCircles.next(place);
    }

    /** The joint at a place. */
    public static int jointAt(int place) {
        return place / ENDS;
    }

    // ---- changes
    // -----------------------------------------------------------------------------------------------------

    /** A joint of circle a with circle b, or with none. Its anchor follows. */
    public int add(JointForm form, int a, int b) {
        int joint = ids.add();
        put(joint, form, a, b);
        colour[joint] = (byte) freeColour(a, b);
        link(joint);
        if (b != JointRow.NONE) {
            splitIfHub(joint, a);
            splitIfHub(joint, b);
        }
        return joint;
    }

    /** Splits the joints of a circle with others that has so many. It does so once for all; then a new joint alone has a colour. */
    private void splitIfHub(int joint, int circle) {
        if (partnersOfCircle[circle] == JointStep.HUB + 1) {
            for (int place = firstOfCircle(circle); place >= 0; place = nextOfCircle(place)) {
                if (b(jointAt(place)) != JointRow.NONE) {
                    split(jointAt(place));
                }
            }
        } else if (partnersOfCircle[circle] > JointStep.HUB) {
            split(joint);
        }
    }

    private void split(int joint) {
        coloursOfCircle[a(joint)] &= ~bit(joint);
        coloursOfCircle[b(joint)] &= ~bit(joint);
        colour[joint] = SPLIT;
    }

    /** All but the colour, the lists and the id. */
    private void put(int joint, JointForm form, int a, int b) {
        System.arraycopy(form.row, 0, rows, JointRow.of(joint), JointRow.STRIDE);
        put(joint, form.traits, a, b, springOf(form.traits, form.frequency, form.dampingRatio));
        setReferences(joint, form.angle, 0);
    }

    private void put(int joint, int form, int a, int b, int spring) {
        int at = JointRow.traits(joint);
        traits[at + JointRow.A] = a;
        traits[at + JointRow.B] = b;
        traits[at + JointRow.FORM] = form;
        traits[at + JointRow.SPRING] = spring;
        traits[at + JointRow.ANCHOR] = 0;
        body[joint] = WORLD;
        renew(joint);
    }

    private int springOf(int form, float frequency, float dampingRatio) {
        return JointForm.has(form, JointRow.ELASTIC) ? springs.take(frequency, dampingRatio) : 0;
    }

    private int freeColour(int a, int b) {
        int free = ~(coloursOf(a) | coloursOf(b)) & ALL_COLOURS;
        return free == 0 ? SPLIT : Integer.numberOfTrailingZeros(free);
    }

    private int coloursOf(int circle) {
        return circle == JointRow.NONE ? 0 : coloursOfCircle[circle];
    }

    /** Enters a joint, which has its colour, into the lists of its circles. */
    private void link(int joint) {
        linkEnd(joint, A, a(joint));
        linkEnd(joint, B, b(joint));
        count(joint, 1);
        orderChanged = true;
    }

    private void linkEnd(int joint, int end, int circle) {
        if (circle != JointRow.NONE) {
            ofCircles.add(circle, ENDS * joint + end);
            coloursOfCircle[circle] |= bit(joint);
            partnersOfCircle[circle] += b(joint) == JointRow.NONE ? 0 : 1;
        }
    }

    private void unlinkEnd(int joint, int end, int circle) {
        if (circle != JointRow.NONE) {
            ofCircles.remove(circle, ENDS * joint + end);
            coloursOfCircle[circle] &= ~bit(joint);
            partnersOfCircle[circle] -= b(joint) == JointRow.NONE ? 0 : 1;
        }
    }

    /** 0 of a split joint. */
    private int bit(int joint) {
        return 1 << colour[joint] & ALL_COLOURS;
    }

    /** Counts a joint among those that have what it has, or takes it out. */
    private void count(int joint, int by) {
        int form = form(joint);
        turning += JointForm.turns(form) ? by : 0;
        breakable += JointForm.has(form, JointRow.BREAKABLE) ? by : 0;
        if (isParting(joint)) {
            parting += by;
            partnersChanged = true;
        }
    }

    /** Gives a joint an anchor in the world, or another place of it. */
    public void anchor(int joint, float x, float y) {
        rows[JointRow.of(joint) + JointRow.ANCHOR_X] = x;
        rows[JointRow.of(joint) + JointRow.ANCHOR_Y] = y;
        changed(joint);
    }

    /** Gives a new joint an anchor on a body of terrain. */
    public void anchorOn(int joint, int itsBody) {
        body[joint] = itsBody;
        anchoredOnBodies++;
    }

    /** Where the anchor of a joint is on its body. */
    public void setOnBody(int joint, float x, float y) {
        onBody[2 * joint] = x + 0f;
        onBody[2 * joint + 1] = y + 0f;
    }

    /** The row of its anchor in the step. */
    void setAnchorRow(int joint, int row) {
        if (traits[JointRow.traits(joint) + JointRow.ANCHOR] != row) {
            traits[JointRow.traits(joint) + JointRow.ANCHOR] = row;
            changed(joint);
        }
    }

    /** The angles, in units, at which both circles are as they should be. */
    public void setReferences(int joint, int angleA, int angleB) {
        traits[JointRow.traits(joint) + JointRow.REFERENCE_A] = angleA;
        traits[JointRow.traits(joint) + JointRow.REFERENCE_B] = angleB;
        changed(joint);
    }

    /** Sets a number of {@link JointRow}. */
    public void setValue(int joint, int which, float value) {
        rows[JointRow.of(joint) + which] = value;
        changed(joint);
    }

    /** All but {@link JointSetting#ANCHOR}. */
    public void set(int joint, JointSetting setting, float x, float y) {
        int at = JointRow.traits(joint);
        int before = traits[at + JointRow.FORM];
        int after = setting.traits(before, x, y);
        if (after != before) {
            count(joint, -1);
            traits[at + JointRow.FORM] = after;
            count(joint, 1);
            if (JointForm.has(after ^ before, JointRow.LOWER | JointRow.UPPER)) {
                renew(joint); // a limit that has gone pushes no more
            }
        }
        setting.write(rows, JointRow.of(joint), x, y);
        if (setting == JointSetting.SPRING) {
            int spring = springOf(after, x + 0f, y + 0f);
            springs.release(traits[at + JointRow.SPRING]);
            traits[at + JointRow.SPRING] = spring;
        } else if (setting == JointSetting.ANGLE) {
            traits[at + JointRow.REFERENCE_A] = JointSetting.angle(x);
        }
        changed(joint);
    }

    public void remove(int joint) {
        count(joint, -1);
        unlinkEnd(joint, A, a(joint));
        unlinkEnd(joint, B, b(joint));
        if (body[joint] != WORLD) {
            anchoredOnBodies--;
        }
        if (JointForm.has(form(joint), JointRow.ELASTIC)) {
            springs.release(spring(joint));
        }
        traits[JointRow.traits(joint) + JointRow.FORM] = JointRow.NO_JOINT;
        changed(joint);
        ids.remove(joint);
        orderChanged = true;
    }

    /** Removes all joints. */
    public void clear() {
        for (int joint = 0; joint < ids.end(); joint++) {
            if (ids.lives(joint)) {
                remove(joint);
            }
        }
    }

    /** Its impulses so far do not count. */
    private void renew(int joint) {
        lastSerial = lastSerial == Integer.MAX_VALUE ? 1 : lastSerial + 1;
        traits[JointRow.traits(joint) + JointRow.SERIAL] = lastSerial;
        changed(joint);
    }

    private void changed(int joint) {
        changedFrom = Math.min(changedFrom, joint);
        changedTo = Math.max(changedTo, joint + 1);
    }

    // ---- states
    // ------------------------------------------------------------------------------------------------------

    public void save(SavedJoints to) {
        to.setIds(ids.end());
        ids.save(to.generation);
        for (int joint = 0; joint < to.ids; joint++) {
            to.form[joint] = ids.lives(joint) ? form(joint) : JointRow.NO_JOINT;
            if (ids.lives(joint)) {
                save(joint, to);
            }
        }
    }

    private void save(int joint, SavedJoints to) {
        to.colour[joint] = colour[joint];
        to.a[joint] = a(joint);
        to.b[joint] = b(joint);
        to.body[joint] = body[joint];
        to.referenceA[joint] = reference(joint, JointRow.REFERENCE_A);
        to.referenceB[joint] = reference(joint, JointRow.REFERENCE_B);
        for (int k = 0; k < SavedJoints.VALUES; k++) {
            to.values[SavedJoints.VALUES * joint + k] = savedValue(joint, k);
        }
    }

    /** A value of {@link SavedJoints}. */
    private float savedValue(int joint, int k) {
        return switch (k) {
            case SavedJoints.FREQUENCY -> frequency(joint);
            case SavedJoints.DAMPING_RATIO -> dampingRatio(joint);
            case JointRow.ANCHOR_X -> body[joint] == WORLD ? value(joint, k) : onBodyX(joint);
            case JointRow.ANCHOR_Y -> body[joint] == WORLD ? value(joint, k) : onBodyY(joint);
            default -> value(joint, k);
        };
    }

    /** Leaves what joints of now keep; others have no impulses. */
    public void keepPresent(SavedJointStates states) {
        states.extend(ids.end());
        for (int joint = 0; joint < ids.end(); joint++) {
            if (!ids.lives(joint) || states.serial[joint] != serial(joint)) {
                states.clear(joint);
            }
        }
    }

    /** Makes room for {@link #load}. If there is none, nothing has changed. */
    public void makeRoom(SavedJoints from, int circleIds) {
        if (from.ids > ids.room()) {
            setRoom(from.ids);
        }
        if (ids.room() > 0) {
            ensureCircles(circleIds);
            springs.ensure(from.ids);
        }
    }

    /** Takes over saved joints, whose circles and bodies are there; what they keep gets the serials of now. There is room. */
    public void load(SavedJoints from, SavedJointStates states) {
        if (!areThose(from)) {
            replace(from);
        }
        for (int joint = 0; joint < from.ids; joint++) {
            states.serial[joint] = ids.lives(joint) ? serial(joint) : 0;
        }
    }

    /** Whether the saved joints are those that are there, by their bits, as in each rollback: their order stays. */
    private boolean areThose(SavedJoints from) {
        boolean same = from.ids == ids.end();
        for (int joint = 0; same && joint < from.ids; joint++) {
            same = ids.isSame(joint, from.lives(joint), from.generation[joint])
                    && (!ids.lives(joint) || isThat(from, joint));
        }
        return same;
    }

    private boolean isThat(SavedJoints from, int joint) {
        boolean same = from.form[joint] == form(joint)
                && from.colour[joint] == colour[joint]
                && from.a[joint] == a(joint)
                && from.b[joint] == b(joint)
                && from.body[joint] == body[joint]
                && from.referenceA[joint] == reference(joint, JointRow.REFERENCE_A)
                && from.referenceB[joint] == reference(joint, JointRow.REFERENCE_B);
        for (int k = 0; same && k < SavedJoints.VALUES; k++) {
            same = Float.floatToRawIntBits(from.values[SavedJoints.VALUES * joint + k])
                    == Float.floatToRawIntBits(savedValue(joint, k));
        }
        return same;
    }

    private void replace(SavedJoints from) {
        ofCircles.clear();
        springs.clear();
        Arrays.fill(coloursOfCircle, 0);
        Arrays.fill(partnersOfCircle, 0);
        turning = 0;
        breakable = 0;
        parting = 0;
        anchoredOnBodies = 0;
        orderChanged = true;
        partnersChanged = true;
        ids.load(from.generation, from.ids);
        for (int joint = 0; joint < from.ids; joint++) {
            traits[JointRow.traits(joint) + JointRow.FORM] = JointRow.NO_JOINT;
            changed(joint);
            if (from.lives(joint)) {
                ids.revive(joint);
                load(joint, from);
            }
        }
    }

    private void load(int joint, SavedJoints from) {
        int values = SavedJoints.VALUES * joint;
        int form = from.form[joint];
        System.arraycopy(from.values, values, rows, JointRow.of(joint), JointRow.STRIDE);
        int spring = springOf(
                form, from.values[values + SavedJoints.FREQUENCY], from.values[values + SavedJoints.DAMPING_RATIO]);
        put(joint, form, from.a[joint], from.b[joint], spring);
        setReferences(joint, from.referenceA[joint], from.referenceB[joint]);
        colour[joint] = from.colour[joint];
        link(joint);
        if (from.body[joint] != WORLD) {
            anchorOn(joint, from.body[joint]);
            setOnBody(joint, from.values[values + JointRow.ANCHOR_X], from.values[values + JointRow.ANCHOR_Y]);
        }
    }

    /** Tells a step of the rows. */
    void publish(JointStep step) {
        step.joints = ids.end();
        step.rows = rows;
        step.traits = traits;
        step.breakable = breaks();
        step.turns = turns();
        step.parts = parts();
        if (changedTo > 0) {
            step.changedFrom = changedFrom;
            step.changedTo = changedTo;
            step.version++;
            changedFrom = Integer.MAX_VALUE;
            changedTo = 0;
        }
    }

    /** Bytes of the table. */
    long bytes() {
        return 4L * (rows.length + traits.length + body.length + onBody.length + 2 * coloursOfCircle.length)
                + colour.length
                + ofCircles.bytes()
                + springs.bytes();
    }
}
