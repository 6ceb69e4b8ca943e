package io.github.circles2d.opencl;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Tag("each-jdk")
class PoclProbeTest {
    private static final String NO_LIMITS = "Max stack size            8388608       unlimited    bytes\n";

    @TempDir
    private Path root;

    private final Map<String, String> environment = new HashMap<>();
    private File library;

    /** A machine on which nothing is missing, of two processors. */
    @BeforeEach
    void createMachine() throws IOException {
        library = write("lib/libpocl.so", "\0ELF\0/usr/lib/llvm-15/bin/clang-15\0-shared\0");
        environment.put("PATH", root.resolve("bin").toString());
        environment.put("POCL_CACHE_DIR", root.resolve("cache/of/pocl").toString());
        program("bin/ld");
        write("proc/self/limits", NO_LIMITS);
        write("proc/self/status", "Uid:\t1000\t1000\t1000\t1000\nCapEff:\t0000000000000000\nVmSize:\t 1000000 kB\n");
        write("proc/loadavg", "0.5 0.4 0.3 1/300 4711\n");
        write("proc/self/cgroup", "0::/user/me\n");
    }

    private File write(String file, String content) throws IOException {
        Path path = root.resolve(file);
        Files.createDirectories(path.getParent());
        return Files.writeString(path, content, java.nio.charset.StandardCharsets.ISO_8859_1)
                .toFile();
    }

    private void program(String file) throws IOException {
        assertThat(write(file, "").setExecutable(true)).isTrue();
    }

    private Optional<String> complaint() {
        return new PoclProbe(environment, root.toFile(), 2).complaint(Optional.of(library));
    }

    @Test
    void nothingIsMissingAndNothingIsLeftBehind() {
        assertThat(complaint()).isEmpty();
        assertThat(root.resolve("cache")).doesNotExist();
        assertThat(root.toFile().list()).containsExactlyInAnyOrder("lib", "bin", "proc");
    }

    @Test
    void aCacheInTheCurrentFolderIsRefused() {
        environment.remove("POCL_CACHE_DIR");
        environment.put("HOME", "?");
        assertThat(complaint().orElseThrow()).contains("?/.cache/pocl", "absolute path");
    }

    @Test
    void aMachineWithoutLinkerIsToldWhereItWasLookedFor() throws IOException {
        environment.put("PATH", "/nowhere:");
        assertThat(complaint().orElseThrow()).contains("ld", "/usr/lib/llvm-15/bin", "/nowhere", "binutils");
        environment.remove("PATH");
        assertThat(complaint().orElseThrow()).contains("ld", "PATH");
        write("usr/lib/llvm-15/bin/ld", "not executable");
        assertThat(complaint()).isPresent();
    }

    @Test
    void theLinkerMayLieInTheFoldersOfClangOfTheTargetAndOfCompilers() throws IOException {
        environment.remove("PATH");
        program("usr/lib/llvm-15/bin/ld");
        assertThat(complaint()).isEmpty();
        Files.delete(root.resolve("usr/lib/llvm-15/bin/ld"));
        program("usr/x86_64-pc-linux-gnu/bin/ld");
        assertThat(complaint()).isEmpty();
        Files.delete(root.resolve("usr/x86_64-pc-linux-gnu/bin/ld"));
        environment.put("COMPILER_PATH", root.resolve("bin").toString());
        assertThat(complaint()).isEmpty();
    }

    @Test
    void aPoclThatLinksByItselfOrIsUnknownNeedsNoLinker() throws IOException {
        environment.remove("PATH");
        library = write("lib/libpocl.so", "\0/usr/bin/clang\0ld.lld: error\0");
        assertThat(complaint()).isEmpty();
        library = write("lib/libpocl.so", "\0/usr/bin/clang\0POCL_CPU_JIT\0");
        assertThat(complaint()).isEmpty();
        library = new File("/nowhere/libpocl.so");
        assertThat(complaint()).isEmpty();
    }

    @Test
    void aCacheThatCannotBeWrittenIsNamed() throws IOException {
        // A file, not a folder: even a superuser cannot create anything below it.
        String cache = write("file", "") + "/cache";
        environment.put("POCL_CACHE_DIR", cache);
        assertThat(complaint().orElseThrow()).contains(cache, "writable", "POCL_CACHE_DIR");
        environment.put("POCL_CACHE_DIR", "");
        assertThat(complaint().orElseThrow()).contains("POCL_CACHE_DIR is empty");
    }

