package io.github.circles2d.world.jvm.threads;

/** Takes the place of {@link SharedInts} in browsers, where one thread alone changes arrays. */
public final class BrowserSharedInts {
    private BrowserSharedInts() {}

    public static int get(int[] array, int i) {
        return array[i];
    }

    public static boolean compareAndSet(int[] array, int i, int expected, int value) {
        if (array[i] != expected) {
            return false;
        }
        array[i] = value;
        return true;
    }

    public static int getAndSet(int[] array, int i, int value) {
        int before = array[i];
        array[i] = value;
        return before;
    }

    public static int getAndAdd(int[] array, int i, int more) {
        int before = array[i];
        array[i] = before + more;
        return before;
    }
}
