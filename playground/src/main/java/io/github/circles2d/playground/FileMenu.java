package io.github.circles2d.playground;

import java.awt.FileDialog;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.swing.JOptionPane;

/** Worlds and pictures in files, and links and pictures in the clipboard. Belongs to the event thread; the loop reads and writes worlds. */
final class FileMenu {
    private static final String WORLD = "circles2d";
    private static final String PICTURE = "png";

    private final PlaygroundCanvas canvas;
    private final SessionLoop loop;
    private final java.awt.Frame parent;
    private final String page;
    private String folder;

    /** Links begin with the address of a page; if it is empty, they are what goes behind one. */
    FileMenu(java.awt.Frame parent, PlaygroundCanvas canvas, SessionLoop loop, String page) {
        this.parent = parent;
        this.page = page;
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

    void copyLink() {
        loop.ask(session -> {
            copy(new StringSelection(page + session.link()));
            session.say(
                    page.isEmpty()
                            ? "what goes behind the page's address is in the clipboard"
                            : "the link is in the clipboard");
        });
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
            say("not saved: " + FileFailure.reason(e));
        }
    }

    static void write(BufferedImage picture, Path file) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        if (!ImageIO.write(picture, PICTURE, bytes)) {
            throw new IOException("this Java runtime cannot write PNG files");
        }
        Files.write(file, bytes.toByteArray()); // ImageIO prints a stack trace if it cannot open a file
    }

    void copyPicture() {
        BufferedImage picture = canvas.picture();
        loop.ask(session -> {
            copy(new CopiedPicture(picture));
            session.say("the picture is in the clipboard");
        });
    }

    private static void copy(Transferable what) {
        try {
            Toolkit.getDefaultToolkit().getSystemClipboard().setContents(what, null);
        } catch (IllegalStateException e) { // another program holds it
            throw new IllegalStateException("the clipboard is busy", e);
        }
    }

    private void say(String text) {
        loop.ask(session -> session.say(text));
    }

    /** Asks with the desktop's own dialog, which asks before it has a file replaced; not if the ending is missing. */
    private Path choose(String title, String ending, boolean toSave) {
        FileDialog dialog = new FileDialog(parent, title, toSave ? FileDialog.SAVE : FileDialog.LOAD);
        dialog.setDirectory(folder);
        dialog.setFilenameFilter((where, name) -> name.endsWith("." + ending));
        dialog.setVisible(true);
        String name = dialog.getFile();
        folder = dialog.getDirectory();
        dialog.dispose();
        if (name == null) {
            return null;
        }
        if (!toSave || name.indexOf('.') >= 0) {
            return Path.of(folder, name);
        }
        Path file = Path.of(folder, name + "." + ending);
        return file.toFile().exists() && !mayReplace(file) ? null : file;
    }

    private boolean mayReplace(Path file) {
        String question = "Replace " + file.getFileName() + "?";
        return JOptionPane.showConfirmDialog(parent, question, "Save", JOptionPane.OK_CANCEL_OPTION)
                == JOptionPane.OK_OPTION;
    }
}
