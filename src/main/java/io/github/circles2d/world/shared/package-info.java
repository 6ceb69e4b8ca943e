/**
 * What all calls of a world share: the guard, the pipeline, what waits for it, the settings, what was read last, and the log. Not
 * part of the public API.
 */
package io.github.circles2d.world.shared;
