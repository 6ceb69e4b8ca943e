package io.github.circles2d.world.reads;

import io.github.circles2d.world.bodies.KeptContacts;
import io.github.circles2d.world.bodies.RigidStep;
import io.github.circles2d.world.circles.IdMask;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.Limits;
import io.github.circles2d.world.shared.WorldParts;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.terrain.SavedPieceContacts;
import java.util.Arrays;

/** Reads how hard circles are pressed, from the impulses that the next step starts from. */
public final class Loads {
    /** Elements of a circle: the number of what presses it, and the sum of the forces. */
    private static final int EACH = 2;

    private final WorldParts world;
    private final IdMask mask = new IdMask();

    public Loads(WorldParts world) {
        this.world = world;
    }

    /** Two elements an id; living, with a bit an id, may be null. */
    public void readById(float[] loads, long[] living) {
        world.guard.enter();
        try (world.guard) {
            Readings.requireRoom("loads", Limits.notNull("loads", loads).length, (long) EACH * world.handles.end());
            Readings.requireRoom(living, world.handles.end());
            SavedState state = world.copies.saved();
            mask.copy(world.handles);
            Arrays.fill(loads, Float.NaN);
            float subStep = world.settings.lastSubStep();
            addWalls(state, subStep, loads);
            addPieces(state, subStep, loads);
            addBodies(state.rigids.contacts, subStep, loads);
            for (int k = 0; k < state.impulses; k++) {
                float force = state.normalImpulse[k] / subStep;
                add(loads, state.lo[k], force);
                add(loads, state.hi[k], force);
            }
            if (living != null) {
                mask.copyTo(living);
            }
        }
    }

    /** What a wall has given is a speed, positive if it was the lower one. */
    private static void addWalls(SavedState state, float subStep, float[] loads) {
        for (int k = 0; k < state.circles; k++) {
            int id = state.id[k];
            loads[EACH * id] = 0;
            loads[EACH * id + 1] = 0;
            float mass = state.circle[CircleRow.STRIDE * k + CircleRow.MASS];
            for (int axis = CircleRow.WALL_X; axis <= CircleRow.WALL_Y; axis++) {
                float speed = Math.abs(state.traits[CircleRow.STRIDE * k + axis]);
                if (speed > 0) {
                    add(loads, id, mass * speed / subStep);
                }
            }
        }
    }

    /** What a piece of terrain has given is a speed, too. Contacts and circles are in the order of ids. */
    private static void addPieces(SavedState state, float subStep, float[] loads) {
        SavedPieceContacts contacts = state.pieceContacts;
        int k = 0;
        for (int c = 0; c < contacts.count; c++) {
            while (state.id[k] != contacts.circle[c]) {
                k++;
            }
            if (contacts.impulse[c] > 0) {
                float mass = state.circle[CircleRow.STRIDE * k + CircleRow.MASS];
                add(loads, contacts.circle[c], mass * contacts.impulse[c] / subStep);
            }
        }
    }

    private static void addBodies(KeptContacts of, float subStep, float[] loads) {
        for (int c = 0; c < of.count; c++) {
            if (of.type(c) == RigidStep.BODY_CIRCLE && of.impulse(c) > 0f) {
                add(loads, of.b(c), of.impulse(c) / subStep);
            }
        }
    }

    private static void add(float[] loads, int id, float force) {
        loads[EACH * id]++;
        loads[EACH * id + 1] += force;
    }
}
