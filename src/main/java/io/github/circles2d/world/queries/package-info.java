/** Finds circles: a tree of boxes over them, and the searches in it. Exact tests decide, in double precision, in Java alone. */
package io.github.circles2d.world.queries;
