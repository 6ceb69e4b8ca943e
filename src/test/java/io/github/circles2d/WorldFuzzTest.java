package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import io.github.circles2d.fuzz.Soundness;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Random programs of calls with hostile values. Each call is refused with an IllegalArgumentException and changes nothing, or
 * does what a plain model of the world does; the state is finite and within the bounds whatever happens. Terrain, joints and bodies, and that all back ends and
 * numbers of threads agree, are for {@link io.github.circles2d.fuzz.FuzzTest}. The system property
 * circles2d.fuzz.programs sets the number of programs, circles2d.fuzz.seed the first one's seed.
 */
@Tag("each-jdk")
class WorldFuzzTest {
    private static final int PROGRAMS = Integer.getInteger("circles2d.fuzz.programs", 1_500);
    private static final long SEED = Long.getLong("circles2d.fuzz.seed", 1);

    private static final float[] HOSTILE = {
        Float.NaN,
        Float.POSITIVE_INFINITY,
        Float.NEGATIVE_INFINITY,
        0,
        -0f,
        Float.MIN_VALUE,
        -Float.MIN_VALUE,
        Float.MIN_NORMAL,
        Float.MAX_VALUE,
        -Float.MAX_VALUE,
        1e-9f,
        1e-6f,
        1e9f,
        -1e9f,
        1.0000001e9f,
        1e18f,
        -1e18f,
        1,
        -1
    };

    @Test
    void anyProgramGivesClearExceptionsOrASoundWorld() {
        run(SEED, PROGRAMS);
    }

    /** Those that follow. */
    @Test
    @Tag("exhaustive")
    void soDoThousandsMore() {
        run(SEED + PROGRAMS, 8_500);
    }

    private static void run(long seed, int programs) {
        for (int k = 0; k < programs; k++) {
            new Program(seed + k).run();
        }
    }

    /** What must live, and what is known of it. */
    private static final class Model {
        /** Radius and mass by handle, in the order of the ids, and the radius to which the circle grows, in how many steps. */
        private final TreeMap<Long, float[]> circles =
                new TreeMap<>((a, b) -> Integer.compare(a.intValue(), b.intValue()));

        private float minX;
        private float minY;
        private float maxX;
        private float maxY;

        Model copy() {
            Model copy = new Model();
            circles.forEach((handle, values) -> copy.circles.put(handle, values.clone()));
            copy.walls(minX, minY, maxX, maxY);
            return copy;
        }

        void grow(int steps) {
            for (float[] c : circles.values()) {
                for (int k = 0; k < steps && c[3] > 0; k++) {
                    c[0] = c[3] == 1 ? c[2] : c[0] + (c[2] - c[0]) / c[3];
                    c[3]--;
                }
            }
        }

        void walls(float x0, float y0, float x1, float y1) {
            minX = x0;
            minY = y0;
            maxX = x1;
            maxY = y1;
        }
    }

    private static final class Program {
        private final long seed;
        private final Random random;
        private List<Long> stale = new ArrayList<>(List.of(0L, -1L, 77L));

        /** Most circles of a program have radii of about the arena over 10 to the power of this. */
        private final int scale;

        private World world;
        private Model model = new Model();
        private ByteBuffer snapshot;
        private Model snapshotModel;
        private List<Long> snapshotStale;

        /** The positions at the last request that has not been taken; null where there is none. */
        private float[] requested;

        /** The handles of the circles at that request. */
        private long[] requestedHandles = {};

        /** Those of them that have been there all the time since. */
        private final Set<Long> survivors = new TreeSet<>();

        private String last = "";

        Program(long seed) {
            this.seed = seed;
            random = new Random(seed * 0x9E3779B97F4A7C15L);
            scale = random.nextInt(8) == 0 ? random.nextInt(6) : random.nextInt(2);
        }

        void run() {
            try {
                world = build();
                try {
                    int calls = 5 + random.nextInt(40);
                    for (int k = 0; k < calls; k++) {
                        call();
                    }
                    check();
                } finally {
                    world.close();
                }
            } catch (AssertionError | RuntimeException | IOException e) {
                throw new AssertionError("program of seed " + seed + ", in " + last, e);
            }
        }

        private World.Builder builder() {
            return WorldScenes.jvm().threads(1).capacity(0);
        }

        /** Every other program is of a world that moves. */
        private World opened(World.Builder builder) {
            World opened = builder.build();
            if (seed % 2 != 0) {
                RandomMoves.of(opened, seed, 1);
            }
            return opened;
        }

