package io.github.circles2d.toy;

import com.example.rollback.Duel;
import io.github.circles2d.Backend;
import io.github.circles2d.Edge;
import io.github.circles2d.World;
import java.nio.ByteBuffer;
import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Float32Array;
import org.teavm.jso.typedarrays.Int32Array;
import org.teavm.jso.typedarrays.Int8Array;

/** The calls of the page. */
public final class Toy {
    private static Sandbox sandbox;
    private static Picture picture;
    private static Duel duel;

    private Toy() {}

    /** Nothing runs unless it is called. */
    public static void main(String[] arguments) {}

    /** Opens a scene in place of what is. */
    @JSExport
    public static void open(String scene) {
        take(Stages.open(scene));
    }

    /** Opens a snapshot in place of what is; all stays as it is if it has no world. Returns why not, or an empty text. */
    @JSExport
    public static String restore(Int8Array snapshot) {
        World world = World.builder().backend(Backend.JVM).build();
        try {
            world.restore(ByteBuffer.wrap(snapshot.copyToJavaArray()));
        } catch (IllegalArgumentException | IllegalStateException e) {
            world.close();
            return e.getMessage();
        }
        take(world);
        return "";
    }

    private static void take(World world) {
        Sandbox next;
        Picture shown;
        try {
            next = new Sandbox(world);
            shown = new Picture(next.grain());
        } catch (RuntimeException | Error e) {
            world.close();
            throw e;
        }
        if (sandbox != null) {
            sandbox.close();
        }
        sandbox = next;
        picture = shown;
    }

    /** What of the world the page does not draw as it is: sentences, or an empty text. */
    @JSExport
    public static String undrawn() {
        return Undrawn.of(sandbox.world());
    }

    /** The world as it is, for a file. The pointer lets it go first. */
    @JSExport
    public static Int8Array snapshot() {
        sandbox.release();
        World world = sandbox.world();
        ByteBuffer bytes = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(bytes);
        return Int8Array.copyFromJavaArray(bytes.array());
    }

    /**
     * Five numbers: the least x and y that the page shows, the greatest, and the radius of usual circles. Those of an axis that is open are
     * the same as long as the world is.
     */
    @JSExport
    public static Float32Array view() {
        View view = sandbox.view();
        Float32Array numbers = new Float32Array(5);
        numbers.set(0, view.minX());
        numbers.set(1, view.minY());
        numbers.set(2, view.maxX());
        numbers.set(3, view.maxY());
        numbers.set(4, sandbox.grain().radius());
        return numbers;
    }

    /** Whether there is no end to the world along x. */
    @JSExport
    public static boolean isOpenX() {
        return sandbox.world().edgeX() == Edge.OPEN;
    }

    /** The same along y. */
    @JSExport
    public static boolean isOpenY() {
        return sandbox.world().edgeY() == Edge.OPEN;
    }

    /** The pointer is there now. */
    @JSExport
    public static void moveTo(float x, float y) {
        sandbox.moveTo(x, y);
    }

    /** Begins to drag the circle at the pointer. */
    @JSExport
    public static void grab() {
        sandbox.grab();
    }

    /** Begins to pour circles at the pointer. */
    @JSExport
    public static void pour() {
        sandbox.pour();
    }

    /** Ends what the pointer does. */
    @JSExport
    public static void release() {
        sandbox.release();
    }

    /** Pushes all circles away from the pointer. */
    @JSExport
    public static void explode() {
        sandbox.explode();
    }

    /** Draws a wall to the pointer. */
    @JSExport
    public static void wallFrom(float x, float y) {
        sandbox.wallFrom(x, y);
    }

    /** Begins a joint at the pointer. */
    @JSExport
    public static void beginJoint() {
        sandbox.beginJoint();
    }

    /** Ends it at the pointer: a rope, or a spring. */
    @JSExport
    public static void endJoint(boolean isRope) {
        sandbox.endJoint(isRope);
    }

    /** Holds the circle at the pointer where it is. */
    @JSExport
    public static void pin() {
        sandbox.pin();
    }

