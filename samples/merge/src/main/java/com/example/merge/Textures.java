package com.example.merge;

import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.Texture;

/** The pictures that the game is drawn with, smooth at every size. */
final class Textures {
    private static final int SIZE = 256;

    private Textures() {}

    /** The colour of a pixel as RGBA8888. */
    interface Pixels {
        int color(int x, int y);
    }

    /** What a picture looks like at a point whose x and y go from -1 to 1. */
    private interface Shader {
        Color color(float x, float y);
    }

    /** A disc with a darker rim, to be tinted. */
    static Texture ball() {
        return paint((x, y) -> {
            float light = 1 - 0.22f * edge(0.86f, x, y) - 0.08f * edge(0.95f, x + 0.15f, y + 0.15f);
            return new Color(light, light, light, 1 - edge(0.985f, x, y));
        });
    }

    /** Two eyes, a mouth and a shine. */
    static Texture face() {
        return paint((x, y) -> {
            float eyes = 1 - edge(0.1f, Math.abs(x) - 0.3f, y + 0.05f);
            float mouth = y > 0.22f ? (1 - edge(0.22f, x, y - 0.18f)) * edge(0.15f, x, y - 0.16f) : 0;
            float shine = 0.55f * (1 - edge(0.16f, (x + 0.42f) * 0.8f, y + 0.52f));
            float ink = Math.max(eyes, mouth);
            return shine > ink ? new Color(1, 1, 1, shine) : new Color(0.2f, 0.1f, 0.08f, ink);
        });
    }

    static Texture square() {
        return paint(1, 1, (x, y) -> 0xffffffff);
    }

    /** From 0 inside of a disc to 1 outside, with a soft edge. */
    private static float edge(float radius, float x, float y) {
        float outside = ((float) Math.sqrt(x * x + y * y) - radius) * SIZE / 4 + 0.5f;
        return Math.max(0, Math.min(1, outside));
    }

    private static Texture paint(Shader shader) {
        return paint(
                SIZE, SIZE, (x, y) -> Color.rgba8888(shader.color((2 * x + 1f) / SIZE - 1, (2 * y + 1f) / SIZE - 1)));
    }

    static Texture paint(int width, int height, Pixels pixels) {
        Pixmap pixmap = new Pixmap(width, height, Pixmap.Format.RGBA8888);
        pixmap.setBlending(Pixmap.Blending.None);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                pixmap.drawPixel(x, y, pixels.color(x, y));
            }
        }
        Texture texture = new Texture(pixmap, true);
        texture.setFilter(Texture.TextureFilter.MipMapLinearLinear, Texture.TextureFilter.Linear);
        pixmap.dispose();
        return texture;
    }
}
