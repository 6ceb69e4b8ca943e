package io.github.circles2d.reference;

import io.github.circles2d.Edge;
import io.github.circles2d.Events;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/** The events of the reference, by comparing the pairs that touch after a step with those before it. */
final class TouchEvents {
    private static final float LEFT = 1f / 64f;
    private static final int NO_SIDE = -1;

    /** Two circles by their handles, or a circle, 0 and the number of a wall. */
    private record Key(long a, long b, int side) {
        boolean has(long handle) {
            return a == handle || b == handle;
        }
    }

    private record Ranked(int rank, Event event) {}

    private static final Comparator<Ranked> ORDER = Comparator.comparingInt((Ranked r) -> (int) r.event.a())
            .thenComparingInt(r -> r.event.side())
            .thenComparingInt(r -> (int) r.event.b())
            .thenComparingInt(Ranked::rank);

    private int types;

    /** Negative if the pair decides. */
    private float hitSpeed = -1f;

    /** The pairs that touch, with a hit that is not complete or null. */
    private Map<Key, Touch> touching = new HashMap<>();

    private List<Ranked> ofStep = new ArrayList<>();
    private List<Event> events = new ArrayList<>();
    private int steps;

    void report(int reported) {
        types = reported;
        boolean isOn = (types & ~Events.WALL) != 0;
        touching.keySet().removeIf(key -> !isOn || key.side >= 0 && (types & Events.WALL) == 0);
        if (!isOn) {
            ofStep.clear();
        }
    }

    void setHitSpeed(float speed) {
        hitSpeed = speed;
    }

    List<Event> take() {
        List<Event> taken = events;
        events = new ArrayList<>();
        steps = 0;
        return taken;
    }

    void removed(Circle c) {
        end(key -> key.has(c.handle), 0);
    }

    private void end(Predicate<Key> ends, int firstRank) {
        for (Key key : List.copyOf(touching.keySet())) {
            if (ends.test(key)) {
                Touch hit = touching.remove(key);
                if (hit != null) {
                    add(firstRank, Events.HIT, key, hit);
                }
                add(firstRank + 1, Events.END, key, null);
            }
        }
    }

    private void add(int rank, int type, Key key, Touch t) {
        if ((types & type) == 0) {
            return;
        }
        Event event = t == null
                ? new Event(0, type, key.a, key.b, key.side, 0f, 0f, 0f, 0f, 0f, 0f)
                : new Event(
                        0,
                        type,
                        key.a,
                        key.b,
                        key.side,
                        Numbers.max(t.approach, 0f),
                        t.impulse,
                        t.point[0],
                        t.point[1],
                        t.normal[0],
                        t.normal[1]);
        ofStep.add(new Ranked(rank, event));
    }

    /** Ends a step. */
    void step(List<Contact> contacts, List<Circle> circles, Arena arena) {
        if ((types & ~Events.WALL) == 0) {
            return;
        }
        Map<Key, Touch> now = new HashMap<>();
        for (Contact c : contacts) {
            now.put(new Key(c.lower.handle, c.higher.handle, NO_SIDE), c.touch);
        }
        if ((types & Events.WALL) != 0) {
            for (Circle c : circles) {
                for (int a = 0; a < 2 && !c.isStatic(); a++) {
                    if (arena.edges()[a] == Edge.WALL) {
                        c.walls[a].touchesAfterStep().forEach((side, t) -> now.put(new Key(c.handle, 0, side), t));
                    }
                }
            }
        }
        for (Touch t : now.values()) {
            t.point = new float[] {arena.inside(0, t.point[0]), arena.inside(1, t.point[1])};
        }
        now.forEach(this::look);
        end(key -> !now.containsKey(key) || !now.get(key).staysInTouch(), 3);
        ofStep.sort(ORDER);
        ofStep.forEach(r -> events.add(r.event.at(steps)));
        ofStep.clear();
        steps++;
    }

    private void look(Key key, Touch t) {
        boolean before = touching.containsKey(key);
        if (!t.touches() && !(before && t.staysInTouch())) {
            return;
        }
        t.impulse = Numbers.max(t.impulse, 0f);
        if (!before) {
            add(2, Events.BEGIN, key, t);
        }
        Touch earlier = touching.put(key, null);
        boolean isHit =
                t.impulse > 0f && (hitSpeed >= 0f ? t.approach >= hitSpeed : t.approach * t.approach > t.threshold);
        if (earlier != null) {
            float impulse = earlier.impulse + t.impulse;
            Touch faster = t.approach > earlier.approach ? t : earlier;
            faster.impulse = impulse;
            add(3, Events.HIT, key, faster);
        } else if (isHit && -t.normalVelocity > LEFT * t.approach) {
            touching.put(key, t);
        } else if (isHit) {
            add(3, Events.HIT, key, t);
        }
    }
}
