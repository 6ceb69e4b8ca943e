/** Plans: the ways to put a step of World to a device, and the table that says which one makes a step. */
package io.github.circles2d.world.device.plan;
