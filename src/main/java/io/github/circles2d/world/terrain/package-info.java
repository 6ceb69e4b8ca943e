/** What a world has of terrain: pieces, the bodies that they belong to, and the tree that steps search. Not part of the public API. */
package io.github.circles2d.world.terrain;
