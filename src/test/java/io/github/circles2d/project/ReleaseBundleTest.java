package io.github.circles2d.project;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The check of a release finds each fault in a bundle that is right otherwise. */
class ReleaseBundleTest {
    private static final String POM = "<project><groupId>io.github.circles2d</groupId><artifactId>game</artifactId>"
            + "<version>1.2.3</version><name>n</name><description>d</description><url>u</url>"
            + "<licenses><license><name>l</name><url>lu</url></license></licenses>"
            + "<developers><developer><name>a</name><email>e</email></developer></developers>"
            + "<scm><connection>c</connection><developerConnection>dc</developerConnection><url>su</url></scm>"
            + "<dependencies><dependency><artifactId>x</artifactId><version>1</version></dependency></dependencies>"
            + "</project>";

    @TempDir
    Path folder;

    @BeforeEach
    void makeABundleWithoutFaults() throws Exception {
        Files.createDirectories(file("").getParent());
        add(".pom", POM.getBytes(StandardCharsets.UTF_8));
        addJar(".jar", "META-INF/LICENSE", "META-INF/MANIFEST.MF", "a/B.class", "a/B$C.class", "a/package-info.class");
        addJar("-sources.jar", "a/B.java");
        addJar("-javadoc.jar", "index.html");
    }

    private Path file(String ending) {
        return folder.resolve("io/github/circles2d/game/1.2.3/game-1.2.3" + ending);
    }

    private void add(String ending, byte[] bytes) throws Exception {
        Files.write(file(ending), bytes);
        Files.writeString(file(ending + ".asc"), "signature");
        for (String algorithm : new String[] {"MD5", "SHA-1"}) {
            byte[] sum = MessageDigest.getInstance(algorithm).digest(bytes);
            String addition = algorithm.equals("MD5") ? ".md5" : ".sha1";
            Files.writeString(file(ending + addition), HexFormat.of().formatHex(sum));
        }
    }

    /** Each entry has its name for its bytes. */
    private void addJar(String ending, String... entries) throws Exception {
        Path jar = Files.createTempFile(folder.getParent(), "bundle", ".jar");
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
            for (String entry : entries) {
                out.putNextEntry(new JarEntry(entry.replace("?", "")));
                out.write(entry.replace("?", "-SNAPSHOT").getBytes(StandardCharsets.UTF_8));
            }
        }
        add(ending, Files.readAllBytes(jar));
        Files.delete(jar);
    }

    private List<String> problems() throws IOException {
        return ReleaseBundle.problems(folder, "1.2.3", List.of("game")).stream()
                .map(problem -> problem.replace("io/github/circles2d/game/1.2.3/", ""))
                .toList();
    }

    @Test
    void aBundleWithoutFaultsHasNone() throws IOException {
        assertThat(problems()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {".pom", "-sources.jar.asc", "-javadoc.jar.md5", ".jar.sha1"})
    void aMissingFileIsNamed(String ending) throws IOException {
        Files.delete(file(ending));
        assertThat(problems()).contains("game-1.2.3" + ending + " is missing");
    }

    @Test
    void aFileThatIsNotPartOfABundleIsNamed() throws IOException {
        Files.createFile(folder.resolve("maven-metadata.xml"));
        assertThat(problems()).containsExactly("maven-metadata.xml is not expected");
    }

    @ParameterizedTest
    @ValueSource(strings = {".md5", ".sha1"})
    void aSumOfOtherBytesIsNamed(String ending) throws IOException {
        Files.writeString(file(".pom"), POM + "\n");
        assertThat(problems()).contains("game-1.2.3.pom" + ending + " is not the sum of its file");
    }

    @ParameterizedTest
    @CsvSource({
        "<name>n</name>, <name> </name>, lacks name",
        "<description>d</description>, '', lacks description",
        "<url>u</url>, '', lacks url",
        "<url>lu</url>, '', lacks licenses/license/url",
        "<email>e</email>, '', lacks developers/developer/email",
        "<connection>c</connection>, '', lacks scm/connection",
        "<url>su</url>, '', lacks scm/url",
        "<url>u</url>, <url>${circles2d.repository}</url>, has ${",
        "<version>1</version>, <version>1-SNAPSHOT</version>, has -SNAPSHOT",
        "<version>1</version>, '', has a dependency without a version",
        "<name>n</name>, <name>n</name><parent></parent>, has <parent>",
        "<version>1.2.3</version>, <version>1.2.4</version>, is that of io.github.circles2d:game:1.2.4",
        "</project>, '', cannot be read"
    })
    void aFaultOfThePomIsNamed(String right, String wrong, String problem) throws Exception {
        add(".pom", POM.replace(right, wrong).getBytes(StandardCharsets.UTF_8));
        assertThat(problems()).hasSize(1).first().asString().startsWith("game-1.2.3.pom " + problem);
    }

    @Test
    void sourcesOfAllClassesMustBeThereAndPagesAndALicence() throws Exception {
        addJar(".jar", "a/B.class", "a/D.class");
        addJar("-javadoc.jar", "README");
        assertThat(problems())
                .containsExactlyInAnyOrder(
                        "game-1.2.3.jar lacks META-INF/LICENSE",
                        "game-1.2.3-javadoc.jar lacks index.html",
                        "game-1.2.3-sources.jar lacks a/D.java");
    }

    @Test
    void aSnapshotIsNone() throws Exception {
        addJar(".jar", "META-INF/LICENSE", "META-INF/MANIFEST.MF?", "a/B.class");
        assertThat(problems()).containsExactly("game-1.2.3.jar has -SNAPSHOT in META-INF/MANIFEST.MF");
        assertThat(ReleaseBundle.problems(folder, "1-SNAPSHOT", List.of())).contains("1-SNAPSHOT is a snapshot");
    }
}
