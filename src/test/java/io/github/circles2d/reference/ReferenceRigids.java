package io.github.circles2d.reference;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Predicate;

/** The bodies that are pushed of a world, and what steps keep of their contacts. */
final class ReferenceRigids {
    private static final int MARK = 3 << 28;
    private static final long CONTACT = 0x7269676964746F75L;

    /** By id; null if the id is free. */
    private final List<Rigid> byId = new ArrayList<>();

    private final Map<Integer, Integer> generations = new HashMap<>();
    private List<RigidContact.Saved> contacts = List.of();
    final RigidEvents events = new RigidEvents();

    /** In the order of their ids. */
    List<Rigid> all() {
        return byId.stream().filter(Objects::nonNull).toList();
    }

    /** Whether a handle is of a body that is pushed. */
    static boolean isRigid(long handle) {
        return ((int) handle & 7 << 28) == MARK;
    }

    Rigid byId(int id) {
        return byId.get(id);
    }

    Rigid find(long handle) {
        return byId.get((int) handle & ~MARK);
    }

    Rigid add(BodyOutline outline, float mass) {
        if (!byId.contains(null)) {
            byId.add(null);
        }
        int id = byId.indexOf(null);
        long generation = generations.merge(id, 1, Integer::sum);
        Rigid body = new Rigid(id, generation << 32 | MARK | id, new RigidOutline(outline), mass);
        byId.set(id, body);
        return body;
    }

    void remove(Rigid body) {
        forgetContacts(body);
        events.end(key -> key.body() == body.id || key.type() == RigidThing.BODY && key.other() == body.id);
        byId.set(body.id, null);
    }

    void clear() {
        events.end(key -> true);
        all().forEach(this::remove);
    }

    /** A circle goes. */
    void removed(Circle c) {
        forgetContacts(c);
        events.end(key -> key.type() == RigidThing.CIRCLE && key.other() == c.id);
    }

    /** All circles go. */
    void removedCircles() {
        events.end(key -> key.type() == RigidThing.CIRCLE);
    }

    void removed(Piece piece) {
        forgetContacts(piece);
        events.end(key -> key.type() == RigidThing.PIECE && key.other() == piece.id);
    }

    private void forget(Predicate<RigidContact.Saved> which) {
        contacts = contacts.stream().filter(which.negate()).toList();
    }

    void forgetContacts(Rigid body) {
        forget(c -> c.body() == body.id || c.type() == RigidThing.BODY && c.other() == body.id);
    }

    void forgetContacts(Circle c) {
        forget(contact -> contact.type() == RigidThing.CIRCLE && contact.other() == c.id);
    }

    void forgetContacts(Piece piece) {
        forget(contact -> contact.type() == RigidThing.PIECE && contact.other() == piece.id);
    }

    List<RigidContact.Saved> contacts() {
        return contacts;
    }

    void keep(List<RigidContact.Saved> ofStep) {
        contacts = ofStep;
    }

    long hash() {
        long sum = 0;
        for (Rigid body : all()) {
            sum += body.hash();
        }
        for (RigidContact.Saved c : contacts) {
            long h = CONTACT;
            for (int number : new int[] {c.type(), c.body(), c.other(), c.first(), c.second()}) {
                h = ReferenceWorld.absorb(h, number);
            }
            sum += ReferenceWorld.absorb(h, c.impulse(), c.grip());
        }
        return sum;
    }
}
