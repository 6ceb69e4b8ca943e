package com.example.merge;

import com.badlogic.gdx.ApplicationAdapter;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import com.badlogic.gdx.graphics.glutils.ShapeRenderer;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.utils.Align;
import com.badlogic.gdx.utils.ScreenUtils;
import io.github.circles2d.Backend;
import io.github.circles2d.FixedStep;

/** What libGDX calls on a desktop and in a browser alike: hands clicks to the game, and draws it. */
class MergeApplication extends ApplicationAdapter {
    static final int WIDTH = 600, HEIGHT = 800; // of the window, in pixels
    private static final int SCALE = 50; // pixels for a length of 1
    private static final Color INK = Color.valueOf("331a14");
    private static final String[] COLORS = {
        "e63946", "f4845f", "9d4edd", "f6bd60", "f77f00", "ef476f", "b5c95a", "f9a8c9", "ffd60a", "80c06b", "2a9d8f"
    };
    private final Backend backend;
    private final int[] kinds = new int[1000];
    Merge game;
    private FixedStep loop;
    private ShapeRenderer shapes;
    private SpriteBatch batch;
    private BitmapFont font;

    MergeApplication(Backend backend, long seed) {
        this.backend = backend;
        start(seed);
    }

    private void start(long seed) {
        game = new Merge(backend, seed);
        loop = new FixedStep(game.world, 1 / 60f);
    }

    /** Lets the game play itself, without a window, and returns what became of it. */
    String playAlone(int frames) {
        for (int frame = 0; frame < frames; frame++) {
            game.playAlone();
            loop.advance(1 / 60f, game);
        }
        String format = "merge: %d frames, %d balls, %d points, hash %016x";
        return String.format(format, frames, game.world.size(), game.score, game.world.hash());
    }

    @Override
    public void create() {
        shapes = new ShapeRenderer();
        batch = new SpriteBatch();
        font = new BitmapFont(Gdx.files.classpath("com/example/merge/points.fnt"));
    }

    @Override
    public void resize(int width, int height) {
        batch.getProjectionMatrix().setToOrtho2D(0, 0, width, height); // text keeps its pixels, so it stays sharp
    }

    @Override
    public void render() {
        game.mouseX = (float) WIDTH / SCALE * Gdx.input.getX() / Gdx.graphics.getWidth() - 1;
        if (Gdx.input.justTouched() && game.isOver()) {
            game.world.close();
            start(System.nanoTime());
        }
        game.isDropWanted |= Gdx.input.justTouched();
        loop.advance(Gdx.graphics.getDeltaTime(), game);
        draw();
    }

    void draw() {
        ScreenUtils.clear(Color.valueOf("fdf0d5"));
        shapes.getProjectionMatrix().setToOrtho2D(-1, -1, 12, 16); // a margin of 1 around the box
        shapes.begin(ShapeRenderer.ShapeType.Filled);
        box("c9975b", -0.3f, -0.3f, Merge.WIDTH + 0.6f, Merge.LINE + 0.8f);
        box("fff8ea", 0, 0, Merge.WIDTH, Merge.LINE + 0.5f);
        box("f3b9a5", 0, Merge.LINE, Merge.WIDTH, 0.06f);
        if (game.isReady()) {
            box("f3b9a5", game.dropX() - 0.02f, 0, 0.04f, Merge.DROP_HEIGHT);
            ball(game.next, game.dropX(), Merge.DROP_HEIGHT, Merge.RADII[game.next], 0);
        }
        var positions = loop.positions(null);
        var radii = loop.radii();
        var angles = loop.angles();
        game.world.readKindsById(kinds, null);
        for (int id = 0; id < game.world.idLimit(); id++) {
            if (!Float.isNaN(positions.get(2 * id))) {
                ball(kinds[id], positions.get(2 * id), positions.get(2 * id + 1), radii.get(id), angles.get(id));
            }
        }
        shapes.end();
        batch.begin();
        font.setColor(Color.valueOf("6b4226"));
        String text = game.isOver() ? " points. Game over: click to play again" : " points";
        int left = Gdx.graphics.getWidth() / 12; // of the box, which has a margin of 1
        font.draw(batch, game.score + text, left, Gdx.graphics.getHeight() * 0.97f, 10 * left, Align.left, true);
        batch.end();
    }

    private void box(String color, float x, float y, float width, float height) {
        shapes.setColor(Color.valueOf(color));
        shapes.rect(x, y, width, height);
    }

    /** A ball whose face has turned by an angle; the light on it has not. */
    private void ball(int kind, float x, float y, float radius, float angle) {
        Color color = Color.valueOf(COLORS[kind]);
        disc(color.cpy().mul(0.8f, 0.8f, 0.8f, 1), x, y, radius);
        disc(color, x, y, 0.88f * radius);
        float right = radius * MathUtils.cos(angle),
                up = radius * MathUtils.sin(angle); // of a step to the face's right
        disc(INK, x - 0.3f * right, y - 0.3f * up, 0.1f * radius); // eyes
        disc(INK, x + 0.3f * right, y + 0.3f * up, 0.1f * radius);
        disc(INK, x + 0.2f * up, y - 0.2f * right, 0.22f * radius); // the lower edge of a disc is a mouth
        disc(color, x + 0.14f * up, y - 0.14f * right, 0.22f * radius);
        disc(Color.WHITE, x - 0.42f * radius, y + 0.5f * radius, 0.15f * radius); // shine
    }

    private void disc(Color color, float x, float y, float radius) {
        shapes.setColor(color);
        shapes.circle(x, y, radius, 64);
    }
}
