/** What is near to a circle: the grid, the pair filter, and continuous collision, which looks along paths. */
package io.github.circles2d.world.jvm.grid;
