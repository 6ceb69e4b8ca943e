package io.github.circles2d.reference;

import io.github.circles2d.JointEvents;
import io.github.circles2d.Joints;
import io.github.circles2d.reference.ReferenceJoint.End;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** The joints between circles, bodies and places. */
final class ReferenceJoints {
    /** The colour of joints that found none. */
    static final int SPLIT = 24;

    /** A circle with more joints with other circles is a hub. */
    private static final int HUB = 10;

    private final List<ReferenceJoint> joints = new ArrayList<>();

    /** By id: how many have had it. */
    private final Map<Integer, Integer> generations = new HashMap<>();

    /** Of joints that went by themselves, and that nobody has taken yet. */
    private List<JointEvent> events = new ArrayList<>();

    /** Of the step: in the order in which they are visited. */
    private List<JointVisit> visits = List.of();

    /** In the order of their ids. */
    List<ReferenceJoint> all() {
        return joints.stream().filter(Objects::nonNull).toList();
    }

    /** Of a circle, in the order of their ids. */
    List<ReferenceJoint> of(Circle c) {
        return all().stream().filter(joint -> joint.isOf(c)).toList();
    }

    /** Whether a joint keeps two circles from colliding. */
    boolean part(Circle c, Circle o) {
        return of(c).stream().anyMatch(joint -> joint.isOf(o) && !joint.collides);
    }

    /** Whether a joint drives a circle. */
    boolean drive(Circle c) {
        return of(c).stream().anyMatch(joint -> joint.drives(c));
    }

    ReferenceJoint find(long handle) {
        return joints.get(Joints.id(handle));
    }

    boolean contains(long handle) {
        int id = Joints.id(handle);
        return id >= 0 && id < joints.size() && joints.get(id) != null && joints.get(id).handle == handle;
    }

    // ---- calls

    /** Adds a joint of a circle or a body with another one, or with a place. */
    ReferenceJoint add(End a, End b, Body body, float[] anchor, JointPlan plan, Arena arena) {
        if (!joints.contains(null)) {
            joints.add(null);
        }
        int id = joints.indexOf(null);
        long handle = (long) generations.merge(id, 1, Integer::sum) << 32 | 1 << 30 | id;
        ReferenceJoint joint = new ReferenceJoint(id, handle, a, b, body, anchor);
        joint.colour = joint.holdsRigid() ? SPLIT : 0;
        while (joint.colour < SPLIT && isTaken(joint.colour, joint)) {
            joint.colour++;
        }
        joint.become(plan, arena);
        joints.set(id, joint);
        if (joint.a != null && joint.b != null) {
            splitIfHub(joint.a);
            splitIfHub(joint.b);
        }
        return joint;
    }

    private void splitIfHub(Circle circle) {
        List<ReferenceJoint> own = all().stream()
                .filter(j -> j.a != null && j.b != null && j.isOf(circle))
                .toList();
        if (own.size() > HUB) {
            own.forEach(j -> j.colour = SPLIT);
        }
    }

    /** Whether a circle of a joint has another joint of a colour. */
    private boolean isTaken(int colour, ReferenceJoint joint) {
        return all().stream()
                .anyMatch(other ->
                        other.colour == colour && (other.isOf(joint.a) || joint.b != null && other.isOf(joint.b)));
    }

    /** Its circles and bodies wake if a call changes something of it. */
    static void wake(ReferenceJoint joint) {
        Stream.of(joint.a, joint.b).filter(Objects::nonNull).forEach(Circle::wake);
        Stream.of(joint.rigids).filter(Objects::nonNull).forEach(Rigid::wake);
    }

    void remove(ReferenceJoint joint) {
        joints.set(joint.id, null);
    }

    /** Removes the joints of a circle that goes. */
    void removed(Circle gone) {
        all().stream().filter(joint -> joint.isOf(gone)).forEach(joint -> {
            wake(joint);
            go(joint, JointEvents.Reason.CIRCLE_REMOVED, 0f, 0f);
        });
    }

    /** Removes the joints of a body that goes. */
    void removed(Rigid gone) {
        all().stream()
                .filter(joint -> joint.isOf(gone))
                .forEach(joint -> go(joint, JointEvents.Reason.BODY_REMOVED, 0f, 0f));
    }

    /** Removes the joints of all bodies. */
    void removedRigids() {
        all().stream()
                .filter(ReferenceJoint::holdsRigid)
                .forEach(joint -> go(joint, JointEvents.Reason.BODY_REMOVED, 0f, 0f));
    }

