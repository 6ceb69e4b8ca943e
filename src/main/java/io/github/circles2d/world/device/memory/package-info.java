/** Memory of a World on a device: the tables of its arrays, structs and status words, and the kernels that share them. */
package io.github.circles2d.world.device.memory;
