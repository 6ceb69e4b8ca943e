package io.github.circles2d.bench.results;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TableTest {
    @TempDir
    Path folder;

    private final Table table = new Table(List.of("a"), List.of("a", "b"));

    @Test
    void whatIsSavedIsReadBackWithCommasQuotesAndLineBreaks() throws IOException {
        table.put(Map.of("a", "1", "b", "plain"));
        table.put(Map.of("a", "2", "b", "with, comma and \"quotes\""));
        table.put(Map.of("a", "3", "b", "two\nlines"));
        table.put(Map.of("a", "4"));
        Path file = folder.resolve("t.csv");
        table.save(file);
        Table read = Table.read(file, new Table(List.of("a"), List.of("a", "b")));
        assertThat(read.rows()).isEqualTo(table.rows());
        assertThat(Files.list(folder)).containsExactly(file);
    }

    @Test
    void aRowWithTheSameKeyTakesThePlaceOfTheOldOne() {
        table.put(Map.of("a", "1", "b", "old"));
        table.put(Map.of("a", "2", "b", "other"));
        table.put(Map.of("a", "1", "b", "new"));
        assertThat(table.rows()).extracting(row -> row.get("b")).containsExactly("new", "other");
    }

    @Test
    void rowsAreFoundByTheirValues() {
        table.put(Map.of("a", "1", "b", "x"));
        table.put(Map.of("a", "2", "b", "y"));
        table.put(Map.of("a", "3", "b", "x"));
        assertThat(table.rows("b", "x")).extracting(row -> row.get("a")).containsExactly("1", "3");
        assertThat(table.rows("b", "x", "a", "3")).hasSize(1);
        assertThat(table.rows("b", "z")).isEmpty();
    }

    @Test
    void columnsThatATableNoLongerHasAreLeftOut() throws IOException {
        Path file = folder.resolve("t.csv");
        Files.writeString(file, "a,gone,b\n1,2,3\n");
        Table read = Table.read(file, new Table(List.of("a"), List.of("a", "b", "later")));
        assertThat(read.rows()).containsExactly(Map.of("a", "1", "b", "3", "later", ""));
    }

    @Test
    void aDamagedFileIsRefused() throws IOException {
        Path file = folder.resolve("t.csv");
        Files.writeString(file, "a,b\n1\n");
        assertThatThrownBy(() -> Table.read(file, table))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("t.csv");
        Files.writeString(file, "");
        assertThatThrownBy(() -> Table.read(file, table)).isInstanceOf(IOException.class);
    }

    @Test
    void anUnknownColumnIsRefused() {
        assertThatThrownBy(() -> table.put(Map.of("a", "1", "c", "2")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("c");
    }
}
