package io.github.circles2d.world.device;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.TestScale;
import io.github.circles2d.scenes.Scene;
import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.SimulationScenes;
import io.github.circles2d.world.changes.Bodies;
import io.github.circles2d.world.changes.BulkChanges;
import io.github.circles2d.world.changes.Pieces;
import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.circles.Commands;
import io.github.circles2d.world.circles.KindTable;
import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.events.EventRows;
import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.jvm.JvmPipeline;
import io.github.circles2d.world.model.AxisEdge;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.Features;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.model.KindField;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.Readiness;
import io.github.circles2d.world.reads.IdReads;
import io.github.circles2d.world.shared.Call;
import io.github.circles2d.world.shared.Pipeline;
import io.github.circles2d.world.snapshots.SavedState;
import io.github.circles2d.world.snapshots.SnapshotCodec;
import io.github.circles2d.world.terrain.ChainPath;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/** A simulation on each of the pipelines that are to be compared: all get the same calls. */
final class Twins implements AutoCloseable {
    private static final int SUB_STEPS = 4;

    /** For a circle with a motion of its own. */
    private static final Readiness OWN_MOTION = new Readiness(false, Features.OWN_MOTION, false, false);

    private final Simulation[] simulations;
    private final Pipeline[] pipelines;

    /** By id: the handle of the last circle that had it. */
    private long[] handles = new long[0];

    /** How many ids have been given. */
    private int ids;

    /** The circles at the last request for positions. */
    private float[] requested;

    /** The handles of these circles. */
    private long[] requestedHandles;

    private boolean takeById;

    /** Whether changes turn circles, and let them grip. */
    private boolean turns;

    private Twins(Simulation[] simulations, Pipeline... pipelines) {
        this.simulations = simulations;
        this.pipelines = pipelines;
        turns = Arrays.stream(pipelines).allMatch(pipeline -> pipeline instanceof JvmPipeline);
    }

    private void each(Consumer<Simulation> call) {
        Arrays.stream(simulations).forEach(call);
    }

    /** Worlds without gravity and circles. */
    static Twins empty(Bounds bounds, Pipeline... pipelines) {
        return empty(bounds, SUB_STEPS, pipelines);
    }

    static Twins empty(Bounds bounds, int subSteps, Pipeline... pipelines) {
        return empty(new WorldParameters(bounds, 0, 0, 0, subSteps, 0), pipelines);
    }

    /** Worlds whose circles sleep, which gravity pulls down. */
    static Twins sleeping(Bounds bounds, int subSteps, float gravity, Pipeline... pipelines) {
        return empty(new WorldParameters(bounds, 0, -gravity, 0, subSteps, 0).sleeping(true), pipelines);
    }

    private static Twins empty(WorldParameters parameters, Pipeline... pipelines) {
        return new Twins(
                Arrays.stream(pipelines)
                        .map(pipeline -> new Simulation(pipeline, parameters))
                        .toArray(Simulation[]::new),
                pipelines);
    }

    /** A scene, on several pipelines. */
    static Twins load(Scene scene, Pipeline... pipelines) {
        return load(scene, SUB_STEPS, pipelines);
    }

    /** A scene, on several pipelines, with a number of sub-steps. */
    static Twins load(Scene scene, int subSteps, Pipeline... pipelines) {
        Twins twins = new Twins(
                Arrays.stream(pipelines)
                        .map(pipeline -> SimulationScenes.simulation(scene, subSteps, pipeline))
                        .toArray(Simulation[]::new),
                pipelines);
        twins.handles = new long[scene.size()];
        twins.ids = scene.size();
        twins.simulations[0].readings.readHandles(twins.handles);
        return twins;
    }

    /** Adds a circle between two heaps of so many circles that do not touch each other. */
    void addCrowd(int heap) {
        float radius = 0.02f;
        add(0.5f, 0.5f, radius, 1, 0, 0, 0);
        for (int i = 0; i < heap; i++) {
            add(0.5f - 1.9f * radius, 0.5f + 1e-4f * i, radius, 1, 0, 0, 0);
            add(0.5f + 1.9f * radius, 0.5f + 1e-4f * i, radius, 1, 0, 0, 0);
        }
    }

    /** Adds a circle among so many larger ones, which are static: all candidates are of cross contacts. */
    void addCrossCrowd(int larger) {
        float radius = 0.04f;
        add(0.5f, 0.5f, 0.25f * radius, 1, 0, 0, 0);
        for (int i = 0; i < larger; i++) {
            double angle = 2 * Math.PI * i / larger;
            float x = 0.5f + 1.1f * radius * (float) Math.cos(angle);
            float y = 0.5f + 1.1f * radius * (float) Math.sin(angle);
            add(x, y, radius, Float.POSITIVE_INFINITY, 0, 0, 0);
        }
    }

    /** Lets changes turn circles on devices, too: the kernels of worlds that do not turn are others. */
    void letChangesTurn() {
        turns = true;
    }

    void setGravity(float x, float y) {
        each(simulation -> simulation.calls.makeOfFloats(Call.GRAVITY, x, y, 0, 0));
    }

    /** Sets a field of a kind. */
    void setKind(KindField field, int kind, int value) {
        each(simulation -> simulation.kinds.set(field, kind, value));
    }

    /** Gives circles kinds from 0 on, by turns. */
    void setKinds(int kinds) {
        for (Simulation simulation : simulations) {
            for (int id = 0; id < ids; id++) {
                simulation.circles.setKind(handles[id], id % kinds);
            }
        }
    }

