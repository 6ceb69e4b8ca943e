package io.github.circles2d.world.jvm.pieces;

import static io.github.circles2d.world.model.CircleRow.PATH_X;
import static io.github.circles2d.world.model.CircleRow.PATH_Y;
import static io.github.circles2d.world.model.CircleRow.RADIUS;
import static io.github.circles2d.world.model.CircleRow.RESTITUTION;
import static io.github.circles2d.world.model.CircleRow.X;
import static io.github.circles2d.world.model.CircleRow.Y;

import io.github.circles2d.world.circles.CircleField;
import io.github.circles2d.world.jvm.state.PieceContactRow;
import io.github.circles2d.world.jvm.state.PieceContacts;
import io.github.circles2d.world.jvm.state.Sleepers;
import io.github.circles2d.world.jvm.state.State;
import io.github.circles2d.world.jvm.state.WrapImages;
import io.github.circles2d.world.jvm.threads.Team;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.CircleRow;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.Paths;
import io.github.circles2d.world.model.PieceGap;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.StepConstants;
import io.github.circles2d.world.model.TerrainStep;
import io.github.circles2d.world.model.Tuning;
import java.util.Arrays;

/** Finds the pieces of terrain that circles are near to, by the tree of their boxes. The tree decides nothing: a distance does. */
public final class PieceSearch {
    /** An eighth more than needed, for rounding. */
    private static final float SLACK = 1.125f;

    private final State state;
    private final Team team;
    private final PieceContacts contacts;
    private final PieceMemory memory = new PieceMemory();
    private final Finder[] finders;

    /** Of a circle that sleeps: its contacts, and how they are measured; null as long as none has slept. */
    private PieceContacts atRest;

    private PieceMeasure measure;

    private final Team.Work findAll = this::findAll;
    private final Team.Work copy = this::copy;

    private TerrainStep terrain;

    /** What is told of contacts; null if they are not recorded. */
    public PieceTouches touches;

    public PieceSearch(State state, Team team) {
        this.state = state;
        this.team = team;
        contacts = state.pieces;
        finders = new Finder[team.most()];
        for (int worker = 0; worker < finders.length; worker++) {
            finders[worker] = new Finder();
        }
    }

    public long bytes() {
        long sum = memory.bytes();
        for (Finder each : finders) {
            sum += 4L * (each.rows.length + each.numbers.length + each.near.length);
        }
        return sum;
    }

    /** Makes room for a step. */
    public void ensure() {
        memory.ensure(state.slotOf.length);
    }

    /** Finds the contacts of all circles, each worker those of its part. */
    public void find(TerrainStep step, boolean turning) {
        terrain = step;
        team.all(findAll);
        contacts.ensureNext(found());
        team.all(copy);
        contacts.take();
        if (turning) {
            contacts.ensureSurfaces();
        }
        if (touches != null) {
            touches.ensure(found());
        }
    }

    private void findAll(int worker) {
        finders[worker].found = 0;
        for (int round = 0; round < team.rounds(); round++) {
            finders[worker].find(team.from(state.awake, worker, round), team.to(state.awake, worker, round), terrain);
        }
    }

    private void copy(int worker) {
        Finder mine = finders[worker];
        contacts.copyNext(mine.rows, mine.numbers, mine.found, mine.place, terrain.rows);
        for (int round = 0; round < team.rounds(); round++) {
            int to = team.to(state.awake, worker, round);
            for (int slot = team.from(state.awake, worker, round); slot < to; slot++) {
                contacts.first[slot] += mine.place;
            }
        }
    }

    // ---- circles that sleep