        private World build() {
            World.Builder builder = builder();
            model.walls(0, 0, 1, 1);
            float[] w = new float[4];
            float size = (float) StrictMath.pow(10, random.nextInt(16) - 6);
            float offset = random.nextInt(3) == 0 ? (random.nextFloat() - 0.5f) * 1e9f : 0;
            for (int k = 0; k < 4; k++) {
                w[k] = k < 2 ? value(offset - size, offset) : value(offset, offset + size);
            }
            ask(false, () -> {
                builder.bounds(w[0], w[1], w[2], w[3]);
                model.walls(w[0], w[1], w[2], w[3]);
            });
            float g = random.nextInt(4) == 0 ? 1e9f : 10;
            float gx = value(-g, g);
            float gy = value(-g, g);
            ask(bad(gx) || bad(gy), () -> builder.gravity(gx, gy));
            float e = value(0, 1);
            ask(bad(e), () -> builder.restitution(e));
            int subSteps = random.nextInt(19);
            ask(subSteps < 1 || subSteps > 16, () -> builder.subSteps(subSteps));
            if (random.nextInt(3) == 0) {
                setContacts(builder);
            }
            if (random.nextInt(3) == 0) {
                setSurfaces(builder);
            }
            return opened(builder);
        }

        private void setSurfaces(World.Builder builder) {
            float friction = friction();
            ask(isBadFriction(friction), () -> builder.friction(friction));
            float resistance = friction();
            ask(isBadFriction(resistance), () -> builder.rollingResistance(resistance));
            if (random.nextBoolean()) {
                Wall wall = Wall.values()[random.nextInt(4)];
                float belt = value(-speed(), speed());
                ask(
                        isBadFriction(friction) || isBadFriction(resistance) || bad(belt),
                        () -> builder.wallSurface(wall, resistance, friction, belt));
            }
        }

        private float friction() {
            return random.nextInt(8) == 0 ? value(0, 1000) : value(0, 1);
        }

        private static boolean isBadFriction(float value) {
            return !(value >= 0 && value <= 1000);
        }

        private void setContacts(World.Builder builder) {
            float threshold = random.nextBoolean() ? value(0, 1e9f) : value(0, 1);
            ask(!(threshold >= 0) || bad(threshold), () -> builder.restitutionThreshold(threshold));
            float frequency = random.nextBoolean() ? value(1, 10_000) : value(1, 80);
            ask(!(frequency >= 1) || bad(frequency), () -> builder.contactFrequency(frequency));
            float damping = random.nextInt(3) * value(0, 500);
            ask(!(damping >= 0) || bad(damping), () -> builder.contactDamping(damping));
            float speed = random.nextInt(3) * value(0, 50);
            ask(!(speed >= 0) || bad(speed), () -> builder.greatestPushOutSpeed(speed));
        }

        private void call() throws IOException {
            switch (random.nextInt(39)) {
                case 0, 1, 2, 3 -> add();
                case 4, 5 -> addAll();
                case 17 -> remove();
                case 6 -> setPosition();
                case 7 -> setVelocity();
                case 8 -> setRadius();
                case 9 -> setMass();
                case 10 -> setRestitution();
                case 11 -> impulse();
                case 12 -> setWorld();
                case 13 -> saveOrRestore();
                case 18 -> requestOrTakePositions();
                case 19 -> setTag();
                case 20 -> setKind();
                case 21 -> setGroup();
                case 22 -> setPairs();
                case 23 -> setMotion();
                case 24 -> setForce();
                case 25 -> changeSome();
                case 26 -> removeSome();
                case 27 -> explode();
                case 28 -> query();
                case 29 -> report();
                case 30, 31 -> grow();
                case 32 -> clear();
                case 33, 34 -> turn();
                case 35 -> setSurface();
                case 36 -> setKindSurface();
                case 37 -> setWallSurface();
                case 38 -> setOwnMotion();
                default -> step();
            }
        }

        private void add() {
            float[] c = circle();
            float vx = value(-speed(), speed());
            float vy = value(-speed(), speed());
            int kind = kind();
            last = "add " + Arrays.toString(c) + " " + vx + " " + vy + " " + kind;
            ask(bad(c) || bad(vx) || bad(vy) || !isKind(kind), () -> {
                long handle = world.add(c[0], c[1], c[2], c[3], vx, vy, kind);
                entered(handle, c[2], c[3]);
                assertThat(world.kindOf(handle)).isEqualTo(kind);
            });
        }

