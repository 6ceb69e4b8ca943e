/**
 * Inside of the World engine: {@link io.github.circles2d.world.Simulation} drives the steps, and a
 * {@link io.github.circles2d.world.Pipeline} holds the state and makes them. Not part of the public API.
 *
 * <h2>One step, as a circle sees it</h2>
 *
 * <p>A circle's caller knows it by its handle; the engine knows it by its id (the lower half of the handle) and finds its
 * data in a slot. Every sum of floats runs in an order that ids decide; slots, threads and work-groups never show.
 *
 * <ol>
 *   <li><b>Commands.</b> What the caller asked for since the last step is applied, record by record, in call order: circles
 *       come, go and change.
 *   <li><b>Grid.</b> The circle's radius puts it into a level, its position into a bucket of that level's grid
 *       ({@link io.github.circles2d.world.model.GridLevels}). A counting sort gives it a new slot: circles of one bucket are
 *       neighbours in memory, ascending by id. Then its reach is computed: how far it looks for contacts in this step.
 *   <li><b>Sweep.</b> Where some circle moves farther than its radius in the step, it looks along its path for what it would
 *       pass through, and the path ends there.
 *   <li><b>Contacts.</b> The circle finds the circles whose reach meets its own, in 3 x 3 cells of its own level and of each
 *       coarser one that has circles. Pairs of static circles are left out. Each pair is a contact of the level of its larger
 *       circle, and belongs to the group of its lesser column and lesser row there; all contacts are sorted by (level,
 *       colour, group, lower id, higher id). That order is the order of every sum below.
 *   <li><b>Prepare.</b> A contact recalls the impulse that it ended the step before with, and is measured: normal (from the
 *       lower id to the higher), separation, whether it carries. It adds its impulse to the sums of its two circles.
 *   <li>Then, in each sub-step of length h:
 *       <ol>
 *         <li><b>Accelerate</b> (by circle). Keep the velocity, with gravity added, as what it was before impulses; a circle is loaded
 *             if one of its contacts, or a wall, carries. Apply the sum of its contacts' impulses at once (warm start), then
 *             its two nearest walls, biased.
 *         <li><b>Push</b> (by contact, level after level, colour after colour). Stop the approach, or what of it would close
 *             the gap within h; push overlaps out softly; bounce.
 *         <li><b>Move</b> (by circle). Displacement += velocity x h, kept within the walls; its walls once more,
 *             unbiased; the sums are cleared.
 *         <li><b>Relax</b> (by contact, in the same order). Measure the contact anew; solve it without push-out, which takes the speed
 *             of the push-out away again; add its impulse to the sums of its circles. In the last sub-step it is remembered
 *             instead.
 *       </ol>
 *   <li><b>Finish.</b> The base of the circle's position takes the displacement; what rounding loses there stays as the
 *       displacement that the next step begins with.
 * </ol>
 *
 * <p>Groups of one level and colour share no circle, so they may run at the same time. Within a group contacts run in
 * order, one after the other. More than that no circle can tell: a group may run as soon as those have that come before it and
 * touch one of its circles.
 *
 * <h2>Threads</h2>
 *
 * <p>On the JVM the workers of a {@code Team} run the same method, each on its share of circles, buckets or rows of groups, with
 * a barrier after each stage. What a share is depends on the number of workers, the state does not: shares are
 * disjoint, and where workers count into the same place, what they have counted is put in order of the ids afterwards.
 *
 * <h2>Snapshots</h2>
 *
 * <p>{@link io.github.circles2d.world.circles.SavedState} is a state by ids, without slots; every pipeline can write one and take one
 * over, and {@link io.github.circles2d.world.circles.SnapshotCodec} makes bytes of it, and checks those that it is given. A step
 * begins with nothing but what is in there, so what comes after it is the same wherever it is taken over.
 */
package io.github.circles2d.world;
