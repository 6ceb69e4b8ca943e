/** Makes the calls of a log again. Not part of the public API. */
package io.github.circles2d.world.replay;
