package io.github.circles2d.world.device;

import static io.github.circles2d.world.device.memory.TouchArrays.AT_APPROACH;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_ID;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_IMPULSE;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_NORMAL_X;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_NORMAL_Y;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_OTHER;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_POINT_X;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_POINT_Y;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_SAYS;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_THRESHOLD;
import static io.github.circles2d.world.device.memory.TouchArrays.AT_VN;
import static io.github.circles2d.world.device.memory.TouchArrays.HOLDS;
import static io.github.circles2d.world.device.memory.TouchArrays.PARTED;
import static io.github.circles2d.world.device.memory.TouchArrays.RECORD;
import static io.github.circles2d.world.device.memory.TouchArrays.TOUCHING;

import io.github.circles2d.world.device.memory.TouchArrays;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.events.TouchRecords;

/** Reads what a device has recorded of the pairs that touch after a step. */
final class TouchReader {
    private final TouchArrays arrays;
    private final ContactEvents events;
    private int[] words = new int[0];

    TouchReader(TouchArrays arrays, ContactEvents events) {
        this.arrays = arrays;
        this.events = events;
    }

    /** Records the pairs of a step; there are so many records, in no order. */
    void read(int count, TouchRecords records) {
        if (count > arrays.room()) {
            throw new IllegalStateException(count + " records of touches do not fit into " + arrays.room());
        }
        if (words.length < RECORD * count) {
            words = new int[RECORD * (count + (count >> 1))];
        }
        arrays.read(words, count);
        for (int at = 0; at < RECORD * count; at += RECORD) {
            int id = words[at + AT_ID];
            int other = words[at + AT_OTHER];
            int says = words[at + AT_SAYS];
            if ((says & PARTED) != 0) {
                events.part(id, other);
                continue;
            }
            float approach = real(at + AT_APPROACH);
            float impulse = real(at + AT_IMPULSE);
            float threshold = real(at + AT_THRESHOLD);
            if (events.concerns(id, other, (says & TOUCHING) != 0, approach, impulse, threshold)) {
                records.add(
                        id,
                        other,
                        approach,
                        impulse,
                        real(at + AT_NORMAL_X),
                        real(at + AT_NORMAL_Y),
                        real(at + AT_POINT_X),
                        real(at + AT_POINT_Y),
                        real(at + AT_VN),
                        threshold);
            }
        }
    }

    /** Behind the end of that step: takes note of the pairs that will be told of when they part. */
    void hold(int count) {
        for (int at = 0; at < RECORD * count; at += RECORD) {
            if ((words[at + AT_SAYS] & HOLDS) != 0) {
                events.hold(words[at + AT_ID], words[at + AT_OTHER]);
            }
        }
    }

    private float real(int at) {
        return Float.intBitsToFloat(words[at]);
    }
}
