package io.github.circles2d.reference;

/** A body of terrain: its pose, and how it moves in a step. */
final class Body {
    private static final long BODY = 0x626F646965733264L;
    private static final double GREATEST_COORDINATE = 1e9;

    /** In a sub-step. */
    private static final long GREATEST_TURN = 15L << 27;

    final int id;
    final long handle;
    final double[] place = new double[2];
    int angle;
    final float[] velocity = new float[2];
    float omega;

    /** Where it travels in the next step: x, y; null if nowhere. */
    float[] target;

    int targetAngle;

    /** In this step, or null if the body is at rest in it. */
    Motion motion;

    // within a step
    private final double[] way = new double[2];
    private final double[] next = new double[2];
    private long turn;

    /**
     * How it moves in a step; of each boundary of sub-steps, from the first to the last one, how far the pivot has come, and the cosine and the
     * sine of how far it has turned.
     */
    record Motion(float[] pivot, float[] velocity, float omega, float[][] ways, float[] cosines, float[] sines) {}

    Body(int id, long handle, float x, float y, int angle) {
        this.id = id;
        this.handle = handle;
        put(x, y, angle);
    }

    void put(float x, float y, int toAngle) {
        place[0] = x;
        place[1] = y;
        angle = toAngle;
        target = null;
    }

    /** A direction of the body's frame, in the world. */
    double[] turned(double[] v) {
        return turned(angle, v);
    }

    private static double[] turned(int by, double[] v) {
        double cos = Angles.cos(by);
        double sin = Angles.sin(by);
        return new double[] {cos * v[0] - sin * v[1], sin * v[0] + cos * v[1]};
    }

    /** A place of the body's frame, in the world. */
    double[] place(float[] at) {
        double[] turned = turned(new double[] {at[0], at[1]});
        return new double[] {place[0] + turned[0], place[1] + turned[1]};
    }

    long hash() {
        long h = absorb(absorb(ReferenceWorld.absorb(BODY, id), place[0]), place[1]);
        h = ReferenceWorld.absorb(ReferenceWorld.absorb(ReferenceWorld.absorb(h, angle), velocity), omega);
        return target == null ? h : ReferenceWorld.absorb(ReferenceWorld.absorb(h, target), targetAngle);
    }

    private static long absorb(long hash, double value) {
        long bits = Double.doubleToRawLongBits(value);
        return ReferenceWorld.absorb(ReferenceWorld.absorb(hash, (int) bits), (int) (bits >> 32));
    }

    boolean moves() {
        return target != null || velocity[0] != 0f || velocity[1] != 0f || omega != 0f;
    }

    /** Finds how it moves in a step. */
    void begin(StepParameters k) {
        motion = null;
        if (!moves()) {
            return;
        }
        for (int a = 0; a < 2; a++) {
            if (target == null) {
                double to = place[a] + (double) velocity[a] * k.dt();
                next[a] = Math.max(-GREATEST_COORDINATE, Math.min(GREATEST_COORDINATE, to));
                way[a] = next[a] - place[a];
            } else {
                next[a] = target[a];
                way[a] = k.arena().shortWay(a, next[a] - place[a]);
            }
        }
        long most = GREATEST_TURN * k.subSteps();
        turn = target == null
                ? Math.max(-most, Math.min(most, Angles.units((double) omega * k.dt())))
                : targetAngle - angle;
        int n = k.subSteps();
        float[][] ways = new float[n + 1][];
        float[] cosines = new float[n + 1];
        float[] sines = new float[n + 1];
        for (int i = 0; i <= n; i++) {
            double share = (double) i / n;
            int turnedSoFar = (int) Math.round(turn * share);
            ways[i] = new float[] {(float) (way[0] * share), (float) (way[1] * share)};
            cosines[i] = (float) Angles.cos(turnedSoFar);
            sines[i] = (float) Angles.sin(turnedSoFar);
        }
        motion = new Motion(
                new float[] {(float) place[0], (float) place[1]},
                new float[] {speed(way[0], k), speed(way[1], k)},
                speed(turn * Angles.UNIT, k),
                ways,
                cosines,
                sines);
    }

    /** How a place of its frame moves in this step. */
    AnchorMotion motionOf(float[] at, StepParameters k) {
        double[] arm = turned(angle, new double[] {at[0], at[1]});
        int n = k.subSteps();
        float[][] ways = new float[n + 1][];
        float[][] velocities = new float[n + 1][];
        for (int i = 0; i <= n; i++) {
            double share = (double) i / n;
            int turnedSoFar = (int) Math.round(turn * share);
            double[] now = turned(angle + turnedSoFar, new double[] {at[0], at[1]});
            ways[i] = new float[] {
                (float) (way[0] * share + (now[0] - arm[0])), (float) (way[1] * share + (now[1] - arm[1]))
            };
            double speed = turn * Angles.UNIT / k.dt();
            velocities[i] = new float[] {
                Numbers.limitSpeed((float) (way[0] / k.dt() - speed * now[1])),
                Numbers.limitSpeed((float) (way[1] / k.dt() + speed * now[0]))
            };
        }
        return new AnchorMotion(ways, velocities);
    }

    private static float speed(double way, StepParameters k) {
        return Numbers.limitSpeed((float) (way / k.dt()));
    }

    /** How far a point at most moves in the step that is so far from the pivot. */
    float most(double distance) {
        if (motion == null) {
            return 0f;
        }
        double along = Math.sqrt(way[0] * way[0] + way[1] * way[1]);
        return (float) ((along + distance * Math.min(Math.abs(turn) * Angles.UNIT, 2)) * (1 + 0x1p-20));
    }

    void end(Arena arena) {
        if (motion == null) {
            return;
        }
        for (int a = 0; a < 2; a++) {
            place[a] = next[a] - arena.laps(a, next[a]);
        }
        angle += (int) turn;
        target = null;
    }
}
