package io.github.circles2d.world.events;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.HandleTable;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** That events stay what they are after more steps than an int counts. */
class ContactEventsTest {
    private final HandleTable handles = new HandleTable();
    private final TouchRecords records = new TouchRecords();

    private ContactEvents ofTwoCircles(int stamp) {
        ContactEvents events = new ContactEvents(stamp);
        handles.ensure(2);
        handles.add(1);
        handles.add(1);
        events.makeRoom(handles);
        events.report(ContactEvents.ALL, handles);
        return events;
    }

    /** A step in which the two circles touch, or not. */
    private void step(ContactEvents events, boolean touch) {
        records.clear();
        events.queue().asked(1);
        int pair = events.find(0, 1);
        if (touch && events.tracker.concerns(pair, 0, 1, true, 0, 0, 1)) {
            records.add(pair, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
        }
        events.endStep(records);
    }

    private static String types(EventRows rows) {
        StringBuilder types = new StringBuilder();
        for (int k = 0; k < rows.size(); k++) {
            types.append(rows.type(k)).append('@').append(rows.step(k)).append(' ');
        }
        return types.toString();
    }

    @Test
    void aPairThatStaysInTouchWhileStampsBeginAgainBeginsOnceAndEndsOnce() {
        for (int stamp : new int[] {1, Integer.MAX_VALUE - 2, Integer.MAX_VALUE}) {
            ContactEvents events = ofTwoCircles(stamp);
            for (int k = 0; k < 7; k++) {
                step(events, k >= 1 && k < 5);
            }
            assertThat(types(events.queue().take())).isEqualTo("1@1 4@5 ");
        }
    }

    @Test
    void aRequestBeyondTheStepsOfAnIntWaitsForItsLastStep() {
        ContactEvents events = ofTwoCircles(1);
        events.queue().asked(Integer.MAX_VALUE);
        events.emptySteps(Integer.MAX_VALUE);
        events.queue().asked(2);
        events.queue().request();
        assertThat(events.queue().haveArrived()).isFalse();
        events.emptySteps(1);
        assertThat(events.queue().haveArrived()).isFalse();
        events.emptySteps(1);
        assertThat(events.queue().haveArrived()).isTrue();
        step(events, true);
        assertThat(types(events.queue().takeRequested())).isEmpty();
        assertThat(types(events.queue().take())).isEqualTo("1@0 ");
    }

    @Test
    void theNumberOfAStepStopsAtTheGreatestInt() {
        ContactEvents events = ofTwoCircles(1);
        events.emptySteps(Integer.MAX_VALUE);
        events.emptySteps(10);
        step(events, true);
        assertThat(types(events.queue().take())).isEqualTo("1@" + Integer.MAX_VALUE + " ");
    }

    /** A device that has made steps with circles whose ids are below a limit. */
    private static final class Known implements ContactEvents.Remote {
        final List<Integer> asked = new ArrayList<>();

        @Override
        public boolean mayKnow(int id) {
            return id < 2;
        }

        @Override
        public void fetchAll() {}

        @Override
        public void fetchOf(int[] ids, int count) {
            for (int k = 0; k < count; k++) {
                asked.add(ids[k]);
            }
        }

        @Override
        public void forgetOf(int[] ids, int count) {
            fetchOf(ids, count);
        }
    }

    @Test
    void aDeviceIsAskedForThePairsOfCirclesThatItMayKnow() {
        ContactEvents events = ofTwoCircles(1);
        Known device = new Known();
        events.setRemote(device);
        events.sent();
        events.leave();
        Commands commands = new Commands();
        for (int id : new int[] {1, 2, 900}) {
            commands.set(Commands.REMOVE, id, 0, 0);
        }
        events.makeRoom(commands);
        assertThat(device.asked).containsExactly(1);
        events.apply(commands, handles);
        assertThat(device.asked).containsExactly(1, 1);
    }
}
