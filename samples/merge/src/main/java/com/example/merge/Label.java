package com.example.merge;

import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.Texture;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;

/** A line of text. AWT draws it, because libGDX's own font is only 15 pixels high. */
final class Label {
    private static final int HEIGHT = 128;
    private static final int WIDTH = 2048;

    private final float height;
    private String text = "";
    private Texture texture;

    /** @param height of a line in the world's lengths */
    Label(float height) {
        this.height = height;
    }

    void draw(SpriteBatch batch, Color color, String newText, float x, float y) {
        if (!newText.equals(text)) {
            dispose();
            text = newText;
            texture = paint(text);
        }
        batch.setColor(color);
        batch.draw(texture, x, y, height * WIDTH / HEIGHT, height);
    }

    private static Texture paint(String text) {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_BYTE_GRAY);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setFont(new Font(Font.SANS_SERIF, Font.BOLD, HEIGHT * 3 / 4));
        g.drawString(text, 0, HEIGHT * 3 / 4);
        g.dispose();
        return Textures.paint(
                WIDTH, HEIGHT, (x, y) -> 0xffffff00 | image.getRaster().getSample(x, y, 0));
    }

    void dispose() {
        if (texture != null) {
            texture.dispose();
        }
    }
}
