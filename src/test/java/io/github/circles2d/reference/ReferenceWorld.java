package io.github.circles2d.reference;

import io.github.circles2d.WorldCalls;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * World as the section "The step to the bit" of ARCHITECTURE.md describes it. Arguments are not checked: World is asked first,
 * and refuses what is not allowed.
 */
public final class ReferenceWorld implements WorldCalls {
    private static final float GREATEST_WARM_SCALE = 4f;

    private static final long CIRCLE = 0x636972636C653264L;
    private static final long IMPULSE = 0x696D70756C736573L;

    private final float restitution;
    private final int subSteps;

    /** By id; null if the id is free. */
    private final List<Circle> byId = new ArrayList<>();

    /** By id: how many circles have had it. */
    private final Map<Integer, Integer> generations = new HashMap<>();

    /** The impulses greater than 0 with which contacts ended the last step. */
    private final Map<Contact.Pair, Float> impulseCache = new HashMap<>();

    private final TouchEvents events = new TouchEvents();
    private float[] min = {0f, 0f};
    private float[] max = {1f, 1f};
    private float[] gravity = {0f, 0f};
    private float previousDt;

    public ReferenceWorld(float restitution, int subSteps) {
        this.restitution = restitution;
        this.subSteps = subSteps;
    }

    private StepParameters parameters(float dt) {
        return new StepParameters(min, max, gravity, dt, subSteps);
    }

    /** In the order of the ids. */
    private List<Circle> circles() {
        return byId.stream().filter(Objects::nonNull).toList();
    }

    private Circle find(long handle) {
        return byId.get((int) handle);
    }

    @Override
    public void step(float dt, int steps) {
        for (int k = 0; k < steps; k++) {
            float warmScale = previousDt == 0f ? 1f : Numbers.min(dt / previousDt, GREATEST_WARM_SCALE);
            List<Contact> contacts = List.of();
            if (size() > 0) {
                Step step = new Step(circles(), parameters(dt));
                step.make(impulseCache, warmScale);
                contacts = step.contacts();
            }
            events.step(contacts, circles());
            previousDt = dt;
        }
    }

    @Override
    public long add(float x, float y, float radius, float mass, float vx, float vy) {
        if (!byId.contains(null)) {
            byId.add(null);
        }
        int id = byId.indexOf(null);
        long generation = generations.merge(id, 1, Integer::sum);
        Circle c = new Circle(id, generation << 32 | id);
        byId.set(id, c);
        c.restitution = restitution;
        c.radius = radius;
        c.mass = mass;
        setPosition(c.handle, x, y);
        setVelocity(c.handle, vx, vy);
        return c.handle;
    }

    @Override
    public void remove(long handle) {
        events.removed(find(handle));
        forgetImpulses(find(handle));
        byId.set((int) handle, null);
    }

    private void forgetImpulses(Circle c) {
        c.wallImpulse[0] = 0f;
        c.wallImpulse[1] = 0f;
        impulseCache.keySet().removeIf(pair -> pair.lower() == c || pair.higher() == c);
    }

    @Override
    public boolean contains(long handle) {
        return find(handle) != null && find(handle).handle == handle;
    }

    @Override
    public int size() {
        return circles().size();
    }

    @Override
    public void read(float[] to) {
        int k = 0;
        for (Circle c : circles()) {
            to[k++] = c.base[0];
            to[k++] = c.base[1];
            to[k++] = c.radius;
            to[k++] = c.mass;
        }
    }

    @Override
    public void readHandles(long[] to) {
        int k = 0;
        for (Circle c : circles()) {
            to[k++] = c.handle;
        }
    }

    @Override
    public void setPosition(long handle, float x, float y) {
        find(handle).place(0, x);
        find(handle).place(1, y);
    }

    @Override
    public void setVelocity(long handle, float vx, float vy) {
        find(handle).velocity[0] = vx;
        find(handle).velocity[1] = vy;
    }

    @Override
    public void setRadius(long handle, float radius) {
        find(handle).radius = radius;
        forgetImpulses(find(handle));
    }

    @Override
    public void setMass(long handle, float mass) {
        find(handle).mass = mass;
        forgetImpulses(find(handle));
    }

    @Override
    public void setRestitution(long handle, float e) {
        find(handle).restitution = e;
    }

    @Override
    public void applyImpulse(long handle, float impulseX, float impulseY) {
        Circle c = find(handle);
        c.velocity[0] = Numbers.limitSpeed(c.velocity[0] + c.inverseMass() * impulseX);
        c.velocity[1] = Numbers.limitSpeed(c.velocity[1] + c.inverseMass() * impulseY);
    }

    @Override
    public void report(int types) {
        events.report(types);
    }

    @Override
    public void setHitSpeed(float speed) {
        events.setHitSpeed(speed);
    }

    /** The events since the last call. */
    public List<Event> takeEvents() {
        return events.take();
    }

    @Override
    public void setGravity(float gx, float gy) {
        gravity = new float[] {gx, gy};
    }

    @Override
    public void setBounds(float minX, float minY, float maxX, float maxY) {
        min = new float[] {minX, minY};
        max = new float[] {maxX, maxY};
        for (Circle c : circles()) {
            for (int a = 0; a < 2; a++) {
                float inside = Numbers.clamp(c.base[a], c.low(a, parameters(0f)), c.high(a, parameters(0f)));
                if (inside != c.base[a]) {
                    c.place(a, inside);
                }
            }
        }
    }

    @Override
    public long hash() {
        long sum = 0;
        for (Circle c : circles()) {
            long h = absorb(absorb(CIRCLE, c.id), c.base);
            h = absorb(absorb(h, c.radius, c.mass), c.displacement);
            sum += absorb(absorb(absorb(h, c.velocity), c.restitution), c.wallImpulse);
        }
        for (Map.Entry<Contact.Pair, Float> entry : impulseCache.entrySet()) {
            Contact.Pair pair = entry.getKey();
            sum += absorb(absorb(absorb(IMPULSE, pair.lower().id), pair.higher().id), entry.getValue());
        }
        return sum;
    }

    private static long absorb(long hash, int word) {
        long h = (hash ^ (word & 0xFFFFFFFFL)) * 0x9E3779B97F4A7C15L;
        return h ^ (h >>> 32);
    }

    private static long absorb(long hash, float... values) {
        long h = hash;
        for (float value : values) {
            h = absorb(h, Float.floatToRawIntBits(value));
        }
        return h;
    }
}
