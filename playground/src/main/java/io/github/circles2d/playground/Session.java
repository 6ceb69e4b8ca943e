package io.github.circles2d.playground;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.Consumer;

/** What a person does to a sandbox, and what there is to be seen of it. Belongs to one thread, which is not that of the window. */
final class Session implements AutoCloseable {
    private static final int MESSAGE_FRAMES = 300;
    private static final float SLOWEST = 1 / 16f;

    /** Time that the steps of a frame may take. */
    private static final double FRAME_MILLIS = 14;

    private static final int MOST_STEPS = 4;

    private static final int MOST_SUB_STEPS = 16;

    private final Sandbox sandbox;
    private final Hand hand = new Hand();
    private final Readout readout = new Readout();
    private final Gauges gauges = new Gauges();
    private final Contacts contacts = new Contacts();
    private final Selection selection = new Selection();
    private final StepProfile profile = new StepProfile();
    private final Whereabouts where = new Whereabouts();
    private final Runnable beforeStep;

    private PaintMode paint = PaintMode.SPEED;
    private boolean paused;
    private boolean rewinding;
    private float speed = 1;
    private double stepsOwed;
    private boolean touched;
    private String message = "";
    private int messageFrames;

    Session(Stage stage, Backend backend) {
        sandbox = new Sandbox(stage, backend);
        beforeStep = () -> hand.beforeStep(sandbox);
    }

    Sandbox sandbox() {
        return sandbox;
    }

    World world() {
        return sandbox.world();
    }

    /** Makes what is due after so many seconds, and fills a frame. */
    void frame(float seconds, Frame frame) {
        long start = System.nanoTime();
        int steps = move(seconds);
        if ((paused || rewinding) && touched) {
            sandbox.loop().reset(); // what was done by hand is to be seen at once
        }
        sandbox.loop().positions(null); // waits for the steps
        if (steps > 0) {
            double millis = (System.nanoTime() - start) / 1e6 / steps;
            String news = where.news(sandbox.look());
            gauges.noteStep(millis, !news.isEmpty());
            if (!news.isEmpty()) {
                say(news);
            }
        }
        readout.fill(frame, sandbox, paint);
        contacts.read(world(), steps);
        noteProfile(steps, false);
        contacts.fill(frame, sandbox.grain());
        if (steps > 0) {
            gauges.noteEnergy(frame.energy);
        }
        gauges.rehash(sandbox, steps > 0, touched);
        describe(frame);
        touched = false;
    }

    private int move(float seconds) {
        if (rewinding) {
            stepsOwed += seconds * speed / Sandbox.TIME_STEP;
            for (; stepsOwed >= 1; stepsOwed--) {
                if (!back()) {
                    stepsOwed = 0;
                    break;
                }
                touched = true;
            }
            return 0;
        }
        if (paused) {
            return 0;
        }
        int most = (int) Math.min(Math.max(FRAME_MILLIS / Math.max(gauges.stepMillis(), 1e-3), 1), MOST_STEPS);
        sandbox.loop().setMaxSteps(most);
        return sandbox.advance(seconds, beforeStep);
    }

    private boolean back() {
        boolean went = sandbox.back();
        hand.wentBack(sandbox);
        if (went) {
            contacts.start(world());
        }
        return went;
    }

    private void noteProfile(int steps, boolean now) {
        if (sandbox.isProfiling()) {
            profile.note(world(), steps, now);
        }
    }

    private void describe(Frame frame) {
        frame.stage = sandbox.stage().name();
        frame.asked = sandbox.asked();
        frame.backend = sandbox.stats().backend();
        frame.device = sandbox.stats().device();
        frame.step = sandbox.step();
        frame.paused = paused;
        frame.rewinding = rewinding;
        frame.stepsToRewind = sandbox.stepsToRewind();
        frame.speed = speed;
        frame.tool = hand.kind();
        frame.paint = paint;
        frame.brush = hand.reach(sandbox);
        frame.size = hand.size();
        frame.gravity = sandbox.gravity();
        frame.greatestGravity = sandbox.greatestGravity();
        frame.restitution = sandbox.restitution();
        frame.friction = sandbox.friction();
        frame.canSleep = world().sleeps();
        frame.sleeps = sandbox.sleeps();
        frame.subSteps = world().subSteps();
        frame.rollingResistance = sandbox.rollingResistance();
        frame.marks = hand.marks(sandbox);
        selection.mark(sandbox, frame.marks);
        frame.card = selection.lines(world());
        frame.showsProfile = sandbox.isProfiling();
        frame.profile = profile.parts();
        gauges.show(frame);
        messageFrames = Math.max(0, messageFrames - 1);
        frame.message = messageFrames > 0 ? message : "";
    }

