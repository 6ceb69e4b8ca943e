package io.github.circles2d.world.device.memory;

import io.github.circles2d.world.model.BodyRow;
import io.github.circles2d.world.model.KindTerrain;
import io.github.circles2d.world.model.PairTable;
import io.github.circles2d.world.model.PieceRow;
import io.github.circles2d.world.model.StepInput;
import io.github.circles2d.world.model.TerrainStep;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;

/**
 * Sends what has changed of the tables of terrain. They stay the host's, which may change them once steps have been enqueued: those that are
 * made once more find on the device what was sent with them.
 */
final class TerrainUpload {
    private static final int NEVER = -1;

    /** Of what was taken down last; meaningless unless there is terrain. */
    private TerrainStep tables;

    private boolean any;
    private int subSteps;
    private int piecesVersion = NEVER;
    private int treeVersion = NEVER;
    private int motionVersion = NEVER;
    private int kindsVersion = NEVER;

    // the same of what is on the device
    private int sentRoom = NEVER;
    private int sentPieces = NEVER;
    private int sentTree = NEVER;
    private int sentLinks = NEVER;
    private int sentMotion = NEVER;
    private int sentKinds = NEVER;

    /** Whether all that was taken down last has been sent, but for what has no room. */
    private boolean sent;

    private final int[] head = new int[TerrainArray.HEAD];
    private final int[] sentHead = new int[TerrainArray.HEAD];
    private final IntBuffer headView = IntBuffer.wrap(head);

    /** What comes is of another world. */
    void forget() {
        tables = null;
        any = false;
        sentRoom = NEVER; // so all tables are sent anew
        sentKinds = NEVER;
        sent = false;
    }

    /** Takes down what the next steps are made with. */
    void set(StepInput input) {
        any = input.constants.terrain;
        if (any) {
            tables = input.terrain;
            subSteps = input.constants.subSteps;
            piecesVersion = tables.version;
            treeVersion = tables.treeVersion;
            motionVersion = tables.motionVersion;
            kindsVersion = tables.kinds.version;
        }
        sent = false;
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
        if (sent || !arrays.features().terrain()) {
            return;
        }
        TableRoom room = arrays.terrainRoom();
        if (sentRoom != room.version()) {
            sentPieces = NEVER;
            sentTree = NEVER;
            sentLinks = NEVER;
            sentMotion = NEVER;
            sentRoom = room.version();
        }
        if (any) {
            sendPieces(arrays);
            sendTree(arrays);
            sendMotion(arrays);
        }
        sendHead(arrays, room);
        sent = true;
    }

    private void sendHead(DeviceArrays arrays, TableRoom room) {
        for (TerrainArray table : TerrainArray.values()) {
            head[table.ordinal()] = room.at(table);
        }
        head[TerrainArray.AT_NODES] = any ? tables.nodes : 0;
        head[TerrainArray.AT_GROUND_NODES] = any ? tables.groundNodes : 0;
        head[TerrainArray.AT_BODIES] = any ? tables.bodies : 1;
        if (!Arrays.equals(head, sentHead)) {
            arrays.writeTable(DeviceArray.TERRAIN_AT, headView);
            System.arraycopy(head, 0, sentHead, 0, head.length);
        }
    }

    private void sendPieces(DeviceArrays arrays) {
        if (sentPieces != piecesVersion) {
            boolean some = sentPieces != NEVER && sentPieces == piecesVersion - 1;
            int from = some ? tables.changedFrom : 0;
            int to = some ? tables.changedTo : tables.pieces;
            arrays.write(TerrainArray.ROWS, tables.rows, PieceRow.of(from), PieceRow.of(to));
            arrays.write(TerrainArray.TRAITS, tables.traits, PieceRow.traits(from), PieceRow.traits(to));
            sentPieces = piecesVersion;
        }
    }

    private void sendTree(DeviceArrays arrays) {
        if (sentTree != treeVersion) {
            boolean some = sentTree != NEVER && sentTree == treeVersion - 1 && sentLinks == tables.linksVersion;
            int from = some ? tables.boxesFrom : 0;
            arrays.write(TerrainArray.BOXES, tables.boxes, TerrainArray.BOX * from, TerrainArray.BOX * tables.nodes);
            if (!some) {
                arrays.write(TerrainArray.LINKS, tables.links, 0, TerrainArray.LINK * tables.nodes);
            }
            sentTree = treeVersion;
            sentLinks = tables.linksVersion;
        }
    }

    private void sendMotion(DeviceArrays arrays) {
        if (sentMotion != motionVersion) {
            int floats = BodyRow.of(tables.bodies, subSteps);
            arrays.write(TerrainArray.MOTION, tables.motion, BodyRow.of(1, subSteps), floats);
            sentMotion = motionVersion;
        }
        if (sentKinds != kindsVersion) {
            int at = DeviceArray.KIND_TERRAIN_AT;
            arrays.writeTable(at, FloatBuffer.wrap(tables.kinds.rows, 0, KindTerrain.of(PairTable.KINDS)));
            sentKinds = kindsVersion;
        }
    }
}
