package io.github.circles2d.opencl;

import java.io.File;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Finds out whether POCL, the OpenCL driver for CPUs, has what it needs: a linker, a cache that can be written, threads and address
 * space. POCL ends the process if it lacks one of them, so this must be known before POCL is loaded.
 *
 * <p>Only Linux is examined. If something cannot be examined, it counts as there. All files are read by {@code java.io}, because
 * the channels of {@code java.nio} fail in a thread that is interrupted.
 */
final class PoclProbe {
    /** A first start writes 1.9 MiB for World, 1.2 MiB for Circles2D (POCL 3.1). */
    private static final int CACHE_BYTES = 4 << 20;

    /** A first start of World takes between 400 and 500 MiB beside the stacks of the threads (POCL 3.1). */
    private static final long ADDRESS_SPACE_BYTES = 512L << 20;

    /** The linker is a process, and the JVM starts a few threads while POCL starts its own. */
    private static final int THREADS_OF_OTHERS = 4;

    /** POCL's library is 1 MiB if it loads LLVM from another library. One that contains LLVM is not searched. */
    private static final int LARGEST_LIBRARY = 16 << 20;

    /** What Java puts for a byte that the encoding of file names lacks; such a path cannot be examined. */
    private static final char UNKNOWN_CHARACTER = '\uFFFD';

    private final Map<String, String> environment;
    private final File root;
    private final int processors;

    /**
     * Examines a machine.
     *
     * @param environment the environment of the process
     * @param root the root of the file system, for the files that have one name on all machines
     * @param processors the processors of the machine, at least 1; POCL starts a thread for each
     */
    PoclProbe(Map<String, String> environment, File root, int processors) {
        this.environment = environment;
        this.root = root;
        this.processors = processors;
    }

    /**
     * Says what POCL lacks.
     *
     * @param library POCL's library; empty if it was not found
     * @return what is missing, and what to do; empty if nothing is
     */
    Optional<String> complaint(Optional<File> library) {
        String content = library.map(PoclProbe::contentOfLibrary).orElse("");
        return linkerComplaint(content)
                .or(() -> cacheComplaint(content))
                .or(this::threadComplaint)
                .or(this::addressSpaceComplaint);
    }

    private static String contentOfLibrary(File library) {
        return library.length() <= LARGEST_LIBRARY ? content(library) : "";
    }

    /** POCL up to 7.2 lets clang call {@code ld}. Later ones need no linker, nor do those that were built with LLD inside. */
    private Optional<String> linkerComplaint(String library) {
        List<File> folders = foldersOfClang(library);
        if (folders.isEmpty() || library.contains("lld") || linksInMemory(library)) {
            return Optional.empty();
        }
        String path = environment.getOrDefault("PATH", "");
        String all = path + ":" + environment.getOrDefault("COMPILER_PATH", "");
        // Clang looks into the folders of GCC's tools, too: /usr/x86_64-pc-linux-gnu/bin.
        File[] targets = new File(root, "usr").listFiles((usr, name) -> name.contains("-linux"));
        Arrays.stream(targets == null ? new File[0] : targets).forEach(target -> folders.add(new File(target, "bin")));
        Arrays.stream(all.split(":"))
                .filter(name -> !name.isEmpty())
                .map(File::new)
                .forEach(folders::add);
        boolean found = all.indexOf(UNKNOWN_CHARACTER) >= 0 || folders.stream().anyMatch(PoclProbe::hasLinker);
        return found
                ? Optional.empty()
                : Optional.of("POCL links kernels by the program ld, which is neither in " + folders.get(0)
                        + " nor in a folder of PATH (" + path
                        + "). Install it (Debian, Ubuntu: apt-get install binutils),"
                        + " or add its folder to PATH");
    }

    /** Clang also takes a linker that is named after its target, such as {@code x86_64-linux-gnu-ld}. */
    private static boolean hasLinker(File folder) {
        File[] linkers = folder.listFiles((in, name) -> name.equals("ld") || name.endsWith("-ld"));
        return linkers != null && Arrays.stream(linkers).anyMatch(file -> file.isFile() && file.canExecute());
    }

    /** The path of clang is compiled into POCL, and clang looks for the linker in the folder of this path first. */
    private List<File> foldersOfClang(String library) {
        List<File> folders = new ArrayList<>();
        for (int at = library.indexOf("/clang"); at >= 0; at = library.indexOf("/clang", at + 1)) {
            String text = library.substring(library.lastIndexOf('\0', at) + 1, Math.max(at, library.indexOf('\0', at)));
            if (text.matches("/[!-~]*/clang(\\+\\+)?(-[0-9.]+)?")) {
                folders.add(new File(root, text).getParentFile());
            }
        }
        return folders;
    }

