package io.github.circles2d.opencl;

import io.github.circles2d.Circles2D;
import io.github.circles2d.World;
import java.lang.reflect.Proxy;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CountDownLatch;

/** Main class for {@link SignalsTest}: uses every device with every engine, and prints which signal handlers changed. */
final class SignalsProgram {
    private static final Map<String, Integer> SIGNALS = new LinkedHashMap<>();

    static {
        String[] names = {
            "HUP", "INT", "QUIT", "ILL", "TRAP", "ABRT", "BUS", "FPE", "USR1", "SEGV", "USR2", "PIPE", "TERM"
        };
        int[] numbers = {1, 2, 3, 4, 5, 6, 7, 8, 10, 11, 12, 13, 15};
        for (int i = 0; i < names.length; i++) {
            SIGNALS.put(names[i], numbers[i]);
        }
    }

    private static SignalHandlers handlers;
    private static Map<String, byte[]> before;

    private SignalsProgram() {}

    public static void main(String[] arguments) throws Exception {
        NativeAccess.prepare();
        handlers = new SignalHandlers(new LoadedLibraries(LoadedLibraries.LIST));
        before = describeAll();
        for (Device device : OpenCl.devices()) {
            compare("discovery");
            useSession(device);
            try (World world = World.builder().device(device).build()) {
                world.addAll(new float[] {0.5f, 0.5f, 0.1f, 1, 0.6f, 0.6f, 0.1f, 1}, null);
                compare("World made");
                world.step(1 / 60f, 3);
                world.hash();
                compare("World stepped");
            }
            useCircles2D(device.kind() != Device.Kind.CPU);
        }
        keepsHandlersOfTheProgram();
        System.out.println("end");
    }

    private static void useSession(Device device) {
        try (Session session = Session.open(device)) {
            Program program = session.build(KernelSource.ofText(
                    "one", "kernel void one(global int *data) {\n    data[get_global_id(0)] = 1;\n}\n"));
            compare("build");
            DeviceBuffer data = session.allocate("data", 1024);
            program.kernel("one").arg(0, data).run(256);
            compare("enqueue");
        }
    }

    private static void useCircles2D(boolean gpu) throws Exception {
        for (int strategy = 0; strategy < 4; strategy++) {
            try (Circles2D engine = new Circles2D(gpu)) {
                engine.addCircle(0.5f, 0.5f, 0.1f, 1);
                engine.addCircle(0.6f, 0.6f, 0.1f, 1);
                engine.init(1 / 60f, strategy, 0.5f, new float[] {0, -1});
                compare("Circles2D initialised, strategy " + strategy);
                engine.loop();
                compare("Circles2D looped, strategy " + strategy);
            }
        }
    }

    /** A handler that the program sets while a driver is at work is there afterwards. */
    private static void keepsHandlersOfTheProgram() throws Exception {
        CountDownLatch inside = new CountDownLatch(1);
        CountDownLatch set = new CountDownLatch(1);
        Thread driver = new Thread(() -> DriverCalls.make(() -> {
            inside.countDown();
            try {
                return set.await(10, java.util.concurrent.TimeUnit.SECONDS);
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        }));
        driver.start();
        inside.await();
        Class<?> signal = Class.forName("sun.misc.Signal"); // by name: the compiler warns of it
        Class<?> handler = Class.forName("sun.misc.SignalHandler");
        Object ours =
                Proxy.newProxyInstance(handler.getClassLoader(), new Class<?>[] {handler}, (proxy, method, args) -> {
                    System.out.println("our handler");
                    return null;
                });
        Object term = signal.getConstructor(String.class).newInstance("TERM");
        signal.getMethod("handle", signal, handler).invoke(null, term, ours);
        byte[] changed = handlers.describe(SIGNALS.get("TERM"));
        set.countDown();
        driver.join();
        boolean kept = Arrays.equals(changed, handlers.describe(SIGNALS.get("TERM")));
        System.out.println("handler of the program kept: " + kept);
    }

    private static Map<String, byte[]> describeAll() {
        Map<String, byte[]> all = new LinkedHashMap<>();
        SIGNALS.forEach((name, number) -> all.put(name, handlers.describe(number)));
        return all;
    }

    private static void compare(String stage) {
        describeAll().forEach((name, now) -> {
            if (!Arrays.equals(now, before.get(name))) {
                System.out.println("changed at stage " + stage + ": " + name + " is "
                        + java.util.HexFormat.of().formatHex(now));
            }
        });
        System.out.println("compared: " + stage);
    }
}
