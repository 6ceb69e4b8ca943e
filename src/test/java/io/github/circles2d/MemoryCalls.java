package io.github.circles2d;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.BiConsumer;

/** Public calls of a world, by name, each with values by chance; and worlds to make them in. For tests in which memory ends. */
final class MemoryCalls {
    private static final float STEP = 1 / 60f;
    private static final float SIDE = 20;

    /** A call: what it does in a scene, what it returns, and whether it makes a step. */
    record Call(String name, boolean steps, Body body) {
        /** Whether it is one of a loop, which keeps what it has taken from its world. */
        boolean isOfLoop() {
            return name.startsWith("fixed.");
        }
    }

    /** A call's effect; it gets the same random numbers in each scene. */
    interface Body {
        Object run(MemoryScene scene, Random random);
    }

    private final List<Call> calls = new ArrayList<>();

    private MemoryCalls() {}

    /** All calls. */
    static List<Call> all() {
        MemoryCalls all = new MemoryCalls();
        all.circles();
        all.many();
        all.kinds();
        all.settings();
        all.terrain();
        all.joints();
        all.events();
        all.reads();
        all.queries();
        all.steps();
        all.states();
        return all.calls;
    }

    private void call(String name, Body body) {
        calls.add(new Call(name, false, body));
    }

    private void change(String name, BiConsumer<MemoryScene, Random> body) {
        call(name, (s, r) -> {
            body.accept(s, r);
            return "";
        });
    }

    private void step(String name, Body body) {
        calls.add(new Call(name, true, body));
    }

    private static float at(Random r) {
        return 1 + (SIDE - 2) * r.nextFloat();
    }

    private static float any(Random r) {
        return 4 * r.nextFloat() - 2;
    }

    private void circles() {
        call("add", (s, r) -> s.world.add(at(r), at(r), 0.2f + r.nextFloat() / 4, 1, any(r), any(r), r.nextInt(3)));
        call("addAll", (s, r) -> {
            int count = 1 + r.nextInt(60);
            float[] circles = new float[4 * count];
            for (int k = 0; k < count; k++) {
                circles[4 * k] = at(r);
                circles[4 * k + 1] = at(r);
                circles[4 * k + 2] = 0.2f + r.nextFloat() / 4;
                circles[4 * k + 3] = r.nextInt(9) == 0 ? Float.POSITIVE_INFINITY : 1;
            }
            long[] handles = new long[count];
            s.world.addAll(circles, handles);
            return handles;
        });
        change("remove", (s, r) -> s.world.remove(s.circle(r)));
        change("setPosition", (s, r) -> s.world.setPosition(s.circle(r), at(r), at(r)));
        change("teleport", (s, r) -> s.world.teleport(s.circle(r), at(r), at(r)));
        change("setVelocity", (s, r) -> s.world.setVelocity(s.circle(r), any(r), any(r)));
        change("setRadius", (s, r) -> s.world.setRadius(s.circle(r), 0.2f + r.nextFloat() / 4));
        change("grow", (s, r) -> s.world.grow(s.circle(r), 0.2f + r.nextFloat() / 4, 1 + r.nextInt(4)));
        change("setMass", (s, r) -> s.world.setMass(s.circle(r), r.nextInt(4) == 0 ? Float.POSITIVE_INFINITY : 2));
        change("setRestitution", (s, r) -> s.world.setRestitution(s.circle(r), r.nextFloat()));
        change("setTag", (s, r) -> s.world.setTag(s.circle(r), r.nextLong()));
        change("setKind", (s, r) -> s.world.setKind(s.circle(r), r.nextInt(4)));
        change("setGroup", (s, r) -> s.world.setGroup(s.circle(r), r.nextInt(4) - 2));
        change("applyImpulse", (s, r) -> s.world.applyImpulse(s.circle(r), any(r), any(r)));
        change("setForce", (s, r) -> s.world.setForce(s.circle(r), any(r), any(r)));
        change("applyForce", (s, r) -> s.world.applyForce(s.circle(r), any(r), any(r)));
        change("setFriction", (s, r) -> s.world.setFriction(s.circle(r), r.nextFloat()));
        change("setRollingResistance", (s, r) -> s.world.setRollingResistance(s.circle(r), r.nextFloat()));
        change("setGravityScale", (s, r) -> s.world.setGravityScale(s.circle(r), r.nextFloat()));
        change("setDamping", (s, r) -> s.world.setDamping(s.circle(r), r.nextFloat()));
        change("setGreatestSpeed", (s, r) -> s.world.setGreatestSpeed(s.circle(r), r.nextFloat()));
        change("setAngle", (s, r) -> s.world.setAngle(s.circle(r), any(r)));
        change("setAngularVelocity", (s, r) -> s.world.setAngularVelocity(s.circle(r), any(r)));
        change("applyAngularImpulse", (s, r) -> s.world.applyAngularImpulse(s.circle(r), any(r)));
        change("setTorque", (s, r) -> s.world.setTorque(s.circle(r), any(r)));
        change("applyTorque", (s, r) -> s.world.applyTorque(s.circle(r), any(r)));
    }

