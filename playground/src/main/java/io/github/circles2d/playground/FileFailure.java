package io.github.circles2d.playground;

import java.nio.file.AccessDeniedException;
import java.nio.file.NoSuchFileException;

/** Says what was wrong with a file. Java's own messages of the usual failures are the file's name alone. */
final class FileFailure {
    private FileFailure() {}

    static String reason(Exception failure) {
        if (failure instanceof NoSuchFileException) {
            return "there is no such file or folder: " + failure.getMessage();
        }
        if (failure instanceof AccessDeniedException) {
            return "access is denied: " + failure.getMessage();
        }
        return failure.getMessage();
    }
}
