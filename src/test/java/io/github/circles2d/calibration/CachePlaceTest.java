package io.github.circles2d.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Tag("each-jdk")
class CachePlaceTest {
    private final Map<String, String> properties = new HashMap<>();
    private final Map<String, String> environment = new HashMap<>();

    /** Absolute, on whatever system this runs. */
    @TempDir
    Path folder;

    @BeforeEach
    void aUserOfLinux() {
        properties.put("os.name", "Linux");
        properties.put("user.home", folder.resolve("home").toString());
    }

    private Optional<Path> place() {
        return CachePlace.find(properties::get, environment::get);
    }

    @Test
    void onLinuxItIsTheXdgFolderWhereThatIsAbsoluteElseDotCache() {
        assertThat(place()).contains(folder.resolve("home/.cache/circles2d/calibration.txt"));
        environment.put("XDG_CACHE_HOME", "relative");
        assertThat(place()).contains(folder.resolve("home/.cache/circles2d/calibration.txt"));
        environment.put("XDG_CACHE_HOME", folder.resolve("xdg").toString());
        assertThat(place()).contains(folder.resolve("xdg/circles2d/calibration.txt"));
    }

    @Test
    void onMacOsItIsTheLibraryAndOnWindowsTheLocalData() {
        environment.put("XDG_CACHE_HOME", folder.resolve("xdg").toString());
        properties.put("os.name", "Mac OS X");
        assertThat(place()).contains(folder.resolve("home/Library/Caches/circles2d/calibration.txt"));
        properties.put("os.name", "Windows 11");
        assertThat(place()).isEmpty();
        environment.put("LOCALAPPDATA", folder.resolve("local").toString());
        assertThat(place()).contains(folder.resolve("local/circles2d/calibration.txt"));
    }

    @Test
    void thePropertyNamesAnotherFileOrTurnsItOff() {
        properties.put("circles2d.calibration", folder.resolve("mine").toString());
        assertThat(place()).contains(folder.resolve("mine"));
        properties.put("circles2d.calibration", "OFF");
        assertThat(place()).isEmpty();
        properties.put("circles2d.calibration", "");
        assertThat(place()).isPresent();
        for (String place : new String[] {"no\0path", folder.toString()}) {
            properties.put("circles2d.calibration", place);
            assertThatIllegalArgumentException()
                    .isThrownBy(this::place)
                    .withMessageContainingAll("circles2d.calibration", place, "must name a file", "'off'");
        }
    }

    @Test
    void aUserWithoutAHomeHasNone() {
        properties.put("user.home", "?"); // as in some containers
        assertThat(place()).isEmpty();
        properties.remove("user.home");
        assertThat(place()).isEmpty();
    }
}