    private void many() {
        call("removeAll", (s, r) -> {
            long[] some = s.circles(r, 3);
            return s.world.removeAll(some, some.length, StaleHandles.SKIP);
        });
        call("setPositions", (s, r) -> {
            long[] some = s.circles(r, 5);
            return s.world.setPositions(
                    some, some.length, s.floats(r, 2 * some.length, 1, SIDE - 1), StaleHandles.SKIP);
        });
        call("setVelocities", (s, r) -> {
            long[] some = s.circles(r, 5);
            return s.world.setVelocities(some, some.length, s.floats(r, 2 * some.length, -3, 3), StaleHandles.SKIP);
        });
        call("applyImpulses", (s, r) -> {
            long[] some = s.circles(r, 5);
            return s.world.applyImpulses(some, some.length, s.floats(r, 2 * some.length, -3, 3), StaleHandles.SKIP);
        });
        call("setForces", (s, r) -> {
            long[] some = s.circles(r, 5);
            return s.world.setForces(some, some.length, s.floats(r, 2 * some.length, -3, 3), StaleHandles.SKIP);
        });
        call("setAngularVelocities", (s, r) -> {
            long[] some = s.circles(r, 5);
            return s.world.setAngularVelocities(some, some.length, s.floats(r, some.length, -3, 3), StaleHandles.SKIP);
        });
        call("setKinds", (s, r) -> {
            long[] some = s.circles(r, 5);
            return s.world.setKinds(some, some.length, new int[some.length], StaleHandles.SKIP);
        });
        call("explode", (s, r) -> s.world.explode(at(r), at(r), 5, 1, 3));
        call("explodeInSight", (s, r) -> s.world.explodeInSight(at(r), at(r), 5, 1, 3));
        change("clear", (s, r) -> s.world.clear());
    }

    private void kinds() {
        change("kind.setCategory", (s, r) -> s.world.kind(r.nextInt(4)).setCategory(1 << r.nextInt(3)));
        change("kind.setMask", (s, r) -> s.world.kind(r.nextInt(4)).setMask(r.nextInt(8)));
        change("kind.setSensor", (s, r) -> s.world.kind(r.nextInt(4)).setSensor(r.nextBoolean()));
        change("kind.setSensesStatic", (s, r) -> s.world.kind(r.nextInt(4)).setSensesStatic(r.nextBoolean()));
        change("kind.setRestitution", (s, r) -> s.world.kind(r.nextInt(4)).setRestitution(r.nextFloat()));
        change("kind.setGravityScale", (s, r) -> s.world.kind(r.nextInt(4)).setGravityScale(r.nextFloat()));
        change("kind.setDamping", (s, r) -> s.world.kind(r.nextInt(4)).setDamping(r.nextFloat()));
        change("kind.setGreatestSpeed", (s, r) -> s.world.kind(r.nextInt(4)).setGreatestSpeed(1 + r.nextFloat()));
        change("kind.setFriction", (s, r) -> s.world.kind(r.nextInt(4)).setFriction(r.nextFloat()));
        change("kind.setRollingResistance", (s, r) -> s.world.kind(r.nextInt(4)).setRollingResistance(r.nextFloat()));
        change("kind.setBeltSpeed", (s, r) -> s.world.kind(r.nextInt(4)).setBeltSpeed(r.nextFloat()));
        change("kind.setInertia", (s, r) -> s.world.kind(r.nextInt(4)).setInertia(Inertia.values()[r.nextInt(2)]));
        change("kind.setAngularDamping", (s, r) -> s.world.kind(r.nextInt(4)).setAngularDamping(r.nextFloat()));
        change("kind.setOneWay", (s, r) -> s.world.kind(r.nextInt(4)).setOneWay(r.nextBoolean()));
        change(
                "setResponse",
                (s, r) -> s.world.setResponse(
                        r.nextInt(4), r.nextInt(4), Response.values()[r.nextInt(Response.values().length)]));
        call("response", (s, r) -> s.world.response(r.nextInt(4), r.nextInt(4)));
    }