        private void addAll() {
            int n = random.nextInt(random.nextInt(10) == 0 ? 80 : 12);
            float[] circles = new float[4 * n];
            boolean bad = false;
            float[] one = circle();
            for (int i = 0; i < n; i++) {
                float[] c = random.nextInt(3) == 0 ? one : circle(); // some at the same place
                System.arraycopy(c, 0, circles, 4 * i, 4);
                bad |= bad(c);
            }
            long[] handles = new long[n];
            int[] kinds = new int[n];
            for (int i = 0; i < n; i++) {
                kinds[i] = random.nextInt(4) == 0 ? kind() : 0;
                bad |= !isKind(kinds[i]);
            }
            last = "addAll " + Arrays.toString(circles) + " " + Arrays.toString(kinds);
            ask(bad, () -> {
                world.addAll(circles, null, kinds, handles);
                for (int i = 0; i < n; i++) {
                    entered(handles[i], circles[4 * i + 2], circles[4 * i + 3]);
                    assertThat(world.kindOf(handles[i])).isEqualTo(kinds[i]);
                }
            });
        }

        private void entered(long handle, float radius, float mass) {
            assertThat(stale).doesNotContain(handle);
            assertThat(model.circles.put(handle, new float[] {radius, mass, 0, 0}))
                    .isNull();
        }

        private void remove() {
            long handle = handle();
            last = "remove " + handle;
            ask(unknown(handle), () -> {
                world.remove(handle);
                model.circles.remove(handle);
                stale.add(handle);
                survivors.remove(handle);
            });
        }

        private void setPosition() {
            long handle = handle();
            float x = value(model.minX, model.maxX);
            float y = value(model.minY, model.maxY);
            boolean teleports = random.nextBoolean();
            last = (teleports ? "teleport " : "setPosition ") + x + " " + y;
            ask(unknown(handle) || bad(x) || bad(y), () -> {
                if (teleports) {
                    world.teleport(handle, x, y);
                } else {
                    world.setPosition(handle, x, y);
                }
            });
        }

        private void setVelocity() {
            long handle = handle();
            float x = value(-speed(), speed());
            float y = value(-speed(), speed());
            last = "setVelocity " + x + " " + y;
            ask(unknown(handle) || bad(x) || bad(y), () -> world.setVelocity(handle, x, y));
        }

        private void setRadius() {
            long handle = handle();
            float radius = radius();
            last = "setRadius " + radius;
            ask(unknown(handle) || bad(radius) || !(radius > 0), () -> {
                world.setRadius(handle, radius);
                model.circles.get(handle)[0] = radius;
                model.circles.get(handle)[3] = 0;
            });
        }

        private void grow() {
            long handle = handle();
            float radius = radius();
            int steps = random.nextInt(10) == 0 ? random.nextInt() : 1 + random.nextInt(6);
            last = "grow " + radius + " " + steps;
            ask(unknown(handle) || bad(radius) || !(radius > 0) || steps < 1 || steps > 100_000, () -> {
                world.grow(handle, radius, steps);
                model.circles.get(handle)[2] = radius;
                model.circles.get(handle)[3] = steps;
                assertThat(world.growthSteps(handle)).isEqualTo(steps);
            });
        }

        private void clear() {
            if (random.nextInt(4) == 0) {
                last = "clear";
                world.clear();
                stale.addAll(model.circles.keySet());
                model.circles.clear();
                survivors.clear();
                check();
            }
        }

        private void setMass() {
            long handle = handle();
            float mass = mass();
            last = "setMass " + mass;
            ask(unknown(handle) || Float.isNaN(mass) || !(mass > 0), () -> {
                world.setMass(handle, mass);
                model.circles.get(handle)[1] = mass;
            });
        }

        private void setRestitution() {
            long handle = handle();
            float e = value(0, 1);
            last = "setRestitution " + e;
            ask(unknown(handle) || !(e >= 0 && e <= 1), () -> world.setRestitution(handle, e));
        }

        private void setTag() {
            long handle = handle();
            long tag = random.nextLong() >> random.nextInt(64);
            last = "setTag " + tag;
            ask(unknown(handle), () -> {
                world.setTag(handle, tag);
                assertThat(world.tag(handle)).isEqualTo(tag);
            });
        }

