package io.github.circles2d.world;

import java.nio.FloatBuffer;
import java.util.Map;

/**
 * A pipeline that remembers its first failure: where a call throws, steps or changes may have been made in part, and its state
 * is lost.
 */
public final class GuardedPipeline implements Pipeline {
    private final Pipeline pipeline;
    private Throwable failure;

    /**
     * Guards a pipeline.
     *
     * @param pipeline the engine
     */
    public GuardedPipeline(Pipeline pipeline) {
        this.pipeline = pipeline;
    }

    /**
     * What a call has thrown.
     *
     * @return null where none has thrown
     */
    public Throwable failure() {
        return failure;
    }

    private RuntimeException failed(Throwable cause) {
        if (failure == null) {
            failure = cause;
        }
        if (cause instanceof Error error) {
            throw error;
        }
        return (RuntimeException) cause;
    }

    @Override
    public void apply(Commands commands) {
        try {
            pipeline.apply(commands);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public void step(StepConstants constants, Levels levels, int steps) {
        try {
            pipeline.step(constants, levels, steps);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public void finish() {
        try {
            pipeline.finish();
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public void confine(Bounds bounds) {
        try {
            pipeline.confine(bounds);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public long hash() {
        try {
            return pipeline.hash();
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public void readCircles(Roster roster, float[] to) {
        try {
            pipeline.readCircles(roster, to);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public FloatBuffer positions(Roster roster) {
        try {
            return pipeline.positions(roster);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public void requestPositions(Roster roster) {
        try {
            pipeline.requestPositions(roster);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public FloatBuffer takePositions() {
        try {
            return pipeline.takePositions();
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public void readVelocities(Roster roster, float[] to) {
        try {
            pipeline.readVelocities(roster, to);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public void save(SavedState into) {
        try {
            pipeline.save(into);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public void load(SavedState from) {
        try {
            pipeline.load(from);
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public long candidatePairs() {
        try {
            return pipeline.candidatePairs();
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public int contacts() {
        try {
            return pipeline.contacts();
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public int greatestContacts() {
        try {
            return pipeline.greatestContacts();
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public long bytesHeld() {
        try {
            return pipeline.bytesHeld();
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public Map<String, Double> stageMillis() {
        try {
            return pipeline.stageMillis();
        } catch (RuntimeException | Error e) {
            throw failed(e);
        }
    }

    @Override
    public String device() {
        return pipeline.device();
    }

    @Override
    public void close() {
        pipeline.close();
    }
}
