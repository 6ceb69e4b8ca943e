package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.Backend;
import io.github.circles2d.World;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The card of the circle that was clicked. */
class SelectionTest {
    private static final float FRAME = 1 / 60f;

    private final Session session = new Session(Stages.named("empty"), Backend.JVM);
    private final Frame frame = new Frame();

    @AfterEach
    void close() {
        session.close();
    }

    private void click(float x, float y) {
        session.press(x, y);
        session.release();
        session.frame(FRAME, frame);
    }

    @Test
    void aClickSelectsACircleUntilOneOnNothing() {
        long ball = session.world().add(80, 30, 2, 4);
        session.setTool(ToolKind.GRAB);
        click(80, 30);
        assertThat(frame.card).hasSize(7);
        assertThat(frame.card.get(0)).isEqualTo("circle " + World.id(ball) + ", kind 0");
        assertThat(frame.card.get(4)).isEqualTo("radius 2.00, mass 4.00");
        assertThat(frame.marks).as("a ring around it").anyMatch(mark -> mark.radius() == 2.5f);
        String place = frame.card.get(1);
        for (int k = 0; k < 200; k++) {
            session.frame(FRAME, frame);
        }
        assertThat(frame.card.get(1)).as("it follows").isNotEqualTo(place);
        assertThat(frame.card.get(5)).as("it lies on the floor").startsWith("contacts  1, force");
        assertThat(frame.card.get(6)).isEqualTo("joints  0");
        for (int k = 0; k < 200; k++) {
            session.frame(FRAME, frame);
        }
        assertThat(frame.card.get(0)).endsWith(", asleep");
        session.setTool(ToolKind.EXPLODE);
        click(10, 60);
        assertThat(frame.card).as("another tool selects nothing").isNotEmpty();
        session.setTool(ToolKind.GRAB);
        click(10, 60);
        assertThat(frame.card).isEmpty();
        assertThat(frame.marks).noneMatch(mark -> mark.radius() == 2.5f);
    }

    @Test
    void theCardGoesWithTheCircleAndWithTheScene() {
        long ball = session.world().add(80, 30, 2, 4);
        click(80, 30);
        assertThat(frame.card).isNotEmpty();
        session.switchTo(Backend.JVM);
        session.frame(FRAME, frame);
        assertThat(frame.card).as("the same circle on another back end").isNotEmpty();
        session.world().remove(ball);
        session.frame(FRAME, frame);
        assertThat(frame.card).isEmpty();
        session.world().add(80, 30, 2, 4);
        click(80, 30);
        session.restart();
        session.frame(FRAME, frame);
        assertThat(frame.card).isEmpty();
    }
}