    /** Gives a wall a friction. */
    void setWall(int wall, float friction) {
        each(simulation -> setWall(simulation, wall, friction, 0, 0));
    }

    static void setWall(Simulation simulation, int wall, float friction, float rolling, float belt) {
        simulation.calls.make(
                Call.WALL_SURFACE,
                wall,
                Float.floatToRawIntBits(friction),
                Float.floatToRawIntBits(rolling),
                Float.floatToRawIntBits(belt));
    }

    void wakeAll() {
        each(simulation -> simulation.calls.make(Call.WAKE_ALL));
    }

    /** Compares who sleeps; returns how many do. */
    int assertSameSleepers(String when) {
        long[] expected = new long[ids / 64 + 1];
        simulations[0].readings.readAwakeById(expected);
        for (Simulation simulation : simulations) {
            long[] awake = new long[expected.length];
            simulation.readings.readAwakeById(awake);
            assertThat(awake).as(when + " on " + simulation.figures().device()).isEqualTo(expected);
            assertThat(simulation.figures().awake())
                    .isEqualTo(simulations[0].figures().awake());
        }
        return size()
                - Arrays.stream(expected)
                        .map(Long::bitCount)
                        .mapToInt(Math::toIntExact)
                        .sum();
    }

    /** Behind a step, devices have counted how many are awake. */
    void assertDevicesKnowWhoIsAwake(String when) {
        for (Pipeline pipeline : pipelines) {
            if (pipeline instanceof DevicePipeline) {
                assertThat(pipeline.awake(size()))
                        .as(when + " on " + pipeline.device())
                        .isEqualTo(simulations[0].figures().awake());
            }
        }
    }

    /** Adds a segment of the ground, or of a body that may move. Returns the body. */
    long addPlate(float x, float y, float length, boolean moves) {
        long body = 0;
        for (Simulation simulation : simulations) {
            body = moves ? simulation.bodies.add(x, y, 0) : simulation.bodies.ground();
            float fromX = moves ? 0 : x;
            float fromY = moves ? 0 : y;
            simulation.pieces.addSegment(body, 0, fromX - 0.5f * length, fromY, fromX + 0.5f * length, fromY, 0);
        }
        return body;
    }

    /** Holds two circles at the distance that they have. */
    void addRod(int id, int other) {
        each(simulation ->
                simulation.joints.add(handles[id], handles[other], new JointForm(JointRow.AXIAL | JointRow.RIGID)));
    }

