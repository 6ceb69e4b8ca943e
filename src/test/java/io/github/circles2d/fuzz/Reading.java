package io.github.circles2d.fuzz;

import io.github.circles2d.BodyEvents;
import io.github.circles2d.Chain;
import io.github.circles2d.Events;
import io.github.circles2d.Joint;
import io.github.circles2d.JointEvents;
import io.github.circles2d.JointedCircles;
import io.github.circles2d.Outline;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.WorldStats;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Set;

/** What calls give, as text that is the same if each bit is: events, joints and the like by all that they can be asked. */
final class Reading {
    /** Of these the first elements are written, and a hash of all. */
    private static final int ELEMENTS = 100;

    /** What depends on the back end, the time or the room that there is. */
    private static final Set<String> OWN = Set.of(
            "candidatePairs",
            "contacts",
            "greatestContacts",
            "bytesHeld",
            "stageMillis",
            "backend",
            "device",
            "reason");

    private final Api api;

    Reading(Api api) {
        this.api = api;
    }

    String of(Object value) throws Throwable {
        if (value instanceof Float f) {
            return f + "/" + Integer.toHexString(Float.floatToRawIntBits(f));
        }
        if (value instanceof float[] floats) {
            return list(floats.length, k -> of(floats[k]), bits(floats));
        }
        if (value instanceof long[] longs) {
            return list(longs.length, k -> "" + longs[k], Arrays.hashCode(longs));
        }
        if (value instanceof int[] ints) {
            return list(ints.length, k -> "" + ints[k], Arrays.hashCode(ints));
        }
        if (value instanceof FloatBuffer buffer) {
            float[] floats = new float[buffer.limit()];
            for (int k = 0; k < floats.length; k++) {
                floats[k] = buffer.get(k);
            }
            return of(floats);
        }
        if (value instanceof LongBuffer buffer) {
            return of(buffer.array());
        }
        if (value instanceof ByteBuffer buffer) {
            return buffer.position() + " bytes, hash "
                    + buffer.duplicate().flip().hashCode();
        }
        if (value instanceof Events events) {
            return events(events, events.size());
        }
        if (value instanceof BodyEvents events) {
            return events(events, events.size());
        }
        if (value instanceof JointEvents events) {
            return events(events, events.size());
        }
        if (value instanceof TerrainBody body) {
            return "body " + body.handle();
        }
        boolean isAsked = value instanceof Joint
                || value instanceof JointedCircles
                || value instanceof Chain
                || value instanceof Outline
                || value instanceof WorldStats;
        return isAsked
                ? asked(value)
                : isPlain(value) ? String.valueOf(value) : value.getClass().getSimpleName();
    }

    private static boolean isPlain(Object value) {
        return value == null
                || value instanceof Number
                || value instanceof Boolean
                || value instanceof Enum
                || value instanceof String;
    }

    @FunctionalInterface
    private interface Element {
        String at(int k) throws Throwable;
    }

    private static String list(int n, Element element, int hash) throws Throwable {
        StringBuilder text = new StringBuilder().append(n).append(" [");
        for (int k = 0; k < Math.min(n, ELEMENTS); k++) {
            text.append(element.at(k)).append(' ');
        }
        return text.append("] hash ").append(hash).toString();
    }

    private static int bits(float[] floats) {
        int hash = 1;
        for (float each : floats) {
            hash = 31 * hash + Float.floatToRawIntBits(each);
        }
        return hash;
    }

    /** All that is said of each event. */
    private String events(Object events, int n) throws Throwable {
        StringBuilder text = new StringBuilder().append(n).append(" events");
        List<Method> methods = methods(events);
        for (int k = 0; k < n; k++) {
            text.append('\n');
            for (Method method : methods) {
                Object[] arguments = method.getParameterCount() == 0
                        ? new Object[0]
                        : method.getParameterCount() == 1 ? new Object[] {k} : new Object[] {k, a((Events) events, k)};
                text.append(method.getName())
                        .append(' ')
                        .append(of(api.call(method, events, arguments)))
                        .append(", ");
            }
        }
        return text.toString();
    }

    private static long a(Events events, int k) {
        return events.a(k);
    }

    private String asked(Object object) throws Throwable {
        StringBuilder text = new StringBuilder();
        for (Method method : methods(object)) {
            if (method.getParameterCount() == 0 && method.getReturnType() != object.getClass()) {
                Object answer = api.call(method, object);
                boolean isOwn = object instanceof WorldStats && OWN.contains(method.getName());
                text.append(isOwn ? "" : method.getName() + " " + of(answer) + ", ");
            }
        }
        if (object instanceof Outline) {
            text.append("inertia ").append(of(api.named(object, "inertia", 2f))).append(", ");
        }
        if (object instanceof Chain || object instanceof Outline) {
            text.append("points ").append(of(api.named(object, "points", 0.5f)));
        }
        return text.toString();
    }

    private static List<Method> methods(Object object) {
        boolean isRecord = object instanceof Record;
        return Api.methods().stream()
                .filter(method -> method.getDeclaringClass()
                                == Objects.requireNonNull(object).getClass()
                        && !Modifier.isStatic(method.getModifiers())
                        && !(isRecord && method.getName().equals("toString")))
                .sorted(Comparator.comparing(Method::getName))
                .toList();
    }
}
