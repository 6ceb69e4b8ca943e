/** The physics of World in Java: formulas, constants, the grids, and the limits of what a caller may give. It knows no pipeline. Not part of the public API. */
package io.github.circles2d.world.model;