    @Test
    void theCacheIsLookedForWherePoclKeepsIt() throws IOException {
        String file = write("file", "").toString();
        environment.remove("POCL_CACHE_DIR");
        environment.put("HOME", file);
        assertThat(complaint().orElseThrow()).contains(file + "/.cache/pocl/kcache");
        environment.put("POCL_KERNEL_CACHE", "0");
        assertThat(complaint().orElseThrow()).contains(file + "/.cache/pocl/uncached");
        environment.put("XDG_CACHE_HOME", root.toString());
        assertThat(complaint()).isEmpty();
        environment.put("XDG_CACHE_HOME", file);
        assertThat(complaint().orElseThrow()).contains(file + "/pocl/uncached");
        environment.remove("XDG_CACHE_HOME");
        environment.remove("HOME");
        assertThat(complaint()).isEmpty();
        String temporaryFiles = write("tmp", "").toString();
        assertThat(complaint().orElseThrow()).contains(temporaryFiles + "/pocl/uncached");
    }

    @Test
    void aFolderWhoseNameJavaCannotReadIsNotExamined() {
        environment.put("POCL_CACHE_DIR", "/nowhere/J\uFFFDrg");
        assertThat(complaint()).isEmpty();
    }

    @Test
    void aUserWhoMayStartTooFewThreadsIsToldSo() throws IOException {
        write("proc/1/status", "Uid:\t0\t0\t0\t0\nThreads:\t100\n");
        write("proc/2/status", "Uid:\t1000\t1000\t1000\t1000\nThreads:\t60\n");
        write("proc/self/limits", NO_LIMITS + "Max processes             65      70     processes\n");
        assertThat(complaint().orElseThrow()).contains("2 threads", "room for 6", "leave 5", "POCL_MAX_PTHREAD_COUNT");
        environment.put("POCL_MAX_PTHREAD_COUNT", "1");
        assertThat(complaint()).isEmpty();
        environment.put("POCL_MAX_PTHREAD_COUNT", "64");
        assertThat(complaint().orElseThrow()).contains("64 threads");
        write("proc/self/status", "Uid:\t1000\t1000\t1000\t1000\nCapEff:\t000001ffffffffff\n");
        assertThat(complaint())
                .as("the limit does not hold for an administrator")
                .isEmpty();
    }

    @Test
    void aContainerThatMayStartTooFewThreadsIsToldSo() throws IOException {
        write("sys/fs/cgroup/user/me/pids.max", "max\n");
        write("sys/fs/cgroup/user/me/pids.current", "20\n");
        assertThat(complaint()).isEmpty();
        write("sys/fs/cgroup/user/pids.max", "40\n");
        write("sys/fs/cgroup/user/pids.current", "35\n");
        assertThat(complaint().orElseThrow()).contains("leave 5", "pids.max");
        write("sys/fs/cgroup/user/pids.current", "34\n");
        assertThat(complaint()).isEmpty();
        write("proc/self/cgroup", "9:name=systemd:/\n8:cpu,pids:/docker/4711\n");
        write("sys/fs/cgroup/pids/pids.max", "40\n");
        write("sys/fs/cgroup/pids/pids.current", "38\n");
        assertThat(complaint().orElseThrow()).contains("leave 2");
    }

    @Test
    void aProcessWithTooLittleAddressSpaceIsToldSo() throws IOException {
        long needed = (512L << 20) + 2 * 8_388_608;
        long used = 1_000_000L * 1024;
        write("proc/self/limits", NO_LIMITS + "Max address space  " + (used + needed) + "  unlimited  bytes\n");
        assertThat(complaint()).isEmpty();
        write("proc/self/limits", NO_LIMITS + "Max address space  " + (used + needed - 1) + "  unlimited  bytes\n");
        assertThat(complaint().orElseThrow()).contains("needs 528 MiB", "leaves 527 MiB", "ulimit -v");
    }

    @Test
    void aMachineThatHidesProcIsNotRefused() throws IOException {
        for (String file : new String[] {"proc/self/limits", "proc/self/status", "proc/self/cgroup", "proc/loadavg"}) {
            write(file, "");
        }
        assertThat(complaint()).isEmpty();
    }

    @Test
    void anInterruptedThreadFindsTheSame() {
        Thread.currentThread().interrupt();
        Optional<String> whole = complaint();
        environment.put("PATH", "/nowhere");
        Optional<String> linker = complaint();
        assertThat(Thread.interrupted()).isTrue();
        assertThat(whole).isEmpty();
        assertThat(linker).isPresent();
    }
}