        private void report() {
            int types = random.nextInt(3) == 0 ? random.nextInt() >> random.nextInt(32) : random.nextInt(16);
            last = "report " + types;
            ask((types & ~15) != 0, () -> world.report(types));
            float speed = value(0, speed());
            last = "setHitSpeed " + speed;
            ask(bad(speed) || speed < 0, () -> world.setHitSpeed(speed));
            int kind = kind();
            int other = kind();
            int ofPair = random.nextInt(3) == 0 ? random.nextInt() >> random.nextInt(32) : random.nextInt(8);
            last = "report " + kind + " " + other + " " + ofPair;
            ask(!isKind(kind) || !isKind(other) || (ofPair & ~7) != 0, () -> world.report(kind, other, ofPair));
            last = "reportWalls " + kind + " " + ofPair;
            ask(!isKind(kind) || (ofPair & ~7) != 0, () -> world.reportWalls(kind, ofPair));
            long[] pairs = new long[random.nextInt(10)];
            last = "touching " + kind + " " + other;
            ask(!isKind(kind) || !isKind(other), () -> {
                int found = world.touching(kind, other, pairs);
                for (int k = 0; k + 1 < pairs.length; k += 2) {
                    boolean isThere = k < 2 * found;
                    assertThat(pairs[k] != 0 && world.kindOf(pairs[k]) == kind).isEqualTo(isThere);
                    assertThat(pairs[k + 1] != 0 && world.kindOf(pairs[k + 1]) == other)
                            .isEqualTo(isThere);
                }
            });
            if (random.nextBoolean()) {
                last = "requestEvents";
                world.requestEvents();
                Soundness.require(world.takeEvents());
            }
        }

        private int kind() {
            return random.nextInt(20) == 0 ? random.nextInt() : random.nextInt(3) == 0 ? 255 : random.nextInt(3);
        }

        private static boolean isKind(int kind) {
            return kind >= 0 && kind <= 255;
        }

        private void setKind() {
            long handle = handle();
            int kind = kind();
            last = "setKind " + kind;
            ask(unknown(handle) || !isKind(kind), () -> {
                world.setKind(handle, kind);
                assertThat(world.kindOf(handle)).isEqualTo(kind);
            });
        }

        private void setMotion() {
            int kind = kind();
            float scale = value(-1000, 1000);
            float damping = value(0, 10);
            float most = value(0, speed());
            last = "setMotion " + kind + " " + scale + " " + damping + " " + most;
            ask(!isKind(kind) || bad(scale), () -> {
                world.kind(kind).setGravityScale(scale);
                assertThat(world.kind(kind).gravityScale()).isEqualTo(scale);
            });
            ask(!isKind(kind) || bad(damping) || damping < 0, () -> {
                world.kind(kind).setDamping(damping);
                assertThat(world.kind(kind).damping()).isEqualTo(damping);
            });
            ask(!isKind(kind) || Float.isNaN(most) || most < 0, () -> {
                world.kind(kind).setGreatestSpeed(most);
                assertThat(world.kind(kind).greatestSpeed()).isEqualTo(most);
            });
        }

        private void setOwnMotion() {
            long handle = handle();
            float scale = value(-1000, 1000);
            float damping = value(0, 10);
            float most = value(0, speed());
            last = "setOwnMotion " + scale + " " + damping + " " + most;
            ask(unknown(handle) || bad(scale) && !Float.isNaN(scale), () -> {
                world.setGravityScale(handle, scale);
                float ofKind = world.kind(world.kindOf(handle)).gravityScale();
                assertThat(world.gravityScale(handle)).isEqualTo(Float.isNaN(scale) ? ofKind : scale + 0f);
            });
            ask(unknown(handle) || bad(damping) && !Float.isNaN(damping) || damping < 0, () -> {
                world.setDamping(handle, damping);
                float ofKind = world.kind(world.kindOf(handle)).damping();
                assertThat(world.damping(handle)).isEqualTo(Float.isNaN(damping) ? ofKind : damping + 0f);
            });
            ask(unknown(handle) || most < 0, () -> {
                world.setGreatestSpeed(handle, most);
                float ofKind = world.kind(world.kindOf(handle)).greatestSpeed();
                assertThat(world.greatestSpeed(handle)).isEqualTo(Float.isNaN(most) ? ofKind : most + 0f);
            });
        }

        private void setForce() {
            long handle = handle();
            float x = value(-1e18f, 1e18f);
            float y = value(-1, 1);
            last = "setForce " + x + " " + y;
            ask(unknown(handle) || bad(x) || bad(y), () -> {
                world.setForce(handle, x, y);
                assertThat(world.forceX(handle)).isEqualTo(x + 0f);
                assertThat(world.forceY(handle)).isEqualTo(y + 0f);
            });
            last = "applyForce " + x + " " + y;
            ask(unknown(handle) || bad(x) || bad(y), () -> world.applyForce(handle, x, y));
        }

