package io.github.circles2d.playground;

import io.github.circles2d.Bodies;
import io.github.circles2d.Joint;
import io.github.circles2d.Joints;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;
import java.nio.FloatBuffer;
import java.util.List;

/**
 * A mouse joint on the circle that was picked; impulses on a body that is pushed. A static circle and a body of terrain are moved along with the
 * mouse.
 */
final class GrabTool implements Tool {
    /** How many radii beside a circle a click may be. */
    private static final float NEAR = 2;

    private static final float HERTZ = 4;

    /** The greatest force, in those that bring the circle to a high speed within a second. */
    private static final float STRENGTH = 150;

    /** Radians of a notch of the wheel, and how far a body turns in a step. */
    private static final float NOTCH = (float) Math.toRadians(15);

    private static final float TURN = 0.04f;

    /** Of a body that is held: how much of the speed that it lacks it gets in a step, and what it keeps of its spin. */
    private static final double GRIP = 0.7;

    private static final double CALM = 0.97;

    private long held;
    private long joint;

    /** A body that is pushed, and the place where it is held, as it lies when it is not turned. */
    private long pushed;

    private float pushedX;
    private float pushedY;
    private TerrainBody body;
    private float bodyAngle;
    private float offsetX;
    private float offsetY;
    private float mouseX;
    private float mouseY;

    @Override
    public void press(Sandbox sandbox, float x, float y, float brush) {
        World world = sandbox.world();
        let(world.joints());
        pushed = sandbox.bodyAt(x, y);
        if (pushed != 0) {
            forgetOthers();
            hold(world.bodies(), x, y);
            drag(sandbox, x, y);
            return;
        }
        long[] found = {world.queries().pick(x, y)};
        float near = NEAR * sandbox.grain().radius();
        long piece = found[0] == 0 ? world.queries().terrain().pick(x, y, near) : 0;
        body = piece == 0 ? null : world.terrain().bodyOf(piece);
        if (body == world.terrain().ground()) {
            body = null; // it does not move
        }
        if (body != null) {
            offsetX = x - body.x();
            offsetY = y - body.y();
            bodyAngle = body.angle();
        } else if (found[0] == 0) {
            world.queries().nearest(x, y, near, 1, found, null);
        }
        held = found[0];
        if (held != 0) {
            offsetX = x - world.x(held);
            offsetY = y - world.y(held);
        }
        drag(sandbox, x, y);
    }

    @Override
    public void drag(Sandbox sandbox, float x, float y) {
        mouseX = x;
        mouseY = y;
    }

    @Override
    public void release(Sandbox sandbox) {
        let(sandbox.world().joints());
        forget();
    }

    private void let(Joints joints) {
        if (joint != 0 && joints.contains(joint)) {
            joints.remove(joint);
        }
        joint = 0;
    }

    private void hold(Bodies bodies, float x, float y) {
        double cos = Math.cos(bodies.angle(pushed));
        double sin = Math.sin(bodies.angle(pushed));
        double dx = (double) x - bodies.x(pushed);
        double dy = (double) y - bodies.y(pushed);
        pushedX = (float) (cos * dx + sin * dy);
        pushedY = (float) (cos * dy - sin * dx);
    }

    @Override
    public void forget() {
        pushed = 0;
        forgetOthers();
    }

    private void forgetOthers() {
        held = 0;
        joint = 0;
        body = null;
    }

    /** A world of the past may be held by a hand of then. */
    @Override
    public void wentBack(Sandbox sandbox) {
        Joints joints = sandbox.world().joints();
        for (int id = 0; id < joints.idLimit(); id++) {
            long found = joints.handle(id);
            if (found != 0 && sandbox.isOfHand(found)) {
                joints.remove(found);
            }
        }
        joint = 0;
    }

    /** Turns the body that is held by notches of the wheel; false if none is. */
    boolean turn(int notches) {
        if (!holdsBody()) {
            return false;
        }
        bodyAngle += notches * NOTCH;
        return true;
    }

    /** The circle that is held; 0 if there is none. */
    long held() {
        return held;
    }

