package io.github.circles2d.reference;

import io.github.circles2d.Edge;
import io.github.circles2d.Events;
import io.github.circles2d.Response;
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

    /** Two circles, the one of lower id first, or a circle, null, and the number of a wall or a piece of terrain. */
    private record Key(Circle lower, Circle higher, int side, Piece piece) {
        static Key of(Circle lower, Circle higher) {
            return new Key(lower, higher, NO_SIDE, null);
        }

        boolean has(Circle c) {
            return lower == c || higher == c;
        }

        /** Whether a circle that sleeps touches what does not move. */
        boolean rests() {
            return higher == null ? lower.isAsleep() : new Contact.Pair(lower, higher).rests();
        }

        long a() {
            return lower.handle;
        }

        long b() {
            return higher == null ? 0 : higher.handle;
        }

        long pieceHandle() {
            return piece == null ? 0 : piece.handle;
        }
    }

    private record Ranked(int rank, Event event) {}

    private static final Comparator<Ranked> ORDER = Comparator.comparingInt((Ranked r) -> (int) r.event.a())
            .thenComparingInt(r -> r.event.piece() == 0 ? 0 : 1)
            .thenComparingInt(r -> r.event.side())
            .thenComparingInt(r -> (int) r.event.b())
            .thenComparingInt(r -> (int) r.event.piece())
            .thenComparingInt(Ranked::rank);

    private final ReportedTypes types = new ReportedTypes();

    /** Negative if the pair decides. */
    private float hitSpeed = -1f;

    /** The pairs that touch, with a hit that is not complete or null. */
    private Map<Key, Touch> touching = new HashMap<>();

    private List<Ranked> ofStep = new ArrayList<>();
    private List<Event> events = new ArrayList<>();
    private int steps;
    private int requestedSteps;

    void report(int reported) {
        types.set(reported);
        forgetOthers();
    }

    void report(int kindA, int kindB, int reported) {
        types.set(kindA, kindB, reported);
        forgetOthers();
    }

    void reportWalls(int kind, int reported) {
        types.setWalls(kind, reported);
        forgetOthers();
    }

    private void forgetOthers() {
        touching.keySet().removeIf(key -> typesOf(key) == 0);
        if (!types.isOn()) {
            ofStep.clear();
        }
        ofStep.removeIf(
                late -> (types.ofAll(late.event.side() != NO_SIDE) & late.event.type()) == 0 && !types.dependOnKinds());
    }

    private int typesOf(Key key) {
        if (key.piece != null) {
            return types.of(key.lower.kind, key.piece.kind);
        }
        return key.higher == null ? types.ofWalls(key.lower) : types.of(key.lower.kind, key.higher.kind);
    }

    /** Lists the pairs of two kinds that touch. */
    List<long[]> touching(int kindA, int kindB) {
        return touching.keySet().stream()
                .filter(key -> key.higher != null && typesOf(key) != 0)
                .filter(key -> key.lower.kind == kindA && key.higher.kind == kindB
                        || key.lower.kind == kindB && key.higher.kind == kindA)
                .sorted(Comparator.comparingInt((Key key) -> key.lower.id).thenComparingInt(key -> key.higher.id))
                .map(key -> key.lower.kind == kindA ? new long[] {key.a(), key.b()} : new long[] {key.b(), key.a()})
                .toList();
    }

    void setHitSpeed(float speed) {
        hitSpeed = speed;
    }

    List<Event> take() {
        List<Event> taken = events;
        events = new ArrayList<>();
        steps = 0;
        requestedSteps = 0;
        return taken;
    }

    void request() {
        requestedSteps = steps;
    }

    /** The events of the steps before the request; the others stay, and their steps count from it. */
    List<Event> takeRequested() {
        int before = requestedSteps;
        List<Event> taken = events.stream().filter(e -> e.step() < before).toList();
        events = new ArrayList<>(events.stream()
                .filter(e -> e.step() >= before)
                .map(e -> e.at(e.step() - before))
                .toList());
        steps -= before;
        requestedSteps = 0;
        return taken;
    }

    void removed(Circle c) {
        end(key -> key.has(c), 0);
    }

    void removed(Piece piece) {
        end(key -> key.piece == piece, 0);
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
        if ((typesOf(key) & type) == 0) {
            return;
        }
        Event event = t == null
                ? new Event(0, type, key.a(), key.b(), key.side, key.pieceHandle(), 0f, 0f, 0f, 0f, 0f, 0f, 0f)
                : new Event(
                        0,
                        type,
                        key.a(),
                        key.b(),
                        key.side,
                        key.pieceHandle(),
                        t.speed(),
                        t.slip,
                        t.impulse,
                        t.point[0],
                        t.point[1],
                        t.normal[0],
                        t.normal[1]);
        ofStep.add(new Ranked(rank, event));
    }

    /** Ends a step. */
    void step(List<Contact> contacts, List<Circle> circles, ReferenceTerrain terrain, Kinds kinds, StepParameters k) {
        Arena arena = k.arena();
        if (!types.isOn()) {
            return;
        }
        Map<Key, Touch> now = new HashMap<>();
        for (Contact c : contacts) {
            now.put(Key.of(c.lower, c.higher), c.touch);
        }
        for (Circle c : circles) {
            for (int a = 0; a < 2 && !c.isStatic(); a++) {
                if (arena.edges()[a] != Edge.WALL) {
                    continue;
                }
                c.walls[a].touchesAfterStep().forEach((side, t) -> now.put(new Key(c, null, side, null), t));
            }
        }
        for (int i = 0; i < circles.size(); i++) {
            Circle lower = circles.get(i);
            for (Circle higher : circles.subList(i + 1, circles.size())) {
                if (isSensed(lower.kind, higher.kind) && kinds.response(lower, higher) == Response.SENSE) {
                    now.put(Key.of(lower, higher), Sensing.touch(lower, higher, k.dt()));
                }
            }
        }
        for (Circle c : circles) {
            for (PieceContact contact : c.isStatic() ? List.<PieceContact>of() : c.pieceContacts) {
                Touch touch = contact.touchAfterStep();
                if (touch != null) {
                    now.put(new Key(c, null, NO_SIDE, contact.piece), touch);
                }
            }
        }
        circles.stream().filter(Circle::isStatic).forEach(c -> lookAtBodies(c, terrain, kinds, k, now));
        now.keySet().removeIf(key -> typesOf(key) == 0);
        for (Touch t : now.values()) {
            t.point = new float[] {arena.inside(0, t.point[0]), arena.inside(1, t.point[1])};
        }
        now.forEach(this::look);
        end(key -> !key.rests() && (!now.containsKey(key) || !now.get(key).staysInTouch()), 3);
        ofStep.sort(ORDER);
        ofStep.forEach(r -> events.add(r.event.at(steps)));
        ofStep.clear();
        steps++;
    }

    private boolean isSensed(int kindA, int kindB) {
        return (types.of(kindA, kindB) & (Events.BEGIN | Events.END)) != 0;
    }

    /** The pieces of bodies that a static circle senses, if a kind asks for it. */
    private void lookAtBodies(Circle c, ReferenceTerrain terrain, Kinds kinds, StepParameters k, Map<Key, Touch> now) {
        for (Piece piece : terrain.pieces()) {
            boolean senses = kinds.asks(c.kind, piece.kind) && kinds.response(c.kind, piece.kind) == Response.SENSE;
            if (piece.body.id != 0 && senses && isSensed(c.kind, piece.kind)) {
                Key key = new Key(c, null, NO_SIDE, piece);
                Touch touch = new PieceContact(c, piece, true, kinds, k).touchOfStatic(touching.containsKey(key));
                if (touch != null) {
                    now.put(key, touch);
                }
            }
        }
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
            Touch faster = t.speed() > earlier.speed() ? t : earlier;
            faster.impulse = impulse;
            add(3, Events.HIT, key, faster);
        } else if (isHit && -t.normalVelocity > LEFT * t.approach) {
            touching.put(key, t);
        } else if (isHit) {
            add(3, Events.HIT, key, t);
        }
    }
}
