package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Base64;
import java.util.Locale;
import java.util.Random;
import java.util.zip.Inflater;
import java.util.zip.InflaterOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Links have the state to the bit, in the format that the page reads. */
class WorldLinkTest {
    @ParameterizedTest
    @ValueSource(strings = {"bridge", "slopes-and-belts", "drum", "empty"})
    void aLinkHasTheWorldToTheBit(String stage) throws Exception {
        try (Sandbox sandbox = new Sandbox(Stages.named(stage), Backend.JVM);
                World other = World.builder().backend(Backend.JVM).build()) {
            for (int k = 0; k < 40; k++) {
                sandbox.stepOnce(() -> {});
            }
            String link = WorldLink.of(sandbox.snapshot().array());
            assertThat(link).matches("#world=[A-Za-z0-9_-]+").hasSizeLessThanOrEqualTo(WorldLink.GREATEST_LENGTH);
            other.restore(ByteBuffer.wrap(decode(link)));
            assertThat(other.hash()).isEqualTo(sandbox.world().hash());
            sandbox.world().step(Sandbox.TIME_STEP, 40);
            other.step(Sandbox.TIME_STEP, 40);
            assertThat(other.hash()).isEqualTo(sandbox.world().hash());
        }
    }

    private static byte[] decode(String link) throws Exception {
        byte[] bytes = Base64.getUrlDecoder().decode(link.substring("#world=".length()));
        assertThat(bytes[0]).as("the format").isEqualTo((byte) 1);
        ByteArrayOutputStream snapshot = new ByteArrayOutputStream();
        try (InflaterOutputStream out = new InflaterOutputStream(snapshot, new Inflater(true))) {
            out.write(Arrays.copyOfRange(bytes, 1, bytes.length));
        }
        return snapshot.toByteArray();
    }

    @Test
    void aLinkThatWouldBeTooLongIsRefused() {
        byte[] noise = new byte[24_000];
        new Random(1).nextBytes(noise);
        Locale before = Locale.getDefault();
        Locale.setDefault(Locale.GERMANY); // the text is English all the same
        try {
            assertThatExceptionOfType(WorldLink.TooLongException.class)
                    .isThrownBy(() -> WorldLink.of(noise))
                    .withMessageMatching(
                            "a link would have 32,0\\d\\d characters, and may have 32,000: save a file instead");
        } finally {
            Locale.setDefault(before);
        }
    }
}
