/** The whole state of a world in plain arrays, as bytes, and as a ring of frames. */
package io.github.circles2d.world.snapshots;
