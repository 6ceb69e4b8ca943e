package com.example.platformer;

import io.github.circles2d.ArcSide;
import io.github.circles2d.Backend;
import io.github.circles2d.Chain;
import io.github.circles2d.Inertia;
import io.github.circles2d.Outline;
import io.github.circles2d.Response;
import io.github.circles2d.Ropes;
import io.github.circles2d.Terrain;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.World;
import java.nio.ByteBuffer;

/** The rules: a hero runs, jumps and pushes crates to a flag; a rope bridge, a lift, a see-saw and floors to jump through are on the way. */
final class Platformer implements Runnable {
    static final float STEP = 1 / 60f, RADIUS = 0.5f, WIDTH = 100, HEIGHT = 25, GROUND = 4, FLAG = 96;
    static final int HERO = 1, FALLING = 2, FLOOR = 3, PLANK = 4; // kinds
    private static final float RUN = 8, JUMP = 13;
    private static final int COYOTE = 6, DROP = 12; // steps: a jump still works, a floor lets through

    final World world;
    final long hero;
    final Outline crate = Outline.box(1.6f, 1.6f);
    boolean left, right, jump, down; // keys
    int deaths;
    private final TerrainBody lift;
    private final long[] partners = new long[8];
    private final float[] contacts = new float[8 * World.CONTACT_STRIDE];
    private ByteBuffer saved;
    private int coyote, drop;
    private float time; // of the lift; it is saved by the tag of the hero

    Platformer(Backend backend) {
        World.Builder builder = World.builder().bounds(0, -10, WIDTH, HEIGHT).gravity(0, -30);
        world = builder.friction(0.6f).backend(backend).build();
        world.kind(HERO).setInertia(Inertia.NONE).setFriction(0).setRestitution(0);
        world.kind(FALLING).copyFrom(world.kind(HERO));
        world.kind(FLOOR).setOneWay(true);
        world.kind(PLANK).setInertia(Inertia.NONE);
        world.setResponse(FALLING, FLOOR, Response.IGNORE);
        hero = world.add(4, GROUND + RADIUS, RADIUS, 1, 0, 0, HERO); // its id is 0
        Terrain terrain = world.terrain();
        // from right to left, so that the hero is above: the cliff, the see-saw, the shaft of the lift, the pit
        terrain.addChain(Chain.of(
                WIDTH, 9, 88, 9, 88, GROUND, 66, GROUND, 66, 10, 61, 10, 61, 2, 55, 2, 55, 7, 52, 7, 52, GROUND, 30,
                GROUND, 30, -8, 18, -8, 18, GROUND, 0, GROUND));
        Ropes.bridge(world, Ropes.at(18, GROUND - 0.3f), Ropes.at(30, GROUND - 0.3f), 20, 0.3f, 0.6f, 0.02f, PLANK);
        for (int k = 0; k < 3; k++) {
            terrain.addSegment(44, 6.4f + 2.4f * k, 36, 6.4f + 2.4f * k, 0.2f, FLOOR); // carries what is above
        }
        lift = terrain.addBody(58, 8.2f, 0);
        lift.addSegment(-2.6f, 0, 2.6f, 0, 0.3f, 0);
        lift.addSegment(-2.6f, 0, -2.6f, -3, 0.3f, 0); // so that nobody gets below it
        terrain.addArc(77, GROUND, 1.2f, 0, (float) Math.PI, ArcSide.OUTER);
        Outline plank = Outline.box(14, 0.5f);
        world.bodies().add(plank, 77, GROUND + 1.5f, 0, 0.5f * plank.area());
        world.bodies().add(crate, 71.5f, GROUND + 2.6f, 0, 0.5f * crate.area()); // keeps the other end up
        world.bodies().add(crate, 47, GROUND + 0.8f, 0, 0.5f * crate.area()); // a step to the high ground
        for (int k = 0; k < 6; k++) { // a pile
            world.bodies().add(crate, 39 + 1.7f * (k % 3), 12.1f + 1.61f * (k / 3), 0, 0.5f * crate.area());
        }
        world.bodies().report(true);
        save();
    }

    /** Before each step of the world. */
    @Override
    public void run() {
        time += STEP;
        world.setTag(hero, Float.floatToIntBits(time));
        lift.moveTo(58, 8.2f + 1.5f * (float) StrictMath.sin(time), 0); // a sine never stops at once
        coyote = stands() ? COYOTE : coyote - 1;
        drop = down && coyote > 0 ? DROP : drop - 1;
        world.setKind(hero, drop > 0 ? FALLING : HERO);
        boolean jumps = jump && coyote > 0;
        coyote = jumps ? 0 : coyote;
        float vx = right == left ? 0 : right ? RUN : -RUN;
        world.setVelocity(hero, vx, jumps ? JUMP : world.vy(hero));
        if (world.y(hero) < -6) {
            deaths++;
            load();
        }
    }

    /** Whether the hero has something below: terrain, the bridge, a body. */
    private boolean stands() {
        int count = Math.min(partners.length, world.contactsOf(hero, partners, contacts));
        for (int k = 0; k < count; k++) {
            if (contacts[World.CONTACT_STRIDE * k + World.NORMAL_Y] > 0.6f) {
                return true;
            }
        }
        return false;
    }

    /** Keeps the game as it is; it returns when the hero dies. */
    void save() {
        saved = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(saved);
        saved.flip();
    }

    void load() {
        world.restore(saved.rewind());
        time = Float.intBitsToFloat((int) world.tag(hero));
        coyote = 0;
    }

    /** A player without hands runs to the right, and jumps if it is stopped or the see-saw ends. */
    void playAlone(int frame) {
        right = world.x(hero) < FLAG;
        boolean ends = Math.abs(world.x(hero) - 83) < 0.7f; // the see-saw does
        jump = right && (ends || frame % 7 == 0 && world.vx(hero) < RUN / 2);
    }
}
