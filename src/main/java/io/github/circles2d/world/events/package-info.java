/** What circles and walls did to each other: which pairs touch, when that begins and ends, and how hard they hit. */
package io.github.circles2d.world.events;
