package io.github.circles2d.playground;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * Writes pictures as an animated PNG that runs for ever, with a palette (PNG specification, third edition). Each picture has only the
 * box in which it differs from the one before, and, if that is shorter, there only the pixels that differ; the others are transparent.
 */
final class ApngWriter {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    /** Few enough that a picture compresses well. The last number is that of transparent pixels. */
    private static final int COLOURS = 32;

    private static final int BIT_DEPTH = 8;
    private static final int WITH_PALETTE = 3;
    private static final int BLEND_OVER = 1;

    private final int width;
    private final int height;
    private final int picturesASecond;
    private int sequence;

    ApngWriter(int width, int height, int picturesASecond) {
        this.width = width;
        this.height = height;
        this.picturesASecond = picturesASecond;
    }

    void write(BufferedImage[] pictures, OutputStream to) throws IOException {
        List<int[]> pixels = new ArrayList<>();
        for (BufferedImage picture : pictures) {
            pixels.add(picture.getRGB(0, 0, width, height, null, 0, width));
        }
        Colours colours = Colours.of(pixels, COLOURS);
        DataOutputStream out = new DataOutputStream(to);
        out.write(SIGNATURE);
        chunk(out, "IHDR", header());
        chunk(out, "acTL", ints(pictures.length, 0));
        writePalette(out, colours.palette());
        int clear = colours.palette().length;
        int[] before = null;
        for (int[] picture : pixels) {
            int[] numbers = new int[picture.length];
            for (int k = 0; k < picture.length; k++) {
                numbers[k] = colours.number(picture[k]);
            }
            writePicture(out, before, numbers, clear);
            before = numbers;
        }
        chunk(out, "IEND", new byte[0]);
        out.flush();
    }

    private byte[] header() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(ints(width, height));
        bytes.write(new byte[] {BIT_DEPTH, WITH_PALETTE, 0, 0, 0});
        return bytes.toByteArray();
    }

    private static void writePalette(DataOutputStream out, int[] palette) throws IOException {
        byte[] colours = new byte[3 * (palette.length + 1)];
        byte[] opacity = new byte[palette.length + 1];
        for (int k = 0; k < palette.length; k++) {
            colours[3 * k] = (byte) (palette[k] >> 16);
            colours[3 * k + 1] = (byte) (palette[k] >> 8);
            colours[3 * k + 2] = (byte) palette[k];
            opacity[k] = (byte) 0xff;
        }
        chunk(out, "PLTE", colours);
        chunk(out, "tRNS", opacity);
    }

    private void writePicture(DataOutputStream out, int[] before, int[] now, int clear) throws IOException {
        int left = 0;
        int top = 0;
        int right = width;
        int bottom = height;
        if (before != null) {
            left = width - 1;
            top = height - 1;
            right = 1;
            bottom = 1;
            for (int at = 0; at < now.length; at++) {
                if (before[at] != now[at]) {
                    left = Math.min(left, at % width);
                    right = Math.max(right, at % width + 1);
                    top = Math.min(top, at / width);
                    bottom = Math.max(bottom, at / width + 1);
                }
            }
            left = Math.min(left, right - 1);
            top = Math.min(top, bottom - 1);
        }
        chunk(out, "fcTL", control(left, top, right - left, bottom - top));
        byte[] data = deflate(null, now, clear, left, top, right, bottom);
        if (before != null) {
            byte[] changes = deflate(before, now, clear, left, top, right, bottom);
            data = changes.length < data.length ? changes : data;
        }
        if (before == null) {
            chunk(out, "IDAT", data);
        } else {
            ByteArrayOutputStream numbered = new ByteArrayOutputStream();
            numbered.write(ints(sequence++));
            numbered.write(data);
            chunk(out, "fdAT", numbered.toByteArray());
        }
    }

    private byte[] control(int left, int top, int wide, int high) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(ints(sequence++, wide, high, left, top));
        bytes.write(new byte[] {0, 1, (byte) (picturesASecond >> 8), (byte) picturesASecond, 0, BLEND_OVER});
        return bytes.toByteArray();
    }

    private byte[] deflate(int[] before, int[] now, int clear, int left, int top, int right, int bottom)
            throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION);
        try (DeflaterOutputStream out = new DeflaterOutputStream(bytes, deflater)) {
            byte[] row = new byte[right - left + 1]; // first the number of the filter: none
            for (int y = top; y < bottom; y++) {
                for (int x = left; x < right; x++) {
                    int at = y * width + x;
                    boolean same = before != null && before[at] == now[at];
                    row[x - left + 1] = (byte) (same ? clear : now[at]);
                }
                out.write(row);
            }
        } finally {
            deflater.end();
        }
        return bytes.toByteArray();
    }

    private static void chunk(DataOutputStream out, String type, byte[] data) throws IOException {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 check = new CRC32();
        check.update(name);
        check.update(data);
        out.writeInt(data.length);
        out.write(name);
        out.write(data);
        out.writeInt((int) check.getValue());
    }

    private static byte[] ints(int... values) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        for (int value : values) {
            out.writeInt(value);
        }
        return bytes.toByteArray();
    }
}
