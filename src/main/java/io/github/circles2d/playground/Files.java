package io.github.circles2d.playground;

import java.awt.Component;
import java.awt.Toolkit;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Worlds and pictures in files, and pictures in the clipboard. Belongs to the event thread; the loop reads and writes worlds. */
final class Files {
    private static final String WORLD = "circles2d";
    private static final String PICTURE = "png";

    private final PlaygroundCanvas canvas;
    private final SessionLoop loop;
    private final Component parent;
    private File folder;

    Files(Component parent, PlaygroundCanvas canvas, SessionLoop loop) {
        this.parent = parent;
        this.canvas = canvas;
        this.loop = loop;
    }

    void open() {
        Path file = choose("Open world", WORLD, false);
        if (file != null) {
            loop.ask(session -> session.open(file));
        }
    }

    void save() {
        Path file = choose("Save world", WORLD, true);
        if (file != null) {
            loop.ask(session -> session.save(file));
        }
    }

    void savePicture() {
        BufferedImage picture = canvas.picture();
        Path file = choose("Save picture", PICTURE, true);
        if (file == null) {
            return;
        }
        try {
            write(picture, file);
            say("saved " + file.getFileName());
        } catch (IOException e) {
            say("not saved: " + e.getMessage());
        }
    }

    static void write(BufferedImage picture, Path file) throws IOException {
        if (!ImageIO.write(picture, PICTURE, file.toFile())) {
            throw new IOException("this Java runtime cannot write PNG files");
        }
    }

    void copyPicture() {
        try {
            Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new CopiedPicture(canvas.picture()), null);
            say("the picture is in the clipboard");
        } catch (IllegalStateException e) { // another program holds it
            say("the clipboard is busy");
        }
    }

    private void say(String text) {
        loop.ask(session -> session.say(text));
    }

    private Path choose(String title, String ending, boolean toSave) {
        JFileChooser chooser = new JFileChooser(folder);
        chooser.setDialogTitle(title);
        chooser.setFileFilter(new FileNameExtensionFilter("*." + ending, ending));
        int answer = toSave ? chooser.showSaveDialog(parent) : chooser.showOpenDialog(parent);
        if (answer != JFileChooser.APPROVE_OPTION) {
            return null;
        }
        folder = chooser.getCurrentDirectory();
        File chosen = chooser.getSelectedFile();
        boolean bare = chosen.getName().indexOf('.') < 0;
        return toSave && bare ? Path.of(chosen + "." + ending) : chosen.toPath();
    }
}
