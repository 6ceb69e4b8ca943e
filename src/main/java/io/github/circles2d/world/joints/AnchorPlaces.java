package io.github.circles2d.world.joints;

import io.github.circles2d.world.terrain.BodyTable;
import java.util.Arrays;

/** By joint: the body of terrain that its anchor is on, and where. */
public final class AnchorPlaces {
    /** In place of a body: that of an anchor in the world, and of joints without one. */
    public static final int WORLD = BodyTable.GROUND;

    private int[] body = new int[0];

    /** In the body's coordinates. */
    private float[] onBody = new float[0];

    private int count;

    void setRoom(int joints) {
        body = Arrays.copyOf(body, joints);
        onBody = Arrays.copyOf(onBody, 2 * joints);
    }

    /** How many anchors are on bodies. */
    public int count() {
        return count;
    }

    /** The body, or {@link #WORLD}. */
    public int body(int joint) {
        return body[joint];
    }

    boolean isOnBody(int joint) {
        return body[joint] != WORLD;
    }

    /** If the anchor is on a body. */
    float x(int joint) {
        return onBody[2 * joint];
    }

    float y(int joint) {
        return onBody[2 * joint + 1];
    }

    /** A new joint, whose anchor is on no body. */
    void begin(int joint) {
        body[joint] = WORLD;
    }

    /** The anchor of a new joint is on a body. */
    void enter(int joint, int itsBody) {
        body[joint] = itsBody;
        count++;
    }

    /** Puts an anchor somewhere else on its body. */
    void set(int joint, float x, float y) {
        onBody[2 * joint] = x + 0f;
        onBody[2 * joint + 1] = y + 0f;
    }

    /** A joint goes. */
    void leave(int joint) {
        if (isOnBody(joint)) {
            count--;
        }
    }

    /** No joints. */
    void clear() {
        count = 0;
    }

    long bytes() {
        return 4L * (body.length + onBody.length);
    }
}
