package io.github.circles2d.playground;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;
import java.util.zip.InflaterInputStream;

/** Reads the animated PNG files that {@link ApngWriter} writes, by the specification and not by the writer. */
final class Apng {
    final List<BufferedImage> pictures = new ArrayList<>();
    int width;
    int height;

    /** Pictures that the file says it has, and how often it runs; 0 for ever. */
    int count;

    int plays;

    /** Of all pictures. */
    double seconds;

    private byte[] palette;
    private byte[] opacity;
    private int[] canvas;
    private int sequence;

    // Of the picture to come.
    private int wide;
    private int high;
    private int left;
    private int top;
    private boolean over;

    Apng(byte[] bytes) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
        require(in.readLong() == 0x89504e470d0a1a0aL, "signature");
        String type;
        do {
            byte[] data = new byte[in.readInt()];
            byte[] name = new byte[4];
            in.readFully(name);
            in.readFully(data);
            CRC32 check = new CRC32();
            check.update(name);
            check.update(data);
            require(in.readInt() == (int) check.getValue(), "check sum");
            type = new String(name, StandardCharsets.US_ASCII);
            chunk(type, data);
        } while (!type.equals("IEND"));
        require(in.available() == 0, "end");
    }

    private void chunk(String type, byte[] data) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(data));
        switch (type) {
            case "IHDR" -> {
                width = in.readInt();
                height = in.readInt();
                require(in.readByte() == 8 && in.readByte() == 3 && in.readByte() == 0, "eight bits of a palette");
                canvas = new int[width * height];
            }
            case "acTL" -> {
                count = in.readInt();
                plays = in.readInt();
            }
            case "PLTE" -> palette = data;
            case "tRNS" -> opacity = data;
            case "fcTL" -> control(in);
            case "IDAT" -> draw(in);
            case "fdAT" -> {
                require(in.readInt() == sequence++, "sequence");
                draw(in);
            }
            default -> require(type.equals("IEND"), type);
        }
    }

    private void control(DataInputStream in) throws IOException {
        require(in.readInt() == sequence++, "sequence");
        wide = in.readInt();
        high = in.readInt();
        left = in.readInt();
        top = in.readInt();
        require(wide > 0 && high > 0 && left >= 0 && top >= 0, "box");
        require(left + wide <= width && top + high <= height, "box");
        int numerator = in.readUnsignedShort();
        seconds += (double) numerator / in.readUnsignedShort();
        require(in.readByte() == 0, "the picture stays");
        over = in.readByte() == 1;
    }

    private void draw(DataInputStream compressed) throws IOException {
        DataInputStream in = new DataInputStream(new InflaterInputStream(compressed));
        for (int y = top; y < top + high; y++) {
            require(in.readByte() == 0, "no filter");
            for (int x = left; x < left + wide; x++) {
                int number = in.readUnsignedByte();
                boolean clear = number < opacity.length && opacity[number] == 0;
                if (!clear || !over) {
                    canvas[y * width + x] = (palette[3 * number] & 0xff) << 16
                            | (palette[3 * number + 1] & 0xff) << 8
                            | palette[3 * number + 2] & 0xff;
                }
            }
        }
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        picture.setRGB(0, 0, width, height, canvas, 0, width);
        pictures.add(picture);
    }

    private static void require(boolean holds, String what) throws IOException {
        if (!holds) {
            throw new IOException("not as it should be: " + what);
        }
    }

    /** Saves pictures of a film: {@code FILM FOLDER NUMBER...}. */
    public static void main(String[] arguments) throws IOException {
        Apng film = new Apng(Files.readAllBytes(Path.of(arguments[0])));
        System.out.println(film.count + " pictures, " + film.seconds + " s");
        for (int k = 2; k < arguments.length; k++) {
            FileMenu.write(
                    film.pictures.get(Integer.parseInt(arguments[k])),
                    Path.of(arguments[1], "film-" + arguments[k] + ".png"));
        }
    }
}
