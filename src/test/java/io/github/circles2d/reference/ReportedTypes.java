package io.github.circles2d.reference;

import io.github.circles2d.Events;
import java.util.HashMap;
import java.util.Map;

/** The types of events that are reported. */
final class ReportedTypes {
    private static final int OF_PAIR = Events.BEGIN | Events.HIT | Events.END;

    private int all;
    private int walls;

    /** By the lesser kind times 256 plus the greater one: what has been set since all were. */
    private final Map<Integer, Integer> ofPair = new HashMap<>();

    /** By kind: the same for walls. */
    private final Map<Integer, Integer> ofWalls = new HashMap<>();

    void set(int types) {
        all = types & OF_PAIR;
        walls = (types & Events.WALL) != 0 ? all : 0;
        ofPair.clear();
        ofWalls.clear();
    }

    void set(int kindA, int kindB, int types) {
        ofPair.put(pair(kindA, kindB), types);
    }

    void setWalls(int kind, int types) {
        ofWalls.put(kind, types);
    }

    private static int pair(int a, int b) {
        return 256 * Math.min(a, b) + Math.max(a, b);
    }

    boolean isOn() {
        int kinds = 256;
        boolean someOfAll = all != 0 && ofPair.size() < kinds * (kinds + 1) / 2 || walls != 0 && ofWalls.size() < kinds;
        return someOfAll
                || ofPair.values().stream().anyMatch(types -> types != 0)
                || ofWalls.values().stream().anyMatch(types -> types != 0);
    }

    boolean dependOnKinds() {
        return !ofPair.isEmpty() || !ofWalls.isEmpty();
    }

    /** The types of all pairs, or walls, of which nothing else has been set. */
    int ofAll(boolean ofWalls) {
        return ofWalls ? walls : all;
    }

    int of(int kindA, int kindB) {
        return ofPair.getOrDefault(pair(kindA, kindB), all);
    }

    int ofWalls(Circle c) {
        return ofWalls.getOrDefault(c.kind, walls);
    }
}
