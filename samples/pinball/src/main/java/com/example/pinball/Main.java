package com.example.pinball;

import com.badlogic.gdx.ApplicationAdapter;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3Application;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3ApplicationConfiguration;
import com.badlogic.gdx.files.FileHandle;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.GL20;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.PixmapIO;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import com.badlogic.gdx.graphics.glutils.ShapeRenderer;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.utils.GdxRuntimeException;
import com.badlogic.gdx.utils.ScreenUtils;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Terrain;
import io.github.circles2d.opencl.OpenClException;
import java.io.OutputStream;
import java.io.PrintStream;

/** A window to play in; or with {@code --frames N} a game that plays itself, and one line of what became of it. */
public final class Main extends ApplicationAdapter {
    private static final int FRAME = 110; // pixels of a screen for a title and a bar of tasks
    private static final int WIDTH = 540, HEIGHT = 864, SCALE = 45; // pixels, and pixels for a length of 1
    private static final String[] COLORS = {"7c6cf2", "e8ecff", "ff4d8d", "ffd166", "4dd2ff", "ff4d8d", "ffb347"
    }; // by kind
    private final Options options;
    private final float[] pieces = new float[100 * Terrain.PIECE_STRIDE];
    private final long[] handles = new long[100];
    private Pinball game;
    private FixedStep loop;
    private ShapeRenderer shapes;
    private SpriteBatch batch;
    private BitmapFont font;

    private Main(Options options) {
        this.options = options;
        start();
    }

    private void start() {
        game = new Pinball(options.backend());
        loop = new FixedStep(game.world, Pinball.STEP);
    }

    public static void main(String[] arguments) {
        Options options = Options.read(arguments);
        try {
            Main main = new Main(options);
            for (int frame = 0; frame < options.frames(); frame++) {
                main.game.playAlone(frame);
                main.loop.advance(1 / 60f, main.game);
            }
            if (options.frames() > 0) {
                String format = "pinball: %d frames, %d points, hash %016x%n";
                System.out.printf(format, options.frames(), main.game.score, main.game.world.hash());
            }
            if (options.frames() == 0 || !options.picture().isEmpty()) { // a picture needs a window, too
                main.open();
            }
            main.game.world.close();
        } catch (OpenClException e) { // no such device, or its driver fails
            Options.end(1, e.getMessage());
        }
    }

    /** Returns when the window has been closed. */
    private void open() {
        Lwjgl3ApplicationConfiguration.errorStream = new PrintStream(OutputStream.nullOutputStream()); // stack traces
        Lwjgl3ApplicationConfiguration configuration = new Lwjgl3ApplicationConfiguration();
        configuration.setTitle("Pinball: left, right, and space to pull the plunger");
        configuration.setResizable(false);
        configuration.setBackBufferConfig(8, 8, 8, 8, 16, 0, 4); // smooth edges
        configuration.disableAudio(true);
        configuration.setInitialVisible(options.frames() == 0);
        try {
            int room = options.frames() == 0 ? Lwjgl3ApplicationConfiguration.getDisplayMode().height - FRAME : HEIGHT;
            int height = Math.min(HEIGHT, room);
            configuration.setWindowedMode(WIDTH * height / HEIGHT, height);
            new Lwjgl3Application(this, configuration);
        } catch (GdxRuntimeException e) {
            if (shapes != null) {
                throw e;
            }
            String why = "no window can be shown here: " + e.getMessage();
            Options.end(1, why, "without a display, it plays by itself: --frames 300");
        }
    }

    @Override
    public void create() {
        shapes = new ShapeRenderer();
        batch = new SpriteBatch();
        font = new BitmapFont();
        font.getData().setScale(1.5f);
        if (!options.picture().isEmpty()) {
            draw();
            Pixmap pixels = Pixmap.createFromFrameBuffer(0, 0, WIDTH, HEIGHT);
            try {
                PixmapIO.writePNG(new FileHandle(options.picture()), pixels, 9, true);
            } catch (GdxRuntimeException e) {
                Options.end(1, "cannot write " + options.picture() + ": " + e.getCause());
            }
            Gdx.app.exit();
        }
    }

    @Override
    public void render() {
        if (Gdx.input.isKeyJustPressed(Keys.SPACE) && game.isOver()) {
            game.world.close();
            start();
        }
        game.isLeftUp = Gdx.input.isKeyPressed(Keys.LEFT);
        game.isRightUp = Gdx.input.isKeyPressed(Keys.RIGHT);
        game.isPulled = Gdx.input.isKeyPressed(Keys.SPACE);
        loop.advance(Gdx.graphics.getDeltaTime(), game);
        draw();
    }

