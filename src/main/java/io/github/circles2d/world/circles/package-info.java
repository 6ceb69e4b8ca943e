/** What World knows of its circles besides their motion: handles, waiting changes, saved states and their bytes, the hash. Not part of the public API. */
package io.github.circles2d.world.circles;
