/**
 * Programs beside the library: the doctor, which says whether OpenCL works on this machine and what to do if it does not,
 * and the vector addition, the smallest complete program on the room {@link io.github.circles2d.opencl}.
 */
package io.github.circles2d.tools;
