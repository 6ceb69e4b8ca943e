package io.github.circles2d.world.changes;

import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Calls;
import io.github.circles2d.world.shared.WorldParts;

/**
 * Removes all circles, and with them all joints. The pipeline loads a state without circles, which takes no command for each. If events are reported, a command for
 * each removes them as any other call does, so that their ends are reported.
 */
public final class Clearing implements Calls.Effects {
    private final WorldParts world;

    public Clearing(WorldParts world) {
        this.world = world;
        world.calls.define(this, Call.CLEAR);
    }

    /** Removes all circles. */
    public void clear() {
        world.calls.make(Call.CLEAR, 0, 0, 0, 0);
    }

    @Override
    public long make(Call call, int[] words) {
        world.pending.settleJoints();
        world.joints.departures().ensure(world.joints.table.ids.size());
        if (world.events.isOn()) {
            world.pending.expect(world.handles.size());
        } else {
            world.pending.finish();
            world.state.makeRoomToRemoveCircles();
        }
        world.copies.forget();
        world.calls.begin(call, words);
        world.joints.departures().removeOfCircles();
        if (world.events.isOn()) {
            world.pending.recordRemovals();
            world.handles.removeAll();
        } else {
            world.pending.drop(); // changes that wait are of circles that go, or that the pipeline never learns of
            world.state.removeCircles();
        }
        world.state.figures().forget();
        return 0;
    }
}
