package io.github.circles2d;

import io.github.circles2d.calibration.FrameTimes;
import io.github.circles2d.opencl.Device;

/** Takes the times that a {@link Calibration} is made of. */
interface Meter {
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
