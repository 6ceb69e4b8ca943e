package io.github.circles2d;

import static io.github.circles2d.WorldScenes.snapshot;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A log knows every call that changes a world: a new public method fails here until it is listed below. */
@Tag("each-jdk")
class RecordedCallsTest {
    /** A call that changes a world with two circles. */
    interface Change {
        void make(World world, long a, long b);
    }

    /** Behind a signature: the call is made for a static circle, where it does something else. */
    private static final String STATIC = " of a static circle";

    private static final float[] TWO = {0.3f, 0.4f, 0.7f, 0.6f};
    private static final float[] SIX = {0.3f, 0.4f, 0.7f, 0.6f, 0.5f, 0.25f};

    /** Lines and an arc, closed. */
    private static final Chain CHAIN =
            Chain.of(0.9f, 0.1f, 0.9f, 0.5f, 0.7f, 0.5f).arcTo(0.5f, 0.5f, -3).close();

    private static final Outline BOX = Outline.box(0.2f, 0.1f);

    /** With more words than a call of a log takes. */
    private static final Outline LONG =
            Outline.polygon(0, 0, 0.2f, 0, 0.3f, 0.1f, 0.25f, 0.2f, 0.1f, 0.25f, -0.1f, 0.1f);

    /** Every method that changes what the next step does, or what a snapshot has, with a call of it that does. */
    private static final Map<String, Change> CHANGES = new TreeMap<>(Map.ofEntries(
            change("add(float, float, float, float)", (w, a, b) -> w.add(0.5f, 0.8f, 0.1f, 2)),
            change("add(float, float, float, float, float, float)", (w, a, b) -> w.add(0.5f, 0.8f, 0.1f, 2, 1, -1)),
            change("addAll(float[], long[])", (w, a, b) -> w.addAll(new float[] {0.5f, 0.8f, 0.1f, 2}, null)),
            change(
                    "addAll(float[], float[], long[])",
                    (w, a, b) -> w.addAll(new float[] {0.5f, 0.8f, 0.1f, 2}, new float[] {1, -1}, new long[1])),
            change(
                    "addAll(float[], float[], int[], long[])",
                    (w, a, b) -> w.addAll(
                            new float[] {0.5f, 0.8f, 0.1f, 2, 0.8f, 0.8f, 0.1f, 2}, null, new int[] {7, 0}, null)),
            change("remove(long)", (w, a, b) -> w.remove(a)),
            change(
                    "removeAll(long[], int, StaleHandles)",
                    (w, a, b) -> w.removeAll(new long[] {b, 7, a}, 2, StaleHandles.SKIP)),
            change("setPosition(long, float, float)", (w, a, b) -> w.setPosition(a, 0.8f, 0.8f)),
            change("setPosition(long, float, float)" + STATIC, (w, a, b) -> {
                w.setMass(a, Float.POSITIVE_INFINITY);
                w.setPosition(a, 0.8f, 0.8f);
            }),
            change("teleport(long, float, float)", (w, a, b) -> w.teleport(a, 0.8f, 0.8f)),
            change("setVelocity(long, float, float)", (w, a, b) -> w.setVelocity(a, 0.8f, 0.8f)),
            change("setRadius(long, float)", (w, a, b) -> w.setRadius(a, 0.15f)),
            change("grow(long, float, int)", (w, a, b) -> w.grow(a, 0.15f, 4)),
            change("clear()", (w, a, b) -> w.clear()),
            change("setMass(long, float)", (w, a, b) -> w.setMass(a, Float.POSITIVE_INFINITY)),
            change("setRestitution(long, float)", (w, a, b) -> w.setRestitution(b, 0.9f)),
            change("setTag(long, long)", (w, a, b) -> w.setTag(b, -1L << 40)),
            change("wake(long)", (w, a, b) -> w.wake(a)),
            change("wakeAll()", (w, a, b) -> {
                w.step(1, 2);
                w.wakeAll();
            }),
            change("Kind.setSleeps(boolean)", (w, a, b) -> w.kind(0).setSleeps(false)),
            change("applyImpulse(long, float, float)", (w, a, b) -> w.applyImpulse(a, 1, 2)),
            change(
                    "setPositions(long[], int, float[], StaleHandles)",
                    (w, a, b) -> w.setPositions(new long[] {a, b}, 2, TWO, StaleHandles.REFUSE)),
            change("setPositions(long[], int, float[], StaleHandles)" + STATIC, (w, a, b) -> {
                w.setMass(a, Float.POSITIVE_INFINITY);
                w.setPositions(new long[] {a, b}, 2, TWO, StaleHandles.REFUSE);
            }),
            change(
                    "setVelocities(long[], int, float[], StaleHandles)",
                    (w, a, b) -> w.setVelocities(new long[] {a, b}, 2, TWO, StaleHandles.REFUSE)),
            change(
                    "applyImpulses(long[], int, float[], StaleHandles)",
                    (w, a, b) -> w.applyImpulses(new long[] {a, b}, 2, TWO, StaleHandles.REFUSE)),
            change(
                    "setForces(long[], int, float[], StaleHandles)",
                    (w, a, b) -> w.setForces(new long[] {a, b}, 2, TWO, StaleHandles.REFUSE)),
            change("setKinds(long[], int, int[], StaleHandles)", (w, a, b) -> {
                w.kind(9).setRestitution(0.25f);
                w.setKinds(new long[] {a, b}, 2, new int[] {9, 1}, StaleHandles.REFUSE);
            }),
            change("explode(float, float, float, float, float)", (w, a, b) -> w.explode(0.4f, 0.4f, 1, 0.1f, 0)),
            change(
                    "explode(float, float, float, float, float, int)",
                    (w, a, b) -> w.explode(0.4f, 0.4f, 1, 0.1f, 0, 1)),
            change(
                    "explodeInSight(float, float, float, float, float)",
                    (w, a, b) -> w.explodeInSight(0.4f, 0.4f, 1, 0.1f, 0)),
            change(
                    "explodeInSight(float, float, float, float, float, int)",
                    (w, a, b) -> w.explodeInSight(0.4f, 0.4f, 1, 0.1f, 0, 1)),
            change(
                    "add(float, float, float, float, float, float, int)",
                    (w, a, b) -> w.add(0.5f, 0.8f, 0.1f, 2, 1, -1, 3)),
            change("setKind(long, int)", (w, a, b) -> w.setKind(a, 200)),
            change("setGroup(long, int)", (w, a, b) -> w.setGroup(a, -5)),
            change("setForce(long, float, float)", (w, a, b) -> w.setForce(a, 1, 2)),
            change("applyForce(long, float, float)", (w, a, b) -> w.applyForce(a, 1, 2)),
            change("setFriction(long, float)", (w, a, b) -> w.setFriction(a, 0.5f)),
            change("setRollingResistance(long, float)", (w, a, b) -> w.setRollingResistance(a, 0.25f)),
            change("setGravityScale(long, float)", (w, a, b) -> w.setGravityScale(a, -0.5f)),
            change("setDamping(long, float)", (w, a, b) -> w.setDamping(a, 2)),
            change("setGreatestSpeed(long, float)", (w, a, b) -> w.setGreatestSpeed(a, 0.125f)),
            change("setAngle(long, float)", (w, a, b) -> w.setAngle(a, -2)),
            change("setAngularVelocity(long, float)", (w, a, b) -> w.setAngularVelocity(a, 3)),
            change("applyAngularImpulse(long, float)", (w, a, b) -> {
                w.kind(3).setInertia(Inertia.RING);
                w.setKind(a, 3);
                w.applyAngularImpulse(a, 0.5f);
                w.kind(3).setInertia(Inertia.DISC);
                w.applyAngularImpulse(b, 0.25f);
            }),
            change("setTorque(long, float)", (w, a, b) -> w.setTorque(b, -0.5f)),
            change("applyTorque(long, float)", (w, a, b) -> w.applyTorque(b, 0.5f)),
            change(
                    "setAngularVelocities(long[], int, float[], StaleHandles)",
                    (w, a, b) -> w.setAngularVelocities(new long[] {a, b}, 2, TWO, StaleHandles.REFUSE)),
            change(
                    "setWallSurface(Wall, float, float, float)",
                    (w, a, b) -> w.setWallSurface(Wall.MIN_Y, 0.5f, 0.25f, -1)),
            change("Kind.setFriction(float)", (w, a, b) -> w.kind(0).setFriction(0.5f)),
            change("Kind.setRollingResistance(float)", (w, a, b) -> w.kind(0).setRollingResistance(0.25f)),
            change(
                    "Kind.setBeltSpeed(float)",
                    (w, a, b) -> w.kind(0).setFriction(1).setBeltSpeed(2)),
            change("Kind.setInertia(Inertia)", (w, a, b) -> w.kind(0).setInertia(Inertia.NONE)),
            change("Kind.setAngularDamping(float)", (w, a, b) -> w.kind(0).setAngularDamping(2)),
            change("setResponse(int, int, Response)", (w, a, b) -> w.setResponse(0, 0, Response.IGNORE)),
            change("Kind.setCategory(int)", (w, a, b) -> w.kind(0).setCategory(6)),
            change("Kind.setMask(int)", (w, a, b) -> w.kind(255).setMask(0)),
            change("Kind.setSensor(boolean)", (w, a, b) -> w.kind(0).setSensor(true)),
            change("Kind.setSensesStatic(boolean)", (w, a, b) -> w.kind(0).setSensesStatic(true)),
            change("Kind.setRestitution(float)", (w, a, b) -> w.kind(1).setRestitution(0.5f)),
            change("Kind.setGravityScale(float)", (w, a, b) -> w.kind(0).setGravityScale(-1)),
            change("Kind.setDamping(float)", (w, a, b) -> w.kind(0).setDamping(2)),
            change("Kind.setGreatestSpeed(float)", (w, a, b) -> w.kind(0).setGreatestSpeed(0.1f)),
            change("setGravity(float, float)", (w, a, b) -> w.setGravity(1, -2)),
            change("setBounds(float, float, float, float)", (w, a, b) -> w.setBounds(0.25f, 0.25f, 0.9f, 0.8f)),
            change("Kind.copyFrom(Kind)", (w, a, b) -> w.kind(0)
                    .copyFrom(w.kind(9).setDamping(0.5f))),
            change("Kind.setOneWay(boolean)", (w, a, b) -> w.kind(3).setOneWay(true)),
            change("Terrain.addSegment(float, float, float, float)", (w, a, b) -> w.terrain()
                    .addSegment(0, 0.2f, 1, 0.1f)),
            change("Terrain.addSegment(float, float, float, float, float, int)", (w, a, b) -> w.terrain()
                    .addSegment(0, 0.2f, 1, 0.1f, 0.05f, 3)),
            change("Terrain.addArc(float, float, float, float, float, ArcSide)", (w, a, b) -> w.terrain()
                    .addArc(0.5f, 0.5f, 0.4f, -3, 0.1f, ArcSide.INNER)),
            change("Terrain.addArc(float, float, float, float, float, ArcSide, int)", (w, a, b) -> w.terrain()
                    .addArc(0.5f, 0.5f, 0.4f, -3, 0.1f, ArcSide.OUTER, 255)),
            change("Terrain.addChain(Chain)", (w, a, b) -> w.terrain().addChain(CHAIN)),
            change("Terrain.addChain(Chain, int, long[])", (w, a, b) -> w.terrain()
                    .addChain(Chain.from(0.9f, 0.9f).arcTo(0.5f, 0.5f, 1).close(), 9, new long[2])),
            change("Terrain.addSegments(float[], int, long[])", (w, a, b) -> w.terrain()
                    .addSegments(new float[] {0, 0, 1, 1, 1, 0, 0, 1}, 2, new long[2])),
            change("Terrain.remove(long)", (w, a, b) -> {
                long[] pieces = new long[CHAIN.pieces()];
                w.terrain().addChain(CHAIN, 4, pieces);
                w.terrain().remove(pieces[1]);
            }),
            change("Terrain.setKind(long, int)", (w, a, b) -> w.terrain()
                    .setKind(w.terrain().addSegment(0, 0, 1, 1), 77)),
            change("Terrain.clear()", (w, a, b) -> {
                liftOf(w);
                w.terrain().clear();
            }),
            change("Terrain.addBody(float, float, float)", (w, a, b) -> w.terrain()
                    .addBody(0.5f, 0.5f, 2)),
            change("TerrainBody.addSegment(float, float, float, float)", (w, a, b) -> liftOf(w)
                    .addSegment(0, 0, 1, 1)),
            change("TerrainBody.addSegment(float, float, float, float, float, int)", (w, a, b) -> liftOf(w)
                    .addSegment(0, 0, 1, 1, 0.1f, 1)),
            change("TerrainBody.addArc(float, float, float, float, float, ArcSide)", (w, a, b) -> liftOf(w)
                    .addArc(0, 0, 0.1f, 0, 1, ArcSide.OUTER)),
            change("TerrainBody.addArc(float, float, float, float, float, ArcSide, int)", (w, a, b) -> liftOf(w)
                    .addArc(0, 0, 0.1f, 0, 1, ArcSide.OUTER, 8)),
            change("TerrainBody.addChain(Chain)", (w, a, b) -> liftOf(w).addChain(CHAIN)),
            change("TerrainBody.addChain(Chain, int, long[])", (w, a, b) -> liftOf(w)
                    .addChain(CHAIN, 1, null)),
            change("TerrainBody.addSegments(float[], int, long[])", (w, a, b) -> liftOf(w)
                    .addSegments(new float[] {0, 0, 1, 1}, 2, null)),
            change("TerrainBody.setVelocity(float, float)", (w, a, b) -> liftOf(w)
                    .setVelocity(1, -2)),
            change("TerrainBody.setAngularVelocity(float)", (w, a, b) -> liftOf(w)
                    .setAngularVelocity(-9)),
            change("TerrainBody.moveTo(float, float, float)", (w, a, b) -> liftOf(w)
                    .moveTo(0.3f, 0.2f, 1)),
            change("TerrainBody.teleport(float, float, float)", (w, a, b) -> liftOf(w)
                    .teleport(0.3f, 0.2f, 1)),
            change("TerrainBody.remove()", (w, a, b) -> liftOf(w).remove()),
            change("Joints.add(long, long, Joint)", (w, a, b) -> w.joints()
                    .add(a, b, Joint.weld().breakingAt(1e6f, 1e5f))),
            change("Joints.add(long, float, float, Joint)", (w, a, b) -> w.joints()
                    .add(a, 0.5f, 0.6f, Joint.spring(3, 0.5f).withLimits(0.1f, 2))),
            change("Joints.add(long, TerrainBody, float, float, Joint)", (w, a, b) -> w.joints()
                    .add(b, liftOf(w), 0.1f, 0.2f, Joint.mouse(5, 1, 30))),
            change("Joints.add(long, Joint)", (w, a, b) -> {
                w.joints().add(a, Joint.friction(0.5f, 0.25f));
                w.joints().add(b, Joint.servo(2, 5, 0.5f, 3));
            }),
            change("Joints.add(long, float, float, long, float, float, Joint)", (w, a, b) -> w.joints()
                    .add(body(w), 0.1f, 0, body(w), 0, 0.1f, Joint.pin())),
            change("Joints.add(long, float, float, long, Joint)", (w, a, b) -> w.joints()
                    .add(body(w), 0.1f, 0, a, Joint.weld())),
            change("Joints.add(long, float, float, float, float, Joint)", (w, a, b) -> w.joints()
                    .add(body(w), 0.1f, 0, 0.5f, 0.6f, Joint.rope(0.5f))),
            change("Joints.add(long, float, float, TerrainBody, float, float, Joint)", (w, a, b) -> w.joints()
                    .add(body(w), 0.1f, 0, liftOf(w), 0.1f, 0.2f, Joint.mouse(5, 1, 30))),
            change("Joints.addAll(long[], long[], Joint, long[])", (w, a, b) -> w.joints()
                    .addAll(new long[] {a, b}, new long[] {b, a}, Joint.distance(), new long[2])),
            change("Joints.addAll(long[], Joint, long[])", (w, a, b) -> w.joints()
                    .addAll(new long[] {a, b}, Joint.motor(2, 1), null)),
            change("Joints.remove(long)", (w, a, b) -> {
                long gone = w.joints().add(a, b, Joint.motor(4, 3));
                w.joints().add(b, 0.5f, 0.6f, Joint.pin());
                w.joints().remove(gone);
            }),
            change("Joints.removeAll(long[])", (w, a, b) -> {
                long[] joints = new long[3];
                for (int k = 0; k < joints.length; k++) {
                    joints[k] = w.joints().add(a, b, Joint.rope(2));
                }
                w.joints().removeAll(new long[] {joints[2], joints[0]});
            }),
            change("Joints.clear()", (w, a, b) -> {
                w.joints().add(a, b, Joint.limits(0.1f, 2));
                w.joints().clear();
            }),
            change("Bodies.add(Outline, float, float, float, float)", (w, a, b) -> w.bodies()
                    .add(BOX, 0.7f, 0.8f, 1, 2)),
            change("Bodies.add(Outline, float, float, float, float, int)", (w, a, b) -> {
                w.bodies().add(BOX, 0.7f, 0.8f, 1, 2, 3);
                w.bodies().add(LONG, 0.3f, 0.8f, 1, 2, 3);
                w.bodies().add(BOX, 0.2f, 0.6f, 1, 2, 3);
            }),
            change("Bodies.addAll(Outline, float[], int[], long[])", (w, a, b) -> w.bodies()
                    .addAll(LONG, new float[] {0.7f, 0.8f, 1, 2, 0.3f, 0.8f, 0, 1}, new int[] {3, 0}, new long[2])),
            change("Bodies.addAll(Outline[], float[], int[], long[])", (w, a, b) -> w.bodies()
                    .addAll(
                            new Outline[] {BOX, LONG, BOX},
                            new float[] {0.7f, 0.8f, 1, 2, 0.3f, 0.8f, 0, 1, 0.2f, 0.6f, 0, 1},
                            null,
                            null)),
            change("Bodies.removeAll(long[], int, StaleHandles)", (w, a, b) -> w.bodies()
                    .removeAll(new long[] {body(w), 7, body(w)}, 2, StaleHandles.SKIP)),
            change("Bodies.teleportAll(long[], int, float[], StaleHandles)", (w, a, b) -> w.bodies()
                    .teleportAll(new long[] {body(w), body(w)}, 2, SIX, StaleHandles.REFUSE)),
            change("Bodies.setVelocities(long[], int, float[], StaleHandles)", (w, a, b) -> w.bodies()
                    .setVelocities(new long[] {body(w), body(w)}, 2, SIX, StaleHandles.REFUSE)),
            change("Bodies.applyImpulses(long[], int, float[], StaleHandles)", (w, a, b) -> w.bodies()
                    .applyImpulses(new long[] {body(w), body(w)}, 2, SIX, StaleHandles.REFUSE)),
            change("Bodies.setForces(long[], int, float[], StaleHandles)", (w, a, b) -> w.bodies()
                    .setForces(new long[] {body(w), body(w)}, 2, SIX, StaleHandles.REFUSE)),
            change("Bodies.setKinds(long[], int, int[], StaleHandles)", (w, a, b) -> w.bodies()
                    .setKinds(new long[] {body(w), body(w)}, 2, new int[] {9, 1}, StaleHandles.REFUSE)),
            change("Bodies.remove(long)", (w, a, b) -> {
                body(w);
                w.bodies().remove(body(w));
            }),
            change("Bodies.clear()", (w, a, b) -> {
                body(w);
                w.bodies().clear();
            }),
            change("Bodies.setVelocity(long, float, float)", (w, a, b) -> w.bodies()
                    .setVelocity(body(w), 2, 3)),
            change("Bodies.setAngularVelocity(long, float)", (w, a, b) -> w.bodies()
                    .setAngularVelocity(body(w), 2)),
            change("Bodies.applyImpulse(long, float, float)", (w, a, b) -> w.bodies()
                    .applyImpulse(body(w), 2, 3)),
            change("Bodies.applyImpulse(long, float, float, float, float)", (w, a, b) -> w.bodies()
                    .applyImpulse(body(w), 2, 3, 0.6f, 0.9f)),
            change("Bodies.applyAngularImpulse(long, float)", (w, a, b) -> w.bodies()
                    .applyAngularImpulse(body(w), 2)),
            change("Bodies.applyForce(long, float, float)", (w, a, b) -> w.bodies()
                    .applyForce(body(w), 2, 3)),
            change("Bodies.applyForce(long, float, float, float, float)", (w, a, b) -> w.bodies()
                    .applyForce(body(w), 2, 3, 0.6f, 0.9f)),
            change("Bodies.applyTorque(long, float)", (w, a, b) -> w.bodies().applyTorque(body(w), 2)),
            change("Bodies.setForce(long, float, float)", (w, a, b) -> w.bodies()
                    .setForce(body(w), 2, 3)),
            change("Bodies.setTorque(long, float)", (w, a, b) -> w.bodies().setTorque(body(w), 2)),
            change("Bodies.setKind(long, int)", (w, a, b) -> w.bodies().setKind(body(w), 2)),
            change("Bodies.setGroup(long, int)", (w, a, b) -> w.bodies().setGroup(body(w), -7)),
            change("Bodies.wake(long)", (w, a, b) -> w.bodies().wake(body(w))),
            change("Bodies.setTag(long, long)", (w, a, b) -> w.bodies().setTag(body(w), -1L << 40)),
            change("Bodies.setRestitution(long, float)", (w, a, b) -> w.bodies().setRestitution(body(w), 0.75f)),
            change("Bodies.setInertia(long, float)", (w, a, b) -> w.bodies()
                    .setInertia(body(w), Float.POSITIVE_INFINITY)),
            change("Bodies.teleport(long, float, float, float)", (w, a, b) -> w.bodies()
                    .teleport(body(w), 0.2f, 0.7f, 2)),
            change("Joints.setAnchor(long, float, float)", (w, a, b) -> w.joints()
                    .setAnchor(w.joints().add(a, 0.5f, 0.6f, Joint.pin(3, 1)), 0.6f, 0.7f)),
            change("Joints.setLength(long, float)", (w, a, b) -> w.joints()
                    .setLength(w.joints().add(a, b, Joint.distance()), 0.3f)),
            change("Joints.setLimits(long, float, float)", (w, a, b) -> w.joints()
                    .setLimits(w.joints().add(a, b, Joint.rope(0.3f)), 0.1f, 0.25f)),
            change("Joints.setSpring(long, float, float)", (w, a, b) -> w.joints()
                    .setSpring(w.joints().add(a, b, Joint.spring(5, 1)), 6, 0.25f)),
            change("Joints.setSpeed(long, float)", (w, a, b) -> w.joints()
                    .setSpeed(w.joints().add(a, b, Joint.motor(5, 1)), 6)),
            change("Joints.setAngle(long, float)", (w, a, b) -> w.joints()
                    .setAngle(w.joints().add(a, b, Joint.servo(1, 5, 1, 9)), -6)),
            change("Joints.setMaxForce(long, float)", (w, a, b) -> w.joints()
                    .setMaxForce(w.joints().add(a, Joint.friction(1, 1)), 6)),
            change("Joints.setMaxTorque(long, float)", (w, a, b) -> w.joints()
                    .setMaxTorque(w.joints().add(a, Joint.friction(1, 1)), 6)),
            change("Joints.setBreaking(long, float, float)", (w, a, b) -> w.joints()
                    .setBreaking(w.joints().add(a, b, Joint.distance()), 1e4f, Float.POSITIVE_INFINITY)),
            change("Joints.setColliding(long, boolean)", (w, a, b) -> w.joints()
                    .setColliding(w.joints().add(a, b, Joint.distance()), true)),
            change("step(float)", (w, a, b) -> w.step(0.01f)),
            change("step(float, int)", (w, a, b) -> w.step(0.01f, 3)),
            change("restore(ByteBuffer)", (w, a, b) -> w.restore(snapshotOfAnother()))));

