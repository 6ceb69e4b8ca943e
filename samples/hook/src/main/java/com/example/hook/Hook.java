package com.example.hook;

import io.github.circles2d.ArcSide;
import io.github.circles2d.Backend;
import io.github.circles2d.Chain;
import io.github.circles2d.Events;
import io.github.circles2d.Joint;
import io.github.circles2d.Joints;
import io.github.circles2d.Queries;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;

/** The rules: a ball on a hook takes the lights in the air, and a car those on the ground. */
final class Hook implements Runnable {
    static final int WIDTH = 160, HEIGHT = 90;
    static final int BALL = 1, CAR = 2, LIGHT = 3; // kinds
    static final float STEP = 1 / 60f, RADIUS = 1.2f;
    private static final float REACH = 70, REEL = 24, SHORTEST = 4; // of the rope; REEL is a speed
    private static final float[] ROCKS = {24, 62, 4, 52, 74, 5, 84, 60, 4, 112, 76, 5, 140, 60, 4};
    private static final float[] LIGHTS = {
        38, 58, 68, 66, 98, 70, 126, 62, 150, 74, 12, 74, 84, 44, 20, 17, 50, 17, 80, 17, 110, 17, 145, 17
    };

    final World world;
    final long ball;
    float aimX, aimY, drive; // where the hook is thrown to; -1 to 1
    boolean isHooked; // whether the player holds the rope
    int score;
    private final Joints joints;
    private final TerrainBody lift;
    private final long rearMotor, frontMotor;
    private final float[] hit = new float[Queries.HIT_STRIDE];
    private long rope; // 0 if there is none
    private float length;

    Hook(Backend backend) {
        World.Builder builder = World.builder().bounds(0, 0, WIDTH, HEIGHT).gravity(0, -25);
        world = builder.friction(0.9f).restitution(0.2f).backend(backend).build();
        joints = world.joints();
        world.kind(LIGHT).setSensor(true);
        world.report(BALL, LIGHT, Events.BEGIN);
        world.report(CAR, LIGHT, Events.BEGIN);
        Chain hills = Chain.from(WIDTH, hill(WIDTH)); // from right to left, so that circles are above
        for (int x = WIDTH - 2; x >= 0; x -= 2) {
            hills.lineTo(x, hill(x));
        }
        world.terrain().addChain(hills);
        for (int k = 0; k < ROCKS.length; k += 3) {
            world.terrain().addArc(ROCKS[k], ROCKS[k + 1], ROCKS[k + 2], 0, 2 * (float) Math.PI, ArcSide.OUTER);
        }
        lift = world.terrain().addBody(68, 40, 0);
        lift.addSegment(-5, 0, 5, 0, 0.6f, 0);
        lift.setVelocity(8, 0);
        for (int k = 0; k < LIGHTS.length; k += 2) {
            world.add(LIGHTS[k], LIGHTS[k + 1], 1.2f, Float.POSITIVE_INFINITY, 0, 0, LIGHT);
        }
        ball = world.add(30, 40, RADIUS, 1.5f, 0, 0, BALL);
        // The car: two wheels, and two circles on springs above them that are welded together.
        long rear = world.add(58, 14, 1.6f, 2, 0, 0, CAR), front = world.add(65, 14, 1.6f, 2, 0, 0, CAR);
        long cab = world.add(60, 16.6f, 1.7f, 1, 0, 0, CAR), bonnet = world.add(63, 16.2f, 1.3f, 0.7f, 0, 0, CAR);
        joints.add(rear, front, Joint.distance());
        joints.add(cab, bonnet, Joint.weld());
        for (long above : new long[] {cab, bonnet}) {
            joints.add(rear, above, Joint.spring(8, 0.5f));
            joints.add(front, above, Joint.spring(8, 0.5f));
        }
        rearMotor = joints.add(rear, Joint.motor(0, 80));
        frontMotor = joints.add(front, Joint.motor(0, 80));
    }

    private static float hill(float x) {
        return 8 + 3 * (float) StrictMath.sin(x * 0.11) + 2 * (float) StrictMath.sin(x * 0.23 + 1);
    }

    /** Makes the changes before each step of the world. */
    @Override
    public void run() {
        Events events = world.events();
        for (int i = 0; i < events.size(); i++) {
            long a = events.a(i), b = events.b(i);
            if (world.contains(a) && world.contains(b)) { // no event before this one has taken the light
                world.remove(world.kindOf(a) == LIGHT ? a : b);
                score++;
            }
        }
        lift.setVelocity(lift.x() < 56 ? 8 : lift.x() > 76 ? -8 : lift.vx(), 0);
        joints.setSpeed(rearMotor, -14 * drive); // clockwise is to the right
        joints.setSpeed(frontMotor, -14 * drive);
        if (isHooked && rope == 0) {
            throwHook(aimX - world.x(ball), aimY - world.y(ball));
        } else if (isHooked) {
            length = Math.max(length - REEL * STEP, SHORTEST);
            joints.setLimits(rope, 0, length);
        } else if (rope != 0) {
            joints.remove(rope);
            rope = 0;
        }
    }

    /** A ray to where the player aims finds the place where the hook holds: of the ground, or of the lift, which takes it along. */
    private void throwHook(float dx, float dy) {
        float share = REACH / Math.max((float) Math.sqrt(dx * dx + dy * dy), 0.01f);
        long piece = world.queries().terrain().rayCast(world.x(ball), world.y(ball), share * dx, share * dy, hit);
        if (piece == 0) {
            return;
        }
        length = hit[Queries.DISTANCE];
        TerrainBody body = world.terrain().bodyOf(piece); // none of them turns
        rope = joints.add(ball, body, hit[Queries.X] - body.x(), hit[Queries.Y] - body.y(), Joint.rope(length));
    }

    /** A player without hands throws the hook to one rock after the other, and drives there and back. */
    void playAlone(int frame) {
        int rock = frame / 80 % (ROCKS.length / 3) * 3;
        isHooked = frame % 80 < 55;
        aimX = ROCKS[rock];
        aimY = ROCKS[rock + 1];
        drive = frame / 240 % 2 == 0 ? 1 : -1;
    }
}
