package io.github.circles2d.project;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;

/**
 * A machine for the launcher to run on: a copy of the launcher in a clone of its own, and a PATH that leads to the basic
 * tools and to fakes of all that it would install or run. Each fake writes its call into a log.
 */
final class FakeMachine {
    private static final List<String> BASIC_TOOLS = List.of(
            "sh",
            "cat",
            "cmp",
            "cp",
            "dirname",
            "env",
            "find",
            "grep",
            "ln",
            "mkdir",
            "mktemp",
            "mv",
            "readlink",
            "rm",
            "sed",
            "sleep",
            "sort",
            "tail",
            "tr");

    final Path root;
    final Path clone;
    final Path elsewhere;
    private final Path bin;
    private final Path calls;
    private final Map<String, String> environment = new TreeMap<>();

    FakeMachine(Path folder) throws IOException {
        this(folder, "a clone"); // with a space
    }

    FakeMachine(Path folder, String cloneName) throws IOException {
        root = folder.toRealPath();
        clone = Files.createDirectories(root.resolve(cloneName));
        elsewhere = Files.createDirectories(root.resolve("elsewhere"));
        bin = Files.createDirectories(root.resolve("bin"));
        calls = Files.createFile(root.resolve("calls"));
        Files.copy(Path.of("circles2d"), clone.resolve("circles2d"), StandardCopyOption.COPY_ATTRIBUTES);
        Files.createDirectories(clone.resolve("src/main"));
        Files.createDirectories(clone.resolve("kernels"));
        Files.createFile(clone.resolve("pom.xml"));
        for (String tool : BASIC_TOOLS) {
            Files.createSymbolicLink(bin.resolve(tool), find(tool));
        }
        fake("uname", "echo Linux");
        fake("id", "echo 1000");
        fake("ldconfig", "echo ' libOpenCL.so.1 (libc6) => " + root + "/lib/libOpenCL.so.1'");
        environment.put("OCL_ICD_VENDORS", root.resolve("vendors").toString());
        environment.put("CIRCLES2D_OCLGRIND", oclgrind().toString());
        environment.put("DISPLAY", ":7");
        environment.put("HOME", root.toString());
        environment.put("TMPDIR", temporary().toString());
    }

    /** A machine that has everything, a JDK of the given version included. */
    static FakeMachine withEverything(Path folder, int jdkVersion) throws IOException {
        return withEverything(folder, "a clone", jdkVersion);
    }

    static FakeMachine withEverything(Path folder, String cloneName, int jdkVersion) throws IOException {
        FakeMachine machine = new FakeMachine(folder, cloneName);
        machine.addJdk(jdkVersion);
        machine.fake("mvn", logged("mvn"));
        machine.fake("npm", logged("npm"));
        machine.addLoader();
        Files.createFile(machine.oclgrind());
        machine.addApt("");
        return machine;
    }

    /** The folder for temporary files. */
    Path temporary() throws IOException {
        return Files.createDirectories(root.resolve("temporary"));
    }

    /** Adds a tool that the launcher can do without, if this machine has it. */
    boolean addTool(String name) throws IOException {
        Path tool = Path.of("/usr/bin", name);
        if (!Files.isExecutable(tool)) {
            return false;
        }
        Files.createSymbolicLink(bin.resolve(name), tool);
        return true;
    }

    /** Where the launcher is told to look for Oclgrind's driver. */
    Path oclgrind() {
        return root.resolve("oclgrind.so");
    }

    void addJdk(int version) throws IOException {
        Path jdk = root.resolve("jdk");
        Files.createDirectories(jdk.resolve("bin"));
        Files.createDirectories(jdk.resolve("lib"));
        Files.writeString(jdk.resolve("lib/libawt_xawt.so"), "");
        script(
                jdk.resolve("bin/java"),
                "case $1 in -XshowSettings:properties) echo '    java.home = " + jdk
                        + "'; echo '    java.specification.version = " + version
                        + "'; exit;; esac\n" + logged("java") + "echo java runs in $PWD\nexit ${JAVA_STATUS:-0}");
        script(jdk.resolve("bin/javac"), "");
        environment.put("JAVA_HOME", jdk.toString());
    }

    void addLoader() throws IOException {
        Files.createDirectories(root.resolve("lib"));
        Files.writeString(root.resolve("lib/libOpenCL.so.1"), "");
    }

    /** Adds apt-get and sudo; {@code onInstall} is what an installation does, in sh. */
    void addApt(String onInstall) throws IOException {
        fake("apt-cache", "case $2 in oclgrind) exit 100;; esac");
        fake("apt-get", logged("apt-get") + "case \"$*\" in *install*) " + onInstall + "\n:;; esac");
        fake("sudo", logged("sudo") + "exec \"$@\"");
    }

    void remove(String tool) throws IOException {
        Files.delete(bin.resolve(tool));
    }

    void fake(String name, String body) throws IOException {
        script(bin.resolve(name), body);
    }

    Path bin() {
        return bin;
    }

    void set(String variable, String value) {
        environment.put(variable, value);
    }

    /** The calls of fakes so far, one a line. */
    String calls() throws IOException {
        return Files.readString(calls, StandardCharsets.UTF_8);
    }

    void forgetCalls() throws IOException {
        Files.writeString(calls, "");
    }

    /** Runs the launcher from a directory that is not its own. */
    Result launch(String... arguments) throws IOException, InterruptedException {
        return launch(clone.resolve("circles2d"), arguments);
    }

    Result launch(Path launcher, String... arguments) throws IOException, InterruptedException {
        Path out = Files.createTempFile(root, "out", "");
        Process process = start(launcher, out, arguments);
        if (!process.waitFor(1, TimeUnit.MINUTES)) {
            process.destroyForcibly();
            throw new AssertionError("the launcher did not end: " + Files.readString(out, StandardCharsets.UTF_8));
        }
        return new Result(process.exitValue(), Files.readString(out, StandardCharsets.UTF_8));
    }

    /** Starts the launcher, and leaves it to itself. */
    Process start(String... arguments) throws IOException {
        return start(clone.resolve("circles2d"), Files.createTempFile(root, "out", ""), arguments);
    }

    private Process start(Path launcher, Path out, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(bin.resolve("sh").toString(), launcher.toString()));
        command.addAll(List.of(arguments));
        ProcessBuilder builder = new ProcessBuilder(command)
                .directory(elsewhere.toFile())
                .redirectErrorStream(true)
                .redirectOutput(out.toFile());
        builder.environment().clear();
        builder.environment().putAll(environment);
        builder.environment().put("PATH", bin.toString());
        builder.environment().put("CALLS", calls.toString());
        Process process = builder.start();
        process.getOutputStream().close();
        return process;
    }

    static final class Result {
        final int status;
        final String output;

        Result(int status, String output) {
            this.status = status;
            this.output = output;
        }
    }

    /** The sh line by which a fake records its call. */
    static String logged(String name) {
        return "echo " + name + " \"$@\" >>\"$CALLS\"\n";
    }

    private static void script(Path file, String body) throws IOException {
        Files.writeString(file, "#!/bin/sh\n" + body + "\n");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    private static Path find(String tool) {
        for (String folder : List.of("/usr/bin", "/bin")) {
            Path file = Path.of(folder, tool);
            if (Files.isExecutable(file)) {
                return file;
            }
        }
        throw new IllegalStateException("this machine has no " + tool);
    }
}