    /** Keeps the contacts of a circle that has fallen asleep, measured; one worker does it for all. */
    public void keep(int slot, TerrainStep terrain, StepConstants k) {
        int id = state.id[slot];
        state.sleepers.keepPieces(id, contacts.first[slot], contacts.count[slot], contacts);
        contacts.count[slot] = 0;
        if (state.sleepers.pieces(id) == 0) {
            return;
        }
        if (atRest == null) {
            atRest = new PieceContacts();
            measure = new PieceMeasure(state, atRest);
        }
        state.motionClamp[CircleRow.of(slot) + PATH_X] = 0f;
        state.motionClamp[CircleRow.of(slot) + PATH_Y] = 0f;
        Finder finder = finders[0];
        finder.found = 0;
        finder.look(slot, terrain);
        finder.take(slot, terrain);
        atRest.ensureNext(finder.found);
        atRest.copyNext(finder.rows, finder.numbers, finder.found, 0, terrain.rows);
        atRest.take();
        measure.begin(terrain, k);
        measure.measure(slot, 0, finder.found, 0);
        keepNormals(id, finder.found);
    }

    private void keepNormals(int id, int found) {
        float[] rows = state.sleepers.pieceRows(id);
        int[] numbers = state.sleepers.pieceNumbers(id);
        int c = 0;
        for (int k = 0; k < state.sleepers.pieces(id); k++) {
            int piece = numbers[PieceContactRow.numbers(k) + PieceContactRow.PIECE];
            while (c < found && atRest.piece(c) < piece) {
                c++;
            }
            boolean acts = c < found
                    && atRest.piece(c) == piece
                    && atRest.serial(c) == numbers[PieceContactRow.numbers(k) + PieceContactRow.SERIAL]
                    && measure.isConstraint(c);
            int row = PieceContactRow.of(k);
            rows[row + PieceContactRow.NX] = acts ? atRest.rows[PieceContactRow.of(c) + PieceContactRow.NX] : 0f;
            rows[row + PieceContactRow.NY] = acts ? atRest.rows[PieceContactRow.of(c) + PieceContactRow.NY] : 0f;
            // one that is no constraint here presses nothing
            numbers[PieceContactRow.numbers(k) + PieceContactRow.FEATURE] = acts ? PieceGap.FACE : PieceGap.NONE;
        }
    }

    /** Whether a piece that moves may reach a circle that sleeps. */
    public boolean comesNear(int slot, int piece, TerrainStep terrain) {
        float r = state.circle[CircleRow.of(slot) + RADIUS];
        float sight = (r + Tuning.MARGIN * r) + Tuning.MARGIN * r;
        return finders[0].response(slot, piece, terrain) != PairTable.IGNORE
                && finders[0].isNear(slot, piece, sight, terrain);
    }

    // ---- the search

    /** Finds the places of what the workers have found, and returns how many contacts that are. */
    private int found() {
        int all = 0;
        for (int k = 0; k < team.size(); k++) {
            finders[k].place = all;
            all += finders[k].found;
        }
        return all;
    }

    /** What a worker looks with. */
    final class Finder {
        private final PieceGap gap = new PieceGap();

        /** Contacts found, as in {@link PieceContacts}. */
        private float[] rows = new float[0];

        private int[] numbers = new int[0];
        private int found;

        /** Where they will be. */
        private int place;

        /** The pieces near a circle, in the order of their ids. */
        private int[] near = new int[16];

        private int count;

        private void find(int from, int to, TerrainStep terrain) {
            for (int slot = from; slot < to; slot++) {
                int before = found;
                if (!state.isStatic(slot)) {
                    look(slot, terrain);
                    take(slot, terrain);
                    if (state.sleepers != null) {
                        state.sleepers.forgetPieces(state.id[slot]);
                    }
                }
                contacts.first[slot] = before;
                contacts.count[slot] = found - before;
            }
        }