    /** Removes the joints of bodies of terrain that go. */
    void removedBodies(Predicate<Body> gone) {
        all().stream()
                .filter(joint -> joint.body != null && gone.test(joint.body))
                .forEach(joint -> go(joint, JointEvents.Reason.BODY_REMOVED, 0f, 0f));
    }

    private void go(ReferenceJoint joint, JointEvents.Reason reason, float force, float torque) {
        events.add(new JointEvent(joint.handle, joint.handle(0), joint.handle(1), force, torque, reason));
        remove(joint);
    }

    List<JointEvent> takeEvents() {
        List<JointEvent> taken = events;
        events = new ArrayList<>();
        return taken;
    }

    long hash() {
        return all().stream().mapToLong(ReferenceJoint::hash).sum();
    }

    // ---- a step

    void begin(List<Circle> circles, StepParameters k, float warmScale) {
        circles.forEach(c -> c.beginJoints(k));
        all().stream().filter(ReferenceJoint::rests).forEach(joint -> joint.keep(warmScale));
        visits = all().stream()
                .filter(joint -> !joint.holdsRigid() && !joint.rests())
                .map(joint -> new JointVisit(joint, k, warmScale))
                .sorted(Comparator.comparingInt((JointVisit visit) -> visit.joint.colour)
                        .thenComparingInt(visit -> visit.joint.id))
                .toList();
        for (ReferenceJoint joint : all()) {
            Stream.of(joint.a, joint.b).filter(Objects::nonNull).forEach(c -> c.jointed = true);
            if (joint.a != null && joint.b != null && !joint.collides) {
                joint.a.parted.add(joint.b);
                joint.b.parted.add(joint.a);
            }
        }
        eachSplit(visit -> {
            visit.joint.a.splitJoints++;
            if (visit.joint.b != null) {
                visit.joint.b.splitJoints++;
            }
        });
    }

    private void eachColoured(Consumer<JointVisit> job) {
        visits.stream().filter(visit -> !visit.isSplit()).forEach(job);
    }

    private void eachSplit(Consumer<JointVisit> job) {
        visits.stream().filter(JointVisit::isSplit).forEach(job);
    }

    private void takeAll(Consumer<Circle> take) {
        List<Circle> split = new ArrayList<>();
        eachSplit(visit -> {
            split.add(visit.joint.a);
            split.add(visit.joint.b);
        });
        split.stream().filter(Objects::nonNull).distinct().forEach(take);
    }

    void prepare() {
        eachColoured(visit -> {
            visit.prepare();
            visit.giveToSums();
        });
        eachSplit(visit -> {
            visit.prepare();
            visit.giveToFixed(false);
        });
        takeAll(Circle::takeJointImpulses);
    }

    void solve(int subStep) {
        eachColoured(visit -> {
            visit.solve(subStep);
            visit.give();
        });
        eachSplit(visit -> {
            visit.solve(subStep);
            visit.giveToFixed(true);
        });
        takeAll(Circle::takeJointGains);
    }

    /** Exact springs alone do nothing without bias. */
    void relax(int subStep) {
        eachColoured(visit -> {
            if (visit.relaxes()) {
                visit.relax(subStep);
                visit.give();
                visit.end();
                visit.giveToSums();
            }
        });
        eachSplit(visit -> {
            if (visit.relaxes()) {
                visit.relax(subStep);
                visit.giveToFixed(true);
            }
        });
        takeAll(Circle::takeJointGains);
        eachSplit(visit -> {
            if (visit.relaxes()) {
                visit.end();
                visit.giveToFixed(false);
            }
        });
        takeAll(Circle::takeJointImpulses);
    }

    /** Ends a step: some break, among them those of bodies. Returns the circles of the others. */
    List<Circle> end(float dt, List<ReferenceJoint> ofBodies) {
        List<ReferenceJoint> broken = Stream.concat(
                        visits.stream().filter(JointVisit::breaks).map(visit -> visit.joint), ofBodies.stream())
                .sorted(Comparator.comparingInt(joint -> joint.id))
                .toList();
        broken.forEach(joint -> go(joint, JointEvents.Reason.BROKEN, joint.force(dt), joint.torque(dt)));
        visits = List.of();
        return broken.stream()
                .filter(joint -> !joint.holdsRigid())
                .flatMap(joint -> Stream.of(joint.a, joint.b))
                .filter(Objects::nonNull)
                .toList();
    }
}
