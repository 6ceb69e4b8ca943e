package io.github.circles2d.playground;

import io.github.circles2d.JointType;
import io.github.circles2d.Joints;
import io.github.circles2d.Kind;
import io.github.circles2d.Terrain;
import io.github.circles2d.World;
import java.nio.FloatBuffer;
import java.util.Arrays;

/** Reads what a frame shows from a world, in one bulk copy for each field. It keeps its arrays. */
final class Readout {
    /** Each force is read by itself. */
    private static final int MOST_FORCES = 4_000;

    private static final long[] NONE = new long[0];

    private final Shades shades = new Shades();
    private final BlobShapes blobs = new BlobShapes();
    private Grain grain;
    private float[] circles = new float[0];
    private float[] velocities = new float[0];
    private float[] loads = new float[0];
    private float[] angles = new float[0];
    private float[] angularVelocities = new float[0];
    private int[] kinds = new int[0];
    private long[] awake = new long[0];

    /** Of joints. */
    private long[] handles = new long[0];

    private double energy;

    /** Fills the circles of a frame, where they are between two steps. */
    void fill(Frame frame, Sandbox sandbox, PaintMode paint) {
        World world = sandbox.world();
        if (grain != sandbox.grain()) {
            grain = sandbox.grain();
            shades.start(grain.highSpeed());
        }
        FloatBuffer positions = sandbox.loop().positions(null);
        int ids = world.idLimit();
        ensure(ids);
        world.readById(circles, null);
        world.readVelocitiesById(velocities, null);
        world.readAnglesById(angles, null);
        world.readAngularVelocitiesById(angularVelocities, null);
        world.readAwakeById(awake);
        boolean turns = turns(ids);
        if (turns) {
            world.readKindsById(kinds, null);
            sandbox.loop().angles().get(0, angles, 0, positions.limit() / 2);
        }
        if (paint.needsLoads()) {
            world.readLoadsById(loads, null);
            for (int id = 0; id < ids; id++) {
                shades.note(loads[2 * id + 1], circles[4 * id + 2]);
            }
            shades.scalePressure();
        }
        frame.arena = Arena.of(world);
        frame.ensure(world.size());
        copy(frame, positions, ids, paint);
        if (turns) {
            mark(frame, world, ids);
        } else {
            Arrays.fill(frame.angle, 0, frame.circles, Float.NaN);
        }
        blobs.read(world);
        blobs.show(frame.blobs, positions, circles);
        sandbox.bodies().read(world, sandbox.loop(), shades, paint);
        frame.bodies.copy(sandbox.bodies().shapes());
        readPieces(frame, sandbox);
        readJoints(frame, sandbox);
        frame.legendMost = shades.most(paint);
        measure(world, ids);
        frame.energy = energy + sandbox.bodies().energy();
    }

    private void copy(Frame frame, FloatBuffer positions, int ids, PaintMode paint) {
        int shown = positions.limit() / 2;
        int count = 0;
        int movable = 0;
        int sleepers = 0;
        for (int id = 0; id < ids; id++) {
            float x = circles[4 * id];
            if (x != x) {
                continue; // no circle
            }
            boolean between = id < shown && positions.get(2 * id) == positions.get(2 * id);
            boolean isStatic = circles[4 * id + 3] == Float.POSITIVE_INFINITY;
            boolean sleeps = (awake[id >> 6] & 1L << id) == 0;
            int own = isStatic ? Theme.STATIC : colour(id, paint);
            int colour = sleeps ? Shades.asleep(own) : own;
            frame.x[count] = between ? positions.get(2 * id) : x;
            frame.y[count] = between ? positions.get(2 * id + 1) : circles[4 * id + 1];
            frame.radius[count] = circles[4 * id + 2];
            frame.colour[count] = colour;
            frame.rim[count] = Ramp.rim(colour);
            movable += isStatic ? 0 : 1;
            sleepers += sleeps ? 1 : 0;
            count++;
        }
        frame.circles = count;
        frame.movable = movable;
        frame.awake = movable - sleepers;
    }

