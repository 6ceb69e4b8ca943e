package com.example.platformer;

import com.badlogic.gdx.ApplicationAdapter;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3Application;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3ApplicationConfiguration;
import com.badlogic.gdx.files.FileHandle;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.PixmapIO;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import com.badlogic.gdx.graphics.glutils.ShapeRenderer;
import com.badlogic.gdx.utils.GdxRuntimeException;
import com.badlogic.gdx.utils.ScreenUtils;
import io.github.circles2d.Bodies;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Terrain;
import io.github.circles2d.opencl.OpenClException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.util.Locale;

/** A window to play in; or with {@code --frames N} a game that plays itself, and one line of what became of it. */
public final class Main extends ApplicationAdapter {
    private static final int WIDTH = 1200, HEIGHT = 620, SCALE = 30; // pixels, and pixels for a length of 1
    private final Options options;
    private final Platformer game;
    private final FixedStep loop;
    private final float[] pieces = new float[60 * Terrain.PIECE_STRIDE];
    private final float[] poses = new float[3 * 20];
    private ShapeRenderer shapes;
    private SpriteBatch batch;
    private BitmapFont font;

    private Main(Options options) {
        this.options = options;
        game = new Platformer(options.backend());
        loop = new FixedStep(game.world, Platformer.STEP);
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
                float x = main.game.world.x(main.game.hero);
                String format = "platformer: %d frames, x %.1f, hash %016x%n";
                System.out.printf(Locale.ROOT, format, options.frames(), x, main.game.world.hash());
            }
            if (options.frames() == 0 || !options.picture().isEmpty()) { // a picture needs a window, too
                main.open();
            }
            main.game.world.close();
        } catch (OpenClException | UnsupportedOperationException e) { // no such device; or one, which takes no bodies
            Options.end(1, e.getMessage());
        }
    }

    /** Returns when the window has been closed. */
    private void open() {
        Lwjgl3ApplicationConfiguration.errorStream = new PrintStream(OutputStream.nullOutputStream()); // stack traces
        Lwjgl3ApplicationConfiguration configuration = new Lwjgl3ApplicationConfiguration();
        configuration.setTitle("Platformer: arrows; F5 saves, F9 loads");
        configuration.setResizable(false);
        configuration.setBackBufferConfig(8, 8, 8, 8, 16, 0, 4); // smooth edges
        configuration.disableAudio(true);
        configuration.setInitialVisible(options.frames() == 0);
        try {
            configuration.setWindowedMode(WIDTH, HEIGHT);
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
        font.getData().setScale(1.4f);
        font.setColor(Color.valueOf("1d3557"));
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
        game.left = Gdx.input.isKeyPressed(Keys.LEFT);
        game.right = Gdx.input.isKeyPressed(Keys.RIGHT);
        game.jump = Gdx.input.isKeyPressed(Keys.UP) || Gdx.input.isKeyPressed(Keys.SPACE);
        game.down = Gdx.input.isKeyPressed(Keys.DOWN);
        if (Gdx.input.isKeyJustPressed(Keys.F5)) {
            game.save();
        }
        if (Gdx.input.isKeyJustPressed(Keys.F9)) {
            game.load();
            loop.reset(); // or all would fly back
        }
        loop.advance(Gdx.graphics.getDeltaTime(), game);
        draw();
    }

    private void draw() {
        var positions = loop.positions(null);
        float half = WIDTH / 2f / SCALE, x = positions.get(0), y = positions.get(1);
        float middle = Math.min(Math.max(x, half), Platformer.WIDTH - half); // of the camera
        ScreenUtils.clear(Color.valueOf("a8dadc"));
        shapes.getProjectionMatrix().setToOrtho2D(middle - half, -1, 2 * half, (float) HEIGHT / SCALE);
        shapes.begin(ShapeRenderer.ShapeType.Filled);
        for (int k = 0; k < 12; k++) { // hills
            disc(k % 2 == 0 ? "8ecae6" : "95d5b2", 10 * k + middle / 2 - 20, -4, 9 + k % 3);
        }
        bar("e9ecef", Platformer.FLAG, 9, Platformer.FLAG, 14, 0.1f);
        bar("e63946", Platformer.FLAG + 0.4f, 13.5f, Platformer.FLAG + 1.4f, 13.5f, 0.4f);
        for (int k = loop.pieces(pieces, null) - 1; k >= 0; k--) {
            piece(k * Terrain.PIECE_STRIDE);
        }
        bodies();
        for (int id = 1; id < game.world.idLimit(); id++) { // planks
            disc("9c6644", positions.get(2 * id), positions.get(2 * id + 1), 0.3f);
        }
        hero(x, y);
        shapes.end();
        batch.begin();
        String state = x > Platformer.FLAG ? "You made it!" : "arrows: run, jump, drop;  F5, F9: save, load";
        font.draw(batch, state + (game.deaths > 0 ? "   deaths: " + game.deaths : ""), 16, HEIGHT - 16);
        batch.end();
    }

    private void piece(int row) {
        float x = pieces[row + Terrain.X1], y = pieces[row + Terrain.Y1];
        float toX = pieces[row + Terrain.X2], toY = pieces[row + Terrain.Y2];
        if (pieces[row + Terrain.FORM] == Terrain.ARC) {
            disc(
                    "6c757d",
                    pieces[row + Terrain.CENTRE_X],
                    pieces[row + Terrain.CENTRE_Y],
                    pieces[row + Terrain.RADIUS]);
        } else if (pieces[row + Terrain.FORM] == Terrain.SEGMENT) {
            boolean isFloor = pieces[row + Terrain.KIND] == Platformer.FLOOR;
            bar(isFloor ? "bc6c25" : "495057", x, y, toX, toY, pieces[row + Terrain.THICKNESS]);
        } else if (y == toY) { // ground, down to the lower end of the picture, and grass on it
            shapes.setColor(Color.valueOf("774936"));
            shapes.rect(toX, -10, x - toX, y + 10);
            bar("40916c", toX, y - 0.15f, x, y - 0.15f, 0.15f);
        }
    }

    /** Crates and the plank: triangles around the centroid, as these outlines are convex. */
    private void bodies() {
        Bodies bodies = game.world.bodies();
        loop.bodies(poses, null);
        for (int id = 0; id < bodies.idLimit(); id++) {
            float x = poses[3 * id], y = poses[3 * id + 1];
            float cos = (float) Math.cos(poses[3 * id + 2]), sin = (float) Math.sin(poses[3 * id + 2]);
            float[] points = bodies.outline(bodies.handle(id)).points(0.02f);
            float least = bodies.outline(bodies.handle(id)).equals(game.crate) ? 0.8f : 0.9f; // a plank has no frame
            for (float scale = 1; scale > least; scale -= 0.15f) {
                shapes.setColor(Color.valueOf(scale == 1 ? "7f5539" : "ddb892"));
                for (int k = 0; k < points.length; k += 2) {
                    float px = scale * points[k], py = scale * points[k + 1];
                    float qx = scale * points[(k + 2) % points.length], qy = scale * points[(k + 3) % points.length];
                    float toX = x + cos * px - sin * py, toY = y + sin * px + cos * py;
                    shapes.triangle(x, y, toX, toY, x + cos * qx - sin * qy, y + sin * qx + cos * qy);
                }
            }
        }
    }

    private void hero(float x, float y) {
        disc("e63946", x, y, Platformer.RADIUS);
        for (float eye = -0.15f, look = game.left ? -0.12f : 0.12f; eye < 0.2f; eye += 0.3f) {
            disc("ffffff", x + look + eye, y + 0.12f, 0.13f);
            disc("1d3557", x + 1.4f * look + eye, y + 0.12f, 0.06f);
        }
    }

    private void bar(String colour, float x, float y, float toX, float toY, float thickness) {
        shapes.setColor(Color.valueOf(colour));
        shapes.rectLine(x, y, toX, toY, 2 * thickness);
        disc(colour, x, y, thickness);
        disc(colour, toX, toY, thickness);
    }

    private void disc(String colour, float x, float y, float radius) {
        shapes.setColor(Color.valueOf(colour));
        shapes.circle(x, y, radius, 48);
    }
}