        private void look(int slot, TerrainStep terrain) {
            int s = CircleRow.of(slot);
            float r = state.circle[s + RADIUS];
            float path = CircleMath.length(state.motionClamp[s + PATH_X], state.motionClamp[s + PATH_Y]);
            float sight = Paths.sight(r, path);
            float x = state.circle[s + X];
            float y = state.circle[s + Y];
            float m = SLACK * sight;
            int id = state.id[slot];
            count = 0;
            if (!memory.recall(id, x - m, y - m, x + m, y + m, terrain.groundVersion, this)) {
                // circles that hardly move find the same pieces for many steps
                float far = m + (r + path);
                walkAll(x, y, far, 0, terrain.groundNodes, terrain);
                memory.keep(id, x - far, y - far, x + far, y + far, terrain.groundVersion, near, count);
            }
            if (terrain.groundNodes < terrain.nodes) {
                walkAll(x, y, m, terrain.groundNodes, terrain.nodes, terrain);
            }
            int seen = count;
            count = 0;
            for (int k = 0; k < seen; k++) {
                int piece = near[k];
                if (isNear(slot, piece, sight, terrain)) {
                    near[count++] = piece;
                }
            }
        }

        /** Finds the pieces whose boxes meet a box around a place or one of its images. */
        private void walkAll(float x, float y, float m, int from, int to, TerrainStep terrain) {
            for (int n = 0; n < state.images.count; n++) {
                float ax = x + state.images.x[n];
                float ay = y + state.images.y[n];
                float mx = m + WrapImages.rounding(state.images.x[n], x);
                float my = m + WrapImages.rounding(state.images.y[n], y);
                walk(ax - mx, ay - my, ax + mx, ay + my, from, to, terrain);
            }
        }

        private void walk(float minX, float minY, float maxX, float maxY, int from, int to, TerrainStep terrain) {
            float[] boxes = terrain.boxes;
            int[] links = terrain.links;
            int node = from;
            while (node < to) {
                int b = 4 * node;
                if (boxes[b] <= maxX && boxes[b + 1] <= maxY && boxes[b + 2] >= minX && boxes[b + 3] >= minY) {
                    int piece = links[2 * node + 1];
                    if (piece >= 0) {
                        insert(piece);
                    }
                    node++;
                } else {
                    node = links[2 * node];
                }
            }
        }

        private boolean isNear(int slot, int piece, float sight, TerrainStep terrain) {
            int row = PieceRow.of(piece);
            int shape = terrain.traits[PieceRow.traits(piece) + PieceRow.SHAPE];
            float ox = PieceMeasure.offsetX(state, slot, terrain.rows, row);
            float oy = PieceMeasure.offsetY(state, slot, terrain.rows, row);
            return PieceGap.distance(terrain.rows, row, shape, ox, oy) < sight + terrain.rows[row + PieceRow.MOST];
        }

        void insert(int piece) {
            if (count == near.length) {
                near = Arrays.copyOf(near, 2 * count);
            }
            int k = count;
            while (k > 0 && near[k - 1] > piece) {
                k--;
            }
            if (k > 0 && near[k - 1] == piece) {
                return; // its image
            }
            System.arraycopy(near, k, near, k + 1, count - k);
            near[k] = piece;
            count++;
        }

