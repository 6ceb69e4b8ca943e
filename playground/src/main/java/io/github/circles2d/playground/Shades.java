package io.github.circles2d.playground;

/** The colours of circles and joints. Scales of speed, pressure and tension belong to a world. */
final class Shades {
    /** The share of its colour in what sleeps. */
    private static final double ASLEEP = 0.5;

    private static final int[] TINTS = {0x4aa8d8, 0x5bc0be, 0x7fb7e6, 0x9b8cf0, 0x6d9eeb, 0x48c9b0, 0x8fd3f4, 0x74a9cf};
    private static final Ramp SPEED = new Ramp(0x5c83bd, 0x4597cf, 0x35b6c4, 0x9fdc7c, 0xffd166, 0xff7a45, 0xffe9dc);
    private static final Ramp PRESSURE = new Ramp(0x4f7398, 0x6a66bd, 0xb04bb0, 0xe0526f, 0xff9a56, 0xfff1b8);
    private static final int[] CONTACTS = {0x4f78a4, 0x3c8dbc, 0x35b6a4, 0x7fcf5f, 0xf2cf4a, 0xf58b3c, 0xe8505b};

    private static final Ramp TENSION = new Ramp(0x6f8aa3, 0xb9c7d3, 0xffd166, 0xff7a45, 0xe8505b);

    /** Of the mean pressure, so that some circles have the colour of the end. */
    private static final double PRESSURE_RANGE = 3;

    /** Weight of the newest mean. */
    private static final double NEWEST = 0.05;

    private double fast = 1;
    private double meanPressure;
    private double sum;
    private int pressed;
    private double meanTension;
    private double sumOfTensions;
    private int tensions;

    /** A world in which this is a high speed. */
    void start(double highSpeed) {
        fast = highSpeed;
        meanPressure = 0;
        meanTension = 0;
    }

    /** The colour of what sleeps, and has another one awake. */
    static int asleep(int awake) {
        return Ramp.mix(Theme.ARENA, awake, ASLEEP);
    }

    static int tint(int id) {
        return TINTS[(id * 5 + (id >>> 3)) % TINTS.length];
    }

    int speed(float vx, float vy) {
        return SPEED.colour(Math.sqrt(Math.sqrt((double) vx * vx + (double) vy * vy) / fast));
    }

    static int contacts(float count) {
        return CONTACTS[Math.min((int) count, CONTACTS.length - 1)];
    }

    int pressure(float force, float radius) {
        return PRESSURE.colour(meanPressure > 0 ? perLength(force, radius) / (PRESSURE_RANGE * meanPressure) : 0);
    }

    /** Takes note of a force on a circle, before colours are asked for. */
    void note(float force, float radius) {
        if (force > 0) {
            sum += perLength(force, radius);
            pressed++;
        }
    }

    /** All forces of a frame have been noted: the scale follows what there is, slowly. */
    void scalePressure() {
        if (pressed > 0) {
            double mean = sum / pressed;
            meanPressure = meanPressure == 0 ? mean : meanPressure + NEWEST * (mean - meanPressure);
        }
        sum = 0;
        pressed = 0;
    }

    /** The colour of a joint that pulls or pushes with a force; takes note of it for the next frame. */
    int tension(float force) {
        double size = Math.abs(force);
        sumOfTensions += size;
        tensions++;
        return TENSION.colour(meanTension > 0 ? size / (PRESSURE_RANGE * meanTension) : 0);
    }

    /** All forces of joints of a frame have been noted. */
    void scaleTension() {
        if (sumOfTensions > 0) {
            double mean = sumOfTensions / tensions;
            meanTension = meanTension == 0 ? mean : meanTension + NEWEST * (mean - meanTension);
        }
        sumOfTensions = 0;
        tensions = 0;
    }

    /** What the last colour of a legend stands for; 0 if it is not known yet. */
    double most(PaintMode mode) {
        return switch (mode) {
            case PLAIN -> 0;
            case SPEED -> fast;
            case PRESSURE -> PRESSURE_RANGE * meanPressure;
            case CONTACTS -> CONTACTS.length - 1;
        };
    }

    private static double perLength(float force, float radius) {
        return force / (2 * Math.PI * radius);
    }

    /** The colours that a legend shows, from little to much. */
    static int[] legend(PaintMode mode) {
        return switch (mode) {
            case PLAIN -> new int[0];
            case CONTACTS -> CONTACTS.clone();
            case SPEED -> samples(SPEED);
            case PRESSURE -> samples(PRESSURE);
        };
    }

    private static int[] samples(Ramp ramp) {
        int[] samples = new int[24];
        for (int k = 0; k < samples.length; k++) {
            samples[k] = ramp.colour(k / (samples.length - 1.0));
        }
        return samples;
    }
}
