/**
 * The inside of the World engine: {@link io.github.circles2d.world.Simulation} drives the steps, and a
 * {@link io.github.circles2d.world.shared.Pipeline} holds the state and makes them. Not part of the public API.
 *
 * <h2>One step, as a circle sees it</h2>
 *
 * <p>A caller knows a circle by its handle. The engine knows it by its id, which is the lower half of the handle, and finds its
 * data in a slot. Ids decide the order of every sum of floats; slots, threads and work-groups never show.
 *
 * <ol>
 *   <li><b>Commands.</b> The engine applies the calls since the last step, record by record, in call order: circles come, go and
 *       change.
 *   <li><b>Grid.</b> The circle's radius puts it into a level, and its position into a bucket of that level's grid
 *       ({@link io.github.circles2d.world.model.GridLevels}). A counting sort gives it a new slot: circles of one bucket are
 *       neighbours in memory, ascending by id. Then the circle gets its speculative distance: how far it looks for contacts in
 *       this step.
 *   <li><b>Continuous collision.</b> If a circle moves farther in the step than its speculative distance covers, it looks along
 *       its path for what it would meet. It stops where it touches that, or, if it touches it already, leaves it to their contact.
 *   <li><b>Contacts.</b> The circle finds the circles that its speculative distance meets, in 3 x 3 cells of its own level and of
 *       each coarser one that has circles. Pairs of static circles are left out. A pair is a contact of the level of its larger
 *       circle, and belongs to the group of its lesser column and row there. All contacts are sorted by (level, colour, group,
 *       lower id, higher id), which is the order of every sum below.
 *   <li><b>Prepare.</b> A contact takes its normal impulse from the impulse cache and is measured: normal (from the lower id to
 *       the higher), separation, whether it carries. It adds its impulse to the sums of its two circles.
 *   <li>Then, in each sub-step of length h:
 *       <ol>
 *         <li><b>integrateVelocities</b> (by circle). Add gravity, and keep this velocity as the one before impulses; a circle is
 *             loaded if one of its contacts, or a wall, carries. Apply the sum of its contacts' impulses at once (warm start), then
 *             visit the nearer wall of each axis with bias.
 *         <li><b>solve</b> (by contact, level after level, colour after colour). Stop the approach, or the part of it that would
 *             close the gap within h; push overlaps out softly, slowly unless they are deep; bounce. Two circles that nothing
 *             carries bounce at once, and are left alone while they part.
 *         <li><b>integratePositions</b> (by circle). Displacement += velocity x h, within the motion clamp and the walls; visit the
 *             walls without bias; clear the sums. A circle that the farther wall of an axis holds stops there.
 *         <li><b>relax</b> (by contact, in the same order). Measure the contact again. Visit it without bias, which takes the speed
 *             of the push-out away again, and add its impulse to the sums of its circles. In the last sub-step the impulse goes to
 *             the impulse cache instead.
 *       </ol>
 *   <li><b>finalizePositions.</b> The base of the circle's position takes the displacement. What rounding loses there stays as
 *       the displacement that the next step begins with.
 *   <li><b>Events</b>, if they are reported. The records of all pairs that touch go to
 *       {@link io.github.circles2d.world.events.ContactEvents}.
 * </ol>
 *
 * <p>Groups of one colour share no circle, so they may run at the same time. Within a group contacts run one after the
 * other, in order. No circle can tell more than that: a group may run as soon as all groups before it that touch one of its
 * circles have run.
 *
 * <h2>Threads</h2>
 *
 * <p>On the JVM the workers of a {@code Team} run the same method, each on its share of circles, buckets or rows of groups, with
 * a barrier after each stage. A share depends on the number of workers, but the state does not: shares are disjoint, and if workers
 * count into the same place, the counted things are put in the order of the ids afterwards.
 *
 * <h2>Snapshots</h2>
 *
 * <p>{@link io.github.circles2d.world.circles.SavedState} is a state by ids, without slots. Every pipeline can save one and load one.
 * {@link io.github.circles2d.world.circles.SnapshotCodec} turns it into bytes, and checks the bytes that it reads. A step depends on
 * nothing else, so a restored world goes on in the same way everywhere.
 */
package io.github.circles2d.world;
