package com.example.merge;

import com.badlogic.gdx.Gdx;
import com.github.xpenatan.gdx.teavm.backends.web.WebApplication;
import com.github.xpenatan.gdx.teavm.backends.web.WebApplicationConfiguration;
import io.github.circles2d.Backend;

/** The game on a page, whose title has the points. */
public final class Browser extends MergeApplication {
    private int shown = -1;

    private Browser(long seed) {
        super(Backend.JVM, seed);
    }

    /** With a number of frames, the game first plays that many by itself, and says on the console what became of it. */
    public static void main(String[] arguments) {
        Browser browser = new Browser(arguments.length > 0 ? 1 : System.nanoTime());
        if (arguments.length > 0) {
            System.out.println(browser.playAlone(Integer.parseInt(arguments[0])));
        }
        WebApplicationConfiguration configuration = new WebApplicationConfiguration("canvas");
        configuration.width = WIDTH;
        configuration.height = HEIGHT;
        configuration.antialiasing = true;
        new WebApplication(browser, configuration);
    }

    @Override
    public void render() {
        super.render();
        if (game.score != shown) {
            shown = game.score;
            Gdx.graphics.setTitle("Merge: " + shown + " points");
        }
    }
}
