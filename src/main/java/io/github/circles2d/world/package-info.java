/**
 * The inside of the World engine: {@link io.github.circles2d.world.Simulation} drives the steps, and a
 * {@link io.github.circles2d.world.shared.Pipeline} holds the state and makes them. ARCHITECTURE.md follows a circle through a step, and
 * docs/step.md defines it. Not part of the public API.
 */
package io.github.circles2d.world;
