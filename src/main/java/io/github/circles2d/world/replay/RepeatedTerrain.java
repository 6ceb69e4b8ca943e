package io.github.circles2d.world.replay;

import static java.lang.Float.intBitsToFloat;

import io.github.circles2d.world.Simulation;
import io.github.circles2d.world.changes.Bodies;
import io.github.circles2d.world.changes.Pieces;
import io.github.circles2d.world.log.LogReader;
import io.github.circles2d.world.shared.LoggedCall;
import io.github.circles2d.world.terrain.ChainPath;

/** Makes the calls on terrain again, which check all values. */
final class RepeatedTerrain {
    private final Pieces pieces;
    private final Bodies bodies;

    /** What there is of a chain; null if none has begun. */
    private ChainPath chain;

    RepeatedTerrain(Simulation simulation) {
        pieces = simulation.pieces();
        bodies = simulation.bodies();
    }

    void repeatOfPieces(LoggedCall call, int[] words) {
        float x = intBitsToFloat(words[0]);
        float y = intBitsToFloat(words[1]);
        switch (call) {
            case SEGMENT ->
                pieces.addSegment(
                        body(words[0]),
                        words[1],
                        intBitsToFloat(words[2]),
                        intBitsToFloat(words[3]),
                        intBitsToFloat(words[4]),
                        intBitsToFloat(words[5]),
                        intBitsToFloat(words[6]));
            case ARC ->
                pieces.addArc(
                        body(words[0]),
                        words[1],
                        intBitsToFloat(words[2]),
                        intBitsToFloat(words[3]),
                        intBitsToFloat(words[4]),
                        intBitsToFloat(words[5]),
                        intBitsToFloat(words[6]),
                        flag(words[7]));
            case CHAIN_START -> chain = new ChainPath(x, y);
            case CHAIN_LINE -> chain().lineTo(x, y);
            case CHAIN_ARC -> chain().arcBy(x, y, LoggedCall.value(words[2], words[3]));
            case CHAIN -> addChain(words[0], words[1], flag(words[2]));
            case REMOVE_PIECE -> pieces.remove(piece(words[0]));
            case PIECE_KIND -> pieces.setKind(piece(words[0]), words[1]);
            case CLEAR_TERRAIN -> pieces.clear();
            default -> throw new IllegalStateException(call + " is no call on pieces");
        }
    }

    void repeatOfBodies(LoggedCall call, int[] words) {
        float x = intBitsToFloat(words[0]);
        float y = intBitsToFloat(words[1]);
        float z = intBitsToFloat(words[2]);
        switch (call) {
            case BODY -> bodies.add(x, y, z);
            case REMOVE_BODY -> bodies.remove(body(words[0]));
            case BODY_VELOCITY -> bodies.setVelocity(body(words[0]), y, z);
            case BODY_ANGULAR_VELOCITY -> bodies.setAngularVelocity(body(words[0]), y);
            case MOVE_BODY -> bodies.move(body(words[0]), y, z, intBitsToFloat(words[3]));
            case TELEPORT_BODY -> bodies.teleport(body(words[0]), y, z, intBitsToFloat(words[3]));
            default -> throw new IllegalStateException(call + " is no call on bodies");
        }
    }

    private ChainPath chain() {
        if (chain == null) {
            throw LogReader.refused("a chain goes on that has not begun");
        }
        return chain;
    }

    private void addChain(int body, int kind, boolean closed) {
        ChainPath whole = chain();
        chain = null;
        if (closed) {
            close(whole);
        }
        pieces.addChain(body(body), whole, kind, null);
    }

    /** The log has the line that closes a chain, if there is one. */
    private static void close(ChainPath whole) {
        int before = whole.pieces();
        try {
            whole.close();
        } catch (IllegalStateException e) {
            throw LogReader.refused("a chain cannot be closed");
        }
        if (whole.pieces() != before) {
            throw LogReader.refused("a chain is closed that has a gap");
        }
    }

    private static boolean flag(int word) {
        if (word != 0 && word != 1) {
            throw LogReader.refused("a yes or no is " + word);
        }
        return word == 1;
    }

    long body(int id) {
        long handle = id >= 0 && id < bodies.idLimit() ? bodies.handle(id) : 0;
        if (handle == 0) {
            throw LogReader.refused("no body of terrain has the id " + id);
        }
        return handle;
    }

    private long piece(int id) {
        long handle = id >= 0 && id < pieces.idLimit() ? pieces.handle(id) : 0;
        if (handle == 0) {
            throw LogReader.refused("no piece of terrain has the id " + id);
        }
        return handle;
    }
}
