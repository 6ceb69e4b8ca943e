package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.model.TerrainStep;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;

/**
 * Sends the tables of terrain where they have changed. They stay the host's, which may change them once steps have been enqueued: those that are
 * made once more find on the device what was sent with them.
 */
final class TerrainTables {
    private static final int NEVER = -1;

    private TerrainStep tables;

    /** Whether the steps have terrain. */
    private boolean any;

    private int subSteps;

    // of what was taken down last
    private int piecesVersion = NEVER;
    private int treeVersion = NEVER;
    private int motionVersion = NEVER;
    private int kindsVersion = NEVER;

    private int roomVersion = NEVER;
    private boolean piecesSent;
    private boolean treeSent;
    private boolean motionSent;
    private boolean kindsSent;
    private boolean headSent;
    private final int[] head = new int[TerrainRoom.HEAD];
    private final IntBuffer headView = IntBuffer.wrap(head);

    /** Takes down what the next steps are made with. */
    void set(StepInput input) {
        tables = input.terrain;
        headSent = headSent && any == input.constants.terrain && (!any || treeVersion == tables.treeVersion);
        any = input.constants.terrain;
        if (!any) {
            return;
        }
        piecesSent = piecesSent && piecesVersion == tables.version;
        treeSent = treeSent && treeVersion == tables.treeVersion;
        motionSent = motionSent && motionVersion == tables.motionVersion && subSteps == input.constants.subSteps;
        kindsSent = kindsSent && kindsVersion == tables.kinds.version;
        piecesVersion = tables.version;
        treeVersion = tables.treeVersion;
        motionVersion = tables.motionVersion;
        kindsVersion = tables.kinds.version;
        subSteps = input.constants.subSteps;
    }

    /** Whether what was taken down last is this. */
    boolean areOf(StepInput input) {
        TerrainStep t = input.terrain;
        return any == input.constants.terrain
                && (!any
                        || piecesVersion == t.version
                                && treeVersion == t.treeVersion
                                && motionVersion == t.motionVersion
                                && kindsVersion == t.kinds.version);
    }

    /** Makes room for what was taken down last. */
    void ensureRoom(DeviceArrays arrays) {
        if (any) {
            arrays.ensureTerrain(tables.pieces, tables.nodes, BodyRow.of(tables.bodies, subSteps));
        }
    }

    /** Sends what is not there yet, where there is memory for it. */
    void send(DeviceArrays arrays) {
        if (!arrays.terrain()) {
            return;
        }
        TerrainRoom room = arrays.terrainRoom();
        if (roomVersion != room.version()) {
            roomVersion = room.version();
            headSent = false;
            piecesSent = false;
            treeSent = false;
            motionSent = false;
        }
        if (!headSent) {
            sendHead(arrays, room);
        }
        if (any) {
            sendTables(arrays, room);
        }
    }

    private void sendHead(DeviceArrays arrays, TerrainRoom room) {
        for (int table = TerrainRoom.ROWS; table <= TerrainRoom.MOTION; table++) {
            head[table] = room.at(table);
        }
        head[TerrainRoom.NODES] = any ? tables.nodes : 0;
        arrays.writeTable(DeviceArray.TERRAIN_AT, headView);
        headSent = true;
    }

    private void sendTables(DeviceArrays arrays, TerrainRoom room) {
        if (!piecesSent) {
            write(arrays, room.at(TerrainRoom.ROWS), tables.rows, PieceRow.of(tables.pieces));
            write(arrays, room.at(TerrainRoom.TRAITS), tables.traits, PieceRow.traits(tables.pieces));
            piecesSent = true;
        }
        if (!treeSent) {
            write(arrays, room.at(TerrainRoom.BOXES), tables.boxes, TerrainRoom.BOX * tables.nodes);
            write(arrays, room.at(TerrainRoom.LINKS), tables.links, TerrainRoom.LINK * tables.nodes);
            treeSent = true;
        }
        if (!motionSent) {
            write(arrays, room.at(TerrainRoom.MOTION), tables.motion, BodyRow.of(tables.bodies, subSteps));
            motionSent = true;
        }
        if (!kindsSent) {
            int at = DeviceArray.KIND_TERRAIN_AT;
            arrays.writeTable(at, FloatBuffer.wrap(tables.kinds.rows, 0, KindTerrain.of(PairTable.KINDS)));
            kindsSent = true;
        }
    }

    private static void write(DeviceArrays arrays, int at, float[] values, int length) {
        arrays.writeTable(DeviceArray.TERRAIN_AT + at, FloatBuffer.wrap(values, 0, length));
    }

    private static void write(DeviceArrays arrays, int at, int[] values, int length) {
        arrays.writeTable(DeviceArray.TERRAIN_AT + at, IntBuffer.wrap(values, 0, length));
    }
}