    // ---- what a person does

    void togglePause() {
        paused = !paused;
        touched = true;
    }

    void stepOnce() {
        paused = true;
        long start = System.nanoTime();
        sandbox.stepOnce(beforeStep);
        world().finish();
        contacts.read(world(), 1);
        noteProfile(1, true);
        gauges.noteStep((System.nanoTime() - start) / 1e6, false);
        touched = true;
    }

    void stepBack() {
        paused = true;
        if (!back()) {
            say("there is no earlier step");
        }
        touched = true;
    }

    void setRewinding(boolean on) {
        if (rewinding && !on) {
            stepsOwed = 0;
        }
        rewinding = on;
        touched = true;
    }

    /** Half as fast, down to a sixteenth, and then as fast as at first. */
    void slower() {
        speed = speed <= SLOWEST ? 1 : speed / 2;
        sandbox.loop().setSpeed(speed);
    }

    void normalSpeed() {
        speed = 1;
        sandbox.loop().setSpeed(speed);
    }

    void setPaint(PaintMode mode) {
        paint = mode;
    }

    void nextPaint() {
        paint = paint.next();
    }

    /** Shows the contacts of each step from now on, or not any more. */
    void toggleContacts() {
        contacts.set(world(), !contacts.isOn());
        say(
                contacts.isOn()
                        ? "contacts of each step: the longer the normal, the greater the impulse"
                        : "contacts are not shown");
    }

    /** Shows from now on how the time of a step divides over its stages, or not any more: the world is built anew, in the same state. */
    void toggleProfile() {
        hand.letGo(sandbox);
        sandbox.setProfiling(!sandbox.isProfiling());
        rebuilt();
        say(sandbox.isProfiling() ? "the stages of each step are measured" : "stages are not measured");
    }

    /** Lets circles fall asleep, or keeps them awake. A scene that was made without sleep starts again with it. */
    void toggleSleep() {
        if (world().sleeps()) {
            boolean sleeps = !sandbox.sleeps();
            use(() -> sandbox.setSleeps(sleeps));
            say(sleeps ? "circles that lie still fall asleep, and are dim" : "all circles are awake");
            return;
        }
        hand.letGo(sandbox);
        sandbox.restartWithSleep();
        restarted();
        say(world().sleeps() ? "circles may fall asleep, from the start" : "a saved world keeps its circles awake");
    }

    /** How large circles are that are poured, in those that are usual in the world. */
    void setSize(float factor) {
        hand.setSize(factor);
    }

    void setGravity(float strength) {
        use(() -> sandbox.setGravity(strength));
    }

    void setRestitution(float restitution) {
        use(() -> sandbox.setRestitution(restitution));
    }

    void setFriction(float friction) {
        use(() -> sandbox.setSurface(friction, sandbox.rollingResistance()));
    }

    void setRollingResistance(float resistance) {
        use(() -> sandbox.setSurface(sandbox.friction(), resistance));
    }

    void setTool(ToolKind kind) {
        hand.take(sandbox, kind);
    }

    void press(float x, float y) {
        use(() -> hand.press(sandbox, x, y));
        if (hand.kind() == ToolKind.GRAB) {
            selection.set(held());
        }
    }

    void moveMouse(float x, float y) {
        hand.move(sandbox, x, y);
        touched |= hand.isPressed();
    }

    void release() {
        use(() -> hand.release(sandbox));
    }

    void explode() {
        use(() -> hand.explode(sandbox));
    }

    void pour(boolean on) {
        hand.pour(sandbox, on);
    }

