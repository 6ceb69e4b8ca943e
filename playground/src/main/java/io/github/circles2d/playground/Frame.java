package io.github.circles2d.playground;

import io.github.circles2d.Backend;
import java.util.Arrays;
import java.util.List;

/**
 * What a picture shows: circles with their colours, the figures beside them, and marks of the tools. The thread of the physics fills it,
 * and hands it over; nobody changes it while it is shown.
 */
final class Frame {
    /** Higher than those of the frames before. */
    long number;

    Arena arena = new Arena(0, 0, 1, 1);
    int circles;

    /** Those that neither sleep nor are static; whether the world may let circles sleep, and whether it does. */
    int awake;

    boolean canSleep;
    boolean sleeps;

    float[] x = new float[0];
    float[] y = new float[0];
    float[] radius = new float[0];
    int[] colour = new int[0];
    int[] rim = new int[0];

    /** Radians anticlockwise; NaN for a circle without a mark of how it has turned. */
    float[] angle = new float[0];

    /** Pieces of terrain, as {@link io.github.circles2d.Terrain#readPieces} gives them, and their colours. */
    int pieces;

    float[] piece = new float[0];
    int[] pieceColour = new int[0];

    /** Soft bodies that are filled, below their circles; and bodies that are pushed. */
    final Polygons blobs = new Polygons();

    final Polygons bodies = new Polygons();

    /** Joints, with x and y of both ends, and their colours. */
    int joints;

    float[] joint = new float[0];
    int[] jointColour = new int[0];

    /** Whether contacts are shown; and those of the last step, as {@link Contacts} has them. */
    boolean showsContacts;

    int contacts;
    float[] contact = new float[0];
    float meanImpulse;

    /** The length of the normal of a mean impulse. */
    float normalLength;

    /** Whether the times of the stages are shown; and these, empty before the first steps. */
    boolean showsProfile;

    List<StepProfile.Part> profile = List.of();

    /** The numbers of the circle that is selected; empty if none is. */
    List<String> card = List.of();

    String stage = "";

    /** The back end that was asked for, and where the world is. */
    Backend asked = Backend.JVM;

    Backend backend = Backend.JVM;
    String device = "";
    int step;
    long hash;
    int hashStep;
    double stepMillis;
    double energy;
    boolean paused;
    boolean rewinding;
    int stepsToRewind;
    float speed = 1;
    ToolKind tool = ToolKind.GRAB;
    PaintMode paint = PaintMode.SPEED;

    /** What the last colour stands for; 0 if it is not known. */
    double legendMost;

    double brush;
    float size = 1;
    float gravity;
    float greatestGravity = 1;
    float restitution;
    float friction;
    int subSteps;
    float rollingResistance;
    String message = "";
    List<Mark> marks = List.of();

    /** Milliseconds a step, 1 beside those in which the world moved, and energies; the newest last. */
    float[] stepTimes = new float[0];

    float[] stepMoves = new float[0];

    float[] energies = new float[0];

    /** How many circles of no mass that is infinite there are. */
    int movable;

    /** Makes room for so many pieces, of so many elements each. */
    void ensurePieces(int count, int stride) {
        if (pieceColour.length < count) {
            int room = count + (count >> 1);
            piece = new float[room * stride];
            pieceColour = new int[room];
        }
    }

    /** Makes room for so many contacts. */
    void ensureContacts(int count) {
        if (contact.length < Contacts.STRIDE * count) {
            contact = new float[Contacts.STRIDE * (count + (count >> 1))];
        }
    }

    /** Makes room for so many joints. */
    void ensureJoints(int count) {
        if (jointColour.length < count) {
            int room = count + (count >> 1);
            joint = new float[4 * room];
            jointColour = new int[room];
        }
    }

    /** Makes room for so many circles. */
    void ensure(int count) {
        if (x.length < count) {
            int room = count + (count >> 1);
            x = Arrays.copyOf(x, room);
            y = Arrays.copyOf(y, room);
            radius = Arrays.copyOf(radius, room);
            colour = Arrays.copyOf(colour, room);
            rim = Arrays.copyOf(rim, room);
            angle = Arrays.copyOf(angle, room);
        }
    }
}
