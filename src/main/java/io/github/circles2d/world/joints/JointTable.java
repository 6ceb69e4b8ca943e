package io.github.circles2d.world.joints;

import io.github.circles2d.world.circles.Handle;
import io.github.circles2d.world.circles.IdTable;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.JointRules;
import io.github.circles2d.world.model.JointStep;
import java.util.Arrays;

/**
 * The joints: of each its rows for steps ({@link JointRow}), its spring, its colour, and where its anchor is on a body of terrain. Changes have been
 * checked, and there is room.
 */
public final class JointTable {
    /** The colour of a split joint. */
    public static final int SPLIT = JointStep.COLOURS;

    public final IdTable ids = new IdTable(Handle.JOINT);

    final SpringTable springs = new SpringTable();

    /** Anchors on bodies of terrain. */
    public final AnchorPlaces places = new AnchorPlaces();

    /** Ends at bodies that are pushed. */
    public final RigidEnds rigid = new RigidEnds();

    final JointsOfCircles ofCircles = new JointsOfCircles();

    // by joint, as steps see it
    private float[] rows = new float[0];
    private int[] traits = new int[0];

    private int lastSerial;

    /** Joints whose rows have changed since the step was told of them: from the first one to before the last one. */
    private int changedFrom = Integer.MAX_VALUE;

