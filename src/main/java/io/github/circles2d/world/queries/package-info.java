/** Finds circles, pieces of terrain and bodies: trees of boxes over them, and the searches in them. Exact tests decide, in double precision, in Java alone. */
package io.github.circles2d.world.queries;
