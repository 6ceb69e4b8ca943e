/** The step of bodies that are pushed: pairs, contacts, visits, their joints, what they sense, and how they wake. */
package io.github.circles2d.world.jvm.bodies;