    private void draw() {
        ScreenUtils.clear(Color.valueOf("0b0719"));
        Gdx.gl.glEnable(GL20.GL_BLEND);
        Gdx.gl.glBlendFunc(GL20.GL_SRC_ALPHA, GL20.GL_ONE_MINUS_SRC_ALPHA);
        Gdx.gl.glColorMask(true, true, true, false); // a picture is opaque
        shapes.getProjectionMatrix().setToOrtho2D(-0.5f, -0.5f, (float) WIDTH / SCALE, (float) HEIGHT / SCALE);
        shapes.begin(ShapeRenderer.ShapeType.Filled);
        paint("1a1040", 1);
        shapes.rect(0, -1, 2 * Pinball.MIDDLE, Pinball.TOP + 1);
        disc("1a1040", 1, Pinball.MIDDLE, Pinball.TOP, Pinball.MIDDLE);
        for (int k = 0; k < 10; k++) { // light behind the bumpers
            disc("ff4d8d", 0.025f, Pinball.MIDDLE, 11.4f, 4.3f - 0.4f * k);
        }
        disc("0b0719", 1, -0.6f, 8.4f, 1.52f); // the bulge of the outline
        paint("ff4d8d", 0.3f);
        shapes.triangle(2, 6, 2, 4.5f, 3.2f, 3.75f);
        shapes.triangle(8, 6, 8, 4.5f, 6.8f, 3.75f);
        int count = loop.pieces(pieces, handles);
        for (int k = 0; k < count; k++) {
            piece(k * Terrain.PIECE_STRIDE, Terrain.id(handles[k]));
        }
        var positions = loop.positions(null);
        for (int id = 0; id < game.world.idLimit(); id++) {
            if (game.world.handle(id) != 0) {
                ball(game.world.handle(id), positions.get(2 * id), positions.get(2 * id + 1));
            }
        }
        shapes.end();
        batch.begin();
        String state = game.isOver() ? "\nspace: play again" : "\nball " + (4 - game.balls);
        font.draw(batch, game.score + state, 16, Gdx.graphics.getHeight() - 16);
        batch.end();
    }

    private void piece(int row, int id) {
        int kind = (int) pieces[row + Terrain.KIND];
        float glow = game.glow[id];
        boolean isDark = kind == Pinball.LIGHT && !game.isOn(id);
        if (pieces[row + Terrain.FORM] == Terrain.ARC) {
            arc(row, kind, glow);
            return;
        }
        float x = pieces[row + Terrain.X1], y = pieces[row + Terrain.Y1];
        float x2 = pieces[row + Terrain.X2], y2 = pieces[row + Terrain.Y2];
        if (pieces[row + Terrain.FORM] == Terrain.SEGMENT) {
            float thickness = pieces[row + Terrain.THICKNESS];
            capsule(COLORS[kind], 0.12f + 0.4f * glow, x, y, x2, y2, 2 * thickness);
            capsule(COLORS[kind], isDark ? 0.3f : 1, x, y, x2, y2, thickness);
        } else { // a line of a chain: its left is solid
            float factor = 0.06f / (float) Math.hypot(x2 - x, y2 - y);
            float left = (y - y2) * factor, up = (x2 - x) * factor;
            capsule(COLORS[kind], 1, x + left, y + up, x2 + left, y2 + up, 0.06f);
        }
    }

    private void arc(int row, int kind, float glow) {
        float x = pieces[row + Terrain.CENTRE_X], y = pieces[row + Terrain.CENTRE_Y], r = pieces[row + Terrain.RADIUS];
        if (kind == Pinball.BUMPER) {
            for (int k = 0; k < 5; k++) {
                float alpha = k == 0 ? 0.4f * glow : k == 3 ? 0.3f + 0.7f * glow : 1;
                disc(k % 2 == 0 ? COLORS[kind] : "ffffff", alpha, x, y, r * (k == 0 ? 1.3f : 1.35f - 0.3f * k));
            }
            return;
        }
        float from = pieces[row + Terrain.FROM], part = (pieces[row + Terrain.TO] - from) / 48;
        float radius = r + (pieces[row + Terrain.INSIDE] == 1 ? 0.06f : -0.06f);
        float toX = x + radius * MathUtils.cos(from), toY = y + radius * MathUtils.sin(from);
        for (int k = 1; k <= 48; k++) {
            float fromX = toX, fromY = toY;
            toX = x + radius * MathUtils.cos(from + k * part);
            toY = y + radius * MathUtils.sin(from + k * part);
            capsule(COLORS[kind], 1, fromX, fromY, toX, toY, 0.06f);
        }
    }

    private void ball(long ball, float x, float y) {
        float r = Pinball.RADIUS, vx = game.world.vx(ball), vy = game.world.vy(ball);
        for (int k = 12; k > 0; k--) { // where it has been
            disc("4dd2ff", 0.06f, x - 0.004f * k * vx, y - 0.004f * k * vy, r * (1 - 0.05f * k));
        }
        disc("8f9ccf", 1, x, y, r);
        disc("d7def7", 1, x - 0.03f, y + 0.03f, 0.8f * r);
        disc("ffffff", 1, x - 0.08f, y + 0.08f, 0.35f * r);
    }

    private void capsule(String color, float alpha, float x1, float y1, float x2, float y2, float thickness) {
        paint(color, alpha);
        shapes.rectLine(x1, y1, x2, y2, 2 * thickness);
        shapes.circle(x1, y1, thickness, 24);
        shapes.circle(x2, y2, thickness, 24);
    }

    private void disc(String color, float alpha, float x, float y, float radius) {
        paint(color, alpha);
        shapes.circle(x, y, radius, 96);
    }

    private void paint(String color, float alpha) {
        shapes.setColor(Color.valueOf(color).mul(1, 1, 1, alpha));
    }
}
