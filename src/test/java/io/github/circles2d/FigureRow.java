package io.github.circles2d;

import java.util.List;
import java.util.function.Supplier;

/** A scene that is measured, which is run when its figures are asked for. */
record FigureRow(String name, Supplier<List<RowFigure>> figures) {
    @Override
    public String toString() {
        return name;
    }
}
