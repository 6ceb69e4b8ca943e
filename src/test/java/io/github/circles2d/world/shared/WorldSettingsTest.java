package io.github.circles2d.world.shared;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.SurfaceSettings;
import org.junit.jupiter.api.Test;

/** A change that the record does not see would be missing in snapshots. */
class WorldSettingsTest {
    private static final Bounds BOUNDS = new Bounds(0, 0, 1, 1);
    private static final Bounds OTHER = new Bounds(0, 0, 2, 1);

    private final WorldParameters start = new WorldParameters(BOUNDS, 1, 2, 0.5f, 4, 0);
    private final WorldSettings settings = new WorldSettings(new ContactEvents(), start);

    @Test
    void theRecordIsTheSameAsLongAsNothingChanges() {
        assertThat(settings.parameters()).isSameAs(start);
        settings.setGravity(1, 2);
        settings.setBounds(BOUNDS, BOUNDS);
        settings.stopWalls();
        settings.setSurfaces(start.surfaces());
        settings.stepped(0);
        assertThat(settings.parameters()).isSameAs(start);
    }

    @Test
    void theRecordSeesEachChange() {
        settings.setGravity(3, 2);
        assertThat(settings.parameters().gravityX()).isEqualTo(3);
        settings.setGravity(3, 4);
        assertThat(settings.parameters().gravityY()).isEqualTo(4);
        settings.setGravity(3, -0f);
        assertThat(settings.parameters().gravityY()).isEqualTo(-0f);
        settings.setGravity(3, 0f);
        assertThat(Float.floatToRawIntBits(settings.parameters().gravityY())).isZero();
        SurfaceSettings gripping = SurfaceSettings.NONE.ofCircles(0.5f, 0);
        settings.setSurfaces(gripping);
        assertThat(settings.parameters().surfaces()).isSameAs(gripping);
        settings.setBounds(BOUNDS, OTHER);
        assertThat(settings.parameters().bounds()).isSameAs(OTHER);
        assertThat(settings.parameters().wallStart()).isSameAs(BOUNDS);
        settings.stopWalls();
        assertThat(settings.parameters().wallStart()).isSameAs(OTHER);
        settings.stepped(0.5f);
        assertThat(settings.parameters().previousTimeStep()).isEqualTo(0.5f);
        settings.set(start);
        assertThat(settings.parameters()).isSameAs(start);
    }
}
