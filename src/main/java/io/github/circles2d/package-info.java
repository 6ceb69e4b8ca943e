/**
 * The public API of circles2d: rigid circles and bodies in two dimensions, simulated on the JVM or by OpenCL on CPUs and GPUs.
 *
 * <p>There are two engines, which have nothing to do with each other:
 *
 * <ul>
 *   <li>{@link io.github.circles2d.World} is <b>the engine for games; start with it.</b> Thousands to a million circles fall,
 *       bounce, roll, pile up and come to rest. They may be added and removed at any time, and a replay gives the same bits on every back
 *       end. It needs no OpenCL.
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
 * <p>Lengths and masses are in your own units, time is in seconds, y points upwards. A handle stays valid until its circle is
 * removed. {@link io.github.circles2d.World#x}, {@link io.github.circles2d.World#vx} and similar calls read one circle. To draw many
 * circles, read all of them at once:
 *
 * <pre>{@code
 * float[] circles = new float[4 * world.idLimit()];
 * world.readById(circles, null); // x, y, radius, mass of each
 * float x = circles[4 * World.id(ball)];
 * }</pre>
 *
 * <h2>A whole game</h2>
 *
 * <p>It makes steps of one length, scores by events, goes a second back when a key is pressed, and writes a log of the game:
 *
 * <pre>{@code
 * final World world = World.builder().bounds(0, 0, 80, 100).gravity(0, -10).build();
 * final long player = world.add(40, 50, 1, 2);
 * final FixedStep loop = new FixedStep(world, 1 / 60f);
 * final Rewind rewind = new Rewind(world, 600); // ten seconds
 * final int[] pointsOf = new int[600]; // the game's own state of the frames that rewind keeps
 * int points;
 * int step;
 *
 * void play(Path file) throws IOException {
 *     Runnable beforeStep = this::beforeStep;
 *     world.report(Events.HIT);
 *     try (world; Recording recording = new Recording(world, Files.newOutputStream(file), 60)) {
 *         while (playing()) {
 *             if (backKey() && rewind.has(step - 60)) {
 *                 goBack(step - 60);
 *             }
 *             loop.advance(secondsSinceTheLastFrame(), beforeStep);
 *             FloatBuffer positions = loop.positions(null); // x and y by id, in between the last two steps
 *             draw(positions.get(2 * World.id(player)), positions.get(2 * World.id(player) + 1));
 *         }
 *         show(points + " points in " + recording.steps() + " steps");
 *     }
 * }
 *
 * void beforeStep() {
 *     Events events = world.events(); // of the step before
 *     for (int i = 0; i < events.size(); i++) {
 *         if (events.a(i) == player || events.b(i) == player) {
 *             points++;
 *         }
 *     }
 *     rewind.save(step); // after the events, which no frame has; drops newer frames if the game has gone back
 *     pointsOf[step % 600] = points;
 *     world.applyForce(player, 40 * stickX(), 0); // changes by input come last
 *     step++;
 * }
 *
 * void goBack(int to) {
 *     rewind.restore(to);
 *     points = pointsOf[to % 600];
 *     step = to;
 *     loop.reset(); // else the first picture would lie between now and then
 * }
 * }</pre>
 *
 * <p>Everything that decides the game happens in {@code beforeStep}, so it is the same at any rate of frames. Pictures and sounds may
 * follow later. A game that reports no events leaves the first lines out. {@link io.github.circles2d.Replay} plays the log, and
 * {@link io.github.circles2d.FixedStep#advanceReplay} draws it.
 *
 * <h2>Where to go on</h2>
 *
 * <ul>
 *   <li>{@link io.github.circles2d.FixedStep}: the loop of a game with a screen, whatever the rate of its frames.
 *   <li>{@link io.github.circles2d.World.Builder}: walls, gravity, restitution, sub-steps, and the back end ({@link
 *       io.github.circles2d.Backend}). {@link io.github.circles2d.World#stats} tells which one was chosen, and why.
 *   <li>{@link io.github.circles2d.Queries}: which circles a disc or a box overlaps, which is at a point, which are nearest, and
 *       which a ray or a moving disc meets.
 *   <li>{@link io.github.circles2d.World#snapshot} and {@link io.github.circles2d.World#restore} save a world and go back;
 *       {@link io.github.circles2d.World#hash} compares two, across machines too.
 *   <li>{@link io.github.circles2d.Terrain}: what does not give way: segments, chains of lines and arcs, and bodies of these that move as the game
 *       says.
 *   <li>{@link io.github.circles2d.Bodies}: boxes, capsules and other {@linkplain io.github.circles2d.Outline outlines} that are pushed as circles
 *       are.
 *   <li>{@link io.github.circles2d.Joints}: ropes, springs, hinges, motors, the mouse; {@link io.github.circles2d.Ropes} and {@link
 *       io.github.circles2d.Blobs} make whole ropes and soft balls.
 *   <li>{@link io.github.circles2d.Kind}: which circles and bodies meet, and how they move.
 *   <li>{@link io.github.circles2d.Rewind} goes back to any of the last frames. {@link io.github.circles2d.Recording} writes a log of
 *       all calls, and {@link io.github.circles2d.Replay} makes them again and compares.
 *   <li>{@link io.github.circles2d.Rollback}: rollback netcode, and the rules that a game keeps for it.
 *   <li>{@link io.github.circles2d.Calibration} measures once which {@link io.github.circles2d.PairIndexing} of Circles2D is the fastest.
 *   <li>{@link io.github.circles2d.opencl}: OpenCL devices, to choose one of several, and the exceptions that say what is
 *       missing.
 * </ul>
 *
 * <p>These calls throw an exception, and change nothing:
 *
 * <ul>
 *   <li>with a value out of range, or a handle whose circle is gone: an IllegalArgumentException that names the value and the range;
 *   <li>with null: a NullPointerException that names the parameter;
 *   <li>after {@code close}: an IllegalStateException;
 *   <li>while another thread is inside a call of the same world: a ConcurrentModificationException.
 * </ul>
 *
 * <p>Both engines hold memory, threads and devices that {@code close} gives back.
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
