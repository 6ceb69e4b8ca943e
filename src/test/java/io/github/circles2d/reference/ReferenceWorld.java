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
    private static final long CIRCLE = 0x636972636C653264L;
    private static final long IMPULSE = 0x696D70756C736573L;

    private final float restitution;
    private final int subSteps;

    /** By id; null if the id is free. */
    private final List<Circle> byId = new ArrayList<>();

    /** By id: how many circles had it and were removed. */
    private final Map<Integer, Integer> generations = new HashMap<>();

    /** The impulses greater than 0 with which contacts ended the last step. */
    private final Map<Contact.Pair, Float> impulseCache = new HashMap<>();

    private StepParameters.Walls x;
    private StepParameters.Walls y;
    private float gravityX;
    private float gravityY;
    private float previousDt;

    public ReferenceWorld(float restitution, int subSteps) {
        this.restitution = restitution;
        this.subSteps = subSteps;
        setBounds(0f, 0f, 1f, 1f);
    }

    @Override
    public void step(float dt, int steps) {
        for (int k = 0; k < steps; k++) {
            if (size() > 0) {
                float warmScale = previousDt == 0f ? 1f : Numbers.min(dt / previousDt, 1f);
                StepParameters parameters = new StepParameters(x, y, dt, subSteps, gravityX, gravityY);
                new Step(circles(), parameters).make(impulseCache, warmScale);
            }
            previousDt = dt;
        }
    }

    @Override
    public long add(float x0, float y0, float radius, float mass, float vx, float vy) {
        int id = byId.contains(null) ? byId.indexOf(null) : byId.size();
        Circle c = new Circle(id);
        c.x.base = x0;
        c.y.base = y0;
        c.x.velocity = vx;
        c.y.velocity = vy;
        c.radius = radius;
        c.mass = mass;
        c.restitution = restitution;
        if (id == byId.size()) {
            byId.add(c);
        } else {
            byId.set(id, c);
        }
        return handle(id);
    }

    private long handle(int id) {
        return (long) (generations.getOrDefault(id, 0) + 1) << 32 | id;
    }

    @Override
    public void remove(long handle) {
        Circle c = find(handle);
        forgetImpulses(c);
        byId.set(c.id, null);
        generations.merge(c.id, 1, Integer::sum);
    }

    private Circle find(long handle) {
        return byId.get((int) handle);
    }

    /** In the order of the ids. */
    private List<Circle> circles() {
        return byId.stream().filter(Objects::nonNull).toList();
    }

    private void forgetImpulses(Circle c) {
        c.x.wallImpulse = 0f;
        c.y.wallImpulse = 0f;
        impulseCache.keySet().removeIf(pair -> pair.lower() == c.id || pair.higher() == c.id);
    }

    @Override
    public boolean contains(long handle) {
        return find(handle) != null && handle((int) handle) == handle;
    }

    @Override
    public int size() {
        return circles().size();
    }

    @Override
    public void read(float[] to) {
        int k = 0;
        for (Circle c : circles()) {
            to[k++] = c.x.base;
            to[k++] = c.y.base;
            to[k++] = c.radius;
            to[k++] = c.mass;
        }
    }

    @Override
    public void readHandles(long[] to) {
        int k = 0;
        for (Circle c : circles()) {
            to[k++] = handle(c.id);
        }
    }

    @Override
    public void setPosition(long handle, float toX, float toY) {
        find(handle).x.place(toX);
        find(handle).y.place(toY);
    }

    @Override
    public void setVelocity(long handle, float vx, float vy) {
        find(handle).x.velocity = vx;
        find(handle).y.velocity = vy;
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
        c.x.velocity = Numbers.limitSpeed(c.x.velocity + c.inverseMass() * impulseX);
        c.y.velocity = Numbers.limitSpeed(c.y.velocity + c.inverseMass() * impulseY);
    }

    @Override
    public void setGravity(float gx, float gy) {
        gravityX = gx;
        gravityY = gy;
    }

    @Override
    public void setBounds(float minX, float minY, float maxX, float maxY) {
        x = new StepParameters.Walls(minX, maxX);
        y = new StepParameters.Walls(minY, maxY);
        for (Circle c : circles()) {
            confine(c.x, minX + c.margin(), maxX - c.margin());
            confine(c.y, minY + c.margin(), maxY - c.margin());
        }
    }

    private static void confine(Circle.Axis axis, float low, float high) {
        float kept = Numbers.clamp(axis.base, low, high);
        if (kept != axis.base) {
            axis.place(kept);
        }
    }

    @Override
    public long hash() {
        long sum = 0;
        for (Circle c : circles()) {
            long h = absorb(CIRCLE, c.id);
            h = absorb(h, c.x.base, c.y.base, c.radius, c.mass, c.x.displacement, c.y.displacement);
            sum += absorb(h, c.x.velocity, c.y.velocity, c.restitution, c.x.wallImpulse, c.y.wallImpulse);
        }
        for (Map.Entry<Contact.Pair, Float> entry : impulseCache.entrySet()) {
            Contact.Pair pair = entry.getKey();
            sum += absorb(absorb(absorb(IMPULSE, pair.lower()), pair.higher()), entry.getValue());
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