    /** POCL after 7.2 keeps kernels in memory; the others load them from files in the cache. */
    private static boolean linksInMemory(String library) {
        return library.contains("POCL_CPU_JIT");
    }

    private Optional<String> cacheComplaint(String library) {
        String name = environment.get("POCL_CACHE_DIR");
        if (name == null) {
            name = defaultCache();
        } else if (name.isEmpty()) {
            return Optional.of("POCL_CACHE_DIR is empty. Unset it, or let it name a folder that can be written");
        }
        if (name.indexOf(UNKNOWN_CHARACTER) >= 0) {
            return Optional.empty();
        }
        if (!new File(name).isAbsolute()) {
            return Optional.of(
                    "POCL's cache " + name
                            + " would be a folder in the current one. Let HOME or POCL_CACHE_DIR name a folder by its absolute path");
        }
        // POCL creates what is missing, which the nearest folder that is there must allow.
        File folder = new File(name);
        while (!folder.exists() && folder.getParentFile() != null) {
            folder = folder.getParentFile();
        }
        File file = null;
        try {
            file = File.createTempFile("circles2d", null, folder);
            fill(file);
            if (!library.isEmpty() && !linksInMemory(library) && file.setExecutable(true) && !file.canExecute()) {
                return Optional.of(
                        "POCL cannot load kernels from its cache " + name + ", because that file system is mounted"
                                + " with the option noexec. Let POCL_CACHE_DIR name a folder on another");
            }
            return Optional.empty();
        } catch (IOException e) {
            return Optional.of(
                    "POCL's cache " + name + " must be writable, with room for " + (CACHE_BYTES >> 20) + " MiB, and "
                            + folder + " is not: " + e.getMessage()
                            + ". Mend this, or let POCL_CACHE_DIR name a folder that is");
        } finally {
            if (file != null) {
                file.delete();
            }
        }
    }

    private String defaultCache() {
        String folder =
                environment.getOrDefault("POCL_KERNEL_CACHE", "1").startsWith("1") ? "pocl/kcache" : "pocl/uncached";
        String caches = environment.getOrDefault("XDG_CACHE_HOME", "");
        if (!caches.isEmpty()) {
            return caches + "/" + folder;
        }
        String home = environment.get("HOME");
        return home == null ? new File(root, "tmp/" + folder).getPath() : home + "/.cache/" + folder;
    }

    /** Writing is the only proof of room: quotas are not part of what a file system says of its free space. */
    private static void fill(File file) throws IOException {
        byte[] part = new byte[64 << 10];
        try (FileOutputStream out = new FileOutputStream(file)) {
            for (int written = 0; written < CACHE_BYTES; written += part.length) {
                out.write(part);
            }
        }
    }

    private Optional<String> threadComplaint() {
        int needed = threads() + THREADS_OF_OTHERS;
        OptionalLong left = threadsLeft(needed);
        return left.isPresent() && left.getAsLong() < needed
                ? Optional.of("POCL starts " + threads() + " threads, for which there should be room for " + needed
                        + " more threads and processes, and the limits of this user or container (ulimit -u, pids.max) leave "
                        + Math.max(0, left.getAsLong())
                        + ". Raise the limit, or set POCL_MAX_PTHREAD_COUNT to a lower number")
                : Optional.empty();
    }

    /** Without a setting POCL asks for the processors of the machine, of which Java may see fewer: these are the least. */
    private int threads() {
        OptionalLong asked = number(environment.getOrDefault("POCL_MAX_PTHREAD_COUNT", ""));
        // The newer name of the setting, which older versions ignore.
        OptionalLong most = number(environment.getOrDefault("POCL_CPU_MAX_CU_COUNT", ""));
        return (int) Math.min(100_000, asked.orElse(Math.min(processors, Math.max(1, most.orElse(processors)))));
    }

    /** How many more threads may be started; empty if there is no limit, or if it is certain that {@code needed} may. */
    private OptionalLong threadsLeft(int needed) {
        long left = Long.MAX_VALUE;
        OptionalLong limit = limit("Max processes");
        if (limit.isPresent() && !isExempt()) {
            long all = threadsOfTheMachine();
            if (limit.getAsLong() < all + needed) {
                left = limit.getAsLong() - threadsOfThisUser();
            }
        }
        for (String line : content("proc/self/cgroup").split("\n")) {
            String[] fields = line.split(":", 3);
            if (fields.length == 3
                    && (fields[1].isEmpty()
                            || Arrays.asList(fields[1].split(",")).contains("pids"))) {
                left = Math.min(left, leftInGroup("sys/fs/cgroup", fields[2]));
                left = Math.min(left, leftInGroup("sys/fs/cgroup/pids", fields[2]));
            }
        }
        return left == Long.MAX_VALUE ? OptionalLong.empty() : OptionalLong.of(left);
    }

