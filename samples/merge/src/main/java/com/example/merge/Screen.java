package com.example.merge;

import com.badlogic.gdx.ApplicationAdapter;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input;
import com.badlogic.gdx.files.FileHandle;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.PixmapIO;
import com.badlogic.gdx.graphics.Texture;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.utils.ScreenUtils;
import com.badlogic.gdx.utils.viewport.FitViewport;
import io.github.circles2d.Backend;
import io.github.circles2d.FixedStep;
import io.github.circles2d.World;
import java.nio.FloatBuffer;
import java.util.zip.Deflater;

/** Draws the game, and makes the mouse its controls. */
final class Screen extends ApplicationAdapter {
    private static final Color BACKGROUND = Color.valueOf("fdf0d5");
    private static final Color BOX = Color.valueOf("fff8ea");
    private static final Color WALL = Color.valueOf("c9975b");
    private static final Color INK = Color.valueOf("6b4226");
    private static final Color LINE = Color.valueOf("e76f5180");
    private static final Color[] BALLS = colors(
            "e63946", "f4845f", "9d4edd", "f6bd60", "f77f00", "ef476f", "b5c95a", "f9a8c9", "ffd60a", "80c06b",
            "2a9d8f");

    private final Backend backend;
    private final int frames;
    private final String picture;
    private final FitViewport viewport = new FitViewport(12, 16);
    private final Vector2 mouse = new Vector2();
    private final Label scoreLabel = new Label(1.3f);
    private final Label bestLabel = new Label(0.8f);
    private final Label overLabel = new Label(0.6f);

    private Merge game;
    private FixedStep loop;
    private int best;
    private SpriteBatch batch;
    private Texture ball;
    private Texture face;
    private Texture square;

    /** @param picture the file of a picture to take after so many frames, and of nothing else; null to play */
    Screen(Backend backend, int frames, String picture) {
        this.backend = backend;
        this.frames = frames;
        this.picture = picture;
    }

    private static Color[] colors(String... names) {
        Color[] colors = new Color[names.length];
        for (int k = 0; k < names.length; k++) {
            colors[k] = Color.valueOf(names[k]);
        }
        return colors;
    }

    @Override
    public void create() {
        batch = new SpriteBatch();
        ball = Textures.ball();
        face = Textures.face();
        square = Textures.square();
        start(picture == null ? System.nanoTime() : 1);
        if (picture != null) {
            Main.playAlone(game, frames);
            loop.reset();
        }
    }

    private void start(long seed) {
        if (game != null) {
            game.close();
        }
        game = new Merge(backend, seed);
        loop = new FixedStep(game.world, Merge.TIME_STEP);
    }

    @Override
    public void resize(int width, int height) {
        viewport.update(width, height, true);
    }

    @Override
    public void render() {
        if (picture == null) {
            play();
        }
        ScreenUtils.clear(BACKGROUND);
        viewport.getCamera().position.set(Merge.WIDTH / 2, 7.2f, 0);
        viewport.apply();
        batch.setProjectionMatrix(viewport.getCamera().combined);
        batch.begin();
        drawBox();
        drawBalls();
        drawText();
        batch.end();
        if (picture != null) {
            Pixmap pixels = Pixmap.createFromFrameBuffer(
                    0, 0, Gdx.graphics.getBackBufferWidth(), Gdx.graphics.getBackBufferHeight());
            PixmapIO.writePNG(new FileHandle(picture), pixels, Deflater.BEST_COMPRESSION, true);
            pixels.dispose();
            Gdx.app.exit();
        }
    }

    private void play() {
        viewport.unproject(mouse.set(Gdx.input.getX(), Gdx.input.getY()));
        game.aim(mouse.x);
        if (Gdx.input.isButtonJustPressed(Input.Buttons.LEFT)) {
            if (game.isOver()) {
                start(System.nanoTime());
            } else {
                game.drop();
            }
        }
        loop.advance(Gdx.graphics.getDeltaTime(), game);
    }

    private void drawBox() {
        fill(WALL, -0.3f, -0.3f, Merge.WIDTH + 0.6f, Merge.LINE + 0.8f);
        fill(BOX, 0, 0, Merge.WIDTH, Merge.LINE + 0.5f);
        for (float x = 0.1f; x < Merge.WIDTH; x += 0.4f) {
            fill(LINE, x, Merge.LINE, 0.2f, 0.06f);
        }
        if (game.isReady()) {
            fill(LINE, game.aim() - 0.02f, 0, 0.04f, Merge.DROP_HEIGHT);
        }
    }

    private void fill(Color color, float x, float y, float width, float height) {
        batch.setColor(color);
        batch.draw(square, x, y, width, height);
    }

    private void drawBalls() {
        World world = game.world;
        FloatBuffer positions = loop.positions(null);
        for (int id = 0; id < world.idLimit(); id++) {
            float x = positions.get(2 * id);
            if (!Float.isNaN(x)) { // there is such a ball, and it is not a new one
                drawBall(x, positions.get(2 * id + 1), (int) world.tag(world.handle(id)));
            }
        }
        if (game.isReady()) {
            drawBall(game.aim(), Merge.DROP_HEIGHT, game.next());
        }
    }

    private void drawBall(float x, float y, int size) {
        float radius = Merge.RADII[size];
        batch.setColor(BALLS[size]);
        batch.draw(ball, x - radius, y - radius, 2 * radius, 2 * radius);
        batch.setColor(Color.WHITE);
        batch.draw(face, x - radius, y - radius, 2 * radius, 2 * radius);
    }

    private void drawText() {
        best = Math.max(best, game.score());
        scoreLabel.draw(batch, INK, "" + game.score(), 0, 13.65f);
        bestLabel.draw(batch, INK, "best " + best, 7.2f, 13.85f);
        if (game.isOver()) {
            overLabel.draw(batch, INK, "Game over: click to play again", 1.2f, 8);
        }
    }

    @Override
    public void dispose() {
        game.close();
        batch.dispose();
        scoreLabel.dispose();
        bestLabel.dispose();
        overLabel.dispose();
        ball.dispose();
        face.dispose();
        square.dispose();
    }
}
