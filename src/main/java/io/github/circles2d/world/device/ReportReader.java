package io.github.circles2d.world.device;

import io.github.circles2d.opencl.Session;
import io.github.circles2d.world.device.memory.DeviceArrays;
import io.github.circles2d.world.device.memory.SensingArrays;
import io.github.circles2d.world.device.memory.Status;
import io.github.circles2d.world.device.memory.StatusWord;
import io.github.circles2d.world.device.memory.TouchArrays;
import io.github.circles2d.world.device.plan.Stages;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.TouchRecords;
import io.github.circles2d.world.model.StepConstants;

/** What a world on a device reports: the memory for it, what it takes around a step, and the hand-over behind each. */
final class ReportReader implements AutoCloseable {
    private final ContactEvents events;
    private final TouchArrays touches;
    private final SensingArrays sensing;
    private final TouchReader touchReader;
    private final SensedReader sensedReader;
    private final TouchRecords records = new TouchRecords();

    /** What of the steps that have been enqueued is reported, and their length. */
    private boolean recording;

    private boolean sensed;
    private int seekingVersion;
    private float timeStep;

    /** Whether the last step that was made recorded what contacts do. */
    private boolean hasRecorded;

    ReportReader(Session session, ContactEvents events) {
        this.events = events;
        touches = new TouchArrays(session, events.hasWalls());
        sensing = new SensingArrays(session);
        touchReader = new TouchReader(touches, events);
        sensedReader = new SensedReader(sensing, events);
    }

    TouchArrays touches() {
        return touches;
    }

    /** Takes down what of the steps to come is reported, and takes the memory for it; none are pending. */
    void prepare(StepConstants k, DeviceArrays arrays) {
        recording = k.recording;
        sensed = k.sensing;
        seekingVersion = k.seekingVersion;
        timeStep = k.dt;
        if (recording) {
            touches.ensure(arrays);
        }
        if (sensed) {
            sensing.ensure(arrays);
            sensing.send(k);
        }
    }

    /** Whether steps report what was taken down. */
    boolean areOf(StepConstants k) {
        return recording == k.recording && sensed == k.sensing && seekingVersion == k.seekingVersion;
    }

    /** Whether steps record what contacts and walls do. */
    boolean isRecording() {
        return recording;
    }

    /** Comes before a step is enqueued. */
    void before(Stages stages, DeviceArrays arrays, int slots, int stepsMade) {
        if (recording) {
            touches.prepare(arrays, stepsMade, events.wantsAll() || !hasRecorded, events.hitSpeed());
        }
        if (sensed) {
            sensing.ensure(arrays);
            stages.sensing().begin(sensing, slots);
        }
    }

    /** Comes behind it. */
    void behind(Stages stages, int circles) {
        if (sensed) {
            stages.sensing().find(sensing, circles);
        }
    }

    /** Hands over the records of a step that has been made. */
    void endStep(Status status, DeviceArrays arrays, Stages stages, int circles) {
        records.clear();
        int touching = status.get(StatusWord.TOUCHES);
        boolean all = !recording || status.has(StatusWord.TOUCHES_ALL);
        if (recording) {
            touchReader.read(touching, records);
        }
        if (sensed) {
            if (status.get(StatusWord.SENSED) > sensing.room()) {
                sensing.ensureRecords(status.get(StatusWord.SENSED));
                status.clear(StatusWord.SENSED);
                status.write(arrays);
                stages.sensing().find(sensing, circles);
                status.read(arrays);
            }
            sensedReader.read(status.get(StatusWord.SENSED), timeStep, records);
        }
        events.endStep(all, records);
        if (recording) {
            touchReader.hold(touching);
            touches.stepMade();
        }
        hasRecorded = recording;
    }

    @Override
    public void close() {
        touches.close();
        sensing.close();
    }
}
