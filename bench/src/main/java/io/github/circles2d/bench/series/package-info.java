/**
 * World and other engines on the same scenes at growing n: like radii, mixed radii, a pile that is too deep, a boulder. Each figure
 * is the time of a step with a wait after it, as a game makes it, out of a JVM of its own. Engines outside Maven get the scenes as
 * files and give their figures as files.
 */
package io.github.circles2d.bench.series;
