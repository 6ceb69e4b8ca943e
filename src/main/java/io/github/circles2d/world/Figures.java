package io.github.circles2d.world;

import java.util.Map;

/**
 * Figures of a simulation and of its last step.
 *
 * @param circles number of circles
 * @param candidatePairs pairs whose distance the broad phase tested in the last step
 * @param contacts contacts listed in the last step
 * @param greatestContacts greatest number of contacts of one circle in the last step
 * @param bytesHeld memory held for circles and contacts
 * @param stageMillis time spent in each stage since the start, by its name; empty unless profiling
 * @param device what the pipeline runs on, in words
 */
public record Figures(
        int circles,
        long candidatePairs,
        int contacts,
        int greatestContacts,
        long bytesHeld,
        Map<String, Double> stageMillis,
        String device) {}