    private static void readPieces(Frame frame, Sandbox sandbox) {
        World world = sandbox.world();
        Terrain terrain = world.terrain();
        frame.ensurePieces(terrain.size(), Terrain.PIECE_STRIDE);
        frame.pieces = sandbox.loop().pieces(frame.piece, null);
        for (int k = 0; k < frame.pieces; k++) {
            Kind kind = world.kind((int) frame.piece[k * Terrain.PIECE_STRIDE + Terrain.KIND]);
            frame.pieceColour[k] = kind.beltSpeed() != 0 ? Theme.BELT : kind.isOneWay() ? Theme.ONE_WAY : Theme.STATIC;
        }
    }

    private void readJoints(Frame frame, Sandbox sandbox) {
        Joints joints = sandbox.world().joints();
        frame.ensureJoints(joints.size());
        if (handles.length < frame.jointColour.length) {
            handles = new long[frame.jointColour.length];
        }
        int all = sandbox.loop().jointEnds(frame.joint, handles);
        int shown = 0;
        for (int k = 0; k < all; k++) {
            float force = all > MOST_FORCES ? 0 : joints.force(handles[k]);
            if (all > MOST_FORCES || !isHidden(joints, handles[k], force)) {
                System.arraycopy(frame.joint, 4 * k, frame.joint, 4 * shown, 4);
                frame.jointColour[shown++] = shades.tension(force);
            }
        }
        frame.joints = shown;
        shades.scaleTension();
    }

    /** A joint that goes through a filled blob; and one that would stretch a rope, beside that rope while it is slack. */
    private boolean isHidden(Joints joints, long joint, float force) {
        long circle = joints.circle(joint);
        long other = joints.other(joint);
        if (blobs.any() && other != 0 && blobs.join(World.id(circle), World.id(other))) {
            return true;
        }
        return force == 0
                && joints.joint(joint).type() == JointType.LIMITS
                && joints.joint(joint).minLength() == 0
                && joints.ofCircle(circle, NONE) > 1;
    }

    /** Whether a circle turns or has turned. */
    private boolean turns(int ids) {
        for (int id = 0; id < ids; id++) {
            if (angles[id] != 0 && angles[id] == angles[id]
                    || angularVelocities[id] != 0 && angularVelocities[id] == angularVelocities[id]) {
                return true;
            }
        }
        return false;
    }

    /** Shows how circles have turned. Static ones show it if they have, and their belts by a colour. */
    private void mark(Frame frame, World world, int ids) {
        int count = 0;
        for (int id = 0; id < ids; id++) {
            if (circles[4 * id] != circles[4 * id]) {
                continue; // no circle
            }
            float angle = angles[id] == angles[id] ? angles[id] : 0; // it is new
            boolean isStatic = circles[4 * id + 3] == Float.POSITIVE_INFINITY;
            frame.angle[count] = isStatic && angle == 0 ? Float.NaN : angle;
            if (isStatic && world.kind(kinds[id]).beltSpeed() != 0) {
                frame.colour[count] = Theme.BELT;
                frame.rim[count] = Ramp.rim(Theme.BELT);
            }
            count++;
        }
    }

    private int colour(int id, PaintMode paint) {
        return switch (paint) {
            case PLAIN -> Shades.tint(id);
            case SPEED -> shades.speed(velocities[2 * id], velocities[2 * id + 1]);
            case PRESSURE -> shades.pressure(loads[2 * id + 1], circles[4 * id + 2]);
            case CONTACTS -> Shades.contacts(loads[2 * id]);
        };
    }

    /** Kinetic energy, that of turning, and that of height. */
    private void measure(World world, int ids) {
        double sum = 0;
        for (int id = 0; id < ids; id++) {
            float mass = circles[4 * id + 3];
            if (mass < Float.POSITIVE_INFINITY) { // not static, and not NaN
                double vx = velocities[2 * id];
                double vy = velocities[2 * id + 1];
                double surface = circles[4 * id + 2] * (double) angularVelocities[id];
                double height = Sandbox.height(world, circles[4 * id], circles[4 * id + 1]);
                sum += mass * (0.5 * (vx * vx + vy * vy) + 0.25 * surface * surface + height);
            }
        }
        energy = sum;
    }

    private void ensure(int ids) {
        if (velocities.length < 2 * ids) {
            int room = ids + (ids >> 1);
            circles = new float[4 * room];
            velocities = new float[2 * room];
            loads = new float[2 * room];
            angles = new float[room];
            angularVelocities = new float[room];
            kinds = new int[room];
            awake = new long[(room >> 6) + 1];
        }
    }
}
