/** The contacts of circles with pieces of terrain and walls: found, measured, visited, recorded. */
package io.github.circles2d.world.jvm.pieces;
