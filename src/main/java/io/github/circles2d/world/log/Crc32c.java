package io.github.circles2d.world.log;

/**
 * The check of a block, CRC-32C: the polynomial 0x1EDC6F41 with its bits reversed, from all ones, inverted at the end. {@code
 * java.util.zip.CRC32C} gives the same, but browsers and Android 13 do not have it.
 */
final class Crc32c {
    private static final int POLYNOMIAL = 0x82F63B78;

    /** Bytes that are looked up at a time. */
    private static final int SLICE = 8;

    /** Entry {@code 256 * k + b} is what byte b does to the check if k more bytes of its slice follow. */
    private static final int[] TABLE = table();

    private Crc32c() {}

    private static int[] table() {
        int[] table = new int[256 * SLICE];
        for (int b = 0; b < 256; b++) {
            int check = b;
            for (int bit = 0; bit < 8; bit++) {
                check = check >>> 1 ^ ((check & 1) == 0 ? 0 : POLYNOMIAL);
            }
            table[b] = check;
        }
        for (int i = 256; i < table.length; i++) {
            int before = table[i - 256];
            table[i] = before >>> 8 ^ table[before & 255];
        }
        return table;
    }

    /** The check of the first bytes of an array. */
    static int of(byte[] bytes, int length) {
        int check = -1;
        int i = 0;
        for (; i <= length - SLICE; i += SLICE) {
            int low = check ^ fourBytes(bytes, i);
            int high = fourBytes(bytes, i + 4);
            check = TABLE[1792 + (low & 255)]
                    ^ TABLE[1536 + (low >>> 8 & 255)]
                    ^ TABLE[1280 + (low >>> 16 & 255)]
                    ^ TABLE[1024 + (low >>> 24)]
                    ^ TABLE[768 + (high & 255)]
                    ^ TABLE[512 + (high >>> 8 & 255)]
                    ^ TABLE[256 + (high >>> 16 & 255)]
                    ^ TABLE[high >>> 24];
        }
        for (; i < length; i++) {
            check = check >>> 8 ^ TABLE[(check ^ bytes[i]) & 255];
        }
        return ~check;
    }

    private static int fourBytes(byte[] bytes, int i) {
        return bytes[i] & 255 | (bytes[i + 1] & 255) << 8 | (bytes[i + 2] & 255) << 16 | bytes[i + 3] << 24;
    }
}