    private int changedTo;

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
        ofCircles.ensure(circleIds);
    }

    private void setRoom(int c) {
        rows = Arrays.copyOf(rows, JointRow.of(c));
        traits = Arrays.copyOf(traits, JointRow.traits(c));
        ofCircles.setRoom(c);
        places.setRoom(c);
        rigid.setRoom(c);
        ids.setRoom(c);
    }

    /** Makes room for more springs. */
    public void ensureSprings(int more) {
        springs.ensure(more);
    }

    // ---- what there is

    /** A trait of {@link JointRow}. */
    int trait(int joint, int which) {
        return traits[JointRow.traits(joint) + which];
    }

    /** {@link JointRow#NONE} if a body that is pushed is its first end. */
    public int a(int joint) {
        return trait(joint, JointRow.A);
    }

    /** {@link JointRow#NONE} if it holds a circle to no other. */
    public int b(int joint) {
        return trait(joint, JointRow.B);
    }

    /** {@link JointRow#FORM} */
    public int form(int joint) {
        return trait(joint, JointRow.FORM);
    }

    public int serial(int joint) {
        return trait(joint, JointRow.SERIAL);
    }

    /** A number of {@link JointRow}. */
    public float value(int joint, int which) {
        return rows[JointRow.of(joint) + which];
    }

    public int colour(int joint) {
        return ofCircles.colour(joint);
    }

    /** Hertz; 0 without a spring. */
    public float frequency(int joint) {
        return springs.frequency(spring(joint));
    }

    public float dampingRatio(int joint) {
        return springs.dampingRatio(spring(joint));
    }

    private int spring(int joint) {
        return trait(joint, JointRow.SPRING);
    }

    /** What a joint does. */
    public JointForm formOf(int joint) {
        JointForm form = new JointForm(form(joint));
        for (int k = JointRow.LENGTH; k <= JointRow.BREAK_TORQUE; k++) { // not where the anchor is, nor the direction
            form.row[k] = value(joint, k);
        }
        form.frequency = frequency(joint);
        form.dampingRatio = dampingRatio(joint);
        form.angle = form.kind() == JointForm.SERVO ? trait(joint, JointRow.REFERENCE_A) : 0;
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

    /** Whether a joint keeps two circles from colliding. */
    boolean parts() {
        return parting > 0;
    }

    boolean isParting(int joint) {
        return isPair(joint) && !JointForm.has(form(joint), JointRow.COLLIDE);
    }

    /** Whether a joint holds two circles. */
    private boolean isPair(int joint) {
        return a(joint) != JointRow.NONE && b(joint) != JointRow.NONE;
    }

    // ---- the joints of a circle, in any order

    /** The first place in its list, or a negative number. */
    public int firstOfCircle(int circle) {
        return ofCircles.first(circle);
    }

    public int nextOfCircle(int place) {
        return ofCircles.next(place);
    }

    /** The joint at a place. */
    public static int jointAt(int place) {
        return JointsOfCircles.jointOf(place);
    }

    // ---- changes

    /** A joint of circle a with circle b, or with none. Its anchor follows. */
    public int add(JointForm form, int a, int b) {
        int joint = ids.add();
        put(joint, form, a, b);
        ofCircles.setColour(joint, ofCircles.freeColour(a, b));
        link(joint);
        if (b != JointRow.NONE) {
            splitIfHub(joint, a);
            splitIfHub(joint, b);
        }
        return joint;
    }

    /** A joint of circles or bodies at A and at B, of which those that are not there are {@link JointRow#NONE}. Its points follow. */
    int add(JointForm form, int a, int b, int bodyA, int bodyB) {
        int joint = ids.add();
        put(joint, form, a, b);
        rigid.enter(joint, bodyA, bodyB);
        ofCircles.setColour(joint, SPLIT);
        link(joint);
        return joint;
    }

    /** Splits the joints of a circle with others that has so many. It does so once for all; then a new joint alone has a colour. */
    private void splitIfHub(int joint, int circle) {
        if (ofCircles.becomesHub(circle)) {
            for (int place = firstOfCircle(circle); place >= 0; place = nextOfCircle(place)) {
                if (isPair(jointAt(place))) {
                    split(jointAt(place));
                }
            }
        } else if (ofCircles.isHub(circle)) {
            split(joint);
        }
    }

    private void split(int joint) {
        ofCircles.split(joint, a(joint), b(joint));
    }

    /** All but the colour, the lists and the id. It is at rest. */
    private void put(int joint, JointForm form, int a, int b) {
        System.arraycopy(form.row, 0, rows, JointRow.of(joint), JointRow.STRIDE);
        int at = JointRow.traits(joint);
        traits[at + JointRow.A] = a;
        traits[at + JointRow.B] = b;
        traits[at + JointRow.FORM] = form.traits;
        traits[at + JointRow.SPRING] = springOf(form.traits, form.frequency, form.dampingRatio);
        traits[at + JointRow.ANCHOR] = 0;
        traits[at + JointRow.REFERENCE_A] = form.angle;
        traits[at + JointRow.REFERENCE_B] = 0;
        renew(joint);
        places.begin(joint);
        rigid.begin(joint);
    }

    /** Its impulses so far do not count. */
    private void renew(int joint) {
        lastSerial = lastSerial == Integer.MAX_VALUE ? 1 : lastSerial + 1;
        setTrait(joint, JointRow.SERIAL, lastSerial);
    }

    void setTrait(int joint, int which, int to) {
        traits[JointRow.traits(joint) + which] = to;
        changed(joint);
    }

    void setValue(int joint, int which, float to) {
        rows[JointRow.of(joint) + which] = to;
        changed(joint);
    }

    private void changed(int joint) {
        changedFrom = Math.min(changedFrom, joint);
        changedTo = Math.max(changedTo, joint + 1);
    }

    /** Where an anchor is in the world. */
    void setAnchor(int joint, float x, float y) {
        setValue(joint, JointRow.ANCHOR_X, x);
        setValue(joint, JointRow.ANCHOR_Y, y);
    }

    /** The angles, in units, at which both circles are as they should be. */
    void setReferences(int joint, int angleA, int angleB) {
        setTrait(joint, JointRow.REFERENCE_A, angleA);
        setTrait(joint, JointRow.REFERENCE_B, angleB);
    }

    private int springOf(int form, float frequency, float dampingRatio) {
        return JointForm.has(form, JointRow.ELASTIC) ? springs.take(frequency, dampingRatio) : 0;
    }

    /** Enters a joint, which has its colour, into the lists of its circles. */
    void link(int joint) {
        ofCircles.enter(joint, a(joint), b(joint));
        count(joint, 1);
        orderChanged = true;
    }

    private void unlink(int joint) {
        count(joint, -1);
        ofCircles.leave(joint, a(joint), b(joint));
        orderChanged = true;
    }

    /** Counts a joint among those that have what it has, or takes it out. */
    private void count(int joint, int by) {
        int form = form(joint);
        turning += JointRules.turns(form) ? by : 0;
        breakable += JointForm.has(form, JointRow.BREAKABLE) ? by : 0;
        if (isParting(joint)) {
            parting += by;
            partnersChanged = true;
        }
    }

    /** All but {@link JointSetting#ANCHOR}. Returns whether the joint is another one then. */
    public boolean set(int joint, JointSetting setting, float x, float y) {
        int before = form(joint);
        int after = setting.traits(before, x, y);
        if (after != before) {
            count(joint, -1);
            setTrait(joint, JointRow.FORM, after);
            count(joint, 1);
            if (JointForm.has(after ^ before, JointRow.LOWER | JointRow.UPPER)) {
                renew(joint); // a limit that has gone pushes no more
            }
        }
        boolean changes = setting.write(rows, JointRow.of(joint), x, y) || after != before;
        changed(joint);
        if (setting == JointSetting.SPRING) {
            changes = frequency(joint) != x || dampingRatio(joint) != y;
            int spring = springOf(after, x + 0f, y + 0f);
            springs.release(spring(joint));
            setTrait(joint, JointRow.SPRING, spring);
        } else if (setting == JointSetting.ANGLE) {
            changes = trait(joint, JointRow.REFERENCE_A) != JointSetting.angle(x);
            setTrait(joint, JointRow.REFERENCE_A, JointSetting.angle(x));
        }
        return changes;
    }

    public void remove(int joint) {
        unlink(joint);
        places.leave(joint);
        rigid.leave(joint);
        if (JointForm.has(form(joint), JointRow.ELASTIC)) {
            springs.release(spring(joint));
        }
        setTrait(joint, JointRow.FORM, JointRow.NO_JOINT);
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

    /** Makes room for so many joints, of circles of ids below a limit, with a spring each. If there is none, nothing has changed. */
    void makeRoom(int joints, int circleIds) {
        if (joints > ids.room()) {
            setRoom(joints);
        }
        if (ids.room() > 0) {
            ofCircles.ensure(circleIds);
            springs.ensure(joints);
        }
    }

    /** Begins to take over saved ids, none of which lives yet; there is room. */
    void load(int[] generations, int joints) {
        ofCircles.clear();
        springs.clear();
        turning = 0;
        breakable = 0;
        parting = 0;
        places.clear();
        rigid.clear();
        orderChanged = true;
        partnersChanged = true;
        ids.load(generations, joints);
        for (int joint = 0; joint < joints; joint++) {
            setTrait(joint, JointRow.FORM, JointRow.NO_JOINT);
        }
        changedFrom = 0; // what has changed behind the last joint is no step's any more
        changedTo = joints;
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
        step.rows = rows;
        step.traits = traits;
        rigid.publish(step);
        if (changedTo > 0) {
            step.changedFrom = changedFrom;
            step.changedTo = changedTo;
            step.version++;
            changedFrom = Integer.MAX_VALUE;
            changedTo = 0;
        }
    }

    long bytes() {
        return 4L * (rows.length + traits.length)
                + places.bytes()
                + rigid.bytes()
                + ofCircles.bytes()
                + springs.bytes();
    }
}
