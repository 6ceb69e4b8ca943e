/** Handles, the table of fields, waiting changes, saved states and their bytes, and the hash: all that World knows of circles besides their motion. Not part of the public API. */
package io.github.circles2d.world.circles;