        private void turn() {
            long handle = handle();
            float angle = value(-10, 10);
            last = "setAngle " + angle;
            ask(unknown(handle) || bad(angle) || Math.abs(angle) > 1e6f, () -> {
                world.setAngle(handle, angle);
                double off = Math.IEEEremainder(world.angle(handle) - (double) angle, 2 * Math.PI);
                assertThat(Math.abs(off)).isLessThan(1e-6);
            });
            if (random.nextBoolean()) {
                float velocity = value(-speed(), speed());
                last = "setAngularVelocity " + velocity;
                ask(unknown(handle) || bad(velocity) || Math.abs(velocity) > 1e9f, () -> {
                    world.setAngularVelocity(handle, velocity);
                    assertThat(world.angularVelocity(handle)).isEqualTo(velocity + 0f);
                });
            }
            float torque = value(-1e18f, 1e18f) * (random.nextBoolean() ? 1 : 1e-18f);
            last = "torque " + torque;
            ask(unknown(handle) || bad(torque) || Math.abs(torque) > 1e18f, () -> {
                world.setTorque(handle, torque);
                assertThat(world.torque(handle)).isEqualTo(torque + 0f);
                world.applyTorque(handle, -0.5f * torque);
                world.applyAngularImpulse(handle, torque);
            });
        }

        private void setSurface() {
            long handle = handle();
            float friction = random.nextInt(4) == 0 ? Float.NaN : friction();
            float resistance = random.nextInt(4) == 0 ? Float.NaN : friction();
            last = "setFriction " + friction + " " + resistance;
            ask(unknown(handle) || !Float.isNaN(friction) && isBadFriction(friction), () -> {
                world.setFriction(handle, friction);
                float kinds = world.kind(world.kindOf(handle)).friction();
                float expected = Float.isNaN(friction) ? kinds : friction;
                assertThat(world.friction(handle))
                        .isEqualTo(Float.isNaN(expected) ? world.defaultFriction() : expected);
            });
            ask(
                    unknown(handle) || !Float.isNaN(resistance) && isBadFriction(resistance),
                    () -> world.setRollingResistance(handle, resistance));
        }

        private void setKindSurface() {
            int kind = kind();
            float friction = random.nextInt(4) == 0 ? Float.NaN : friction();
            float belt = value(-speed(), speed());
            float damping = value(0, 10);
            last = "setKindSurface " + kind + " " + friction + " " + belt + " " + damping;
            boolean isBad = !isKind(kind) || !Float.isNaN(friction) && isBadFriction(friction);
            ask(isBad, () -> world.kind(kind).setFriction(friction));
            ask(isBad, () -> world.kind(kind).setRollingResistance(friction));
            ask(!isKind(kind) || bad(belt) || Math.abs(belt) > 1e9f, () -> world.kind(kind)
                    .setBeltSpeed(belt));
            ask(!isKind(kind) || bad(damping) || damping < 0, () -> world.kind(kind)
                    .setAngularDamping(damping));
            ask(!isKind(kind), () -> world.kind(kind).setInertia(Inertia.values()[random.nextInt(3)]));
        }

        private void setWallSurface() {
            Wall wall = Wall.values()[random.nextInt(4)];
            float friction = friction();
            float resistance = friction();
            float belt = value(-speed(), speed());
            last = "setWallSurface " + wall + " " + friction + " " + resistance + " " + belt;
            boolean isBad = isBadFriction(friction) || isBadFriction(resistance) || bad(belt) || Math.abs(belt) > 1e9f;
            ask(isBad, () -> {
                world.setWallSurface(wall, friction, resistance, belt);
                assertThat(world.wallFriction(wall)).isEqualTo(friction + 0f);
                assertThat(world.wallBeltSpeed(wall)).isEqualTo(belt + 0f);
            });
        }

        private void setGroup() {
            long handle = handle();
            int group = random.nextInt() >> random.nextInt(32);
            last = "setGroup " + group;
            ask(unknown(handle), () -> {
                world.setGroup(handle, group);
                assertThat(world.group(handle)).isEqualTo(group);
            });
        }

        private void setPairs() {
            int kind = kind();
            int other = kind();
            float e = value(0, 1);
            Response response = Response.values()[random.nextInt(4)];
            last = "setPairs " + kind + " " + other + " " + e + " " + response;
            ask(!isKind(kind) || !isKind(other), () -> {
                world.setResponse(kind, other, response);
                assertThat(world.response(other, kind)).isEqualTo(response);
            });
            int mask = random.nextInt() >> random.nextInt(32);
            ask(!isKind(kind), () -> {
                world.kind(kind).setMask(mask).setCategory(random.nextInt(4)).setSensor(random.nextInt(3) == 0);
                boolean senses = random.nextBoolean();
                assertThat(world.kind(kind).setSensesStatic(senses).sensesStatic())
                        .isEqualTo(senses);
                assertThat(world.kind(kind).mask()).isEqualTo(mask);
            });
            ask(!isKind(kind) || !Float.isNaN(e) && !(e >= 0 && e <= 1), () -> {
                world.kind(kind).setRestitution(e);
                assertThat(Float.compare(world.kind(kind).restitution(), e)).isZero();
            });
        }

