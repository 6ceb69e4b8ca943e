/** The bytes of a log of calls: a writer and a reader, which know numbers and words, and not what they mean. Not part of the public API. */
package io.github.circles2d.world.log;
