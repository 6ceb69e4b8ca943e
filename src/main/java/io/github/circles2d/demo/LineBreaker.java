package io.github.circles2d.demo;

import java.awt.FontMetrics;
import java.util.ArrayList;
import java.util.List;

/** Breaks text into lines that fit. */
final class LineBreaker {
    private LineBreaker() {}

    /** Breaks between words; within a word that is longer than a line. */
    static List<String> words(String text, FontMetrics metrics, int room) {
        List<String> lines = new ArrayList<>();
        String rest = text;
        while (metrics.stringWidth(rest) > room && rest.length() > 1) {
            int fitting = fitting(rest, metrics, room);
            int blank = rest.lastIndexOf(' ', fitting);
            int end = blank > 0 ? blank : fitting;
            lines.add(rest.substring(0, end));
            rest = rest.substring(end).stripLeading();
        }
        lines.add(rest);
        return lines;
    }

    /** How many characters from the start fit, at least one. */
    private static int fitting(String text, FontMetrics metrics, int room) {
        int length = 1;
        while (length < text.length() && metrics.stringWidth(text.substring(0, length + 1)) <= room) {
            length++;
        }
        return length;
    }

    /** Breaks between parts, which stay whole; what is too long for a line is left out. */
    static List<String> parts(List<String> parts, String between, FontMetrics metrics, int room) {
        List<String> lines = new ArrayList<>();
        String line = "";
        for (String part : parts) {
            String longer = line.isEmpty() ? part : line + between + part;
            if (metrics.stringWidth(longer) <= room) {
                line = longer;
            } else if (metrics.stringWidth(part) <= room) {
                lines.add(line);
                line = part;
            }
        }
        lines.add(line);
        lines.removeIf(String::isEmpty);
        return lines;
    }
}
