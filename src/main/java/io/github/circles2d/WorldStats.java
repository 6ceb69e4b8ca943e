package io.github.circles2d;

import java.util.Map;

/**
 * The size of a world, its back end, and the work of its last step.
 *
 * @param circles number of circles
 * @param candidatePairs pairs whose distance the broad phase tested in the last step; back ends test the same ones if radii are
 *     alike, so that there is one level of the grid, no circle is static, as the JVM does not test those that do not move, and circles
 *     fill the arena, as the JVM fits its grid to where they are
 * @param contacts pairs of circles that were listed as contacts in the last step: they touch, or might have within the step
 * @param greatestContacts greatest number of contacts of one circle in the last step
 * @param awake circles that steps move: they neither sleep nor are static
 * @param bodies number of bodies of {@link World#bodies}
 * @param awakeBodies bodies that do not sleep
 * @param bodyContacts pairs of a body and something else, a body, a circle, a piece of terrain or a wall, that have contacts since the last step: they
 *     touch, or might have within the step. Of two bodies that touch there is one pair, however many points they touch at
 * @param bytesHeld bytes of memory that the engine holds for circles and contacts, on the device if there is one
 * @param stageMillis milliseconds spent in each stage since the world was built, by the stage's name; empty unless profiling
 * @param backend the back end that the world runs on; never {@link Backend#AUTO}
 * @param device the device, in words
 * @param reason why the world runs there
 * @param moves how often the world has moved between back ends
 * @param moveMillis what all moves together have taken, in milliseconds
 */
public record WorldStats(
        int circles,
        long candidatePairs,
        int contacts,
        int greatestContacts,
        int awake,
        int bodies,
        int awakeBodies,
        int bodyContacts,
        long bytesHeld,
        Map<String, Double> stageMillis,
        Backend backend,
        String device,
        String reason,
        int moves,
        double moveMillis) {}
