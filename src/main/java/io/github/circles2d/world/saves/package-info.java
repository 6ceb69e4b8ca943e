/** Snapshots of a world, and the log of its calls. Not part of the public API. */
package io.github.circles2d.world.saves;
