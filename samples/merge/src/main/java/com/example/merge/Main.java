package com.example.merge;

import com.badlogic.gdx.ApplicationAdapter;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.backends.headless.HeadlessApplication;
import com.badlogic.gdx.backends.headless.HeadlessApplicationConfiguration;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3Application;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3ApplicationConfiguration;
import io.github.circles2d.Backend;
import io.github.circles2d.FixedStep;

/** A window to play in; or with {@code --frames N} a game that plays itself, and one line of what became of it. */
public final class Main {
    private Main() {}

    public static void main(String[] arguments) {
        Backend backend = Backend.AUTO;
        int frames = 0;
        String picture = null;
        for (int k = 0; k < arguments.length; k += 2) {
            if (k + 1 == arguments.length) {
                usage();
            }
            switch (arguments[k]) {
                case "--backend" -> backend = Backend.valueOf(arguments[k + 1]);
                case "--frames" -> frames = Integer.parseInt(arguments[k + 1]);
                case "--picture" -> picture = arguments[k + 1];
                default -> usage();
            }
        }
        if (frames > 0 && picture == null) {
            playWithoutWindow(backend, frames);
        } else {
            openWindow(backend, frames, picture);
        }
    }

    private static void usage() {
        System.err.println("usage: merge [--frames N [--picture FILE.png]] [--backend AUTO|JVM|OPENCL_CPU|OPENCL_GPU]");
        System.exit(2);
    }

    private static void playWithoutWindow(Backend backend, int frames) {
        HeadlessApplicationConfiguration configuration = new HeadlessApplicationConfiguration();
        configuration.updatesPerSecond = 0; // as many as it can
        new HeadlessApplication(
                new ApplicationAdapter() {
                    @Override
                    public void create() {
                        try (Merge game = new Merge(backend, 1)) {
                            playAlone(game, frames);
                        }
                        Gdx.app.exit();
                    }
                },
                configuration);
    }

    /** Makes so many steps, and prints what became of the world. */
    static void playAlone(Merge game, int frames) {
        FixedStep loop = new FixedStep(game.world, Merge.TIME_STEP);
        for (int frame = 0; frame < frames; frame++) {
            game.playAlone();
            loop.advance(Merge.TIME_STEP, game);
        }
        System.out.printf(
                "merge: %d frames, %d balls, %d points, hash %016x%n",
                frames, game.world.size(), game.score(), game.world.hash());
    }

    private static void openWindow(Backend backend, int frames, String picture) {
        Lwjgl3ApplicationConfiguration configuration = new Lwjgl3ApplicationConfiguration();
        configuration.setTitle("Merge");
        configuration.setWindowedMode(600, 800);
        configuration.useVsync(true);
        configuration.disableAudio(true);
        configuration.setInitialVisible(picture == null);
        new Lwjgl3Application(new Screen(backend, frames, picture), configuration);
    }
}
