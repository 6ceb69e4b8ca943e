/**
 * What has been measured of the back ends and pair indexings, and the file that keeps it. Knows nothing of engines and devices:
 * these are names here. Not part of the public API; {@link io.github.circles2d.Calibration} is.
 */
package io.github.circles2d.calibration;
