/**
 * Rigid circles in two dimensions, simulated on the JVM or by OpenCL on CPUs and GPUs: the public face of circles2d.
 *
 * <p>Two engines, which have nothing to do with each other:
 *
 * <ul>
 *   <li>{@link io.github.circles2d.World} is <b>the engine for games; start with it.</b> Thousands to a million circles fall,
 *       bounce, pile up and come to rest, come and go, and replay to the last bit on every back end. It needs no OpenCL.
 *   <li>{@link io.github.circles2d.Circles2D} is the engine of a thesis on pair indexing, reproduced. It tests every pair of
 *       circles in every step. Take it to study, to teach and to measure.
 * </ul>
 *
 * <h2>A first world</h2>
 *
 * <pre>{@code
 * try (World world = World.builder().bounds(0, 0, 80, 100).gravity(0, -10).restitution(0.5f).build()) {
 *     long floor = world.add(40, 0, 20, Float.POSITIVE_INFINITY); // x, y, radius, mass: a static circle
 *     long ball = world.add(40, 90, 1, 2);
 *     for (int frame = 0; frame < 300; frame++) {
 *         world.step(1 / 60f);
 *         draw(world.x(ball), world.y(ball), world.radius(ball)); // your own
 *     }
 * }
 * }</pre>
 *
 * <p>Lengths and masses are in units of your own, time is in seconds, y points upwards. A handle stays valid until its circle
 * is removed. Of one circle {@link io.github.circles2d.World#x}, {@link io.github.circles2d.World#vx} and their sisters
 * tell; whoever draws many takes them all at once:
 *
 * <pre>{@code
 * float[] circles = new float[4 * world.idLimit()];
 * world.readById(circles, null); // x, y, radius, mass of each
 * float x = circles[4 * World.id(ball)];
 * }</pre>
 *
 * <h2>Where to go on</h2>
 *
 * <ul>
 *   <li>{@link io.github.circles2d.FixedStep}: the loop of a game with a screen, whatever the rate of its frames.
 *   <li>{@link io.github.circles2d.World.Builder}: walls, gravity, restitution, sub-steps, and what to run on ({@link
 *       io.github.circles2d.Backend}). {@link io.github.circles2d.World#stats} tells what was chosen, and why.
 *   <li>{@link io.github.circles2d.Queries}: which circles a disc or a box overlaps, which is at a point, which are nearest, and
 *       which a ray or a moving disc meets.
 *   <li>{@link io.github.circles2d.World#snapshot} and {@link io.github.circles2d.World#restore} save a world and go back;
 *       {@link io.github.circles2d.World#hash} compares two, across machines too.
 *   <li>{@link io.github.circles2d.Rewind} goes back to any of the last frames. {@link io.github.circles2d.Recording} writes a log of
 *       all calls, and {@link io.github.circles2d.Replay} makes them again and compares.
 *   <li>{@link io.github.circles2d.Calibration} measures once which back end is the fastest on this machine.
 *   <li>{@link io.github.circles2d.opencl}: OpenCL devices, where one of several is to be chosen, and the exceptions that tell
 *       what is missing.
 * </ul>
 *
 * <p>What is out of range is refused with an IllegalArgumentException that names the value and what is allowed, and changes
 * nothing. Both engines hold memory, threads and devices that {@code close} gives back.
 *
 * <h2>Without OpenCL</h2>
 *
 * <p>A game that uses the JVM alone may leave out the jars of JavaCL, opencl4java and BridJ. {@link io.github.circles2d.Backend#AUTO}
 * then takes the JVM, and what needs OpenCL throws an {@link io.github.circles2d.opencl.OpenClUnavailableException} that names them.
 * In Maven, one exclusion leaves all of them out:
 *
 * <pre>{@code
 * <dependency>
 *   <groupId>io.github.circles2d</groupId>
 *   <artifactId>circles2d</artifactId>
 *   <version>...</version>
 *   <exclusions>
 *     <exclusion>
 *       <groupId>com.nativelibs4java</groupId>
 *       <artifactId>javacl-core</artifactId>
 *     </exclusion>
 *   </exclusions>
 * </dependency>
 * }</pre>
 */
package io.github.circles2d;