    /** Removes the joints at the pointer. */
    @JSExport
    public static void cut() {
        sandbox.cut();
    }

    /** Makes a step. */
    @JSExport
    public static void step() {
        sandbox.step();
    }

    /** Goes back by a step. */
    @JSExport
    public static void back() {
        sandbox.back();
    }

    /** Steps from the start. */
    @JSExport
    public static int steps() {
        return sandbox.steps();
    }

    /** The state as a number, in 16 hexadecimal digits. */
    @JSExport
    public static String hash() {
        String digits = Long.toHexString(sandbox.world().hash());
        return "0".repeat(16 - digits.length()) + digits;
    }

    /** Gives walls and all circles that are no belts a surface. */
    @JSExport
    public static void setSurface(float friction, float rollingResistance) {
        sandbox.setSurface(friction, rollingResistance);
    }

    /** Sets how strong gravity is, from 0 on, in the direction that it has at first; down if there is none. */
    @JSExport
    public static void setGravity(float strength) {
        sandbox.setGravity(strength);
    }

    /** How strong it is. */
    @JSExport
    public static float gravity() {
        return sandbox.gravity();
    }

    /** The friction of that surface. */
    @JSExport
    public static float friction() {
        return sandbox.friction();
    }

    /** Its rolling resistance. */
    @JSExport
    public static float rollingResistance() {
        return sandbox.rollingResistance();
    }

    /** Five numbers for each circle that does not sleep: x, y, radius, shade, and the angle by which it has turned, or NaN. */
    @JSExport
    public static Float32Array picture(int mode) {
        return picture.of(sandbox.world(), mode);
    }

    /** The same of those that have fallen asleep since the picture before, each behind its id. After another mode, all that sleep. */
    @JSExport
    public static Float32Array rested() {
        return picture.rested();
    }

    /** The ids of those that have slept in the picture before, and do not any more. */
    @JSExport
    public static Int32Array woken() {
        return picture.woken();
    }

    /** All circles. */
    @JSExport
    public static int size() {
        return sandbox.world().size();
    }

    /** Those that neither slept nor were static in the last picture. */
    @JSExport
    public static int awake() {
        return picture.awake();
    }

    /** Whether the world is one in which circles may fall asleep. */
    @JSExport
    public static boolean canSleep() {
        return sandbox.world().sleeps();
    }

    /** Whether they do. */
    @JSExport
    public static boolean sleeps() {
        return sandbox.sleeps();
    }

    /** Lets them, or keeps them awake. */
    @JSExport
    public static void setSleeps(boolean sleeps) {
        sandbox.setSleeps(sleeps);
    }

    /** The pieces of terrain, as {@link io.github.circles2d.Terrain#readPieces} gives them, with a shade in place of the kind. */
    @JSExport
    public static Float32Array terrain() {
        return picture.terrainOf(sandbox.world());
    }

    /** Three numbers for each point of the outlines of soft bodies: x, y, and the number of the body. */
    @JSExport
    public static Float32Array blobs() {
        return picture.blobsOf(sandbox.world());
    }

    /** Begins a match of two peers, with a slow network between them. */
    @JSExport
    public static void openMatch() {
        duel = new Duel();
    }

    /** Makes a sixtieth of a second of the match pass. */
    @JSExport
    public static void tickMatch() {
        duel.tick();
    }

    /** Sets how many ticks a packet takes at most. */
    @JSExport
    public static void setSlowest(int ticks) {
        duel.setSlowest(ticks);
    }

    /** The player of a side, 0 or 1, wants to be there. */
    @JSExport
    public static void steer(int side, int x, int y) {
        duel.steer(side, x, y);
    }

    /** What the peer of a side sees, as {@link Duel#seen} has it. */
    @JSExport
    public static Float32Array seen(int side) {
        return duel.seen(side);
    }

    /** Five numbers a joint: x and y of both ends, and a shade of its force. */
    @JSExport
    public static Float32Array joints() {
        return picture.jointsOf(sandbox.world());
    }

    /** The hash of a scene on record after some steps. */
    @JSExport
    public static String sameBits(String scene, int steps) {
        return SameBits.hash(scene, steps);
    }
}
