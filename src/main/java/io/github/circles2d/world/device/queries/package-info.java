/** Queries on a device: a tree of boxes over the circles that are there, and the searches in it. */
package io.github.circles2d.world.device.queries;
