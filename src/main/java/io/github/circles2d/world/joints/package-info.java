/** What a world has of joints: who they hold to whom, and what steps are told of them. Not part of the public API. */
package io.github.circles2d.world.joints;
