package io.github.circles2d.world.jvm.bodies;

/**
 * A line of a {@link RigidThing}, against the place of that. Of a hollow the place is its centre, the normal is that at its middle, turned, the length minus
 * its radius, the thickness the cosine of half its opening.
 */
final class RigidLine {
    /** Its number among those of the thing. */
    final int number;

    // as the thing lies unturned: where its core begins, and its normal
    private float ownX;
    private float ownY;
    private float ownNx;
    private float ownNy;

    float length;
    float thickness;

    // as the thing has turned
    float x;
    float y;
    float nx;
    float ny;

    RigidLine(int number) {
        this.number = number;
    }

    void set(float px, float py, float normalX, float normalY, float itsLength, float thick) {
        ownX = px;
        ownY = py;
        ownNx = normalX;
        ownNy = normalY;
        length = itsLength;
        thickness = thick;
    }

    void turn(float cos, float sin) {
        x = cos * ownX - sin * ownY;
        y = sin * ownX + cos * ownY;
        nx = cos * ownNx - sin * ownNy;
        ny = sin * ownNx + cos * ownNy;
    }

    boolean isHollow() {
        return length < 0f;
    }
}