        /** Queries with what may be hostile are refused or answered; those that are answered find what a look at all finds. */
        private void query() {
            float w = model.maxX - model.minX;
            float h = model.maxY - model.minY;
            float x = value(model.minX - 0.2f * w, model.maxX + 0.2f * w);
            float y = value(model.minY - 0.2f * h, model.maxY + 0.2f * h);
            float radius = random.nextInt(3) == 0 ? radius() : value(0, w);
            float toX = random.nextInt(4) == 0 ? x : value(model.minX, model.maxX);
            float toY = random.nextInt(4) == 0 ? y : value(model.minY, model.maxY);
            last = "query " + x + " " + y + " " + radius + " " + toX + " " + toY;
            boolean bad = bad(x) || bad(y) || bad(radius) || radius < 0 || bad(toX - x) || bad(toY - y);
            QueryComparison comparison =
                    random.nextBoolean() ? new QueryComparison(world) : new QueryComparison(world, random.nextInt(8));
            ask(bad, () -> comparison.compare(x, y, radius, toX, toY));
        }

        private void impulse() {
            long handle = handle();
            float x = value(-1e18f, 1e18f);
            float y = value(-1, 1);
            last = "applyImpulse " + x + " " + y;
            ask(unknown(handle) || bad(x) || bad(y), () -> world.applyImpulse(handle, x, y));
        }

        private void changeSome() {
            int call = random.nextInt(6);
            float x = call == 0 ? model.minX : call == 1 || call == 5 ? -speed() : -1e18f;
            float y = call == 0 ? model.minY : call == 1 || call == 5 ? -speed() : -1;
            float toX = call == 0 ? model.maxX : -x;
            float toY = call == 0 ? model.maxY : -y;
            long[] handles = new long[random.nextInt(6)];
            float[] values = new float[2 * handles.length];
            int[] kinds = new int[handles.length];
            boolean bad = false;
            int unknown = 0;
            for (int k = 0; k < handles.length; k++) {
                handles[k] = handle();
                kinds[k] = kind();
                values[2 * k] = value(x, toX);
                values[2 * k + 1] = value(y, toY);
                unknown += unknown(handles[k]) ? 1 : 0;
                boolean badValues =
                        switch (call) {
                            case 4 -> !isKind(kinds[k]);
                            case 5 -> bad(values[k]);
                            default -> bad(values[2 * k]) || bad(values[2 * k + 1]);
                        };
                bad |= !unknown(handles[k]) && badValues;
            }
            StaleHandles stale = StaleHandles.values()[random.nextInt(2)];
            int skipped = unknown;
            last = "change " + call + " of some, " + stale + " " + Arrays.toString(values);
            ask(bad || skipped > 0 && stale == StaleHandles.REFUSE, () -> {
                int result =
                        switch (call) {
                            case 0 -> world.setPositions(handles, handles.length, values, stale);
                            case 1 -> world.setVelocities(handles, handles.length, values, stale);
                            case 3 -> world.setForces(handles, handles.length, values, stale);
                            case 4 -> world.setKinds(handles, handles.length, kinds, stale);
                            case 5 -> world.setAngularVelocities(handles, handles.length, values, stale);
                            default -> world.applyImpulses(handles, handles.length, values, stale);
                        };
                assertThat(result).isEqualTo(skipped);
            });
        }

        private void removeSome() {
            long[] handles = new long[random.nextInt(4)];
            Set<Long> known = new TreeSet<>();
            for (int k = 0; k < handles.length; k++) {
                handles[k] = handle();
                if (!unknown(handles[k])) {
                    known.add(handles[k]);
                }
            }
            StaleHandles stale = StaleHandles.values()[random.nextInt(2)];
            int skipped = handles.length - known.size();
            last = "removeAll " + Arrays.toString(handles) + " " + stale;
            ask(skipped > 0 && stale == StaleHandles.REFUSE, () -> {
                assertThat(world.removeAll(handles, handles.length, stale)).isEqualTo(skipped);
                known.forEach(model.circles::remove);
                this.stale.addAll(known);
                survivors.removeAll(known);
            });
        }

