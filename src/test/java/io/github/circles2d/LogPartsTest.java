package io.github.circles2d;

import static java.lang.Float.floatToRawIntBits;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import io.github.circles2d.world.joints.JointForm;
import io.github.circles2d.world.log.LogWriter;
import io.github.circles2d.world.model.JointRow;
import io.github.circles2d.world.shared.Call;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Calls of a log that others behind them complete: the parts of a chain, and the form of joints. */
class LogPartsTest {
    private static final int GROUND = 0;
    private static final int OPEN = 0;
    private static final int CLOSED = 1;

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private World world;
    private LogWriter log;

    @BeforeEach
    void build() {
        world = WorldScenes.jvm().threads(1).build();
        world.add(0.5f, 0.5f, 0.1f, 1);
        begin();
    }

    @AfterEach
    void close() {
        world.close();
    }

    /** Begins a log with a snapshot of now. */
    private void begin() {
        bytes.reset();
        log = new LogWriter(bytes, 1);
        ByteBuffer snapshot = ByteBuffer.allocate(world.snapshotBytes());
        world.snapshot(snapshot);
        log.snapshot(snapshot.array(), snapshot.capacity());
    }

    private void write(Call call, int... words) {
        assertThat(words).hasSize(call.words);
        log.begin(call.number, call.words);
        for (int word : words) {
            log.word(word);
        }
        log.end();
    }

    private void writeChain() {
        write(Call.CHAIN_START, floatToRawIntBits(0.1f), floatToRawIntBits(0.1f));
        write(Call.CHAIN_LINE, floatToRawIntBits(0.9f), floatToRawIntBits(0.1f));
    }

    private void writeForm() {
        JointForm form = new JointForm(JointRow.TURN_SPEED);
        int[] words = new int[JointForm.WORDS];
        for (int k = 0; k < words.length; k++) {
            words[k] = form.word(k);
        }
        write(Call.JOINT_FORM, words);
    }

    private Replay replay() throws IOException {
        log.close();
        return new Replay(new ByteArrayInputStream(bytes.toByteArray()), world);
    }

    private static void assertRefused(Replay replay, String why) {
        assertThatIllegalArgumentException().isThrownBy(replay::run).withMessageContaining(why);
    }

    @Test
    void whatIsCompleteComes() throws IOException {
        writeChain();
        write(Call.CHAIN, GROUND, 0, OPEN);
        writeForm();
        write(Call.JOINT_ALONE, 0);
        replay().run();
        assertThat(world.terrain().size()).isOne();
        assertThat(world.joints().size()).isOne();
    }

    @Test
    void aChainThatIsRefusedIsGone() throws IOException {
        writeChain();
        write(Call.CHAIN, GROUND, 0, CLOSED);
        write(Call.CHAIN, GROUND, 0, OPEN);
        Replay replay = replay();
        assertRefused(replay, "a chain is closed that has a gap");
        assertRefused(replay, "a chain goes on that has not begun");
        assertThat(world.terrain().size()).isZero();
    }

    @Test
    void noLogGoesOnWithTheChainOfAnother() throws IOException {
        writeChain();
        replay().run();
        begin();
        write(Call.CHAIN, GROUND, 0, OPEN);
        assertRefused(replay(), "a chain goes on that has not begun");
        assertThat(world.terrain().size()).isZero();
    }

    @Test
    void noLogGoesOnWithTheFormOfAnother() throws IOException {
        writeForm();
        replay().run();
        begin();
        write(Call.JOINT_ALONE, 0);
        assertRefused(replay(), "a joint comes without a form");
        assertThat(world.joints().size()).isZero();
    }
}
