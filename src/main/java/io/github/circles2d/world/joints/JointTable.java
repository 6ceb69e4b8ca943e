package io.github.circles2d.world.joints;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.IdTable;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointStep;

/**
 * The joints: of each its rows for steps ({@link JointRow}), its spring, its colour, and where its anchor is on a body of terrain. Changes have been
 * checked, and there is room.
 */
public final class JointTable {
    /** The colour of a split joint. */
    public static final int SPLIT = JointStep.COLOURS;

    // the ends of a joint
    private static final int ENDS = 2;
    private static final int A = 0;
    private static final int B = 1;

    public final IdTable ids = new IdTable(Handle.JOINT);

    final SpringTable springs = new SpringTable();

    /** What steps are told of each joint. */
    final JointRows rows = new JointRows();

    final JointColours colours = new JointColours();

    /** Anchors on bodies of terrain. */
    public final AnchorPlaces places = new AnchorPlaces();

    private final JointLists ofCircles = new JointLists();

    // joints by what they have
    private int turning;
    private int breakable;
    private int parting;

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
        rows.setRoom(c);
        colours.setRoom(c);
        places.setRoom(c);
        ids.setRoom(c);
    }

    private void ensureCircles(int circleIds) {
        ofCircles.ensure(circleIds, ENDS * ids.room());
        colours.ensure(circleIds);
    }

    /** Makes room for one more spring. */
    public void ensureSpring() {
        ensureSprings(1);
    }

    /** Makes room for more springs. */
    public void ensureSprings(int more) {
        springs.ensure(more);
    }

    // ---- what there is
    // -----------------------------------------------------------------------------------------------

    public int a(int joint) {
        return rows.trait(joint, JointRow.A);
    }

    /** {@link JointRow#NONE} if it holds a circle to no other. */
    public int b(int joint) {
        return rows.trait(joint, JointRow.B);
    }

    /** {@link JointRow#FORM} */
    public int form(int joint) {
        return rows.trait(joint, JointRow.FORM);
    }

    public int serial(int joint) {
        return rows.trait(joint, JointRow.SERIAL);
    }

    /** {@link JointRow#REFERENCE_A} or {@code REFERENCE_B}. */
    public int reference(int joint, int which) {
        return rows.trait(joint, which);
    }

    /** A number of {@link JointRow}. */
    public float value(int joint, int which) {
        return rows.value(joint, which);
    }

    public int colour(int joint) {
        return colours.get(joint);
    }

    /** Hertz; 0 without a spring. */
    public float frequency(int joint) {
        return springs.frequency(spring(joint));
    }

    public float dampingRatio(int joint) {
        return springs.dampingRatio(spring(joint));
    }

    private int spring(int joint) {
        return rows.trait(joint, JointRow.SPRING);
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
        colours.set(joint, colours.free(a, b));
        link(joint);
        if (b != JointRow.NONE) {
            splitIfHub(joint, a);
            splitIfHub(joint, b);
        }
        return joint;
    }

    /** Splits the joints of a circle with others that has so many. It does so once for all; then a new joint alone has a colour. */
    private void splitIfHub(int joint, int circle) {
        if (colours.becomesHub(circle)) {
            for (int place = firstOfCircle(circle); place >= 0; place = nextOfCircle(place)) {
                if (b(jointAt(place)) != JointRow.NONE) {
                    split(jointAt(place));
                }
            }
        } else if (colours.isHub(circle)) {
            split(joint);
        }
    }

    private void split(int joint) {
        colours.split(joint, a(joint), b(joint));
    }

    /** All but the colour, the lists and the id. */
    private void put(int joint, JointForm form, int a, int b) {
        rows.put(joint, form, springOf(form.traits, form.frequency, form.dampingRatio), a, b);
        places.begin(joint);
    }

    private int springOf(int form, float frequency, float dampingRatio) {
        return JointForm.has(form, JointRow.ELASTIC) ? springs.take(frequency, dampingRatio) : 0;
    }

    /** Enters a joint, which has its colour, into the lists of its circles. */
    void link(int joint) {
        int a = a(joint);
        int b = b(joint);
        ofCircles.add(a, ENDS * joint + A);
        if (b != JointRow.NONE) {
            ofCircles.add(b, ENDS * joint + B);
        }
        colours.enter(joint, a, b);
        count(joint, 1);
        orderChanged = true;
    }

    private void unlink(int joint) {
        int a = a(joint);
        int b = b(joint);
        count(joint, -1);
        ofCircles.remove(a, ENDS * joint + A);
        if (b != JointRow.NONE) {
            ofCircles.remove(b, ENDS * joint + B);
        }
        colours.leave(joint, a, b);
        orderChanged = true;
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

    /** All but {@link JointSetting#ANCHOR}. */
    public void set(int joint, JointSetting setting, float x, float y) {
        int before = form(joint);
        int after = setting.traits(before, x, y);
        if (after != before) {
            count(joint, -1);
            rows.setTrait(joint, JointRow.FORM, after);
            count(joint, 1);
            if (JointForm.has(after ^ before, JointRow.LOWER | JointRow.UPPER)) {
                rows.renew(joint); // a limit that has gone pushes no more
            }
        }
        rows.write(joint, setting, x, y);
        if (setting == JointSetting.SPRING) {
            int spring = springOf(after, x + 0f, y + 0f);
            springs.release(spring(joint));
            rows.setTrait(joint, JointRow.SPRING, spring);
        } else if (setting == JointSetting.ANGLE) {
            rows.setTrait(joint, JointRow.REFERENCE_A, JointSetting.angle(x));
        }
    }

    public void remove(int joint) {
        unlink(joint);
        places.leave(joint);
        if (JointForm.has(form(joint), JointRow.ELASTIC)) {
            springs.release(spring(joint));
        }
        rows.setTrait(joint, JointRow.FORM, JointRow.NO_JOINT);
        ids.remove(joint);
    }

    /** Removes all joints. */
    public void clear() {
        for (int joint = 0; joint < ids.end(); joint++) {
            if (ids.lives(joint)) {
                remove(joint);
            }
        }
    }

    // ---- states
    // ------------------------------------------------------------------------------------------------------

    /** Makes room for so many joints, of circles of ids below a limit, with a spring each. If there is none, nothing has changed. */
    void makeRoom(int joints, int circleIds) {
        if (joints > ids.room()) {
            setRoom(joints);
        }
        if (ids.room() > 0) {
            ensureCircles(circleIds);
            springs.ensure(joints);
        }
    }

    /** Begins to take over saved ids, none of which lives yet; there is room. */
    void load(int[] generations, int joints) {
        ofCircles.clear();
        springs.clear();
        colours.clear();
        turning = 0;
        breakable = 0;
        parting = 0;
        places.clear();
        orderChanged = true;
        partnersChanged = true;
        ids.load(generations, joints);
        rows.load(joints);
    }

    /** A saved joint lives; its colour, its anchor and {@link #link} follow. */
    void revive(int joint, JointForm form, int a, int b) {
        ids.revive(joint);
        put(joint, form, a, b);
    }

    /** Tells a step of the rows. */
    void publish(JointStep step) {
        step.joints = ids.end();
        step.breakable = breaks();
        step.turns = turns();
        step.parts = parts();
        rows.publish(step);
    }

    /** Bytes of the table. */
    long bytes() {
        return rows.bytes() + places.bytes() + colours.bytes() + ofCircles.bytes() + springs.bytes();
    }
}
