package io.github.circles2d.reference;

import io.github.circles2d.BodyEvents;
import io.github.circles2d.Wall;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.TreeMap;
import java.util.function.Predicate;

/** The events of bodies that are pushed, by comparing the pairs that touch in a step with those of the step before. */
final class RigidEvents {
    /** Finds the handles of a pair: that of the body, and that of what it touches. */
    interface Handles {
        long[] of(RigidTouch.Key key);
    }

    private boolean on;

    /** The pairs that touch, with their handles. */
    private TreeMap<RigidTouch.Key, long[]> touching = new TreeMap<>(RigidTouch.Key.ORDER);

    private List<RigidEvent> events = new ArrayList<>();

    void report(boolean wanted) {
        if (wanted != on) {
            touching.clear();
            events.clear();
        }
        on = wanted;
    }

    boolean isOn() {
        return on;
    }

    boolean touched(RigidTouch.Key key) {
        return touching.containsKey(key);
    }

    /** The handles of what touches a body, but walls. */
    List<Long> touching(int body) {
        List<Long> list = new ArrayList<>();
        touching.forEach((key, handles) -> {
            if (key.body() == body && key.type() != RigidThing.WALL) {
                list.add(handles[1]);
            } else if (key.type() == RigidThing.BODY && key.other() == body) {
                list.add(handles[0]);
            }
        });
        return list;
    }

    List<RigidEvent> take() {
        List<RigidEvent> taken = events;
        events = new ArrayList<>();
        return taken;
    }

    /** Ends the pairs of what goes. */
    void end(Predicate<RigidTouch.Key> which) {
        for (RigidTouch.Key key : List.copyOf(touching.keySet())) {
            if (which.test(key)) {
                events.add(event(false, key, touching.remove(key), null));
            }
        }
    }

    /** A step has been made, in which pairs touched; those at rest go on to do so. */
    void step(List<RigidTouch> touches, Collection<RigidTouch.Key> resting, Handles handles) {
        if (!on) {
            return;
        }
        TreeMap<RigidTouch.Key, RigidTouch> now = new TreeMap<>(RigidTouch.Key.ORDER);
        touches.forEach(touch -> now.put(touch.key(), touch));
        TreeMap<RigidTouch.Key, long[]> next = new TreeMap<>(RigidTouch.Key.ORDER);
        List<RigidTouch.Key> all = new ArrayList<>(now.keySet());
        touching.keySet().stream().filter(key -> !now.containsKey(key)).forEach(all::add);
        all.sort(RigidTouch.Key.ORDER);
        for (RigidTouch.Key key : all) {
            if (now.containsKey(key)) {
                next.put(key, handles.of(key));
                if (!touching.containsKey(key)) {
                    events.add(event(true, key, handles.of(key), now.get(key)));
                }
            } else if (resting.contains(key)) {
                next.put(key, touching.get(key));
            } else {
                events.add(event(false, key, touching.get(key), null));
            }
        }
        touching = next;
    }

    private static RigidEvent event(boolean begin, RigidTouch.Key key, long[] handles, RigidTouch touch) {
        boolean isWall = key.type() == RigidThing.WALL;
        return new RigidEvent(
                begin,
                handles[0],
                BodyEvents.Partner.values()[key.type()],
                isWall ? 0 : handles[1],
                isWall ? Wall.values()[key.other()] : null,
                touch == null ? 0f : touch.point()[0],
                touch == null ? 0f : touch.point()[1],
                touch == null ? 0f : touch.normal()[0],
                touch == null ? 0f : touch.normal()[1],
                touch == null ? 0f : touch.impulse(),
                touch == null ? 0f : touch.speed());
    }
}
