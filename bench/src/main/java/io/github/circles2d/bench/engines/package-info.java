/**
 * The engines that are compared, each behind {@link io.github.circles2d.bench.engines.Engine}: load a scene, step, read
 * positions and velocities.
 */
package io.github.circles2d.bench.engines;
