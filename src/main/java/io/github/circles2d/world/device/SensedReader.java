package io.github.circles2d.world.device;

import static io.github.circles2d.world.device.memory.SensingArrays.AT_A;
import static io.github.circles2d.world.device.memory.SensingArrays.AT_B;
import static io.github.circles2d.world.device.memory.SensingArrays.AT_ID;
import static io.github.circles2d.world.device.memory.SensingArrays.AT_OTHER;
import static io.github.circles2d.world.device.memory.SensingArrays.PATH_X;
import static io.github.circles2d.world.device.memory.SensingArrays.PATH_Y;
import static io.github.circles2d.world.device.memory.SensingArrays.RADIUS;
import static io.github.circles2d.world.device.memory.SensingArrays.RECORD;
import static io.github.circles2d.world.device.memory.SensingArrays.X;
import static io.github.circles2d.world.device.memory.SensingArrays.Y;

import io.github.circles2d.world.device.memory.SensingArrays;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.SensedPair;
import io.github.circles2d.world.events.TouchRecords;

/** Reads what a device has found of the pairs that are only sensed. */
final class SensedReader {
    private final SensingArrays arrays;
    private final ContactEvents events;
    private int[] words = new int[0];

    SensedReader(SensingArrays arrays, ContactEvents events) {
        this.arrays = arrays;
        this.events = events;
    }

    /** Records the pairs of a step that touch; there are so many records, in no order. */
    void read(int count, float dt, TouchRecords records) {
        if (words.length < RECORD * count) {
            words = new int[RECORD * (count + (count >> 1))];
        }
        arrays.read(words, count);
        for (int at = 0; at < RECORD * count; at += RECORD) {
            int a = at + AT_A;
            int b = at + AT_B;
            SensedPair.tell(
                    events,
                    records,
                    words[at + AT_ID],
                    words[at + AT_OTHER],
                    real(a + X),
                    real(a + Y),
                    real(a + PATH_X),
                    real(a + PATH_Y),
                    real(a + RADIUS),
                    real(b + X),
                    real(b + Y),
                    real(b + PATH_X),
                    real(b + PATH_Y),
                    real(b + RADIUS),
                    dt);
        }
    }

    private float real(int at) {
        return Float.intBitsToFloat(words[at]);
    }
}
