package io.github.circles2d.world.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Random;
import java.util.zip.CRC32C;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("each-jdk")
class Crc32cTest {
    @Test
    void theCheckIsThatOfTheStandard() {
        byte[] digits = "123456789".getBytes(StandardCharsets.US_ASCII);
        assertThat(Crc32c.of(digits, digits.length)).isEqualTo(0xE3069283);
    }

    @Test
    void theCheckIsThatOfTheJdkForEveryLength() {
        Random random = new Random(7);
        byte[] bytes = new byte[1000];
        for (int length = 0; length <= bytes.length; length++) {
            random.nextBytes(bytes);
            CRC32C expected = new CRC32C();
            expected.update(bytes, 0, length);
            assertThat(Crc32c.of(bytes, length)).as("%d bytes", length).isEqualTo((int) expected.getValue());
        }
    }
}
