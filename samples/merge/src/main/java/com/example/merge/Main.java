package com.example.merge;

import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3Application;
import com.badlogic.gdx.backends.lwjgl3.Lwjgl3ApplicationConfiguration;
import com.badlogic.gdx.files.FileHandle;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.PixmapIO;
import com.badlogic.gdx.utils.GdxRuntimeException;
import io.github.circles2d.Backend;
import io.github.circles2d.opencl.OpenClException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.util.zip.Deflater;

/** A window to play in; or with {@code --frames N} a game that plays itself, and one line of what became of it. */
public final class Main extends MergeApplication {
    private static final int FRAME = 110; // pixels of a screen for a title and a bar of tasks
    private final String picture;
    private boolean isOpen;

    private Main(Backend backend, long seed, String picture) {
        super(backend, seed);
        this.picture = picture;
    }

    public static void main(String[] arguments) {
        Options options = Options.read(arguments);
        int frames = options.frames();
        try {
            Main main = new Main(options.backend(), frames > 0 ? 1 : System.nanoTime(), options.picture());
            if (frames > 0) {
                System.out.println(main.playAlone(frames));
            }
            if (frames == 0 || !main.picture.isEmpty()) { // a picture needs a window, too
                main.open(frames == 0);
            }
            main.game.world.close();
        } catch (OpenClException e) { // no such device, or its driver fails
            Options.end(1, e.getMessage());
        }
    }

    /** Returns when the window has been closed. */
    private void open(boolean isVisible) {
        Lwjgl3ApplicationConfiguration.errorStream = new PrintStream(OutputStream.nullOutputStream()); // stack traces
        Lwjgl3ApplicationConfiguration configuration = new Lwjgl3ApplicationConfiguration();
        configuration.setTitle("Merge: click to drop a ball");
        configuration.setResizable(false);
        configuration.setBackBufferConfig(8, 8, 8, 8, 16, 0, 4); // smooth edges
        configuration.disableAudio(true);
        configuration.setInitialVisible(isVisible);
        try {
            int room = isVisible ? Lwjgl3ApplicationConfiguration.getDisplayMode().height - FRAME : HEIGHT;
            int height = Math.min(HEIGHT, room);
            configuration.setWindowedMode(WIDTH * height / HEIGHT, height);
            new Lwjgl3Application(this, configuration);
        } catch (GdxRuntimeException e) {
            if (isOpen) {
                throw e;
            }
            String why = "no window can be shown here: " + e.getMessage();
            Options.end(1, why, "without a display, it plays by itself: --frames 300");
        }
    }

    @Override
    public void create() {
        isOpen = true;
        super.create();
        if (!picture.isEmpty()) {
            draw();
            Pixmap pixels = Pixmap.createFromFrameBuffer(0, 0, WIDTH, HEIGHT);
            try {
                PixmapIO.writePNG(new FileHandle(picture), pixels, Deflater.BEST_COMPRESSION, true);
            } catch (GdxRuntimeException e) {
                Options.end(1, "cannot write " + picture + ": " + e.getCause());
            }
            Gdx.app.exit();
        }
    }
}