    /** The limit of a control group holds for the groups in it, too. A container sees its own group as the top. */
    private long leftInGroup(String top, String group) {
        long left = Long.MAX_VALUE;
        String path = group;
        while (true) {
            OptionalLong most = number(content(top + path + "/pids.max"));
            OptionalLong now = number(content(top + path + "/pids.current"));
            if (most.isPresent() && now.isPresent()) {
                left = Math.min(left, most.getAsLong() - now.getAsLong());
            }
            if (path.isEmpty()) {
                return left;
            }
            path = path.substring(0, path.lastIndexOf('/'));
        }
    }

    /** The limit of processes does not hold for the superuser, nor for who may administer the system or its resources. */
    private boolean isExempt() {
        String status = content("proc/self/status");
        String capabilities = field(status, "CapEff").orElse("0");
        long bits = capabilities.matches("[0-9a-f]{1,15}|0[0-9a-f]{15}") ? Long.parseLong(capabilities, 16) : -1;
        boolean maySetLimits = (bits >> 21 & 1) != 0 || (bits >> 24 & 1) != 0; // CAP_SYS_ADMIN, CAP_SYS_RESOURCE
        return maySetLimits || realUser(status).equals("0");
    }

    private long threadsOfTheMachine() {
        Matcher tasks = Pattern.compile("/([0-9]{1,18}) ").matcher(content("proc/loadavg"));
        return tasks.find() ? Long.parseLong(tasks.group(1)) : Long.MAX_VALUE / 2;
    }

    private long threadsOfThisUser() {
        String user = realUser(content("proc/self/status"));
        File[] processes = new File(root, "proc").listFiles((proc, name) -> name.matches("[0-9]+"));
        long threads = 0;
        for (File process : processes == null ? new File[0] : processes) {
            String status = content(new File(process, "status"));
            if (realUser(status).equals(user)) {
                threads += field(status, "Threads")
                        .map(PoclProbe::number)
                        .orElse(OptionalLong.empty())
                        .orElse(0);
            }
        }
        return threads;
    }

    private static String realUser(String status) {
        return field(status, "Uid").orElse("").split("\\s")[0];
    }

    private Optional<String> addressSpaceComplaint() {
        OptionalLong limit = limit("Max address space");
        Optional<String> size = field(content("proc/self/status"), "VmSize"); // "8973028 kB"
        if (limit.isEmpty() || size.isEmpty()) {
            return Optional.empty();
        }
        long stack = limit("Max stack size").orElse(2 << 20); // glibc's own size, if there is no limit
        long needed = ADDRESS_SPACE_BYTES + (long) threads() * stack;
        long left = limit.getAsLong() - number(size.get().split(" ")[0]).orElse(0) * 1024;
        return left < needed
                ? Optional.of("POCL needs " + (needed >> 20)
                        + " MiB of address space, and the limit of this process (ulimit -v)" + " leaves "
                        + Math.max(0, left >> 20) + " MiB. Raise the limit, or give the heap less (-Xmx)")
                : Optional.empty();
    }

    /** The soft limit that /proc/self/limits names; empty if there is none. */
    private OptionalLong limit(String name) {
        return content("proc/self/limits")
                .lines()
                .filter(line -> line.startsWith(name))
                .map(line -> number(line.substring(name.length()).trim().split("\\s+")[0]))
                .findFirst()
                .orElse(OptionalLong.empty());
    }

    private static Optional<String> field(String status, String name) {
        return status.lines()
                .filter(line -> line.startsWith(name + ":"))
                .map(line -> line.substring(name.length() + 1).trim())
                .findFirst();
    }

    private static OptionalLong number(String text) {
        String digits = text.trim();
        return digits.matches("[0-9]{1,18}") ? OptionalLong.of(Long.parseLong(digits)) : OptionalLong.empty();
    }

    private String content(String path) {
        return content(new File(root, path));
    }

    /** Returns the bytes of a file, each as one character; nothing if it cannot be read. */
    static String content(File file) {
        try (InputStream in = new FileInputStream(file)) {
            return new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
        } catch (IOException e) {
            return "";
        }
    }
}
