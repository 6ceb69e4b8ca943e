package io.github.circles2d.bench.sweep;

/** Kills the JVMs that this one has started if they run for too long. */
final class Watchdog implements AutoCloseable {
    private final Thread thread;
    private volatile boolean fired;

    Watchdog(long seconds) {
        thread = new Thread(() -> watch(seconds), "watchdog");
        thread.setDaemon(true);
        thread.start();
    }

    private void watch(long seconds) {
        try {
            Thread.sleep(1000 * seconds);
        } catch (InterruptedException e) {
            return;
        }
        fired = true;
        ProcessHandle.current().children().forEach(ProcessHandle::destroyForcibly);
    }

    /** Whether it had to. */
    boolean fired() {
        return fired;
    }

    @Override
    public void close() {
        thread.interrupt();
    }
}
