package com.example.merge.teavm;

/** In place of the class of this name: a map in which gdx-teavm leaves addresses for extensions of libGDX. This game has none. */
public final class JPlatformMap {
    public void put(String key, Object value) {}
}
