/** The calls on events. Not part of the public API. */
package io.github.circles2d.world.reports;
