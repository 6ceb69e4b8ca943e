package io.github.circles2d.playground;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.playground.HudLayout.Graphs;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Scenes fill the window, and panels and cards stand beside them where they can. */
class HudLayoutTest {
    private static final double USUAL = 1.6;
    private static final int CARD = 142;

    private static HudLayout of(int width, int height, double aspect) {
        return HudLayout.of(width, height, aspect, true, Graphs.IF_THERE_IS_ROOM, false);
    }

    @Test
    void atAnySizeAllIsInTheCanvasAndNothingIsOverAnother() {
        for (int width = 340; width <= 1900; width += 17) {
            for (int height = 130; height <= 1100; height += 13) {
                for (double aspect : new double[] {0.2, 1, USUAL, 4}) {
                    for (Graphs graphs : new Graphs[] {Graphs.NO, Graphs.IF_THERE_IS_ROOM}) {
                        HudLayout layout = HudLayout.of(width, height, aspect, true, graphs, false);
                        List<Rectangle> all = new ArrayList<>(layout.panels());
                        all.add(layout.arena());
                        requireApart(layout, all, width, height);
                        assertThat(layout.message(new Dimension(Math.min(300, layout.messageWidth()), HudLayout.LINE)))
                                .matches(note -> !note.intersects(layout.arena()))
                                .matches(note -> layout.canvas().contains(note));
                    }
                }
            }
        }
    }

    private static void requireApart(HudLayout layout, List<Rectangle> all, int width, int height) {
        for (int k = 0; k < all.size(); k++) {
            assertThat(layout.canvas().contains(all.get(k)))
                    .as("%d x %d: %s", width, height, layout)
                    .isTrue();
            assertThat(all.subList(0, k))
                    .as("%d x %d: %s", width, height, layout)
                    .noneMatch(all.get(k)::intersects);
        }
    }

    @Test
    void anArenaFillsItsRoomAndKeepsItsShape() {
        for (double aspect : new double[] {0.2, 1, USUAL, 4}) {
            for (int width = 400; width <= 1900; width += 50) {
                for (int height = 200; height <= 1100; height += 50) {
                    HudLayout layout = of(width, height, aspect);
                    Rectangle arena = layout.arena();
                    assertThat(Math.abs(arena.width - aspect * arena.height)).isLessThanOrEqualTo(1 + aspect);
                    assertThat(arena.width >= layout.scene().width - 1 || arena.height >= layout.scene().height - 1)
                            .isTrue();
                    double most = Math.min(width - 16, (height - 52) * aspect);
                    assertThat(arena.width).isGreaterThan((int) (0.8 * most - 2));
                }
            }
        }
    }

    @Test
    void panelsAreAColumnInAWideWindowRowsInATallOneAndALineInASmallOne() {
        HudLayout wide = of(1280, 693, USUAL);
        assertThat(wide.figures().x).isGreaterThan(wide.arena().x + wide.arena().width);
        assertThat(wide.energy().y).isGreaterThan(wide.steps().y).isGreaterThan(wide.legend().y);
        HudLayout tall = of(600, 719, USUAL);
        assertThat(tall.arena().y).isGreaterThan(tall.energy().y);
        assertThat(tall.steps().y).as("beside the figures").isEqualTo(tall.figures().y);
        HudLayout narrow = of(420, 900, USUAL);
        assertThat(narrow.steps().y).as("under the figures").isGreaterThan(narrow.figures().y);
        assertThat(narrow.panels()).hasSize(4);
        HudLayout small = of(700, 500, USUAL);
        assertThat(small.figures().height).isEqualTo(HudLayout.LINE);
        assertThat(small.panels()).containsExactly(small.figures(), small.legend());
        assertThat(of(420, 180, USUAL).legend()).isNull();
    }

    @Test
    void graphsThatHaveNoRoomAreShownOverTheSceneOnDemand() {
        HudLayout asked = HudLayout.of(700, 500, USUAL, true, Graphs.OVER_THE_SCENE, false);
        assertThat(of(700, 500, USUAL).steps()).isNull();
        assertThat(asked.steps()).matches(asked.arena()::intersects);
        assertThat(asked.arena()).isEqualTo(of(700, 500, USUAL).arena());
        assertThat(of(1280, 250, USUAL).steps()).as("a low column").isNull();
        assertThat(HudLayout.of(1280, 250, USUAL, true, Graphs.OVER_THE_SCENE, false)
                        .steps())
                .isNotNull();
        assertThat(HudLayout.of(1280, 693, USUAL, true, Graphs.NO, false).panels())
                .hasSize(2);
    }

    @Test
    void cardsAreOverNoPanelAndOverTheSceneOnlyIfThereIsNoOtherPlace() {
        int beside = 0;
        for (int width = 340; width < 1900; width += 20) {
            for (int height = 200; height < 1100; height += 50) {
                HudLayout layout = of(width, height, USUAL);
                List<Rectangle> cards = cards(layout, CARD, CARD);
                for (Rectangle card : cards) {
                    assertThat(layout.canvas().contains(card)).isTrue();
                    assertThat(List.of(layout.figures())).noneMatch(card::intersects);
                    assertThat(cards).filteredOn(other -> other != card).noneMatch(card::intersects);
                    if (card.intersects(layout.arena())) {
                        assertThat(width).isGreaterThanOrEqualTo(HudLayout.CARDS_FROM);
                        assertThat(layout.panels()).noneMatch(card::intersects);
                    } else {
                        beside++;
                    }
                }
            }
        }
        assertThat(beside).isGreaterThan(1000);
    }

    @Test
    void aCardThatStaysMayMakeTheSceneSmaller() {
        assertThat(of(800, 456, USUAL).figures().height).as("a line").isEqualTo(HudLayout.LINE);
        HudLayout open = HudLayout.of(800, 456, USUAL, true, Graphs.IF_THERE_IS_ROOM, true);
        assertThat(open.figures().x).isGreaterThan(open.arena().x + open.arena().width);
        assertThat(cards(open, CARD)).hasSize(1).noneMatch(open.arena()::intersects);
        assertThat(HudLayout.of(640, 300, 2.5, true, Graphs.NO, true).arena())
                .as("but not by more")
                .isEqualTo(of(640, 300, 2.5).arena());
    }

    private static List<Rectangle> cards(HudLayout layout, int... heights) {
        return Arrays.stream(layout.cards(heights)).filter(card -> card != null).toList();
    }

    @Test
    void aCardThatHasNoPlaceLeavesItToTheNext() {
        HudLayout layout = of(1280, 693, USUAL);
        Rectangle[] places = layout.cards(2000, CARD);
        assertThat(places[0]).isNull();
        assertThat(places[1]).isNotNull();
        assertThat(layout.cards(0, CARD)).containsExactly(null, places[1]);
    }

    @Test
    void twoCardsStandBesideAWideScene() {
        HudLayout layout = of(1280, 693, USUAL);
        assertThat(cards(layout, CARD, CARD))
                .hasSize(2)
                .noneMatch(layout.arena()::intersects)
                .allMatch(card -> layout.panels().stream().noneMatch(card::intersects));
        HudLayout low = of(1280, 500, USUAL);
        assertThat(cards(low, CARD, CARD))
                .hasSize(2)
                .as("beside the scene, or in place of the graphs")
                .noneMatch(low.arena()::intersects);
    }
}
