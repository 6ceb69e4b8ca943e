package io.github.circles2d.check;

import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/** What a browser, or Node, calls. */
public final class Browser {
    private Browser() {}

    /** Nothing runs unless it is called. */
    public static void main(String[] arguments) {}

    /** All lines of the check. */
    @JSExport
    public static String check() {
        return Check.all();
    }

    /** A log that is written here. */
    @JSExport
    public static Int8Array record() {
        return Int8Array.copyFromJavaArray(Logs.record());
    }

    /** Says what a log gives that was written elsewhere. */
    @JSExport
    public static String replay(Int8Array log) {
        return Logs.replay(log.copyToJavaArray());
    }
}