    private void settings() {
        change("setGravity", (s, r) -> s.world.setGravity(any(r), any(r)));
        change("setBounds", (s, r) -> s.world.setBounds(-r.nextFloat(), -r.nextFloat(), SIDE, SIDE + r.nextFloat()));
        change(
                "setWallSurface",
                (s, r) -> s.world.setWallSurface(Wall.values()[r.nextInt(4)], r.nextFloat(), r.nextFloat(), any(r)));
    }

    private void terrain() {
        call(
                "addBody",
                (s, r) -> s.world.terrain().addBody(at(r), at(r), any(r)).handle());
        call("addSegment", (s, r) -> s.body(r).addSegment(at(r), at(r), at(r), at(r), r.nextFloat() / 4, r.nextInt(3)));
        call("addArc", (s, r) -> s.body(r).addArc(at(r), at(r), 1 + r.nextFloat(), 0, 3, ArcSide.OUTER, r.nextInt(3)));
        call("addChain", (s, r) -> {
            int count = 2 + r.nextInt(12);
            Chain chain = Chain.from(1, at(r));
            for (int k = 1; k < count; k++) {
                chain = chain.lineTo(1 + k, at(r));
            }
            long[] handles = new long[count];
            return new Object[] {s.body(r).addChain(chain, r.nextInt(3), handles), handles};
        });
        call("addSegments", (s, r) -> {
            int count = 1 + r.nextInt(30);
            long[] handles = new long[count];
            s.body(r).addSegments(s.floats(r, 4 * count, 1, SIDE - 1), r.nextInt(3), handles);
            return handles;
        });
        change("terrain.remove", (s, r) -> s.world.terrain().remove(s.piece(r)));
        change("terrain.setKind", (s, r) -> s.world.terrain().setKind(s.piece(r), r.nextInt(3)));
        change("terrain.clear", (s, r) -> s.world.terrain().clear());
        change("body.setVelocity", (s, r) -> s.body(r).setVelocity(any(r), any(r)));
        change("body.setAngularVelocity", (s, r) -> s.body(r).setAngularVelocity(any(r)));
        change("body.moveTo", (s, r) -> s.body(r).moveTo(at(r), at(r), any(r)));
        change("body.teleport", (s, r) -> s.body(r).teleport(at(r), at(r), any(r)));
        change("body.remove", (s, r) -> s.body(r).remove());
        call("readPieces", (s, r) -> {
            float[] pieces = new float[Terrain.PIECE_STRIDE * s.world.terrain().size()];
            return new Object[] {s.world.terrain().readPieces(pieces, null), pieces};
        });
    }

    private static Joint joint(Random r) {
        return switch (r.nextInt(8)) {
            case 0 -> Joint.distance();
            case 1 -> Joint.distance(1);
            case 2 -> Joint.spring(1 + r.nextInt(5), 0.5f);
            case 3 -> Joint.weld();
            case 4 -> Joint.rope(2);
            case 5 -> Joint.distance().breakingAt(20, Float.POSITIVE_INFINITY);
            case 6 -> Joint.spring(1 + r.nextInt(5), 0.5f).colliding(true);
            default -> Joint.distance().breakingAt(0, Float.POSITIVE_INFINITY);
        };
    }

