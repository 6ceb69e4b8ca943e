/** The state of the circles by slot, those that sleep or rest, and what contacts and joints keep from step to step. */
package io.github.circles2d.world.jvm.state;
