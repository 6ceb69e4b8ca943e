/** The calls that change circles and kinds. Not part of the public API. */
package io.github.circles2d.world.changes;
