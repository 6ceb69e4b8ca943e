package io.github.circles2d.world.shared;

import io.github.circles2d.world.circles.WorldParameters;
import io.github.circles2d.world.events.ContactEvents;
import io.github.circles2d.world.model.Bounds;
import io.github.circles2d.world.model.ContactSettings;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.SurfaceSettings;

/** What a world has besides circles and kinds: bounds, gravity, how contacts and surfaces are, and the length of the last step. */
public final class WorldSettings {
    private final ContactEvents events;
    private Bounds bounds;

    /** Where the walls start in the next step: where they were, or where they are if they jumped. */
    private Bounds wallStart;

    private float gravityX;
    private float gravityY;
    private float defaultRestitution;
    private int subSteps;
    private ContactSettings contacts;
    private SurfaceSettings surfaces;

    /** The length of the last step; 0 before the first. */
    private float timeStep;

    /** Whether circles fall asleep. */
    private boolean sleeps;

    /** All of it; null once something has changed, until it is asked for. */
    private WorldParameters parameters;

    /** As a world begins; events take part in each change of the bounds. */
    public WorldSettings(ContactEvents events, WorldParameters start) {
        this.events = events;
        set(start);
    }

    /** Takes over saved settings. */
    public void set(WorldParameters p) {
        bounds = p.bounds();
        events.setArena(bounds);
        wallStart = p.wallStart();
        gravityX = p.gravityX();
        gravityY = p.gravityY();
        defaultRestitution = p.restitution();
        subSteps = p.subSteps();
        contacts = p.contacts();
        surfaces = p.surfaces();
        timeStep = p.previousTimeStep();
        sleeps = p.sleeps();
        parameters = p;
    }

    private void changeIf(boolean other) {
        if (other) {
            parameters = null;
        }
    }

    public void setGravity(float x, float y) {
        changeIf(Float.compare(x, gravityX) != 0 || Float.compare(y, gravityY) != 0);
        gravityX = x;
        gravityY = y;
    }

    public void setBounds(Bounds start, Bounds next) {
        changeIf(start != wallStart || next != bounds);
        wallStart = start;
        bounds = next;
        events.setArena(next);
    }

    /** The next step moves no wall. */
    public void stopWalls() {
        changeIf(wallStart != bounds);
        wallStart = bounds;
    }

    public void setSurfaces(SurfaceSettings next) {
        changeIf(next != surfaces);
        surfaces = next;
    }

    /** A step has been made, of a length. */
    public void stepped(float length) {
        changeIf(length != timeStep);
        timeStep = length;
    }

    public boolean sleeps() {
        return sleeps;
    }

    public Bounds bounds() {
        return bounds;
    }

    public Bounds wallStart() {
        return wallStart;
    }

    /** Whether the next step moves a wall. */
    public boolean wallsMove() {
        return wallStart.differs(bounds);
    }

    public float gravityX() {
        return gravityX;
    }

    public float gravityY() {
        return gravityY;
    }

    public float defaultRestitution() {
        return defaultRestitution;
    }

    public int subSteps() {
        return subSteps;
    }

    public ContactSettings contacts() {
        return contacts;
    }

    public SurfaceSettings surfaces() {
        return surfaces;
    }

    /** The length of the last step; 0 before the first. */
    public float lastStep() {
        return timeStep;
    }

    /** The length of a sub-step of the last step; 0 before the first. */
    public float lastSubStep() {
        return timeStep / subSteps;
    }

    public void computeConstants(StepConstants constants, float length) {
        float before = timeStep == 0 ? length : timeStep;
        constants.set(length, subSteps, gravityX, gravityY, wallStart, bounds, before, contacts);
        constants.surfaces = surfaces;
        constants.sleeping = sleeps;
    }

    /** All of it. */
    public WorldParameters parameters() {
        if (parameters == null) {
            parameters = new WorldParameters(
                    bounds,
                    gravityX,
                    gravityY,
                    defaultRestitution,
                    subSteps,
                    timeStep,
                    contacts,
                    wallStart,
                    surfaces,
                    sleeps);
        }
        return parameters;
    }

    public long hash() {
        return WorldParameters.hash(bounds, wallStart, contacts, surfaces);
    }
}
