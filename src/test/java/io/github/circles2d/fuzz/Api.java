package io.github.circles2d.fuzz;

import io.github.circles2d.Blobs;
import io.github.circles2d.Bodies;
import io.github.circles2d.BodyEvents;
import io.github.circles2d.BodyQueries;
import io.github.circles2d.Calibration;
import io.github.circles2d.Chain;
import io.github.circles2d.Circles2D;
import io.github.circles2d.Events;
import io.github.circles2d.FixedStep;
import io.github.circles2d.Joint;
import io.github.circles2d.JointEvents;
import io.github.circles2d.JointedCircles;
import io.github.circles2d.Joints;
import io.github.circles2d.Kind;
import io.github.circles2d.Outline;
import io.github.circles2d.Queries;
import io.github.circles2d.Recording;
import io.github.circles2d.Replay;
import io.github.circles2d.Rewind;
import io.github.circles2d.Rollback;
import io.github.circles2d.Ropes;
import io.github.circles2d.Terrain;
import io.github.circles2d.TerrainBody;
import io.github.circles2d.TerrainQueries;
import io.github.circles2d.World;
import io.github.circles2d.WorldStats;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** The public methods that programs make, and which of them have been made. */
final class Api {
    /** The types whose methods a fuzz makes. Those of the engine of the thesis and of calibrations have tests of their own. */
    static final List<Class<?>> TYPES = List.of(
            World.class,
            World.Builder.class,
            Terrain.class,
            TerrainBody.class,
            Joints.class,
            Bodies.class,
            Outline.class,
            Joint.class,
            Kind.class,
            Chain.class,
            Queries.class,
            TerrainQueries.class,
            BodyQueries.class,
            Events.class,
            JointEvents.class,
            BodyEvents.class,
            FixedStep.class,
            Rewind.class,
            Rollback.class,
            Recording.class,
            Replay.class,
            Ropes.class,
            Blobs.class,
            JointedCircles.class,
            WorldStats.class);

    /** Those of them whose methods no table has: each program builds its world, reads what calls give, and plays its log. */
    private static final Set<Class<?>> BY_HAND = Set.of(
            World.Builder.class,
            Replay.class,
            Joint.class,
            Chain.class,
            Outline.class,
            Events.class,
            JointEvents.class,
            BodyEvents.class,
            JointedCircles.class,
            WorldStats.class);

    /** The same of single methods. */
    private static final Set<String> METHODS_BY_HAND = Set.of(
            "World.builder()",
            "World.close()",
            "Recording.close()",
            "FixedStep.advanceReplay(float, Replay)",
            "Ropes.circle(long)",
            "Ropes.at(float, float)",
            "Ropes.on(TerrainBody, float, float)");

    /** What has no calls on a world: the engine of the thesis, calibrations. Their tests are {@code Circles2DFuzzTest} and {@code CalibrationTest}. */
    private static final Set<Class<?>> LEFT_OUT = Set.of(Circles2D.class, Calibration.class);

    private static final Set<String> OF_VALUES = Set.of("equals", "hashCode", "toString");

    /** Whether a call of a method, by its name, has returned. It is false after refusals alone. */
    private final TreeMap<String, Boolean> made = new TreeMap<>();

    private static final List<Method> METHODS = all();

    /** All methods. */
    static List<Method> methods() {
        return METHODS;
    }

    private static List<Method> all() {
        List<Method> methods = new ArrayList<>();
        for (Class<?> type : TYPES) {
            for (Method method : type.getDeclaredMethods()) {
                boolean isCall =
                        Modifier.isPublic(method.getModifiers()) && (!method.isSynthetic() || method.isBridge());
                boolean isOfValue = (type.isRecord() || type == Outline.class) && OF_VALUES.contains(method.getName());
                if (isCall && !isOfValue) {
                    methods.add(method);
                }
            }
        }
        return methods;
    }

    /** Whether no table has a method, because each program calls it anyway. */
    static boolean isMadeByHand(Method method) {
        return BY_HAND.contains(method.getDeclaringClass()) || METHODS_BY_HAND.contains(name(method));
    }

    /** Whether a class is public and has methods, and nobody has thought of it here. */
    static boolean isUnknown(Class<?> type) {
        boolean isPublic = Modifier.isPublic(type.getModifiers());
        return isPublic
                && !type.isEnum()
                && !type.isInterface()
                && !TYPES.contains(type)
                && !LEFT_OUT.contains(type)
                && Arrays.stream(type.getDeclaredMethods())
                        .anyMatch(method -> Modifier.isPublic(method.getModifiers()));
    }

    /** The class, the name and the types of the parameters. */
    static String name(Method method) {
        return Arrays.stream(method.getParameterTypes())
                .map(Class::getSimpleName)
                .collect(Collectors.joining(
                        ", ", method.getDeclaringClass().getSimpleName() + "." + method.getName() + "(", ")"));
    }

    /** Makes a call, and counts it. */
    Object call(Method method, Object receiver, Object... arguments) throws Throwable {
        made.putIfAbsent(name(method), false);
        try {
            Object result = method.invoke(receiver, arguments);
            made.put(name(method), true);
            return result;
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }

    /** Makes a call of the only method that has this name and takes such arguments. */
    Object named(Object receiver, String name, Object... arguments) throws Throwable {
        List<Method> found = methods().stream()
                .filter(method -> method.getDeclaringClass() == receiver.getClass()
                        && method.getName().equals(name)
                        && method.getParameterCount() == arguments.length)
                .toList();
        if (found.size() != 1) {
            throw new IllegalStateException("of " + name + " there are " + found);
        }
        return call(found.get(0), receiver, arguments);
    }

    /** The methods that no program has made, or that have refused each call. */
    List<String> missing() {
        return methods().stream()
                .map(Api::name)
                .filter(name -> !made.getOrDefault(name, false))
                .sorted()
                .toList();
    }
}
