package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.circles2d.Backend;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** Contacts as a person sees them: those of the last step, with their normals and impulses. */
class ContactsTest {
    private static final float FRAME = 1 / 60f;

    private final Frame frame = new Frame();

    private void frames(Session session, int count) {
        for (int k = 0; k < count; k++) {
            session.frame(FRAME, frame);
        }
    }

    @Test
    void aCircleAtRestHasOneContactWhoseImpulseCarriesIt() {
        try (Session session = new Session(Stages.named("empty"), Backend.JVM)) {
            float x = (session.world().minX() + session.world().maxX()) / 2;
            float radius = session.sandbox().grain().radius();
            long circle = session.world().add(x, session.world().minY() + radius, radius, 4);
            frames(session, 20);
            assertThat(frame.contacts).as("nobody wants to see them").isZero();
            session.toggleContacts();
            frames(session, 20); // before it sleeps
            assertThat(frame.showsContacts).isTrue();
            assertThat(frame.contacts).isEqualTo(1);
            assertThat(frame.contact[0]).isCloseTo(x, within(radius));
            assertThat(frame.contact[1]).isCloseTo(session.world().minY(), within(0.1f * radius));
            assertThat(Math.abs(frame.contact[3])).as("upright").isCloseTo(1, within(1e-4f));
            float weight = session.world().mass(circle) * session.sandbox().gravity() * Sandbox.TIME_STEP;
            assertThat(frame.contact[4]).isCloseTo(weight, within(0.05f * weight));
            assertThat(ContactPainter.length(frame, frame.contact[4])).isCloseTo(radius, within(0.1 * radius));
            session.toggleContacts();
            frames(session, 2);
            assertThat(frame.contacts).isZero();
        }
    }

    @Test
    void theyComeAgainAfterAStepBackAnotherBackEndAndAnotherScene() {
        try (Session session = new Session(Stages.named("pegs"), Backend.JVM)) {
            session.toggleContacts();
            frames(session, 120);
            assertThat(frame.contacts).isPositive();
            session.stepBack();
            frames(session, 1);
            assertThat(frame.contacts)
                    .as("none is known of a step that was taken back")
                    .isZero();
            session.stepOnce();
            frames(session, 1);
            assertThat(frame.contacts).isPositive();
            session.togglePause();
            List<Consumer<Session>> changes =
                    List.of(s -> s.switchTo(Backend.JVM), Session::restart, s -> s.load(Stages.named("hourglass")));
            for (Consumer<Session> change : changes) {
                change.accept(session);
                frames(session, 120);
                assertThat(frame.contacts).isBetween(1, Contacts.MOST);
            }
        }
    }

    @Test
    void theyChangeNoStep() {
        try (Session seen = new Session(Stages.named("hourglass"), Backend.JVM);
                Sandbox unseen = new Sandbox(Stages.named("hourglass"), Backend.JVM)) {
            seen.toggleContacts();
            for (int k = 0; k < 60; k++) {
                seen.stepOnce();
                unseen.stepOnce(() -> {});
            }
            assertThat(seen.world().hash()).isEqualTo(unseen.world().hash());
        }
    }
}
