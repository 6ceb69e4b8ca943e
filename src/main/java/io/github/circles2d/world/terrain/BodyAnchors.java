package io.github.circles2d.world.terrain;

import io.github.circles2d.world.model.AnchorRow;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.Rotation;
import io.github.circles2d.world.model.Velocity;

/** Where places of bodies are, and how they move: the anchors of joints, and what callers ask for. */
public final class BodyAnchors {
    private final BodyTable bodies;

    // from the pivot to the place
    private double armX;
    private double armY;

    public BodyAnchors(BodyTable bodies) {
        this.bodies = bodies;
    }

    private void turn(int angle, float x, float y) {
        double cos = Rotation.cos(angle);
        double sin = Rotation.sin(angle);
        armX = cos * x - sin * y;
        armY = sin * x + cos * y;
    }

    /** Where a place of a body is now, inside along axes that wrap. */
    public float x(int body, float x, float y, Bounds bounds) {
        turn(bodies.angle[body], x, y);
        return bounds.placeX((float) BodyTable.place(bodies.x[body] + armX, bounds.minX(), bounds.periodX()));
    }

    public float y(int body, float x, float y, Bounds bounds) {
        turn(bodies.angle[body], x, y);
        return bounds.placeY((float) BodyTable.place(bodies.y[body] + armY, bounds.minY(), bounds.periodY()));
    }

    /** Where a place of a body is, with the body in such a pose. */
    public float x(BodyPoses poses, int body, float x, float y, Bounds bounds) {
        turn(poses.angle(body), x, y);
        return bounds.placeX((float) BodyTable.place(poses.x(body) + armX, bounds.minX(), bounds.periodX()));
    }

    public float y(BodyPoses poses, int body, float x, float y, Bounds bounds) {
        turn(poses.angle(body), x, y);
        return bounds.placeY((float) BodyTable.place(poses.y(body) + armY, bounds.minY(), bounds.periodY()));
    }

    /** A place of now in the body's coordinates, by the short way from its pivot. */
    public float onBodyX(int body, float x, float y, Bounds bounds) {
        way(body, x, y, bounds);
        return (float) (Rotation.cos(bodies.angle[body]) * armX + Rotation.sin(bodies.angle[body]) * armY);
    }

    public float onBodyY(int body, float x, float y, Bounds bounds) {
        way(body, x, y, bounds);
        return (float) (Rotation.cos(bodies.angle[body]) * armY - Rotation.sin(bodies.angle[body]) * armX);
    }

    private void way(int body, float x, float y, Bounds bounds) {
        armX = BodyTable.shortWay(bounds.placeX(x) - bodies.x[body], bounds.periodX());
        armY = BodyTable.shortWay(bounds.placeY(y) - bodies.y[body], bounds.periodY());
    }

    /** Fills a row of {@link AnchorRow} for a place of a body that moves in the step that begins. */
    public void fill(float[] rows, int row, int body, float x, float y, float dt, int subSteps, Bounds bounds) {
        bodies.plan(body, dt, subSteps, bounds);
        double omega = bodies.turn * Rotation.RADIANS_PER_UNIT / dt;
        turn(bodies.angle[body], x, y);
        double startX = armX;
        double startY = armY;
        for (int boundary = 0; boundary <= subSteps; boundary++) {
            double share = (double) boundary / subSteps;
            turn(bodies.angle[body] + (int) Rotation.nearest(bodies.turn * share), x, y);
            int at = AnchorRow.of(row, boundary, subSteps);
            rows[at + AnchorRow.DX] = (float) (bodies.travelX * share + (armX - startX));
            rows[at + AnchorRow.DY] = (float) (bodies.travelY * share + (armY - startY));
            rows[at + AnchorRow.VX] = Velocity.limitSpeed((float) (bodies.travelX / dt - omega * armY));
            rows[at + AnchorRow.VY] = Velocity.limitSpeed((float) (bodies.travelY / dt + omega * armX));
        }
    }
}