        private void explode() {
            float x = value(model.minX, model.maxX);
            float y = value(model.minY, model.maxY);
            float size = model.maxX - model.minX;
            float radius = value(0, size);
            float falloff = value(0, size);
            float impulse = value(-speed(), speed());
            last = "explode " + x + " " + y + " " + radius + " " + impulse + " " + falloff;
            ask(bad(x) || bad(y) || !(radius >= 0) || !(falloff >= 0) || bad(impulse) || bad(radius + falloff), () -> {
                int pushed = random.nextBoolean()
                        ? world.explode(x, y, radius, impulse, falloff)
                        : world.explode(x, y, radius, impulse, falloff, random.nextInt(8));
                assertThat(pushed).isBetween(0, model.circles.size());
            });
        }

        private void setWorld() {
            if (random.nextBoolean()) {
                float gx = value(-1e9f, 1e9f);
                float gy = value(-20, 20);
                last = "setGravity " + gx + " " + gy;
                ask(bad(gx) || bad(gy), () -> world.setGravity(gx, gy));
            } else {
                float w = (model.maxX - model.minX) * (float) StrictMath.pow(10, -random.nextInt(3));
                float[] b = {
                    value(model.minX, model.minX + 0.3f * w),
                    value(model.minY - w, model.minY + w),
                    value(model.maxX - 0.3f * w, model.maxX),
                    value(model.maxY - 0.1f * w, model.maxY + w)
                };
                last = "setBounds " + Arrays.toString(b);
                ask(bad(b[0]) || bad(b[1]) || bad(b[2]) || bad(b[3]), () -> {
                    world.setBounds(b[0], b[1], b[2], b[3]);
                    model.walls(b[0], b[1], b[2], b[3]);
                });
            }
        }

        private void requestOrTakePositions() {
            if (requested == null) {
                last = "takePositions";
                assertThatIllegalStateException().isThrownBy(world::takePositions);
            } else if (random.nextBoolean()) {
                last = "takePositions";
                if (random.nextBoolean()) {
                    FloatBuffer taken = world.takePositions();
                    assertThat(taken).isEqualTo(FloatBuffer.wrap(requested));
                } else {
                    takeById();
                }
                requested = null;
                return;
            }
            last = "requestPositions";
            float[] circles = new float[4 * world.size()];
            world.read(circles);
            world.requestPositions();
            requestedHandles = new long[world.size()];
            world.readHandles(requestedHandles);
            survivors.clear();
            Arrays.stream(requestedHandles).forEach(survivors::add);
            requested = new float[2 * world.size()];
            for (int i = 0; i < requested.length; i++) {
                requested[i] = circles[4 * (i / 2) + i % 2];
            }
        }

        /** Shown are the circles of the request that are still there. */
        private void takeById() {
            FloatBuffer taken = world.takePositionsById(null);
            float[] expected = new float[taken.limit()];
            Arrays.fill(expected, Float.NaN);
            for (int k = 0; k < requestedHandles.length; k++) {
                if (survivors.contains(requestedHandles[k])) {
                    System.arraycopy(requested, 2 * k, expected, 2 * World.id(requestedHandles[k]), 2);
                }
            }
            assertThat(taken).isEqualTo(FloatBuffer.wrap(expected));
        }

        private void saveOrRestore() throws IOException {
            if (snapshot == null || random.nextBoolean()) {
                last = "snapshot";
                snapshot = ByteBuffer.allocate(world.snapshotBytes());
                world.snapshot(snapshot);
                snapshot.flip();
                snapshotModel = model.copy();
                snapshotStale = new ArrayList<>(stale);
                return;
            }
            last = "restore";
            if (random.nextInt(3) == 0) {
                byte[] damaged = snapshot.array().clone();
                damaged[random.nextInt(damaged.length)] ^= (byte) (1 << random.nextInt(8));
                ask(true, () -> world.restore(ByteBuffer.wrap(damaged)));
                return;
            }
            if (random.nextBoolean()) {
                world.close();
                world = opened(builder());
                requested = null;
            }
            world.restore(snapshot.duplicate());
            survivors.removeIf(handle -> !world.contains(handle));
            model = snapshotModel.copy();
            stale = new ArrayList<>(snapshotStale);
            check();
        }

        private void step() {
            float dt = random.nextInt(3) == 0 ? value(0, 1) : 1 / 60f;
            int steps = random.nextInt(8) == 0 ? random.nextInt(3) - 1 : 1 + random.nextInt(3);
            last = "step " + dt + " " + steps;
            ask(bad(dt) || !(dt > 0) || steps < 1, () -> {
                world.step(dt, steps);
                model.grow(steps);
            });
            check();
            Soundness.require(world.events());
        }

