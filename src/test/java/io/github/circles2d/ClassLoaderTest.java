package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.circles2d.opencl.ForkedJvm;
import io.github.circles2d.opencl.TestDevices;
import java.io.File;
import java.lang.ref.WeakReference;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The library in class loaders of their own, as application servers and hosts of plug-ins have them. */
@Tag("each-jdk")
class ClassLoaderTest {
    /** Loads the library twice, each time in a new loader, uses it there, and lets go of the loader. */
    static final class Host {
        public static void main(String[] arguments) throws Exception {
            // One that does not know the library.
            Thread.currentThread().setContextClassLoader(ClassLoader.getPlatformClassLoader());
            for (int round = 0; round < 2; round++) {
                WeakReference<ClassLoader> loader = useInNewLoader(arguments[0]);
                System.out.println("collected: " + isCollected(loader));
            }
        }

        private static WeakReference<ClassLoader> useInNewLoader(String what) throws Exception {
            List<URL> urls = new ArrayList<>();
            for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
                urls.add(Path.of(entry).toUri().toURL());
            }
            try (URLClassLoader loader =
                    new URLClassLoader(urls.toArray(new URL[0]), ClassLoader.getPlatformClassLoader())) {
                loader.loadClass(PlugIn.class.getName()).getMethod(what).invoke(null);
                return new WeakReference<>(loader);
            }
        }

        private static boolean isCollected(WeakReference<ClassLoader> loader) throws InterruptedException {
            for (int k = 0; k < 50 && loader.get() != null; k++) {
                System.gc();
                Thread.sleep(20);
            }
            return loader.get() == null;
        }
    }

    /** What runs in the new loader. */
    public static final class PlugIn {
        private PlugIn() {}

        /** A world that is closed, one by AUTO, and one that is abandoned with its threads. */
        public static void jvm() {
            try (World world = world(Backend.JVM)) {
                System.out.println("closed: " + world.hash());
            }
            try (World world = world(Backend.AUTO)) {
                System.out.println("by AUTO: " + world.hash());
            }
            System.out.println("abandoned: " + world(Backend.JVM).hash());
        }

        private static World world(Backend backend) {
            World world = World.builder()
                    .bounds(0, 0, 100, 100)
                    .threads(2)
                    .backend(backend)
                    .build();
            for (int i = 0; i < 1000; i++) {
                world.add(1 + 2 * (i % 40), 1 + 2 * (i / 40), 0.9f, 1);
            }
            world.step(1 / 60f, 3);
            return world;
        }

        public static void openCl() throws Exception {
            try (Circles2D physics = new Circles2D(false)) {
                physics.addCircle(0.5f, 0.5f, 0.1f, 1);
                physics.init(1 / 60f, PairIndexing.EXACT, 0.5f, new float[] {0, -1});
                System.out.println("circles: " + physics.loop()[0].length);
            }
        }
    }

    @Test
    void aLoaderIsCollectedWhenOnlyTheJvmWasUsed() {
        ForkedJvm.Result result = new ForkedJvm().run(Host.class, "jvm");
        assertThat(result.exitStatus()).as(result.output()).isZero();
        assertThat(result.output().split("collected: true", -1))
                .as(result.output())
                .hasSize(3);
    }

    /** Such a loader is never collected: BridJ's native library holds on to its classes. */
    @Test
    @Tag("long")
    void everyLoaderCanUseOpenClWhateverTheContextClassLoader() {
        TestDevices.all();
        ForkedJvm.Result result = new ForkedJvm().run(Host.class, "openCl");
        assertThat(result.exitStatus()).as(result.output()).isZero();
        assertThat(result.output().split("circles: 1", -1)).as(result.output()).hasSize(3);
    }
}
