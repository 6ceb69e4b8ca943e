package io.github.circles2d.world;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import io.github.circles2d.world.circles.SavedState;

/**
 * Removes all circles. The pipeline loads a state without circles, which takes no command for each. If events are reported, a command
 * for each removes them as any other call does, so that their ends are reported.
 */
public final class Clearing {
    private final Simulation simulation;
    private final Guard guard;
    private final HandleTable handles;
    private final Commands commands;

    /** A state without circles. */
    private final SavedState empty = new SavedState();

    Clearing(Simulation simulation) {
        this.simulation = simulation;
        guard = simulation.guard;
        handles = simulation.handles;
        commands = simulation.commands;
    }

    /** Removes all circles. */
    public void clear() {
        guard.enter();
        try {
            if (simulation.events.isOn()) {
                simulation.expect(handles.size());
            } else {
                simulation.finishSteps();
                empty.ids = handles.end();
                simulation.pipeline.makeRoom(empty);
            }
            simulation.changed();
            simulation.journal.call(LoggedCall.CLEAR, 0, 0);
            guard.changing = true;
            if (simulation.events.isOn()) {
                removeEach();
            } else {
                removeAtOnce();
            }
            simulation.forgetFigures();
            guard.changing = false;
        } catch (RuntimeException | Error e) {
            throw guard.failed(e);
        } finally {
            guard.user = null;
        }
    }

    /** Records the removals, which wait as those of any call; the log has the call in their place. */
    private void removeEach() {
        for (int id = 0; id < handles.end(); id++) {
            if (handles.lives(id)) {
                commands.set(Commands.REMOVE, id, 0, 0);
            }
        }
        simulation.journal.skipCommands();
        handles.removeAll();
    }

    /** Changes that wait are of circles that go, or that the pipeline never learns of. */
    private void removeAtOnce() {
        commands.clear();
        simulation.journal.logged = 0;
        handles.removeAll();
        simulation.pipeline.load(empty);
    }
}