    /** Methods that leave a world as it is, by name; those of events change what it tells. */
    private static final Set<String> READS = reads("""
            World: angle angles angularVelocity bodies close contactDamping contactFrequency contactsOf contains
                damping defaultFriction defaultRestitution defaultRollingResistance edgeX edgeY events finish
                forceX forceY friction gravityScale gravityX gravityY greatestPushOutSpeed greatestSpeed group
                growthSteps handle hash idLimit isAwake joints kind kindOf mass maxX maxY minX minY positions
                positionsById queries radius read readAnglesById readAngularVelocitiesById readAwakeById
                readById readHandles readKindsById readLoadsById readRadiiById readTagsById readVelocities
                readVelocitiesById report reportWalls requestEvents requestPositions response restitution
                restitutionThreshold rollingResistance setHitSpeed shortestX shortestY size sleeps snapshot
                snapshotBytes stats subSteps tag takeEvents takePositions takePositionsById terrain torque
                touching touchingPieces vx vy wallBeltSpeed wallFriction wallRollingResistance x y
            Kind: angularDamping beltSpeed category damping friction gravityScale greatestSpeed inertia isOneWay
                isSensor mask number restitution rollingResistance sensesStatic sleeps toString
            Bodies: angle angularVelocity awake contains events forceX forceY group handle idLimit inertia
                isAwake kindOf mass outline readById readHandles readVelocitiesById report restitution size tag
                torque touching vx vy x y
            Joints: anchorX anchorY circle contains events force forceX forceY handle idLimit joint length
                ofBody ofCircle other pick readEnds report size torque
            Terrain: body bodyOf contains ground handle idLimit kindOf readPieces size
            TerrainBody: angle angularVelocity exists handle localX localY toString vx vxAt vy vyAt worldX
                worldY x y
            """);

