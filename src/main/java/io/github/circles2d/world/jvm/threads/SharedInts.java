package io.github.circles2d.world.jvm.threads;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;

/**
 * Elements of int arrays that several threads change at the same time. It is the only class with a VarHandle, which browsers do
 * not have: there a class with the same methods takes its place.
 */
public final class SharedInts {
    private static final VarHandle INTS = MethodHandles.arrayElementVarHandle(int[].class);

    private SharedInts() {}

    /** The value that every thread sees now. */
    public static int get(int[] array, int i) {
        return (int) INTS.getVolatile(array, i);
    }

    /** Sets an element if it has the expected value; returns whether it had. */
    public static boolean compareAndSet(int[] array, int i, int expected, int value) {
        return INTS.compareAndSet(array, i, expected, value);
    }

    /** Sets an element; returns the value before. */
    public static int getAndSet(int[] array, int i, int value) {
        return (int) INTS.getAndSet(array, i, value);
    }

    /** Adds to an element; returns the value before. */
    public static int getAndAdd(int[] array, int i, int more) {
        return (int) INTS.getAndAdd(array, i, more);
    }
}
