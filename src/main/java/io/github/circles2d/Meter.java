package io.github.circles2d;

import io.github.circles2d.calibration.Crowd;
import io.github.circles2d.calibration.FrameTimes;
import io.github.circles2d.opencl.Device;
import java.util.Optional;

/** Takes the times that a {@link Calibration} is made of. */
interface Meter {
    /**
     * Times a frame of World: a step, and a read of all circles.
     *
     * @param device what to run on; the JVM where it is empty
     * @param crowd the circles
     * @return what frames took
     */
    FrameTimes world(Optional<Device> device, Crowd crowd);

    /**
     * Times a loop of Circles2D.
     *
     * @param device what to run on
     * @param indexing one of the indexings, not {@link PairIndexing#AUTO}
     * @param circles number of circles
     * @return what loops took
     */
    FrameTimes loop(Device device, PairIndexing indexing, int circles);
}
