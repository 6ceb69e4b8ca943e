/** The calls that search for circles, on the host or the device, for pieces of terrain and for bodies. Not part of the public API. */
package io.github.circles2d.world.search;
