package io.github.circles2d.demo;

import io.github.circles2d.Circles2D;
import io.github.circles2d.opencl.Device;
import io.github.circles2d.opencl.OpenClException;
import io.github.circles2d.scenes.Scene;
import java.io.IOException;
import java.util.List;
import java.util.Locale;

/** {@link Circles2D}, the engine of the thesis, as the demo sees it. */
final class Circles2DEngine implements Engine {
    private static final List<String> STRATEGIES = List.of(
            "strategy 0 (computed)", "strategy 1 (look-up table)", "strategy 2 (row search)", "strategy 3 (exact)");

    private final Circles2D circles2d;
    private final Scene scene;
    private final float restitution;
    private final float[] gravity;
    private int strategy;
    private float[][] now;

    private Circles2DEngine(Circles2D circles2d, Scene scene, Options options) {
        this.circles2d = circles2d;
        this.scene = scene;
        this.restitution = options.restitution();
        this.gravity = new float[] {options.gravityX(), options.gravityY()};
    }

    static Circles2DEngine open(Options options) throws EngineException {
        Scene scene = options.scene();
        Circles2D circles2d = null;
        try {
            circles2d = new Circles2D(DeviceChoice.find(options.device()));
            Circles2DEngine engine = new Circles2DEngine(circles2d, scene, options);
            engine.start(options.strategy());
            circles2d = null;
            return engine;
        } catch (OpenClException e) {
            throw new EngineException(e.getMessage(), e);
        } finally {
            if (circles2d != null) {
                circles2d.close();
            }
        }
    }

    @Override
    public float[][] loop() throws EngineException {
        try {
            now = circles2d.loop();
            return now;
        } catch (OpenClException
                | IllegalStateException e) { // the latter after a switch that the driver let down half-way
            throw new EngineException(e.getMessage(), e);
        }
    }

    @Override
    public float[][] circles() {
        return now;
    }

    @Override
    public void restart() throws EngineException {
        start(strategy);
    }

    @Override
    public String name() {
        return "Circles2D";
    }

    @Override
    public String device() {
        Device device = circles2d.device();
        return device.name() + " (" + device.kind() + ", " + device.platform() + ")";
    }

    @Override
    public List<String> strategies() {
        return STRATEGIES;
    }

    @Override
    public int strategy() {
        return strategy;
    }

    @Override
    public void switchTo(int wanted) throws EngineException {
        try {
            load(now, circles2d.velocities(), wanted);
        } catch (OpenClException e) {
            throw new EngineException(e.getMessage(), e);
        }
    }

    @Override
    public String remark() {
        long wrong = circles2d.wrongSlots();
        return wrong == 0 ? "" : String.format(Locale.ROOT, "%,d slots are mapped to a wrong pair", wrong);
    }

    @Override
    public void close() {
        circles2d.close();
    }

    private void start(int wanted) throws EngineException {
        float[][] circles = {scene.x(), scene.y(), scene.radius(), scene.mass()};
        load(circles, new float[][] {scene.vx(), scene.vy()}, wanted);
        now = circles;
    }

    private void load(float[][] circles, float[][] velocities, int wanted) throws EngineException {
        try {
            circles2d.clear();
            for (int k = 0; k < circles[0].length; k++) {
                circles2d.addCircle(
                        circles[0][k], circles[1][k], circles[2][k], circles[3][k], velocities[0][k], velocities[1][k]);
            }
            circles2d.init(Options.TIME_STEP, wanted, restitution, gravity);
            strategy = wanted;
        } catch (OpenClException | IOException | IllegalArgumentException e) {
            throw new EngineException(e.getMessage(), e);
        }
    }
}
