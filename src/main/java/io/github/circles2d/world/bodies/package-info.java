/** Tables of the rigid bodies of a world. Not part of the public API. */
package io.github.circles2d.world.bodies;