    void scaleBrush(int notches) {
        hand.scaleBrush(notches);
    }

    /** What is held by the tool that grabs; 0 if nothing is. */
    long held() {
        return ((GrabTool) hand.tool(ToolKind.GRAB)).held();
    }

    private void use(Runnable action) {
        action.run();
        touched = true;
        String news = sandbox.takeNews();
        if (!news.isEmpty()) {
            say(news);
        }
    }

    void load(Stage stage) {
        hand.letGo(sandbox);
        sandbox.load(stage, sandbox.asked());
        restarted();
        sayStage();
    }

    void restart() {
        hand.letGo(sandbox);
        sandbox.restart();
        restarted();
        sayStage();
    }

    /** Starts again with so many sub-steps more, or fewer. */
    void addSubSteps(int more) {
        int wished = Math.min(Math.max(world().subSteps() + more, 1), MOST_SUB_STEPS);
        hand.letGo(sandbox);
        sandbox.restart(wished);
        restarted();
        boolean taken = world().subSteps() == wished;
        say(taken ? wished + " sub-steps a step, from the start" : "a saved world keeps its sub-steps");
    }

    private void sayStage() {
        String note = StageNotes.of(sandbox.stage().name());
        say(note.isEmpty() ? sandbox.stage().name() : note);
    }

    /** Goes on with another back end, and says whether the hash is the same. */
    void switchTo(Backend backend) {
        hand.letGo(sandbox); // terrain that is held belongs to the old world
        long before = world().hash();
        sandbox.switchTo(backend);
        rebuilt();
        long hash = gauges.hashNow(sandbox);
        say(String.format(
                Locale.ROOT,
                "%s goes on from step %,d: hash %016x, %s",
                Whereabouts.words(backend, sandbox.stats().backend()),
                sandbox.step(),
                hash,
                hash == before ? "the same" : String.format("and not %016x", before)));
    }

    void save(Path file) {
        hand.letGo(sandbox); // the saved world has no hand in it
        attempt("saved " + file.getFileName(), () -> sandbox.save(file));
    }

    void open(Path file) {
        hand.letGo(sandbox);
        attempt("opened " + file.getFileName(), () -> {
            sandbox.open(file);
            hand.forget();
            restarted();
        });
    }

    /** The world as the fragment of a link. */
    String link() {
        hand.letGo(sandbox);
        return WorldLink.of(sandbox.snapshot().array());
    }

    private void restarted() {
        rebuilt();
        gauges.forget();
        selection.set(0);
        rewinding = false;
    }

    /** Another world has come, with the same state or another. */
    private void rebuilt() {
        sandbox.loop().setSpeed(speed);
        contacts.start(world());
        profile.start(sandbox.stats().stageMillis());
        where.start(sandbox.stats());
        gauges.forgetTimes();
        touched = true;
    }

    /** Shows a line for some seconds. */
    void say(String text) {
        message = text;
        messageFrames = MESSAGE_FRAMES;
    }

    /** What reads or writes a file. */
    private interface FileWork {
        void run() throws IOException;
    }

    private void attempt(String success, FileWork work) {
        try {
            work.run();
            say(success);
        } catch (IOException | IllegalArgumentException e) {
            say("not done: " + FileFailure.reason(e));
        }
    }

    /** Makes what a person asks for; if it fails, says why, and goes on. */
    void obey(Consumer<Session> command) {
        try {
            command.accept(this);
        } catch (RuntimeException e) {
            String reason = e.getMessage() == null ? e.toString() : e.getMessage();
            say("not done: " + reason.lines().findFirst().orElse(""));
        }
    }

    /** After a failure that has cost the state: the stage from the start, on the JVM; if memory was short, one that needs none. */
    void recover(Throwable failure) {
        hand.forget();
        boolean small = failure instanceof OutOfMemoryError;
        sandbox.load(small ? Stages.named("empty") : sandbox.stage(), Backend.JVM);
        restarted();
        say("from the start on the JVM, after a failure: " + (small ? "too little memory" : failure.getMessage()));
    }

    @Override
    public void close() {
        sandbox.close();
    }
}