    private void joints() {
        call("joints.add", (s, r) -> s.world.joints().add(s.circle(r), s.circle(r), joint(r)));
        call("joints.add weld", (s, r) -> s.world.joints().add(s.circle(r), s.circle(r), Joint.weld()));
        call("joints.add to a place", (s, r) -> s.world.joints().add(s.circle(r), at(r), at(r), Joint.pin(2, 1)));
        call("joints.add to a body", (s, r) -> s.world
                .joints()
                .add(s.circle(r), s.body(r), any(r), any(r), Joint.spring(1, 1).withLength(1)));
        call("joints.add alone", (s, r) -> s.world.joints().add(s.circle(r), Joint.motor(any(r), 1 + r.nextFloat())));
        call("joints.addAll", (s, r) -> {
            int count = 1 + r.nextInt(20);
            long[] firsts = new long[count];
            long[] others = new long[count];
            for (int k = 0; k < count; k++) {
                firsts[k] = s.circle(r);
                others[k] = s.circle(r);
            }
            long[] handles = new long[count];
            s.world.joints().addAll(firsts, others, joint(r), handles);
            return handles;
        });
        call("joints.addAll to a hub", (s, r) -> {
            long[] others = s.circles(r, 70);
            long[] firsts = new long[others.length];
            Arrays.fill(firsts, s.world.handle(0));
            return s.world.joints().addAll(firsts, others, Joint.spring(2, 1), null);
        });
        change("joints.remove", (s, r) -> s.world.joints().remove(s.joint(r)));
        change("joints.removeAll", (s, r) -> s.world.joints().removeAll(new long[] {s.joint(r)}));
        change("joints.clear", (s, r) -> s.world.joints().clear());
        change("joints.setAnchor", (s, r) -> s.world.joints().setAnchor(s.joint(r), at(r), at(r)));
        change("joints.setLength", (s, r) -> s.world.joints().setLength(s.joint(r), 1 + r.nextFloat()));
        change("joints.setLimits", (s, r) -> s.world.joints().setLimits(s.joint(r), 1, 2 + r.nextFloat()));
        change("joints.setSpring", (s, r) -> s.world.joints().setSpring(s.joint(r), 1 + r.nextFloat(), 1));
        change("joints.setSpeed", (s, r) -> s.world.joints().setSpeed(s.joint(r), any(r)));
        change("joints.setBreaking", (s, r) -> s.world.joints().setBreaking(s.joint(r), 30 * r.nextFloat(), 1e9f));
        change("joints.setColliding", (s, r) -> s.world.joints().setColliding(s.joint(r), r.nextBoolean()));
        change("joints.report", (s, r) -> s.world.joints().report(r.nextInt(4) > 0));
        call("joints.joint", (s, r) -> s.world.joints().joint(s.joint(r)));
        call("joints.ofCircle", (s, r) -> {
            long[] joints = new long[20];
            return new Object[] {s.world.joints().ofCircle(s.circle(r), joints), joints};
        });
        call("joints.pick", (s, r) -> s.world.joints().pick(at(r), at(r), 3));
        call(
                "joints.force",
                (s, r) -> s.world.joints().force(s.joint(r)) + s.world.joints().torque(s.joint(r)));
        call("joints.readEnds", (s, r) -> {
            float[] ends = new float[4 * s.world.joints().size()];
            return new Object[] {s.world.joints().readEnds(ends), ends};
        });
    }

    private void events() {
        change("report", (s, r) -> s.world.report(r.nextInt(3) == 0 ? r.nextInt(16) : 15));
        change("report of kinds", (s, r) -> s.world.report(r.nextInt(3), r.nextInt(3), r.nextInt(8)));
        change("reportWalls", (s, r) -> s.world.reportWalls(r.nextInt(3), r.nextInt(8)));
        change("setHitSpeed", (s, r) -> s.world.setHitSpeed(r.nextFloat()));
        call("events", (s, r) -> MemoryScene.list(s.world.events()));
        call("joints.events", (s, r) -> MemoryScene.list(s.world.joints().events()));
        change("requestEvents", (s, r) -> s.world.requestEvents());
        call("takeEvents", (s, r) -> MemoryScene.list(s.world.takeEvents()));
        call("touching", (s, r) -> {
            long[] handles = new long[200];
            return new Object[] {s.world.touching(r.nextInt(2), r.nextInt(2), handles), handles};
        });
        call("touchingPieces", (s, r) -> {
            long[] handles = new long[200];
            return new Object[] {s.world.touchingPieces(r.nextInt(2), r.nextInt(2), handles), handles};
        });
    }