    /** Makes random calls on joints. */
    void addJoints(long seed, int calls) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int k = 0; k < calls; k++) {
            changeJoints(random);
        }
    }

    void moveBody(long body, float vx, float vy) {
        each(simulation -> simulation.calls.changeByFloats(Call.BODY_VELOCITY, body, vx, vy, 0, 0));
    }

    /** Number of circles. */
    int size() {
        return simulations[0].circles.size();
    }

    void step(float dt, int steps) {
        each(simulation -> simulation.step(dt, steps));
    }

    void assertEqual(String when) {
        long expected = simulations[0].hash();
        for (Simulation simulation : simulations) {
            assertThat(simulation.hash())
                    .as(when + " on " + simulation.figures().device())
                    .isEqualTo(expected);
        }
    }

    /** Has events reported. */
    void report(int types) {
        each(simulation -> simulation.reports.report(types));
    }

    void setHitSpeed(float speed) {
        each(simulation -> simulation.reports.setHitSpeed(speed));
    }

    /** Has events of two kinds reported. */
    void report(int kindA, int kindB, int types) {
        each(simulation -> simulation.reports.report(kindA, kindB, types));
    }

    /** Makes a kind a sensor, and every so many circles of that kind. */
    void giveSensors(int kind, int every) {
        for (Simulation simulation : simulations) {
            simulation.kinds.set(KindField.SENSOR, kind, 1);
            for (int id = 0; id < ids; id += every) {
                if (lives(id)) {
                    simulation.circles.setKind(handles[id], kind);
                }
            }
        }
    }

    /** Lets circles of two kinds pass through each other, and sense that. */
    void sense(int kindA, int kindB) {
        each(simulation -> simulation.kinds.setSetting(kindA, kindB, KindTable.RESPONSE + PairTable.SENSE));
    }

    /** Takes the events from every pipeline, and returns their number. */
    int assertSameEvents(String when) {
        return assertSameEvents(when, simulation -> simulation.reports.take());
    }

    /** Asks every pipeline for the events up to now. */
    void requestEvents() {
        each(simulation -> simulation.reports.request());
    }

    /** Takes the events that were asked for, and returns their number. */
    int assertSameRequestedEvents(String when) {
        return assertSameEvents(when, simulation -> simulation.reports.takeRequested());
    }

    private int assertSameEvents(String when, Function<Simulation, EventRows> take) {
        List<String> expected = events(take.apply(simulations[0]));
        for (int k = 1; k < simulations.length; k++) {
            assertThat(events(take.apply(simulations[k])))
                    .as(when + " on " + simulations[k].figures().device())
                    .isEqualTo(expected);
        }
        return expected.size();
    }

    /** Adds a body that turns, with a segment of a kind whose middle is its pivot; its angular velocity may be 0. */
    void addSpinner(float x, float y, float length, float angularVelocity, int kind) {
        for (Simulation simulation : simulations) {
            long body = simulation.bodies.add(x, y, 0.3f);
            simulation.pieces.addSegment(body, kind, -0.5f * length, 0, 0.5f * length, 0, 0);
            simulation.calls.changeByFloats(Call.BODY_ANGULAR_VELOCITY, body, angularVelocity, 0, 0, 0);
        }
    }

    /** Compares which pairs of two kinds touch. */
    void assertSameTouching(int kindA, int kindB) {
        long[] expected = new long[1000];
        int pairs = simulations[0].reports.touching(kindA, kindB, expected);
        for (Simulation simulation : simulations) {
            long[] found = new long[expected.length];
            assertThat(simulation.reports.touching(kindA, kindB, found)).isEqualTo(pairs);
            assertThat(found).isEqualTo(expected);
        }
    }

    static List<String> events(EventRows rows) {
        List<String> events = new ArrayList<>();
        for (int i = 0; i < rows.size(); i++) {
            events.add(rows.step(i) + " " + rows.type(i) + " " + rows.a(i) + " " + rows.b(i) + " " + rows.side(i) + " "
                    + rows.piece(i) + " "
                    + rows.speed(i) + " " + rows.slipSpeed(i) + " " + rows.impulse(i) + " " + rows.x(i) + " "
                    + rows.y(i) + " " + rows.normalX(i)
                    + " " + rows.normalY(i));
        }
        return events;
    }

    /**
     * Pipelines may look for pairs of unlike radii each in its own way, and the JVM does not look for pairs of circles that rest and may fit its grid
     * to where circles are, so the pairs that they test are compared if radii are alike, no circle is static, and the grid is not fitted.
     */
    void assertSameFigures() {
        Simulation.Figures expected = simulations[0].figures();
        boolean fits = Arrays.stream(pipelines).anyMatch(each -> each instanceof JvmPipeline jvm && jvm.fitsGrid());
        boolean lookAlike = !fits && lookForPairsAlike();
        for (Simulation simulation : simulations) {
            Simulation.Figures figures = simulation.figures();
            assertThat(figures.contacts()).isEqualTo(expected.contacts());
            assertThat(figures.greatestContacts()).isEqualTo(expected.greatestContacts());
            if (lookAlike) {
                assertThat(figures.candidatePairs()).isEqualTo(expected.candidatePairs());
            }
        }
    }

    private boolean lookForPairsAlike() {
        float[] circles = new float[4 * simulations[0].circles.size()];
        simulations[0].readings.read(circles);
        float least = Float.MAX_VALUE;
        float greatest = 0f;
        boolean noneIsStatic = true;
        for (int k = 2; k < circles.length; k += 4) {
            least = Math.min(least, circles[k]);
            greatest = Math.max(greatest, circles[k]);
            noneIsStatic &= circles[k + 1] < Float.POSITIVE_INFINITY;
        }
        return noneIsStatic && greatest < 2f * least;
    }

    void assertSameReadings() {
        int n = simulations[0].circles.size();
        float[][] circles = new float[simulations.length][4 * n];
        float[][] velocities = new float[simulations.length][2 * n];
        for (int k = 0; k < simulations.length; k++) {
            simulations[k].readings.read(circles[k]);
            simulations[k].readings.readVelocities(velocities[k]);
            assertThat(circles[k]).isEqualTo(circles[0]);
            assertThat(velocities[k]).isEqualTo(velocities[0]);
            assertPositions(simulations[k].readings.positions(), circles[0]);
            assertSameReadingsById(simulations[k], circles[0], velocities[0]);
        }
        requestPositions();
        assertSameRequestedPositions();
    }

    private void assertSameReadingsById(Simulation simulation, float[] circles, float[] velocities) {
        int ids = simulation.circles.idLimit();
        float[] byId = new float[4 * ids + 4];
        float[] velocitiesById = new float[2 * ids];
        long[] living = new long[(ids + 63) / 64];
        simulation.readings.readById(byId, null);
        simulation.readings.readVelocitiesById(velocitiesById, null);
        FloatBuffer positions = simulation.readings.positionsById(living);
        float[] expected = new float[byId.length];
        float[] expectedPositions = new float[2 * ids];
        float[] expectedVelocities = new float[2 * ids];
        Arrays.fill(expected, Float.NaN);
        Arrays.fill(expectedPositions, Float.NaN);
        Arrays.fill(expectedVelocities, Float.NaN);
        int place = 0;
        for (int id = 0; id < ids; id++) {
            boolean lives = (living[id / 64] >>> id & 1) != 0;
            assertThat(lives).isEqualTo(simulation.circles.handle(id) != 0);
            if (lives) {
                System.arraycopy(circles, 4 * place, expected, 4 * id, 4);
                System.arraycopy(circles, 4 * place, expectedPositions, 2 * id, 2);
                System.arraycopy(velocities, 2 * place++, expectedVelocities, 2 * id, 2);
            }
        }
        assertThat(byId).isEqualTo(expected);
        assertThat(velocitiesById).isEqualTo(expectedVelocities);
        assertThat(positions).isEqualTo(FloatBuffer.wrap(expectedPositions));
    }

    /** Asks every pipeline for the positions as they are now. */
    void requestPositions() {
        requested = new float[4 * simulations[0].circles.size()];
        requestedHandles = new long[simulations[0].circles.size()];
        simulations[0].readings.readHandles(requestedHandles);
        // Of the first pipeline alone: the others are not to come to rest before they are asked.
        simulations[0].readings.read(requested);
        each(simulation -> simulation.readings.requestPositions());
    }

    /** Takes the positions from every pipeline, by turns by id: those of the request. */
    void assertSameRequestedPositions() {
        takeById = !takeById;
        for (Simulation simulation : simulations) {
            if (takeById) {
                assertRequestedById(simulation);
            } else {
                assertPositions(simulation.readings.takePositions(), requested);
            }
        }
    }

    /** Those of circles that are still there. */
    private void assertRequestedById(Simulation simulation) {
        long[] living = new long[ids / 64 + 1];
        FloatBuffer positions = simulation.readings.takePositionsById(living);
        float[] expected = new float[positions.limit()];
        Arrays.fill(expected, Float.NaN);
        long[] expectedLiving = new long[living.length];
        for (int place = 0; place < requestedHandles.length; place++) {
            if (simulation.circles.contains(requestedHandles[place])) {
                int id = (int) requestedHandles[place];
                System.arraycopy(requested, 4 * place, expected, 2 * id, 2);
                expectedLiving[id / 64] |= 1L << id;
            }
        }
        assertThat(positions).isEqualTo(FloatBuffer.wrap(expected));
        assertThat(living).isEqualTo(expectedLiving);
    }

    private static void assertPositions(FloatBuffer positions, float[] circles) {
        assertThat(positions.remaining()).isEqualTo(circles.length / 2);
        for (int i = 0; i < circles.length / 4; i++) {
            assertThat(positions.get()).isEqualTo(circles[4 * i]);
            assertThat(positions.get()).isEqualTo(circles[4 * i + 1]);
        }
    }

    /** Makes the arena a little smaller. */
    void confine() {
        for (Simulation simulation : simulations) {
            Bounds now = simulation.settings().bounds();
            float less = 0.01f * (now.maxX() - now.minX());
            simulation.calls.makeOfFloats(Call.BOUNDS, now.minX() + less, now.minY(), now.maxX() - less, now.maxY());
        }
    }

    /** Moves every wall by up to a length, in or out. */
    void moveWalls(SplittableRandom random, float most) {
        Bounds now = simulations[0].settings().bounds();
        float minX = now.minX() + between(random, -most, most);
        float minY = now.minY() + between(random, -most, most);
        float maxX = now.maxX() + between(random, -most, most);
        float maxY = now.maxY() + between(random, -most, most);
        each(simulation -> simulation.calls.makeOfFloats(Call.BOUNDS, minX, minY, maxX, maxY));
    }

    /** Saves every state, which is the same, and lets each go on from what another has saved. */
    void exchange() {
        ByteBuffer[] saved = new ByteBuffer[simulations.length];
        for (int k = 0; k < simulations.length; k++) {
            saved[k] = snapshot(simulations[k]);
            assertThat(saved[k]).isEqualTo(saved[0]);
        }
        for (int k = 0; k < simulations.length; k++) {
            simulations[k].snapshots.restore(saved[(k + 1) % simulations.length].duplicate());
        }
    }

    private static ByteBuffer snapshot(Simulation simulation) {
        ByteBuffer snapshot = ByteBuffer.allocate(simulation.snapshots.bytes());
        simulation.snapshots.write(snapshot);
        return snapshot.flip();
    }

    /** Other worlds, of such pipelines, take over the state, and all go on alike. */
    void assertGoOnIn(Scene scene, Pipeline... pipelines) {
        try (Twins others = load(scene, pipelines)) {
            others.takeOver(this);
            others.step(scene.timeStep(), 3);
            step(scene.timeStep(), 3);
            others.assertEqual(scene.name() + " in other worlds");
            assertThat(others.hash()).as(scene.name()).isEqualTo(hash());
        }
    }

    /** Goes on from the state of others. */
    void takeOver(Twins others) {
        each(simulation -> simulation.snapshots.restore(snapshot(others.simulations[0])));
        handles = others.handles.clone();
        ids = others.ids;
    }

    /** Number of pieces of terrain. */
    int pieces() {
        return simulations[0].pieceIds.size();
    }

    /** Sets the number of sub-steps, by the only way there is: a restore. */
    void restoreWithSubSteps(int count) {
        restoreWith(p -> new WorldParameters(
                p.bounds(), p.gravityX(), p.gravityY(), p.restitution(), count, p.previousTimeStep()));
    }

    /** Sets how contacts are, by a restore. */
    void restoreWith(ContactSettings contacts) {
        restoreWith(p -> p.with(contacts));
    }

    /** Takes a scene in place of all that is, with edges of its own. Kernels are not compiled again, which takes long. */
    void loadInPlace(Scene scene, AxisEdge x, AxisEdge y) {
        try (Twins one = load(scene, new JvmPipeline(1, JvmPipeline.LEAST_SHARE, 0, false))) {
            one.restoreWithEdges(x, y);
            takeOver(one);
        }
    }

    /** Goes on from the state as it is, with other edges. */
    void restoreWithEdges(AxisEdge x, AxisEdge y) {
        restoreWith(p -> {
            Bounds bounds = p.bounds().with(x, y);
            return new WorldParameters(
                    bounds,
                    p.gravityX(),
                    p.gravityY(),
                    p.restitution(),
                    p.subSteps(),
                    p.previousTimeStep(),
                    p.contacts(),
                    bounds,
                    p.surfaces(),
                    p.sleeps());
        });
    }

    private void restoreWith(UnaryOperator<WorldParameters> change) {
        for (Simulation simulation : simulations) {
            SavedState state = new SavedState();
            SnapshotCodec.read(snapshot(simulation), state);
            state.setParameters(change.apply(state.parameters()));
            ByteBuffer changed =
                    SnapshotCodec.encode(state, ByteBuffer.allocate(0).order(ByteOrder.LITTLE_ENDIAN));
            SnapshotCodec.addCheck(changed);
            simulation.snapshots.restore(changed);
        }
    }

    /** Adds a circle. */
    void add(float x, float y, float r, float mass, float restitution, float vx, float vy) {
        for (Simulation simulation : simulations) {
            long handle = simulation.newCircles.add(x, y, r, mass, vx, vy, 0);
            int id = (int) handle;
            if (id >= handles.length) {
                handles = Arrays.copyOf(handles, 2 * (id + 1));
            }
            handles[id] = handle;
            ids = Math.max(ids, id + 1);
            simulation.circles.set(Commands.RESTITUTION, handle, restitution, 0);
        }
    }

    /** Changes the circle that had an id last. */
    void set(int operation, int id, float a, float b) {
        each(simulation -> simulation.circles.set(operation, handles[id], a, b));
    }

    /** Removes the circle that had an id last. */
    void remove(int id) {
        each(simulation -> simulation.circles.remove(handles[id]));
    }

    /** Puts the circle that had an id last somewhere else; a static one travels there. */
    void move(int id, float x, float y) {
        each(simulation -> simulation.circles.move(handles[id], x, y));
    }

    /** Makes some change of each kind. */
    void change(Scene scene, SplittableRandom random) {
        Bounds bounds = simulations[0].settings().bounds();
        int id = random.nextInt(ids);
        if (lives(id)) {
            long[] twice = {handles[id], handles[id]};
            boolean alone = random.nextBoolean();
            for (Simulation simulation : simulations) {
                if (alone) {
                    simulation.circles.remove(handles[id]);
                } else {
                    assertThat(simulation.bulk.remove(twice, 2, true)).isOne();
                }
            }
        }
        changeSome(bounds, random);
        float r = scene.radius(random.nextInt(scene.size()));
        if (random.nextInt(4) > 0) {
            float x = between(random, bounds.minX(), bounds.maxX());
            float y = between(random, bounds.minY(), bounds.maxY());
            add(x, y, r, between(random, 1, 2), 0.5f, between(random, -r, r), between(random, -r, r));
        }
        for (int operation = Commands.POSITION; operation <= Commands.IMPULSE; operation++) {
            id = random.nextInt(ids);
            if (!lives(id)) {
                continue;
            }
            switch (operation) {
                case Commands.POSITION -> {
                    float x = between(random, bounds.minX(), bounds.maxX());
                    move(id, x, between(random, bounds.minY(), bounds.maxY()));
                }
                case Commands.VELOCITY, Commands.IMPULSE ->
                    set(operation, id, between(random, -9 * r, 9 * r), between(random, -9 * r, 9 * r));
                case Commands.RADIUS -> set(operation, id, r, 0);
                default -> set(operation, id, between(random, 0.1f, 1), 0);
            }
        }
        if (random.nextInt(8) == 0) {
            changeKinds(random);
        }
        if (turns) {
            turn(random.nextInt(ids), random);
        }
        for (int k = 0; k < 5; k++) {
            grow(random.nextInt(ids), r * between(random, 0.8f, 1.3f), 1 + random.nextInt(6));
        }
        boolean moves = TestScale.EXHAUSTIVE || Arrays.stream(pipelines).allMatch(Twins::isReadyForMotions);
        for (CircleField field : CircleField.values()) {
            boolean isOfCalls = field != CircleField.TARGET
                    && field != CircleField.GROWTH
                    && (turns || !field.isOfTurning())
                    && (moves || !field.isOfMotion());
            for (int k = 0; k < 20 && isOfCalls; k++) {
                setField(field, random.nextInt(ids), random.nextLong() >> random.nextInt(Long.SIZE));
            }
        }
    }

    /** Whether a device has kernels for circles with motions of their own: changes compile none, which would be programs of no other test. */
    private static boolean isReadyForMotions(Pipeline pipeline) {
        return pipeline instanceof JvmPipeline || pipeline.isReady(OWN_MOTION);
    }

    /** Makes circles grip and turn: some kinds, some walls and some circles, each in some way. */
    void changeSurfaces(SplittableRandom random) {
        int kind = random.nextInt(3);
        int wall = random.nextInt(4);
        float friction = surface(random);
        float resistance = 0.2f * surface(random);
        float belt = random.nextInt(3) > 0 ? 0 : between(random, -1, 1);
        int inertia = random.nextInt(4) % 3;
        float damping = random.nextInt(2) == 0 ? 0 : between(random, 0, 3);
        boolean ofKind = random.nextBoolean();
        for (Simulation simulation : simulations) {
            setWall(simulation, wall, resistance + friction, 0.5f * resistance, belt);
            simulation.kinds.set(KindField.FRICTION, kind, ofKind ? friction : Float.NaN);
            simulation.kinds.set(KindField.ROLLING_RESISTANCE, kind, resistance);
            simulation.kinds.set(KindField.BELT_SPEED, kind, belt);
            simulation.kinds.set(KindField.INERTIA, kind, inertia);
            simulation.kinds.set(KindField.ANGULAR_DAMPING, kind, damping);
        }
        for (int k = 0; k < 20 && ids > 0; k++) {
            int id = random.nextInt(ids);
            float a = surface(random);
            float b = between(random, -1, 1);
            if (lives(id)) {
                for (Simulation simulation : simulations) {
                    turnOne(simulation, k, handles[id], a, b);
                }
            }
        }
    }

    /** Gives the circle that had an id last a surface, a torque and an angular velocity of any magnitude. */
    void turnExtremely(int id, SplittableRandom random) {
        float friction = PipelinesAgreeTest.power(random, -9, 3);
        float resistance = PipelinesAgreeTest.power(random, -9, 3);
        float torque = (random.nextInt(3) - 1) * PipelinesAgreeTest.power(random, -18, 18);
        float velocity = (random.nextInt(3) - 1) * PipelinesAgreeTest.power(random, -9, 6);
        if (lives(id)) {
            for (Simulation simulation : simulations) {
                simulation.fields.setOwn(CircleField.FRICTION, handles[id], friction);
                simulation.fields.setOwn(CircleField.ROLLING_RESISTANCE, handles[id], resistance);
                simulation.forces.applyTorque(handles[id], torque);
                simulation.circles.setAngularVelocity(handles[id], velocity);
                simulation.circles.applyAngularImpulse(handles[id], -torque);
            }
        }
    }

    /** Makes one of the changes of a circle that make it turn. */
    private static void turnOne(Simulation simulation, int change, long handle, float a, float b) {
        switch (change % 8) {
            case 0 -> simulation.fields.setOwn(CircleField.FRICTION, handle, a);
            case 1 -> simulation.fields.setOwn(CircleField.ROLLING_RESISTANCE, handle, 0.2f * a);
            case 2 -> simulation.fields.setTorque(handle, 0.01f * b);
            case 3 -> simulation.forces.applyTorque(handle, b);
            case 4 -> simulation.circles.setAngle(handle, 9 * b);
            case 5 -> simulation.circles.setAngularVelocity(handle, 20 * b);
            case 6 -> simulation.circles.applyAngularImpulse(handle, 0.01f * b);
            default -> simulation.circles.setKind(handle, (int) (8 * a) % 3);
        }
    }

    /** Changes terrain in some way: pieces, bodies, kinds that are one-way. */
    void changeTerrain(SplittableRandom random) {
        Bounds bounds = simulations[0].settings().bounds();
        float width = bounds.maxX() - bounds.minX();
        float x = between(random, bounds.minX(), bounds.maxX());
        float y = between(random, bounds.minY(), bounds.maxY());
        float length = between(random, 0.05f, 0.3f) * width;
        float angle = between(random, -3, 3);
        float bend = between(random, -2, 2);
        float velocity = random.nextInt(3) == 0 ? 0 : between(random, -1, 1);
        int kind = random.nextInt(3);
        int change = random.nextInt(14);
        long body = anyBody(random);
        long piece = anyPiece(random);
        for (Simulation simulation : simulations) {
            changeTerrain(simulation, change, body, piece, kind, x, y, length, angle, bend, velocity);
        }
    }

    private static void changeTerrain(
            Simulation simulation,
            int change,
            long body,
            long piece,
            int kind,
            float x,
            float y,
            float length,
            float angle,
            float bend,
            float velocity) {
        Pieces pieces = simulation.pieces;
        Bodies bodies = simulation.bodies;
        boolean ground = body == bodies.ground();
        float toX = x + length * (float) Math.cos(angle);
        float toY = y + length * (float) Math.sin(angle);
        // in the coordinates of a body
        float atX = ground ? x : 0.1f * velocity;
        float atY = ground ? y : -0.2f * velocity;
        switch (change) {
            case 0, 1, 2 ->
                pieces.addSegment(body, kind, atX, atY, atX + toX - x, atY + toY - y, change * 0.1f * length);
            case 3 -> pieces.addArc(body, kind, atX, atY, length, angle, angle + 2 + bend, bend > 0);
            case 4, 5 -> {
                ChainPath chain = new ChainPath(atX, atY);
                chain.lineTo(atX + length, atY + 0.5f * bend * length);
                chain.arcTo(atX + length, atY + length + bend * length, bend < 0 ? bend - 0.1f : bend + 0.1f);
                chain.lineTo(atX + 2 * length, atY - length);
                if (bend > 1) {
                    chain.close();
                }
                pieces.addChain(body, chain, kind, null);
            }
            case 6 -> bodies.add(x, y, angle);
            case 7 -> remove(simulation, body, piece, bend > 1);
            case 8 -> simulation.kinds.set(KindField.ONE_WAY, kind, bend > 1 ? 1 : 0);
            case 9 -> {
                if (piece != 0) {
                    simulation.calls.change(Call.PIECE_KIND, piece, kind, 0, 0);
                }
            }
            default -> {
                if (!ground) {
                    moveBody(simulation, change, body, x, y, angle, length, bend, velocity);
                }
            }
        }
    }

    private static void remove(Simulation simulation, long body, long piece, boolean withBody) {
        if (withBody && body != simulation.bodies.ground()) {
            simulation.calls.change(Call.REMOVE_BODY, body);
        } else if (piece != 0) {
            simulation.calls.change(Call.REMOVE_PIECE, piece);
        }
    }

    private static void moveBody(
            Simulation simulation,
            int change,
            long body,
            float x,
            float y,
            float angle,
            float length,
            float bend,
            float velocity) {
        Bodies bodies = simulation.bodies;
        switch (change) {
            case 10 -> simulation.calls.changeByFloats(Call.BODY_VELOCITY, body, velocity, bend * velocity, 0, 0);
            case 11 -> simulation.calls.changeByFloats(Call.BODY_ANGULAR_VELOCITY, body, 5 * velocity, 0, 0, 0);
            case 12 -> {
                float toX = bodies.x(body) + 0.3f * length;
                simulation.calls.changeByFloats(Call.MOVE_BODY, body, toX, bodies.y(body), angle, 0);
            }
            default -> simulation.calls.changeByFloats(Call.TELEPORT_BODY, body, x, y, angle, 0);
        }
    }

    private long anyBody(SplittableRandom random) {
        IdReads bodies = simulations[0].bodyIds;
        long body = bodies.handle(random.nextInt(bodies.limit()));
        return random.nextInt(3) == 0 || body == 0 ? simulations[0].bodies.ground() : body;
    }

    /** Adds a joint, changes or removes one; of a circle of a low id, so that it has many. Some calls are refused. */
    void changeJoints(SplittableRandom random) {
        long circle = handles[random.nextInt(3) == 0 ? random.nextInt(3) : random.nextInt(ids)];
        long other = handles[random.nextInt(ids)];
        long body = anyBody(random);
        long seed = random.nextLong();
        Boolean done = null;
        for (Simulation simulation : simulations) {
            RandomJoints joints = new RandomJoints(simulation, new SplittableRandom(seed), turns);
            boolean isDone = joints.change(circle, other, body);
            assertThat(done == null || done == isDone).isTrue();
            done = isDone;
        }
    }

    /** Number of joints. */
    int joints() {
        return simulations[0].jointIds.size();
    }

    /** 0 if there is none. */
    private long anyPiece(SplittableRandom random) {
        IdReads pieces = simulations[0].pieceIds;
        return pieces.limit() == 0 ? 0 : pieces.handle(random.nextInt(pieces.limit()));
    }

    private static float surface(SplittableRandom random) {
        return random.nextInt(4) == 0 ? 0 : between(random, 0, 1);
    }

    /** Begins to turn and ends with the surfaces that all circles had before. */
    void turnWithoutGrip() {
        for (Simulation simulation : simulations) {
            simulation.fields.setOwn(CircleField.FRICTION, handles[0], 1);
            simulation.fields.set(CircleField.FRICTION, handles[0], CircleField.FRICTION.initial());
        }
    }

    long hash() {
        return simulations[0].hash();
    }

    void assertSameTurns(String when) {
        int n = simulations[0].circles.idLimit();
        float[] angles = new float[n];
        float[] velocities = new float[n];
        simulations[0].readings.readAnglesById(angles, null);
        simulations[0].readings.readAngularVelocitiesById(velocities, null);
        for (Simulation simulation : simulations) {
            float[] read = new float[n];
            simulation.readings.readAnglesById(read, null);
            assertThat(read).as(when).isEqualTo(angles);
            simulation.readings.readAngularVelocitiesById(read, null);
            assertThat(read).as(when).isEqualTo(velocities);
        }
    }

    /** Turns the circle that had an id last, and changes the surfaces of a kind and of a wall. */
    private void turn(int id, SplittableRandom random) {
        float angle = between(random, -9, 9);
        float velocity = between(random, -9, 9);
        float impulse = between(random, -1, 1);
        long[] some = random.ints(5, 0, ids).mapToLong(k -> handles[k]).toArray();
        float[] velocities = {velocity, -velocity, 0, angle, impulse};
        int kind = random.nextInt(4) == 0 ? 255 : random.nextInt(2);
        int wall = random.nextInt(4);
        float friction = random.nextInt(4) == 0 ? Float.NaN : between(random, 0, 1);
        float resistance = between(random, 0, 0.5f);
        int inertia = random.nextInt(3);
        for (Simulation simulation : simulations) {
            if (lives(id)) {
                simulation.circles.setAngle(handles[id], angle);
                simulation.circles.setAngularVelocity(handles[id], velocity);
                simulation.circles.applyAngularImpulse(handles[id], impulse);
            }
            simulation.bulk.setAngularVelocities(some, some.length, velocities, true);
            simulation.kinds.set(KindField.FRICTION, kind, friction);
            simulation.kinds.set(KindField.ROLLING_RESISTANCE, kind, resistance);
            simulation.kinds.set(KindField.BELT_SPEED, kind, impulse);
            simulation.kinds.set(KindField.INERTIA, kind, inertia);
            simulation.kinds.set(KindField.ANGULAR_DAMPING, kind, resistance);
            setWall(simulation, wall, resistance, resistance, impulse);
        }
    }

    /** Lets the circle that had an id last grow or shrink. */
    private void grow(int id, float radius, int steps) {
        if (lives(id)) {
            each(simulation ->
                    simulation.calls.change(Call.GROW, handles[id], Float.floatToRawIntBits(radius), steps, 0));
        }
    }

    /** Changes what a kind is, or what two kinds do to each other. */
    private void changeKinds(SplittableRandom random) {
        int kind = random.nextInt(4) == 0 ? 255 : random.nextInt(2);
        int other = random.nextInt(4) == 0 ? 255 : random.nextInt(2);
        int setting = random.nextInt(4);
        int mask = random.nextInt(4) - 1;
        int category = 1 << random.nextInt(2);
        int sensor = random.nextInt(4) == 0 ? 1 : 0;
        boolean byMatrix = random.nextBoolean();
        float scale = between(random, -1, 2);
        float damping = random.nextInt(2) == 0 ? 0 : between(random, 0, 5);
        float most = random.nextInt(2) == 0 ? Float.POSITIVE_INFINITY : between(random, 0, 5);
        for (Simulation simulation : simulations) {
            simulation.kinds.set(KindField.GRAVITY_SCALE, kind, scale);
            simulation.kinds.set(KindField.DAMPING, kind, damping);
            simulation.kinds.set(KindField.GREATEST_SPEED, kind, most);
            if (byMatrix) {
                simulation.kinds.setSetting(kind, other, setting);
            } else {
                simulation.kinds.set(KindField.MASK, kind, mask);
                simulation.kinds.set(KindField.CATEGORY, kind, category);
                simulation.kinds.set(KindField.SENSOR, kind, sensor);
            }
            simulation.kinds.set(KindField.SENSES_STATIC, kind, mask & 1);
        }
    }

    /** Makes a change of some circles at once, of which some may be gone, and now and then an explosion. */
    private void changeSome(Bounds bounds, SplittableRandom random) {
        int call = random.nextInt(5);
        long[] some = random.ints(5, 0, ids).mapToLong(id -> handles[id]).toArray();
        float[] values = new float[2 * some.length];
        for (int k = 0; k < values.length; k++) {
            values[k] = k % 2 == 0
                    ? between(random, bounds.minX(), bounds.maxX())
                    : between(random, bounds.minY(), bounds.maxY());
        }
        int[] kinds = random.ints(some.length, 0, 3).toArray();
        boolean explodes = random.nextInt(50) == 0;
        float reach = between(random, 0, bounds.maxX() - bounds.minX());
        for (Simulation simulation : simulations) {
            BulkChanges bulk = simulation.bulk;
            switch (call) {
                case 0 -> bulk.setPositions(some, some.length, values, true);
                case 1 -> bulk.setVelocities(some, some.length, values, true);
                case 2 -> bulk.setForces(some, some.length, values, true);
                case 3 -> bulk.setKinds(some, some.length, kinds, true);
                default -> bulk.applyImpulses(some, some.length, values, true);
            }
            if (explodes) {
                bulk.explode(false, 0, values[0], values[1], 0.3f * reach, reach, 0.7f * reach);
            }
        }
    }

    /** Makes some circles ignore others, by kind and by group, and some move by their kind; some become static. */
    void giveKinds() {
        for (Simulation simulation : simulations) {
            for (int id = 0; id < ids; id++) {
                if (lives(id)) {
                    simulation.circles.setKind(handles[id], id % 3 == 0 ? 200 : id % 2);
                    if (id % 11 == 0) {
                        simulation.circles.set(Commands.MASS, handles[id], Float.POSITIVE_INFINITY, 0);
                    }
                    if (id % 7 == 0) {
                        simulation.circles.setForce(handles[id], 0.5f, -1);
                        simulation.forces.apply(handles[id], -3, 0.25f);
                    }
                    simulation.fields.set(CircleField.GROUP, handles[id], id % 5 == 0 ? -3 : 0);
                }
            }
            simulation.kinds.setSetting(1, 200, KindTable.RESPONSE + PairTable.IGNORE);
            simulation.kinds.set(KindField.MASK, 0, ~2);
            simulation.kinds.set(KindField.CATEGORY, 200, 2);
            simulation.kinds.set(KindField.GRAVITY_SCALE, 200, -0.5f);
            simulation.kinds.set(KindField.DAMPING, 200, 0.5f);
            simulation.kinds.set(KindField.DAMPING, 0, 0.25f);
            simulation.kinds.set(KindField.GREATEST_SPEED, 1, 2f);
        }
    }

    /** Makes some circles move in another way than others of their kind. */
    void giveMotions() {
        for (Simulation simulation : simulations) {
            for (int id = 0; id < ids; id++) {
                if (lives(id)) {
                    giveMotion(simulation, id);
                }
            }
        }
    }

    private void giveMotion(Simulation simulation, int id) {
        if (id % 4 == 1) {
            simulation.fields.setOwn(CircleField.GRAVITY_SCALE, handles[id], 0.25f * (id % 12 - 4));
        }
        if (id % 6 == 1) {
            simulation.fields.setOwn(CircleField.DAMPING, handles[id], id % 9);
        }
        if (id % 10 == 1) {
            simulation.fields.setOwn(CircleField.GREATEST_SPEED, handles[id], id % 3 == 0 ? 0.125f : 1e9f);
        }
    }

    /** Gives the circle that had an id last the allowed value that is nearest to a number. */
    private void setField(CircleField field, int id, long number) {
        if (lives(id)) {
            float asFloat = (int) (number % 64) / 16f;
            boolean isPositive = field.isFloat() && field.least() >= 0;
            long value = field.isFloat()
                    ? Float.floatToIntBits(isPositive ? Math.abs(asFloat) : asFloat)
                    : Math.max(field.least(), Math.min(number, field.greatest()));
            for (Simulation simulation : simulations) {
                if (field == CircleField.APPLIED_X || field == CircleField.APPLIED_Y) {
                    simulation.forces.apply(handles[id], Float.intBitsToFloat((int) value), 0.5f);
                    continue;
                }
                if (field == CircleField.APPLIED_TORQUE) {
                    simulation.forces.applyTorque(handles[id], Float.intBitsToFloat((int) value));
                    continue;
                }
                simulation.fields.set(field, handles[id], value);
            }
        }
    }

    private boolean lives(int id) {
        return simulations[0].circles.contains(handles[id]);
    }

    private static float between(SplittableRandom random, float low, float high) {
        return low + (float) random.nextDouble() * (high - low);
    }

    @Override
    public void close() {
        each(simulation -> simulation.close());
    }
}