        private void take(int slot, TerrainStep terrain) {
            int old = contacts.first[slot];
            int end = old + contacts.count[slot];
            float[] oldRows = contacts.rows;
            int[] oldNumbers = contacts.numbers;
            Sleepers sleepers = state.sleepers;
            if (sleepers != null && sleepers.pieces(state.id[slot]) > 0) {
                old = 0;
                end = sleepers.pieces(state.id[slot]);
                oldRows = sleepers.pieceRows(state.id[slot]);
                oldNumbers = sleepers.pieceNumbers(state.id[slot]);
            }
            ensure(found + count);
            for (int k = 0; k < count; k++) {
                int piece = near[k];
                int response = response(slot, piece, terrain);
                if (response == PairTable.IGNORE) {
                    continue;
                }
                while (old < end && oldNumbers[PieceContactRow.numbers(old) + PieceContactRow.PIECE] < piece) {
                    old++;
                }
                int row = PieceContactRow.of(found);
                int number = PieceContactRow.numbers(found);
                int serial = terrain.traits[PieceRow.traits(piece) + PieceRow.SERIAL];
                int oldNumber = PieceContactRow.numbers(old);
                boolean kept = old < end
                        && oldNumbers[oldNumber + PieceContactRow.PIECE] == piece
                        && oldNumbers[oldNumber + PieceContactRow.SERIAL] == serial;
                int before = PieceContactRow.of(old);
                for (int i = 0; i < PieceContactRow.KEPT; i++) {
                    rows[row + i] = kept ? oldRows[before + i] : 0f;
                }
                float ofKind = terrain.kinds.rows[KindTerrain.of(kind(piece, terrain)) + KindTerrain.RESTITUTION];
                rows[row + PieceContactRow.BOUNCE] = 0f;
                rows[row + PieceContactRow.BASE_X] =
                        PieceMeasure.offsetX(state, slot, terrain.rows, PieceRow.of(piece));
                rows[row + PieceContactRow.BASE_Y] =
                        PieceMeasure.offsetY(state, slot, terrain.rows, PieceRow.of(piece));
                rows[row + PieceContactRow.RESTITUTION] =
                        CircleMath.max(state.traits[CircleRow.of(slot) + RESTITUTION], ofKind);
                boolean solid = response == PairTable.SOLID; // PieceMeasure finds the side of others
                if (rows[row + PieceContactRow.SIDE] == 0f
                        && (solid
                                || PieceMeasure.isTwoSided(
                                        terrain, piece, terrain.traits[PieceRow.traits(piece) + PieceRow.SHAPE]))) {
                    rows[row + PieceContactRow.SIDE] = side(slot, piece, terrain);
                }
                numbers[number + PieceContactRow.PIECE] = piece;
                numbers[number + PieceContactRow.SERIAL] = serial;
                numbers[number + PieceContactRow.RESPONSE] = response;
                numbers[number + PieceContactRow.SHAPE] = terrain.traits[PieceRow.traits(piece) + PieceRow.SHAPE];
                numbers[number + PieceContactRow.MOTION] = terrain.traits[PieceRow.traits(piece) + PieceRow.MOTION];
                numbers[number + PieceContactRow.FEATURE] = PieceGap.FACE;
                found++;
            }
        }

        private int response(int slot, int piece, TerrainStep terrain) {
            if (!state.filtering) {
                return PairTable.SOLID;
            }
            int kind = state.fields.getInt(CircleField.KIND, state.id[slot]);
            return PairTable.get(state.responses, kind, kind(piece, terrain));
        }

        private int kind(int piece, TerrainStep terrain) {
            return terrain.traits[PieceRow.traits(piece) + PieceRow.KIND];
        }

        /** Where a circle is as it comes near. */
        private float side(int slot, int piece, TerrainStep terrain) {
            float[] p = terrain.rows;
            int row = PieceRow.of(piece);
            int shape = terrain.traits[PieceRow.traits(piece) + PieceRow.SHAPE];
            int kind = kind(piece, terrain);
            float ox = PieceMeasure.offsetX(state, slot, p, row);
            float oy = PieceMeasure.offsetY(state, slot, p, row);
            boolean front = PieceGap.isInFront(p, row, shape, ox, oy);
            boolean oneWay = terrain.kinds.rows[KindTerrain.of(kind) + KindTerrain.ONE_WAY] != 0f;
            if (PieceRow.form(shape) == PieceRow.SEGMENT && !oneWay) {
                return front ? 1f : -1f;
            }
            if (front && oneWay) {
                gap.measure(p, row, shape, ox, oy, state.circle[CircleRow.of(slot) + RADIUS], 1f);
                return gap.gap >= 0f ? 1f : 0f;
            }
            return front ? 1f : 0f;
        }

        private void ensure(int room) {
            if (PieceContactRow.of(room) > rows.length) {
                numbers = Arrays.copyOf(numbers, PieceContactRow.numbers(room + (room >> 1)));
                rows = Arrays.copyOf(rows, PieceContactRow.of(room + (room >> 1)));
            }
        }
    }
}
