/**
 * The engine World in its plainest form, written from docs/step.md: one thread, one circle after the
 * other, one contact after the other. It uses nothing of the library, not even its constants and formulas, so an error there shows as a
 * difference here. World must have the same bits on every back end.
 */
package io.github.circles2d.reference;
