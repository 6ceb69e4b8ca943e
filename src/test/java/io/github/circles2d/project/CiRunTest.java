package io.github.circles2d.project;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The script {@code .ci/run}, on a launcher that leaves a report of three tests and behaves as each test wants. */
@EnabledOnOs(OS.LINUX)
class CiRunTest {
    @TempDir
    Path project;

    private Path home;
    private int status;
    private String output;

    @BeforeEach
    void copyTheScript() throws IOException {
        Files.createDirectories(project.resolve(".ci"));
        Files.copy(Path.of(".ci/run"), project.resolve(".ci/run"), StandardCopyOption.COPY_ATTRIBUTES);
        home = Files.createDirectories(project.resolve("home"));
    }

    private void run(String launcher) throws IOException, InterruptedException {
        run(launcher, "exit 0");
    }

    private void run(String launcher, String dryRun, String... arguments) throws IOException, InterruptedException {
        String report = "mkdir -p target/surefire-reports\n"
                + "echo '<testsuite name=\"A\" tests=\"3\" errors=\"0\" skipped=\"0\" failures=\"'${FAILURES:-0}'\">'"
                + " >target/surefire-reports/TEST-A.xml\n";
        writeProgram("circles2d", launcher + "\n" + report + "exit ${STATUS:-0}");
        writeProgram(".ci/release-dry-run", dryRun);
        List<String> command =
                new ArrayList<>(List.of(project.resolve(".ci/run").toString()));
        command.addAll(List.of(arguments));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("HOME", home.toString());
        Process process = builder.start();
        output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        status = process.waitFor();
    }

