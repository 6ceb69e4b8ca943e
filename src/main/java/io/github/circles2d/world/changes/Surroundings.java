package io.github.circles2d.world.changes;

import static io.github.circles2d.world.shared.Call.real;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.joints.JointTable;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.SurfaceSettings;
import io.github.circles2d.world.model.WallMotion;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;

/** The calls on gravity, the bounds and the surfaces of walls. */
public final class Surroundings implements Calls.Effects {
    private final WorldParts world;
    private final NextStep nextStep;

    public Surroundings(WorldParts world, NextStep nextStep) {
        this.world = world;
        this.nextStep = nextStep;
        world.calls.define(this, Call.GRAVITY, Call.BOUNDS, Call.WALL_SURFACE);
    }

    @Override
    public long make(Call call, int[] w) {
        if (call == Call.GRAVITY) {
            world.calls.begin(call, w);
            world.settings.setGravity(real(w[0]), real(w[1]));
        } else if (call == Call.WALL_SURFACE) {
            SurfaceSettings surfaces = world.settings.surfaces().withWall(w[0], real(w[1]), real(w[2]), real(w[3]));
            world.calls.begin(call, w);
            if (world.settings.sleeps() && surfaces.differs(world.settings.surfaces())) {
                world.commands.wakeAtWall(w[0]);
            }
            world.settings.setSurfaces(surfaces);
        } else {
            Bounds next = Limits.bounds(real(w[0]), real(w[1]), real(w[2]), real(w[3]));
            moveWalls(
                    w,
                    next.with(
                            world.settings.bounds().edgeX(),
                            world.settings.bounds().edgeY()));
        }
        return 0;
    }

    private void moveWalls(int[] w, Bounds next) {
        Limits.moved(world.settings.bounds(), next);
        boolean hasCircles = world.handles.size() > 0;
        if (hasCircles) {
            Limits.room("the greatest radius of a circle", world.handles.greatestRadius(), next);
            Limits.room("the least radius of a circle", world.handles.leastRadius(), next);
            nextStep.requireRoom(next);
        }
        world.rigids.requireRoom(next);
        boolean pushesStatics = world.settings.sleeps()
                && world.handles.hasStatics()
                && WallMotion.movesIn(world.settings.bounds(), next);
        if (pushesStatics) {
            world.pending.settleJoints();
            world.pending.expect(world.joints.table.ids.size());
        }
        world.pending.apply();
        world.copies.forget();
        float greatest = hasCircles ? world.handles.greatestRadius() : 0f;
        Bounds start = WallMotion.start(world.settings.wallStart(), next, greatest);
        Bounds startWalls = start.walls();
        Bounds nextWalls = next.walls();
        float far = pushesStatics ? Sleep.NEIGHBOURS * greatestStaticRadius() : 0f;
        Bounds calm = pushesStatics ? WallMotion.calm(world.settings.bounds(), next, far) : Bounds.EVERYWHERE;
        world.calls.begin(Call.BOUNDS, w); // what follows takes no memory
        if (world.settings.sleeps()
                && (WallMotion.jumps(world.settings.wallStart(), start) || world.rigids.moveIn(next, nextWalls))) {
            world.commands.wakeAll();
        }
        if (pushesStatics) {
            wakeHeldByStatics();
            world.rigids.step.wakeOutside(calm);
        }
        world.pipeline.confine(startWalls, nextWalls, calm);
        nextStep.confine(nextWalls);
        world.rigids.confine(next, nextWalls);
        world.settings.setBounds(start, next);
    }

    /** A wall may take along static circles: those that joints hold to them wake. There is room. */
    private void wakeHeldByStatics() {
        JointTable table = world.joints.table;
        for (int joint = 0; joint < table.ids.end(); joint++) {
            if (table.ids.lives(joint) && table.a(joint) != JointRow.NONE && table.b(joint) != JointRow.NONE) {
                boolean ofStaticA = world.handles.isStatic(table.a(joint));
                if (ofStaticA != world.handles.isStatic(table.b(joint))) {
                    world.commands.set(Commands.WAKE, ofStaticA ? table.b(joint) : table.a(joint), 0, 0);
                }
            }
        }
    }

    private float greatestStaticRadius() {
        float greatest = 0f;
        for (int id = 0; id < world.handles.end(); id++) {
            if (world.handles.lives(id) && world.handles.isStatic(id)) {
                greatest = Math.max(greatest, world.handles.radius(id));
            }
        }
        return greatest;
    }
}
