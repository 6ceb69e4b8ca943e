/** The calls that search for circles, on the host or the device. Not part of the public API. */
package io.github.circles2d.world.search;