    /** With the class before each name, but for World. */
    private static Set<String> reads(String byClass) {
        Set<String> reads = new TreeSet<>();
        String type = "";
        for (String word : byClass.trim().split("\\s+")) {
            if (word.endsWith(":")) {
                type = word.equals("World:") ? "" : word.replace(':', '.');
            } else {
                reads.add(type + word);
            }
        }
        return reads;
    }

    private static long body(World world) {
        return world.bodies().add(BOX, 0.7f, 0.8f, 1, 2);
    }

    private static Map.Entry<String, Change> change(String signature, Change call) {
        return Map.entry(signature, call);
    }

    /** The methods of World, and of classes of the same package whose objects it gives out, other than plain values. */
    @Test
    void everyMethodIsARecordedChangeOrARead() {
        Set<String> known = CHANGES.keySet().stream()
                .map(name -> name.replace(STATIC, ""))
                .collect(Collectors.toCollection(TreeSet::new));
        Set<String> reads = new TreeSet<>(READS);
        Set<Class<?>> types = new LinkedHashSet<>(Set.of(World.class));
        for (Method method : World.class.getDeclaredMethods()) {
            Class<?> given = method.getReturnType();
            if (given.getPackage() == World.class.getPackage() && !given.isRecord() && !given.isEnum()) {
                types.add(given);
            }
        }
        types.add(TerrainBody.class); // Terrain gives it out
        types.remove(World.Builder.class); // a snapshot has what it sets
        types.remove(Queries.class); // they read
        types.remove(TerrainQueries.class);
        types.remove(Events.class);
        for (Class<?> type : types) {
            for (Method method : type.getDeclaredMethods()) {
                if (Modifier.isPublic(method.getModifiers()) && !Modifier.isStatic(method.getModifiers())) {
                    String name = (type == World.class ? "" : type.getSimpleName() + ".") + method.getName();
                    if (!reads.contains(name)) {
                        String signature = name
                                + Arrays.stream(method.getParameterTypes())
                                        .map(Class::getSimpleName)
                                        .collect(Collectors.joining(", ", "(", ")"));
                        assertThat(CHANGES)
                                .as("%s must be listed here: docs/how-to-extend.md says how", signature)
                                .containsKey(signature);
                        known.remove(signature);
                    }
                }
            }
        }
        assertThat(known).as("listed, but gone").isEmpty();
    }

