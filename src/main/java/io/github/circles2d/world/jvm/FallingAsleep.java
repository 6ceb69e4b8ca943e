package io.github.circles2d.world.jvm;

import static io.github.circles2d.world.model.CircleRow.DX;
import static io.github.circles2d.world.model.CircleRow.DY;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.jvm.state.Sleepers;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.KindSleep;
import io.github.circles2d.world.model.Sleep;
import io.github.circles2d.world.model.StepConstants;

/** The end of a step in which circles fall asleep. {@link Sleep} has the rule. */
final class FallingAsleep {
    private FallingAsleep() {}

    /** Looks at some slots of circles that are awake; returns whether one of them sleeps now. driven: by id, or null. */
    static boolean find(State state, float[] kinds, boolean[] driven, int from, int to, StepConstants k) {
        boolean some = false;
        for (int slot = from; slot < to; slot++) {
            if (!state.sleepers.movesOn[slot] && !state.isStatic(slot)) {
                some |= look(state, kinds, driven, slot, k);
            }
        }
        return some;
    }

    private static boolean look(State state, float[] kinds, boolean[] driven, int slot, StepConstants k) {
        Sleepers all = state.sleepers;
        int s = CircleRow.of(slot);
        int id = state.id[slot];
        all.writeStart(slot, id);
        float r = state.circle[s + RADIUS];
        int row = Sleepers.RESTS * id;
        float driftX = Float.intBitsToFloat(all.rests[row + Sleepers.DRIFT_X]) + all.moved[CircleRow.vector(slot)];
        float driftY = Float.intBitsToFloat(all.rests[row + Sleepers.DRIFT_Y]) + all.moved[CircleRow.vector(slot) + 1];
        if (!Sleep.rests(driftX, driftY, 0, r, Sleep.DRIFT * r)) {
            all.begins[id] = true;
            return false;
        }
        int turned = all.rests[row + Sleepers.TURNED] + (k.turning ? all.turnedInStep[slot] : 0);
        float gainX = state.gainX(slot, k);
        float gainY = state.gainY(slot, k);
        float gain = CircleMath.length(gainX, gainY);
        int kind = KindSleep.of(state.fields.getInt(CircleField.KIND, id));
        float damping = CircleMath.orOfKind(state.own(CircleField.DAMPING, slot), kinds[kind + KindSleep.DAMPING]);
        float most = Sleep.drift(r, gain, k.inverseH, damping);
        boolean mayRest = (gain > 0f || damping > 0f)
                && kinds[kind + KindSleep.AWAKE] == 0f
                && (driven == null || !driven[id])
                && state.fields.getFloat(CircleField.TORQUE, id) == 0f
                && !(k.turning && Math.abs(state.turning.angularVelocity[slot]) * k.dt >= Sleep.TURN_OF_STEP);
        if (!mayRest || !Sleep.rests(driftX, driftY, turned, r, most)) {
            all.begins[id] = true;
            return false;
        }
        int rest = all.rest(id) + 1;
        all.set(id, rest, turned, driftX - state.motion[s + DX], driftY - state.motion[s + DY]);
        if (Sleep.fallsAsleep(rest, k.dt)
                && Sleep.stays(state.circle[s + X], state.motion[s + DX])
                && Sleep.stays(state.circle[s + Y], state.motion[s + DY])) {
            state.sleep(slot, gainX * k.inverseH, gainY * k.inverseH);
            return true;
        }
        return false;
    }
}
