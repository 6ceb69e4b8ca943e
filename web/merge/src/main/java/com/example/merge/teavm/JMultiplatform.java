package com.example.merge.teavm;

/** In place of the class of this name that gdx-teavm asks for a map. */
public final class JMultiplatform {
    private static final JMultiplatform INSTANCE = new JMultiplatform();
    private final JPlatformMap map = new JPlatformMap();

    private JMultiplatform() {}

    public static JMultiplatform getInstance() {
        return INSTANCE;
    }

    public JPlatformMap getMap() {
        return map;
    }
}
