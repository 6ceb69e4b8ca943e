/** The calls that read circles. Not part of the public API. */
package io.github.circles2d.world.reads;
