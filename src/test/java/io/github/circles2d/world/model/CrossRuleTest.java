package io.github.circles2d.world.model;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

class CrossRuleTest {
    @Test
    void scaleIsAPowerOfTwoThatGivesARange44BitsAndUnitIsItsInverse() {
        assertAll(
                () -> assertEquals(0x1p44f, CrossRule.scaleOf(1f)),
                () -> assertEquals(0x1p-44f, CrossRule.unitOf(1f)),
                () -> assertEquals(0x1p44f, CrossRule.scaleOf(Math.nextDown(2f))),
                () -> assertEquals(0x1p43f, CrossRule.scaleOf(2f)),
                () -> assertEquals(0x1p45f, CrossRule.scaleOf(0.75f)),
                () -> assertEquals(0x1p-83f, CrossRule.scaleOf(Float.MAX_VALUE)),
                () -> assertEquals(0x1p83f, CrossRule.unitOf(Float.MAX_VALUE)));
    }

    @Test
    void scaleAndUnitAreNormalForAnyRange() {
        for (float range : new float[] {0f, Float.MIN_VALUE, Float.MIN_NORMAL, 0x1p-81f, 0x1p-80f}) {
            assertEquals(0x1p124f, CrossRule.scaleOf(range));
            assertEquals(0x1p-124f, CrossRule.unitOf(range));
        }
        for (float range : new float[] {Float.POSITIVE_INFINITY, Float.NaN}) {
            assertEquals(0x1p-84f, CrossRule.scaleOf(range));
            assertEquals(0x1p84f, CrossRule.unitOf(range));
        }
    }

    @Test
    void termsAreTruncatedAndCut() {
        assertAll(
                () -> assertEquals(1, CrossRule.toFixed(1.99f, 1f)),
                () -> assertEquals(-1, CrossRule.toFixed(-1.99f, 1f)),
                () -> assertEquals(0, CrossRule.toFixed(-0f, 0x1p124f)),
                () -> assertEquals(0, CrossRule.toFixed(Float.MIN_VALUE, 0x1p44f)),
                () -> assertEquals(1L << 44, CrossRule.toFixed(1f, 0x1p44f)),
                () -> assertEquals(1L << 56, CrossRule.toFixed(4096f, 0x1p44f)),
                () -> assertEquals(1L << 56, CrossRule.toFixed(4097f, 0x1p44f)),
                () -> assertEquals(-(1L << 56), CrossRule.toFixed(-1e38f, 0x1p124f)),
                () -> assertEquals(1L << 56, CrossRule.toFixed(Float.POSITIVE_INFINITY, 0x1p-84f)),
                () -> assertEquals(1L << 56, CrossRule.toFixed(Float.NaN, 0x1p-84f)));
    }

    @Test
    void aTermComesBackAsItWasUnlessItIsTiny() {
        Random random = new Random(1);
        for (int k = 0; k < 10_000; k++) {
            float range = (float) Math.exp(random.nextGaussian() * 10);
            float scale = CrossRule.scaleOf(range);
            float unit = CrossRule.unitOf(range);
            float v = (float) (range * (random.nextBoolean() ? 1 : -1) * Math.pow(2, -20 + 31 * random.nextDouble()));
            assertEquals(1f, scale * unit);
            assertEquals(v, CrossRule.fromFixed(CrossRule.toFixed(v, scale), unit));
        }
    }

    @Test
    void sumsThatCancelAreZero() {
        float scale = CrossRule.scaleOf(0.3f);
        long sum = CrossRule.toFixed(0.7f, scale) + CrossRule.toFixed(0.2f, scale) + CrossRule.toFixed(-0.7f, scale);
        assertEquals(0.2f, CrossRule.fromFixed(sum, CrossRule.unitOf(0.3f)));
    }

    @Test
    void sumsAreRoundedToTheNearestFloat() {
        assertEquals(16777216f, CrossRule.fromFixed(16777217, 1f));
        assertEquals(16777220f, CrossRule.fromFixed(16777219, 1f));
        assertEquals(-0x1p63f * 0x1p-44f, CrossRule.fromFixed(Long.MIN_VALUE, 0x1p-44f));
    }

    @Test
    void loadAndShare() {
        assertAll(
                () -> assertEquals(8193, CrossRule.loadOfHeavy(1f, 1f)),
                () -> assertEquals(4097, CrossRule.loadOfHeavy(3f, 1f)),
                () -> assertEquals(1, CrossRule.loadOfHeavy(3f, 0f)),
                () -> assertEquals(1, CrossRule.loadOfHeavy(1e9f, 1e-9f)),
                () -> assertEquals(1f, CrossRule.crossShare(1)),
                () -> assertEquals(1f, CrossRule.crossShare(16384)),
                () -> assertEquals(16385f / 16384f, CrossRule.crossShare(16385)),
                () -> assertEquals(2.5f, CrossRule.crossShare(40960)),
                () -> assertEquals(1f / 5f, CrossRule.crossMass(2f, 1f, 3f)));
    }

    @Test
    void theLighterCircleIsTheLightOneAndIfTheyAreAlikeTheFiner() {
        assertTrue(CrossRule.isFinerLight(2f, 1f));
        assertTrue(CrossRule.isFinerLight(1f, 1f));
        assertTrue(CrossRule.isFinerLight(1f, 0f));
        assertFalse(CrossRule.isFinerLight(0f, 1f));
    }

    @Test
    void elasticCirclesWaitToBounceUnlessOneIsStaticOrTheyWouldBeTooDeep() {
        assertTrue(CrossRule.mayWait(1f, 1f, 0.1f, 1f, 1f));
        assertFalse(CrossRule.mayWait(1f, 0f, 0.1f, 1f, 1f));
        assertFalse(CrossRule.mayWait(0.9f, 1f, 0.1f, 1f, 1f));
        assertTrue(CrossRule.mayWait(1f, 1f, -0.5f, 1f, 1f));
        assertFalse(CrossRule.mayWait(1f, 1f, Math.nextDown(-0.5f), 1f, 1f));
        assertTrue(CrossRule.mayWait(1f, 1f, -4f, 1f, 99f));
        assertFalse(CrossRule.mayWait(1f, 1f, Math.nextDown(-4f), 99f, 1f));
    }

    @Test
    void rangesAreThoseOfTheSpeedThatTakesACircleItsRadiusFarInASubStep() {
        assertEquals(120f, CrossRule.velocityRange(0.5f, 240f));
        assertEquals(480f, CrossRule.impulseRange(0.5f, 240f, 0.25f));
        assertEquals(Float.POSITIVE_INFINITY, CrossRule.impulseRange(0.5f, 240f, 0f));
    }
}