    static Set<String> changes() {
        return CHANGES.keySet();
    }

    /** With two circles that rest on each other, and a step behind the call. */
    @ParameterizedTest
    @MethodSource("changes")
    void aChangeIsMadeAgain(String signature) throws IOException {
        boolean sleeps = !signature.startsWith("Bodies."); // which such a world refuses
        try (World world = newWorld(sleeps);
                World player = WorldScenes.jvm().threads(1).build()) {
            long a = world.add(0.4f, 0.31f, 0.1f, 1);
            long b = world.add(0.4f, 0.1f, 0.1f, 1);
            world.step(1 / 60f, 20);
            ByteBuffer before = snapshot(world);
            ByteArrayOutputStream log = new ByteArrayOutputStream();
            try (Recording recording = new Recording(world, log, 100)) {
                CHANGES.get(signature).make(world, a, b);
                assertThat(snapshot(world)).as("what %s has changed", signature).isNotEqualTo(before);
                assertThat(recording.bytes()).isPositive();
            }
            Replay replay = new Replay(new ByteArrayInputStream(log.toByteArray()), player);
            assertThat(snapshot(player)).isEqualTo(before);
            assertThat(replay.run().differs()).as(replay.difference()).isFalse();
            assertThat(snapshot(player)).isEqualTo(snapshot(world));
            world.step(1 / 60f, 5);
            player.step(1 / 60f, 5);
            assertThat(player.hash()).isEqualTo(world.hash());
        }
    }

    /** A body with a piece, that moves. */
    private static TerrainBody liftOf(World world) {
        TerrainBody lift = world.terrain().addBody(0.7f, 0.2f, -1);
        lift.addSegment(-0.1f, 0, 0.1f, 0);
        lift.setVelocity(0, 0.5f);
        return lift;
    }

    private static World newWorld(boolean sleeps) {
        return WorldScenes.jvm().gravity(0, -9).sleep(sleeps).threads(1).build();
    }

    private static ByteBuffer snapshotOfAnother() {
        try (World other = newWorld(true)) {
            other.add(0.5f, 0.5f, 0.1f, 3);
            return snapshot(other);
        }
    }
}
