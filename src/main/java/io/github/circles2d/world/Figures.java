package io.github.circles2d.world;

import java.util.Map;

/**
 * Figures of a simulation, and of its last step: pairs whose distance the broad phase tested, contacts, the greatest number of contacts
 * of one circle, circles that neither sleep nor are static; bodies that are pushed, those that do not sleep, their pairs with contacts. Memory is in bytes; times by stage since the start, in milliseconds, are empty unless profiling.
 */
public record Figures(
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
        String device) {}
