package io.github.circles2d.playground;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Base64;
import java.util.Locale;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * A saved world as the fragment of a link, which the page in a browser opens: {@code #world=}, and then in base64url, without padding, a
 * byte with the number of the format, which is 1, and the snapshot, compressed by raw DEFLATE (RFC 1951).
 */
final class WorldLink {
    /** Characters of the longest fragment: about 500 circles that move, or more that are as they were put there. */
    static final int GREATEST_LENGTH = 32_000;

    private static final String KEY = "#world=";
    private static final int FORMAT = 1;

    private WorldLink() {}

    /** A world that is too large for a link. */
    static final class TooLongException extends RuntimeException {
        private static final long serialVersionUID = 1;

        TooLongException(int length) {
            super(String.format(
                    Locale.ROOT,
                    "a link would have %,d characters, and may have %,d: save a file instead",
                    length,
                    GREATEST_LENGTH));
        }
    }

    /** The fragment of a snapshot; throws {@link TooLongException} if it would be too long. */
    static String of(byte[] snapshot) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(FORMAT);
        Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION, true);
        try (DeflaterOutputStream out = new DeflaterOutputStream(bytes, deflater)) {
            out.write(snapshot);
        } catch (IOException e) {
            throw new UncheckedIOException(e); // an array takes all
        } finally {
            deflater.end();
        }
        String link = KEY + Base64.getUrlEncoder().withoutPadding().encodeToString(bytes.toByteArray());
        if (link.length() > GREATEST_LENGTH) {
            throw new TooLongException(link.length());
        }
        return link;
    }
}