    @Override
    public void beforeStep(Sandbox sandbox) {
        World world = sandbox.world();
        if (holdsBody()) {
            moveBody(sandbox.grain().radius());
        }
        if (holdsPushed(world)) {
            pull(world.bodies(), sandbox.grain().highSpeed());
        }
        if (!holds(world)) {
            return;
        }
        float mass = world.mass(held);
        if (mass == Float.POSITIVE_INFINITY) {
            move(world, (double) mouseX - offsetX - world.x(held), (double) mouseY - offsetY - world.y(held));
            return;
        }
        Joints joints = world.joints();
        if (joint == 0 || !joints.contains(joint)) {
            float strength = STRENGTH * sandbox.grain().highSpeed() * mass;
            joint = joints.add(held, mouseX - offsetX, mouseY - offsetY, Joint.mouse(HERTZ, 1, strength));
        } else {
            joints.setAnchor(joint, mouseX - offsetX, mouseY - offsetY);
        }
    }

    private boolean holdsPushed(World world) {
        return pushed != 0 && world.bodies().contains(pushed);
    }

    private float armX(Bodies bodies) {
        double angle = bodies.angle(pushed);
        return (float) (Math.cos(angle) * pushedX - Math.sin(angle) * pushedY);
    }

    private float armY(Bodies bodies) {
        double angle = bodies.angle(pushed);
        return (float) (Math.sin(angle) * pushedX + Math.cos(angle) * pushedY);
    }

    /** Takes the held place towards the mouse: its speed follows the distance, as far as a part of the mass that moves there allows. */
    private void pull(Bodies bodies, float highSpeed) {
        float armX = armX(bodies);
        float armY = armY(bodies);
        float x = bodies.x(pushed) + armX;
        float y = bodies.y(pushed) + armY;
        double spin = bodies.angularVelocity(pushed);
        double wishedX = HERTZ * ((double) mouseX - x) - (bodies.vx(pushed) - spin * armY);
        double wishedY = HERTZ * ((double) mouseY - y) - (bodies.vy(pushed) + spin * armX);
        double part = Math.min(1, highSpeed / Math.max(Math.hypot(wishedX, wishedY), 1e-30));
        double arm = (double) armX * armX + (double) armY * armY;
        double mass = GRIP / (1.0 / bodies.mass(pushed) + arm / bodies.inertia(pushed));
        bodies.applyImpulse(pushed, (float) (mass * part * wishedX), (float) (mass * part * wishedY), x, y);
        bodies.setAngularVelocity(pushed, (float) (spin * CALM));
    }

    /** Not farther in a step than by a radius. */
    private void moveBody(float most) {
        double dx = (double) mouseX - offsetX - body.x();
        double dy = (double) mouseY - offsetY - body.y();
        double part = Math.min(1, most / Math.max(Math.hypot(dx, dy), 1e-30));
        double turn = Math.IEEEremainder((double) bodyAngle - body.angle(), 2 * Math.PI);
        body.moveTo((float) (body.x() + dx * part), (float) (body.y() + dy * part), (float)
                (body.angle() + Math.min(Math.max(turn, -TURN), TURN)));
    }

    private boolean holdsBody() {
        return body != null && body.exists(); // a world that goes back in time may lose it
    }

    /** Not farther in a step than by a radius, so that it pushes a crowd and does not fly through it. */
    private void move(World world, double dx, double dy) {
        double part = Math.min(1, world.radius(held) / Math.max(Math.hypot(dx, dy), 1e-30));
        float x = (float) (world.x(held) + dx * part);
        float y = (float) (world.y(held) + dy * part);
        world.setPosition(
                held,
                Math.min(Math.max(x, world.minX()), world.maxX()),
                Math.min(Math.max(y, world.minY()), world.maxY()));
    }

    private boolean holds(World world) {
        return held != 0 && world.contains(held);
    }

    @Override
    public void mark(Sandbox sandbox, List<Mark> marks) {
        World world = sandbox.world();
        if (holdsBody()) {
            marks.add(Mark.ring(body.x(), body.y(), sandbox.grain().radius(), 1));
            marks.add(Mark.line(body.x(), body.y(), mouseX, mouseY));
        }
        if (holdsPushed(world)) {
            Bodies bodies = world.bodies();
            float x = bodies.x(pushed) + armX(bodies);
            float y = bodies.y(pushed) + armY(bodies);
            marks.add(Mark.line(x, y, mouseX, mouseY));
        }
        if (holds(world)) {
            FloatBuffer shown = sandbox.loop().positions(null); // between two steps, as the circle is drawn
            int at = 2 * World.id(held);
            boolean between = at < shown.limit() && !Float.isNaN(shown.get(at));
            float x = between ? shown.get(at) : world.x(held);
            float y = between ? shown.get(at + 1) : world.y(held);
            marks.add(Mark.ring(x, y, world.radius(held), 1));
            marks.add(Mark.line(x + offsetX, y + offsetY, mouseX, mouseY));
        }
    }
}