    private void writeProgram(String name, String text) throws IOException {
        Path file = project.resolve(name);
        Files.writeString(file, "#!/bin/sh\n" + text + "\n");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    private String lastLine() {
        List<String> lines = output.lines().toList();
        return lines.get(lines.size() - 1);
    }

    @Test
    void passedTestsAreCounted() throws Exception {
        run("");
        assertThat(status).as(output).isZero();
        assertThat(lastLine()).matches("(3|6) passed, 0 failed"); // with one JDK or two
    }

    @Test
    void failedTestsAreCountedOnce() throws Exception {
        run("STATUS=1 FAILURES=1");
        assertThat(status).isEqualTo(1);
        assertThat(lastLine()).matches("2 passed, 1 failed|4 passed, 2 failed");
    }

    @Test
    void aPageThatFailsIsAFailure() throws Exception {
        run("[ \"$1\" != web ] || STATUS=1");
        assertThat(status).isEqualTo(1);
        assertThat(output).contains("circles2d web --test failed");
        assertThat(lastLine()).matches("(3|6) passed, 1 failed");
    }

    @Test
    void aDryRunOfAReleaseThatFailsIsAFailureOnce() throws Exception {
        run("", "exit 1");
        assertThat(status).isEqualTo(1);
        assertThat(output).containsOnlyOnce("the dry run of a release failed");
        assertThat(lastLine()).matches("(3|6) passed, 1 failed");
    }

    @Test
    void aDryRunAndAPageThatFailAreTwoFailures() throws Exception {
        run("[ \"$1\" != web ] || STATUS=1", "echo a dry run; exit 1");
        assertThat(status).isEqualTo(1);
        assertThat(output)
                .containsSubsequence("a dry run", "the dry run of a release failed", "circles2d web --test failed");
        assertThat(lastLine()).matches("(3|6) passed, 2 failed");
    }

    @Test
    void aDryRunOfAReleaseThatDiesIsAFailure() throws Exception {
        run("", "kill -9 $$");
        assertThat(status).isEqualTo(1);
        assertThat(output).contains("the dry run of a release failed: exit status 137");
        assertThat(lastLine()).matches("(3|6) passed, 1 failed");
    }

    @Test
    void theSecondJdkHasACopyOfTheProjectAndTheTestsThatEachJdkMustPass() throws Exception {
        run("echo \"$* in $(pwd)\"");
        List<String> calls =
                output.lines().filter(line -> line.matches("(test|web) .*")).toList();
        Path real = project.toRealPath();
        assertThat(calls)
                .hasSizeBetween(2, 3)
                .contains("test -Plong -Dsurefire.timeout=2700 in " + real, "web --test in " + real);
        for (String call : calls.subList(1, calls.size() - 1)) {
            assertThat(call)
                    .contains("-Dcircles2d.included.tests=each-jdk")
                    .endsWith(" in " + real.resolve("target/second-jdk"));
        }
    }

    @Test
    void aJdkOnWhichNoTestOfTheLibraryRunsIsAFailure() throws Exception {
        run("[ \"$1\" = web ] || exit 0");
        assertThat(status).isEqualTo(1);
        assertThat(output).contains("no test of the library was run");
        assertThat(lastLine()).matches("0 passed, [12] failed");
    }

    @Test
    void aBuildThatFailsBeforeItsTestsIsOneFailureAJdk() throws Exception {
        run("[ \"$1\" = web ] || exit 1");
        assertThat(status).isEqualTo(1);
        assertThat(output).contains("circles2d test ended with exit status 1");
        assertThat(lastLine()).matches("0 passed, [12] failed");
    }

    @Test
    void onWishAllTestsRunOnceOnNoOlderJdkThanTheDefaultOne() throws Exception {
        String newest =
                "\"${JAVA_HOME:+$JAVA_HOME/bin/}java\" -version 2>&1 | sed -n 's/.* version \"\\([0-9]*\\).*/java \\1/p'";
        run("echo \"arguments $*\"; " + newest, "echo a dry run", "exhaustive");
        assertThat(status).as(output).isZero();
        assertThat(output).containsOnlyOnce("arguments ").contains("arguments test -Pexhaustive");
        assertThat(output).doesNotContain("a dry run");
        assertThat(lastLine()).isEqualTo("3 passed, 0 failed");
        String version = output.lines()
                .filter(line -> line.startsWith("java "))
                .findFirst()
                .orElseThrow();
        assertThat(Integer.parseInt(version.substring(5)))
                .isGreaterThanOrEqualTo(Runtime.version().feature());
    }

    @Test
    void anotherArgumentIsRefusedAndNothingRuns() throws Exception {
        run("echo it runs", "exit 0", "everything");
        assertThat(status).isEqualTo(2);
        assertThat(output).contains("usage: .ci/run [exhaustive]").doesNotContain("it runs");
    }

    @Test
    void aTestJvmThatDiedIsAFailureWithItsReason() throws Exception {
        String reason = "The forked VM terminated without properly saying goodbye. VM crash or System.exit called?";
        run("STATUS=1; for k in 1 2; do echo '" + reason + "'; echo 'Crashed tests:'; echo SomeTest; done");
        assertThat(status).isEqualTo(1);
        assertThat(output).containsSubsequence("ended with exit status 1", reason, "Crashed tests:", "SomeTest");
        assertThat(lastLine()).matches("3 passed, 1 failed|6 passed, 2 failed");
    }

    @Test
    void aClassOfTestsThatHangsIsNamed() throws Exception {
        run("STATUS=1; echo '[INFO] Running a.First'; echo '[INFO] Running a.Second'\n"
                + "echo '[INFO] Tests run: 1, Failures: 0, Time elapsed: 1 s -- in a.First'\n"
                + "echo 'There was a timeout or other error in the fork'");
        assertThat(status).isEqualTo(1);
        assertThat(output).containsSubsequence("There was a timeout", "did not end: a.Second");
        assertThat(output).doesNotContain("did not end: a.First");
    }

    @Test
    void cachesAreEmptyAtTheStartAndThoseOfTheUserAreBackAtTheEnd() throws Exception {
        Path mine = Files.createDirectories(home.resolve(".javacl/cache")).resolve("mine");
        Files.createFile(mine);
        run(
                "echo \"pocl $POCL_CACHE_DIR has $(ls \"$POCL_CACHE_DIR\"); javacl has $(ls ~/.javacl/cache 2>/dev/null)\"\n"
                        + ": >\"$POCL_CACHE_DIR/kernel\"; mkdir -p ~/.javacl/cache; : >~/.javacl/cache/kernel");
        String first = output.lines()
                .filter(line -> line.startsWith("pocl "))
                .findFirst()
                .orElseThrow();
        assertThat(first).matches("pocl /.* has ; javacl has ");
        assertThat(Path.of(first.split(" ")[1])).doesNotExist();
        assertThat(mine).exists();
        assertThat(mine.resolveSibling("kernel")).doesNotExist();
        assertThat(home.resolve(".javacl"))
                .isDirectoryNotContaining(file -> file.toString().contains("aside"));
    }
}
