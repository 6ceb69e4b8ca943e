/** The physics of World in Java. Not part of the public API. */
package io.github.circles2d.world.model;
