package io.github.circles2d.opencl;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Tag("each-jdk")
class KernelSourceTest {
    @AfterEach
    void readFromTheJarAgain() {
        System.clearProperty(KernelSource.FOLDER_PROPERTY);
    }

    @Test
    void filesAreJoinedInOrderAndMarkedForTheCompilersMessages(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("A.cl"), "int a;\n");
        Files.writeString(folder.resolve("B.cl"), "int b;\n");
        System.setProperty(KernelSource.FOLDER_PROPERTY, folder.toString());
        KernelSource source = KernelSource.of("B.cl", "A.cl");
        assertThat(source.text()).isEqualTo("#line 1 \"B.cl\"\nint b;\n\n#line 1 \"A.cl\"\nint a;\n\n");
        assertThat(source).hasToString("B.cl + A.cl");
    }

    @Test
    void filesAreAddedBehindTheOthersAndDefinitionsKept(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("A.cl"), "int a;\n");
        Files.writeString(folder.resolve("B.cl"), "int b;\n");
        System.setProperty(KernelSource.FOLDER_PROPERTY, folder.toString());
        KernelSource first = KernelSource.of("B.cl").define("N", 3);
        KernelSource both = first.and("A.cl");
        assertThat(both.text()).isEqualTo(KernelSource.of("B.cl", "A.cl").text());
        assertThat(both).hasToString("B.cl + A.cl");
        assertThat(both.buildOptions()).containsExactly("-DN=3");
        assertThat(first).hasToString("B.cl");
    }

    @Test
    void aFileComesOnceAndBehindThoseThatItUses(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("Top.cl"), "// uses: Left.cl Right.cl\nint top;\n");
        Files.writeString(folder.resolve("Left.cl"), "// A comment.\n// uses: Base.cl\n");
        Files.writeString(folder.resolve("Right.cl"), "// uses: Left.cl\n// uses: Base.cl\n");
        Files.writeString(folder.resolve("Base.cl"), "int base;\n");
        System.setProperty(KernelSource.FOLDER_PROPERTY, folder.toString());
        KernelSource top = KernelSource.of("Top.cl", "Base.cl");
        assertThat(top).hasToString("Base.cl + Left.cl + Right.cl + Top.cl");
        assertThat(top.text()).startsWith("#line 1 \"Base.cl\"\nint base;\n\n#line 1 \"Left.cl\"\n// A comment.\n");
        assertThat(top.and(KernelSource.of("Right.cl")).text()).isEqualTo(top.text());
    }

    @Test
    void aRingIsRefusedWithItsFiles(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("Top.cl"), "// uses: A.cl\n");
        Files.writeString(folder.resolve("A.cl"), "// uses: B.cl\n");
        Files.writeString(folder.resolve("B.cl"), "// uses: A.cl\n");
        System.setProperty(KernelSource.FOLDER_PROPERTY, folder.toString());
        assertIllegalArgument("ring: A.cl uses B.cl uses A.cl", () -> KernelSource.of("Top.cl"));
    }

    @Test
    void aFileThatIsUsedButAbsentIsNamedWithItsUser(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("A.cl"), "// uses: Absent.cl\n");
        System.setProperty(KernelSource.FOLDER_PROPERTY, folder.toString());
        assertIllegalArgument("Absent.cl, which A.cl uses", () -> KernelSource.of("A.cl"));
    }

    @Test
    void twoTextsOfOneNameAreRefused() {
        assertIllegalArgument("text", () -> KernelSource.ofText("text", "a").and(KernelSource.ofText("text", "b")));
    }

    @Test
    void aLetterThatIsNotAsciiIsRefusedWithItsLine(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("A.cl"), "int a;\n// caf\u00e9\n");
        System.setProperty(KernelSource.FOLDER_PROPERTY, folder.toString());
        assertThatThrownBy(() -> KernelSource.of("A.cl"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("A.cl")
                .hasMessageContaining("line 2");
    }

    @Test
    void aFolderWithoutTheFileIsRefusedWithPropertyAndValue(@TempDir Path folder) {
        for (String bad :
                new String[] {folder.toString(), folder.resolve("none").toString(), "no\0path"}) {
            System.setProperty(KernelSource.FOLDER_PROPERTY, bad);
            assertThatThrownBy(() -> KernelSource.of("A.cl"))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContainingAll(KernelSource.FOLDER_PROPERTY, "'" + bad + "'", "a folder", "A.cl");
        }
    }

    @Test
    void anInterruptedThreadReadsAndStaysInterrupted(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("A.cl"), "int a;\n");
        System.setProperty(KernelSource.FOLDER_PROPERTY, folder.toString());
        Thread.currentThread().interrupt();
        try {
            assertThat(KernelSource.of("A.cl").text()).contains("int a;");
            assertThat(Thread.currentThread().isInterrupted()).isTrue();
        } finally {
            Thread.interrupted();
        }
    }

    @Test
    void aMissingFileIsNamed() {
        assertIllegalArgument("Absent.cl", () -> KernelSource.of("Absent.cl"));
    }

    @Test
    void definitionsBecomeOptionsAndLeaveTheOriginalAlone() {
        KernelSource plain = KernelSource.ofText("text", "");
        KernelSource defined = plain.define("N", 3).define("ON", true).define("F", 0.1f);
        assertThat(defined.buildOptions()).containsExactly("-DN=3", "-DON=1", "-DF=0x1.99999ap-4f");
        assertThat(plain.buildOptions()).isEmpty();
    }
}
