package io.github.circles2d.playground;

import java.awt.Color;
import java.awt.Font;

/** The one palette of the playground, and its type. */
final class Theme {
    /** Behind the arena. */
    static final int GROUND = 0x0b0e13;

    /** The arena. */
    static final int ARENA = 0x131922;

    /** The walls of the arena. */
    static final int WALL = 0x3b4756;

    /** Static circles, their rims, and terrain. */
    static final int STATIC = 0x5a6878;

    /** Static circles and terrain whose surfaces move. */
    static final int BELT = 0x8a6a3a;

    /** Terrain that circles pass from behind. */
    static final int ONE_WAY = 0x2f7f9f;

    static final Color PANEL = new Color(0x10, 0x15, 0x1c, 215);
    static final Color BAR = new Color(0x171d26);
    static final Color BUTTON = new Color(0x222b37);
    /** The part of a slider up to its value. */
    static final Color TRACK = new Color(0x1f5f86);

    static final Color HOVER = new Color(0x2d3948);
    static final Color TEXT = new Color(0xe3e9ef);
    static final Color FAINT = new Color(0x8593a3);
    /** What cannot be chosen: it can be read, and is darker than what can. */
    static final Color DISABLED = new Color(0x7a8796);

    static final Color ACCENT = new Color(0x4cc2ff);
    /** Where surfaces touch, and their normals. */
    static final Color CONTACT = new Color(0xff5f6d);

    static final Color NORMAL = new Color(0xf4f7fa);

    static final Color WARM = new Color(0xffb454);
    static final Color LINE = new Color(0x2b3542);

    private Theme() {}

    static Font font(float size) {
        return new Font(Font.SANS_SERIF, Font.PLAIN, 1).deriveFont(size);
    }

    static Font bold(float size) {
        return new Font(Font.SANS_SERIF, Font.BOLD, 1).deriveFont(size);
    }

    /** For numbers that change: their digits have one width. */
    static Font digits(float size) {
        return new Font(Font.MONOSPACED, Font.PLAIN, 1).deriveFont(size);
    }
}
