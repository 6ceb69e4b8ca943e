/**
 * Broad phases side by side: the same circles, moved as {@code World} moves them, and the same pairs. {@link
 * io.github.circles2d.bench.broadphase.BroadPhases} lists them.
 */
package io.github.circles2d.bench.broadphase;