    private void reads() {
        call("x", (s, r) -> s.world.x(s.circle(r)));
        call("vx", (s, r) -> s.world.vx(s.circle(r)));
        call("angle", (s, r) -> s.world.angle(s.circle(r)));
        call("angularVelocity", (s, r) -> s.world.angularVelocity(s.circle(r)));
        call("read", (s, r) -> {
            float[] all = new float[4 * s.world.size()];
            s.world.read(all);
            return all;
        });
        call("readLoadsById", (s, r) -> {
            float[] all = new float[2 * s.world.idLimit()];
            s.world.readLoadsById(all, null);
            return all;
        });
        call("contactsOf", (s, r) -> {
            long[] partners = new long[8];
            float[] contacts = new float[8 * World.CONTACT_STRIDE];
            return new Object[] {s.world.contactsOf(s.circle(r), partners, contacts), partners, contacts};
        });
        call("readRadiiById", (s, r) -> {
            float[] all = new float[s.world.idLimit()];
            s.world.readRadiiById(all, null);
            return all;
        });
        call("positions", (s, r) -> MemoryScene.list(s.world.positions()));
        call("positionsById", (s, r) -> MemoryScene.list(s.world.positionsById(null)));
        call("angles", (s, r) -> MemoryScene.list(s.world.angles()));
        change("requestPositions", (s, r) -> s.world.requestPositions());
        call("takePositions", (s, r) -> MemoryScene.list(s.world.takePositions()));
        call("takePositionsById", (s, r) -> MemoryScene.list(s.world.takePositionsById(null)));
        call("hash", (s, r) -> s.world.hash());
        call("stats", (s, r) -> {
            WorldStats stats = s.world.stats();
            return stats.circles() + " " + stats.contacts();
        });
        change("finish", (s, r) -> s.world.finish());
    }

    private void queries() {
        call("overlapCircle", (s, r) -> {
            long[] handles = new long[100];
            return new Object[] {s.world.queries().overlapCircle(at(r), at(r), 3, handles), handles};
        });
        call("overlapBox", (s, r) -> {
            long[] handles = new long[100];
            return new Object[] {s.world.queries().overlapBox(1, 1, at(r) + 1, at(r) + 1, handles), handles};
        });
        call("pick", (s, r) -> s.world.queries().pick(at(r), at(r)));
        call("nearest", (s, r) -> {
            long[] handles = new long[20];
            float[] distances = new float[20];
            int n = s.world.queries().nearest(at(r), at(r), 9, 20, handles, distances);
            return new Object[] {n, handles, distances};
        });
        call("rayCastAll", (s, r) -> {
            long[] handles = new long[100];
            float[] hits = new float[Queries.HIT_STRIDE * 100];
            return new Object[] {s.world.queries().rayCastAll(at(r), at(r), 9, 9, handles, hits), handles, hits};
        });
        call("circleCasts", (s, r) -> {
            long[] handles = new long[4];
            float[] hits = new float[Queries.HIT_STRIDE * 4];
            float[] casts = s.floats(r, 20, 1, 3);
            return new Object[] {s.world.queries().circleCast(casts, 4, handles, hits), handles, hits};
        });
        call("terrain.overlapBox", (s, r) -> {
            long[] handles = new long[100];
            int n = s.world.queries().terrain().overlapBox(1, 1, at(r) + 1, at(r) + 1, handles);
            return new Object[] {n, handles};
        });
        call("terrain.nearest", (s, r) -> {
            long[] handles = new long[20];
            float[] hits = new float[Queries.HIT_STRIDE * 20];
            int n = s.world.queries().terrain().nearest(at(r), at(r), 9, 20, handles, hits);
            return new Object[] {n, handles, hits};
        });
        call("terrain.rayCast", (s, r) -> s.world.queries().terrain().rayCast(at(r), at(r), 9, 9, null));
    }

    private void steps() {
        step("step", (s, r) -> {
            s.world.step(STEP);
            return "";
        });
        step("fixed.advance", (s, r) -> s.fixed.advance(STEP, null));
        step("steps", (s, r) -> {
            s.world.step(r.nextBoolean() ? STEP : STEP / 2, 3);
            return "";
        });
    }

    private void states() {
        call("snapshotBytes", (s, r) -> s.world.snapshotBytes());
        change("restore of more", (s, r) -> s.world.restore(s.more.rewind()));
        change("restore of fewer", (s, r) -> s.world.restore(s.fewer.rewind()));
        change("rewind.save", (s, r) -> s.rewind.save(s.frame + 1));
        change("rewind.restore", (s, r) -> s.rewind.restore(s.rewind.oldest()));
        call("fixed.positions", (s, r) -> MemoryScene.list(s.fixed.positions(null)));
        call("fixed.radii", (s, r) -> MemoryScene.list(s.fixed.radii()));
        call("fixed.angles", (s, r) -> MemoryScene.list(s.fixed.angles()));
        call("fixed.pieces", (s, r) -> {
            float[] pieces = new float[Terrain.PIECE_STRIDE * s.world.terrain().size()];
            return new Object[] {s.fixed.pieces(pieces, null), pieces};
        });
        call("fixed.jointEnds", (s, r) -> {
            float[] ends = new float[4 * s.world.joints().size()];
            return new Object[] {s.fixed.jointEnds(ends, null), ends};
        });
    }
}