        /** Makes a call that must be refused, or that may be where the values are odd; a refused one must change nothing. */
        private void ask(boolean mustRefuse, Runnable call) {
            long hash = world == null ? 0 : world.hash();
            boolean refused = false;
            try {
                call.run();
            } catch (IllegalArgumentException e) {
                refused = true;
                assertThat(e.getMessage()).isNotBlank();
                if (world != null) {
                    assertThat(world.hash()).isEqualTo(hash);
                }
            }
            assertThat(refused || !mustRefuse).as("refused").isTrue();
        }

        private void check() {
            int n = model.circles.size();
            assertThat(world.size()).isEqualTo(n);
            float[] circles = new float[4 * n];
            float[] velocities = new float[2 * n];
            long[] handles = new long[n];
            world.read(circles);
            world.readVelocities(velocities);
            world.readHandles(handles);
            float[] byId = new float[4 * world.idLimit()];
            long[] living = new long[world.idLimit() / 64 + 1];
            world.readById(byId, living);
            float[] angles = new float[world.idLimit()];
            float[] turning = new float[world.idLimit()];
            world.readAnglesById(angles, null);
            world.readAngularVelocitiesById(turning, null);
            float[] radii = new float[world.idLimit()];
            world.readRadiiById(radii, null);
            assertThat(Arrays.stream(living).map(Long::bitCount).sum()).isEqualTo(n);
            int k = 0;
            for (Map.Entry<Long, float[]> entry : model.circles.entrySet()) {
                int id = World.id(handles[k]);
                boolean sound = handles[k] == entry.getKey()
                        && handles[k] == world.handle(id)
                        && Arrays.equals(circles, 4 * k, 4 * k + 4, byId, 4 * id, 4 * id + 4)
                        && (living[id / 64] >>> id & 1) != 0
                        && circles[4 * k] >= model.minX
                        && circles[4 * k] <= model.maxX
                        && circles[4 * k + 1] >= model.minY
                        && circles[4 * k + 1] <= model.maxY
                        && circles[4 * k + 2] == entry.getValue()[0]
                        && radii[id] == entry.getValue()[0]
                        && world.growthSteps(handles[k]) == entry.getValue()[3]
                        && circles[4 * k + 3] == entry.getValue()[1]
                        && Math.abs(angles[id]) <= (float) Math.PI
                        && Math.abs(turning[id]) <= 1e9f
                        && Math.abs(velocities[2 * k]) <= 1e9f
                        && Math.abs(velocities[2 * k + 1]) <= 1e9f;
                assertThat(sound)
                        .as(
                                "circle %d at %s, %s, velocity %s, %s",
                                k, circles[4 * k], circles[4 * k + 1], velocities[2 * k], velocities[2 * k + 1])
                        .isTrue();
                k++;
            }
            for (long handle : stale) {
                assertThat(world.contains(handle)).isFalse();
            }
        }

        // ---- values

        private float value(float low, float high) {
            return random.nextInt(150) == 0
                    ? HOSTILE[random.nextInt(HOSTILE.length)]
                    : low + (high - low) * random.nextFloat();
        }

        private float speed() {
            return (float) StrictMath.pow(10, random.nextInt(14) - 4);
        }

        private float[] circle() {
            return new float[] {value(model.minX, model.maxX), value(model.minY, model.maxY), radius(), mass()};
        }

        private float radius() {
            float extent = Math.min(model.maxX - model.minX, model.maxY - model.minY);
            float least = random.nextInt(4) == 0 ? 0 : 0.02f * extent;
            return value(least, 0.52f * extent * (float) StrictMath.pow(10, -scale - random.nextInt(2)));
        }

        private float mass() {
            return random.nextInt(8) == 0
                    ? Float.POSITIVE_INFINITY
                    : value(0, (float) StrictMath.pow(10, random.nextInt(19) - 9));
        }

        private long handle() {
            if (model.circles.isEmpty() || random.nextInt(12) == 0) {
                return random.nextInt(8) == 0 ? random.nextLong() : stale.get(random.nextInt(stale.size()));
            }
            int place = random.nextInt(model.circles.size());
            return model.circles.keySet().stream().skip(place).findFirst().orElseThrow();
        }

        private boolean unknown(long handle) {
            return model.circles.keySet().stream().noneMatch(known -> known == handle);
        }

        private static boolean bad(float value) {
            return !Float.isFinite(value);
        }

        private static boolean bad(float[] c) {
            return bad(c[0]) || bad(c[1]) || bad(c[2]) || !(c[2] > 0) || Float.isNaN(c[3]) || !(c[3] > 0);
        }
    }
}
