package io.github.circles2d.project;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@EnabledOnOs(OS.LINUX)
class LauncherTest {
    @TempDir
    Path folder;

    @Test
    void helpNamesEveryCommandAndAnUnknownCommandIsAWrongCall() throws Exception {
        FakeMachine machine = new FakeMachine(folder);
        FakeMachine.Result help = machine.launch("help");
        assertThat(help.output).contains("thesis", "demo", "play", "test", "bench", "doctor", "calibrate");
        assertThat(help.status).isZero();
        FakeMachine.Result unknown = machine.launch("frobnicate");
        assertThat(unknown.output).contains("unknown command: frobnicate", "usage:");
        assertThat(unknown.status).isEqualTo(2);
        assertThat(machine.calls()).isEmpty();
    }

    @Test
    void onAMachineThatHasEverythingNothingIsInstalled() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        for (String command : new String[] {"thesis", "demo", "doctor", "calibrate"}) {
            FakeMachine.Result result = machine.launch(command);
            assertThat(result.status).as(result.output).isZero();
        }
        assertThat(machine.calls()).contains("java").doesNotContain("apt-get").doesNotContain("sudo");
    }

    @Test
    void argumentsReachTheJobUnchangedInTheDirectoryOfTheUser() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        FakeMachine.Result demo = machine.launch("demo", "--circles", "12 000");
        assertThat(machine.calls())
                .contains("io.github.circles2d.demo.CirclesTest --circles 12 000")
                .contains(machine.clone + "/target/classes:");
        assertThat(demo.output).contains("java runs in " + machine.elsewhere);
        machine.launch("calibrate", "--forget");
        assertThat(machine.calls()).contains("io.github.circles2d.tools.Calibrate --forget");
    }

    @Test
    void theExitStatusIsThatOfTheJob() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        machine.set("JAVA_STATUS", "42");
        assertThat(machine.launch("doctor").status).isEqualTo(42);
        assertThat(machine.launch("calibrate").status).isEqualTo(42);
        assertThat(machine.launch("demo").status).isEqualTo(42);
        machine.fake("mvn", "exit 7");
        assertThat(machine.launch("test").status).isEqualTo(7);
    }

    @Test
    void theLibraryIsBuiltWhenASourceIsNewerAndOnlyThen() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        machine.launch("demo");
        assertThat(machine.calls()).contains("mvn");
        machine.forgetCalls();
        machine.launch("demo");
        assertThat(machine.calls()).doesNotContain("mvn").contains("CirclesTest");
        Path kernel = Files.createFile(machine.clone.resolve("kernels/New.cl"));
        Files.setLastModifiedTime(kernel, FileTime.from(Instant.now().plusSeconds(5)));
        machine.forgetCalls();
        machine.launch("demo");
        assertThat(machine.calls()).contains("mvn");
    }

    @Test
    void afterAFailedBuildNothingRunsAndTheNextCallBuildsAgain() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        machine.fake("mvn", "exit 1");
        assertThat(machine.launch("demo").status).isEqualTo(1);
        assertThat(machine.calls()).doesNotContain("CirclesTest");
        machine.fake("mvn", FakeMachine.logged("mvn"));
        assertThat(machine.launch("demo").status).isZero();
        assertThat(machine.calls()).contains("mvn", "CirclesTest");
    }

    @Test
    void itCanBeCalledThroughALink() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        Path link = machine.elsewhere.resolve("circles");
        Files.createSymbolicLink(link, Path.of("../a clone/circles2d"));
        assertThat(machine.launch(link, "doctor").status).isZero();
        assertThat(machine.calls()).contains(machine.clone + "/target/classes:");
    }

    @Test
    void aProjectWithAColonInItsPathRunsThroughALinkThatIsGoneAfterwards() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, "a:clone", 17);
        FakeMachine.Result doctor = machine.launch("doctor");
        assertThat(doctor.status).as(doctor.output).isZero();
        assertThat(machine.calls())
                .containsPattern(
                        "-cp ([^: ]+)/target/classes:\\1/target/launch/lib/\\* io.github.circles2d.tools.Doctor");
        assertThat(machine.temporary()).isEmptyDirectory();
        machine.set("JAVA_STATUS", "42");
        assertThat(machine.launch("doctor").status).isEqualTo(42);
        assertThat(machine.temporary()).isEmptyDirectory();
    }

    @Test
    void thePlaygroundAndTheGamesAreBuiltAndRunThroughSuchALink() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, "a:clone", 17);
        pretendToBuild(machine);
        FakeMachine.Result play = machine.launch("play");
        assertThat(play.status).as(play.output).isZero();
        assertThat(machine.calls())
                .containsPattern("-f playground/pom.xml -Dmaven.repo.local=[^: ]+/samples/target/repository ")
                .containsPattern(
                        "-cp ([^: ]+)/playground/target/classes:\\1/playground/target/lib/\\* io.github.circles2d.playground");
        assertThat(machine.launch("play", "swarm").status).isZero();
        assertThat(machine.calls()).containsPattern("-cp ([^: ]+)/samples/swarm/target/classes:\\1/samples/swarm/");
        assertThat(machine.temporary()).isEmptyDirectory();
    }

    @Test
    void testsAndBenchmarksOfAProjectWithAColonInItsPathAreRefused() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, "a:clone", 17);
        pretendToBuild(machine);
        for (String command : new String[] {"test", "bench"}) {
            FakeMachine.Result refused = machine.launch(command);
            assertThat(refused.output).hasLineCount(1).contains(machine.clone + " has a ':'", "move the project");
            assertThat(refused.status).isEqualTo(3);
        }
        assertThat(machine.calls()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    @Tag("long")
    void theSecondOfTwoLaunchersWaitsForTheBuildOfTheFirst(boolean flock) throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        assumeTrue(!flock || machine.addTool("flock"));
        machine.fake("mvn", FakeMachine.logged("mvn") + "case $1 in --version) ;; *) sleep 1; esac");
        CompletableFuture<FakeMachine.Result> first = launchAside(machine);
        CompletableFuture<FakeMachine.Result> second = launchAside(machine);
        assertThat(first.get().status).as(first.get().output).isZero();
        assertThat(second.get().status).as(second.get().output).isZero();
        assertThat(machine.calls()).containsOnlyOnce("process-classes");
        assertThat(first.get().output + second.get().output)
                .containsOnlyOnce("another ./circles2d is building the library; waiting for it");
    }

    private static CompletableFuture<FakeMachine.Result> launchAside(FakeMachine machine) {
        // Not the common pool, which may have a single thread.
        return CompletableFuture.supplyAsync(
                () -> {
                    try {
                        return machine.launch("demo");
                    } catch (IOException | InterruptedException e) {
                        throw new IllegalStateException(e);
                    }
                },
                task -> new Thread(task).start());
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aLauncherThatWasKilledInItsBuildIsNotWaitedFor(boolean flock) throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        assumeTrue(!flock || machine.addTool("flock"));
        machine.fake("mvn", "case $1 in --version) ;; *) : >\"$HOME/building\"; sleep 60; esac");
        Process killed = machine.start("demo");
        while (Files.notExists(machine.root.resolve("building"))) {
            assertThat(killed.isAlive()).isTrue();
            Thread.sleep(20);
        }
        Stream.concat(killed.descendants(), Stream.of(killed.toHandle()))
                .toList()
                .forEach(ProcessHandle::destroyForcibly);
        killed.waitFor();
        machine.fake("mvn", FakeMachine.logged("mvn"));
        FakeMachine.Result next = machine.launch("demo");
        assertThat(next.status).as(next.output).isZero();
        assertThat(machine.calls()).contains("process-classes", "CirclesTest");
    }

    @Test
    void aMavenThatIsTooOldIsNamedWithTheOneThatIsNeeded() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        for (String old : new String[] {"2.2.1", "3.3.9", "3.6.2"}) {
            machine.fake("mvn", FakeMachine.logged("mvn") + "echo Apache Maven " + old + " '(of old)'");
            FakeMachine.Result demo = machine.launch("demo");
            assertThat(demo.output).contains("this machine lacks Maven >= 3.6.3 (mvn is " + old + ")");
            assertThat(demo.status).isEqualTo(3);
        }
        assertThat(machine.calls()).contains("apt-get").doesNotContain("process-classes", "CirclesTest");
        for (String fine : new String[] {"3.6.3", "3.8.7", "3.10.0", "4.0.0-rc-4"}) {
            Files.deleteIfExists(machine.clone.resolve("target/launch/built"));
            machine.fake("mvn", FakeMachine.logged("mvn") + "echo Apache Maven " + fine);
            assertThat(machine.launch("demo").status).isZero();
        }
        assertThat(machine.calls()).contains("process-classes", "CirclesTest");
    }

    @Test
    void withoutADisplayTheDemoRendersAPictureAndSaysWhere() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        machine.set("DISPLAY", "");
        FakeMachine.Result demo = machine.launch("demo", "--seed", "4");
        String picture = machine.clone + "/target/demo/circles2d.png";
        assertThat(machine.calls()).contains("CirclesTest --seed 4 --png " + picture + "\n");
        assertThat(demo.output).contains("there is no display").contains("the picture is " + picture);
        machine.forgetCalls();
        machine.launch("demo", "--frames", "5", "--png", "own.png");
        assertThat(machine.calls())
                .contains("CirclesTest --frames 5 --png own.png")
                .doesNotContain("circles2d.png");
    }

    @Test
    void thePlaygroundGetsItsArgumentsAndTellsItselfWhatToDoWithoutADisplay() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        machine.set("DISPLAY", "");
        machine.set("JAVA_STATUS", "1");
        FakeMachine.Result play = machine.launch("play", "--scene", "pegs");
        assertThat(machine.calls()).contains("io.github.circles2d.playground.Playground --scene pegs");
        assertThat(play.status).isEqualTo(1);
        machine.set("JAVA_STATUS", "0");
        assertThat(machine.launch("play", "--film", "film.png").status).isZero();
        assertThat(machine.calls()).contains("Playground --film film.png").doesNotContain("apt-get");
    }

    @Test
    void playWithoutAGameBuildsThePlaygroundOnTheInstalledLibraryIfASourceIsNewer() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        FakeMachine.Result play = machine.launch("play");
        assertThat(play.status).as(play.output).isZero();
        assertThat(play.output).contains("java runs in " + machine.elsewhere);
        String repository = machine.clone + "/samples/target/repository";
        assertThat(machine.calls())
                .containsSubsequence(
                        " package\n",
                        "-DlocalRepositoryPath=" + repository,
                        "-f playground/pom.xml -Dmaven.repo.local=" + repository,
                        "-cp " + machine.clone + "/playground/target/classes:" + machine.clone
                                + "/playground/target/lib/* io.github.circles2d.playground.Playground\n");
        machine.forgetCalls();
        machine.launch("play", "--scene", "pegs");
        assertThat(machine.calls()).doesNotContain("mvn").contains("Playground --scene pegs\n");
        for (String file : new String[] {"src/main", "playground/src/main"}) {
            Path source = Files.createFile(machine.clone.resolve(file).resolve("New.java"));
            Files.setLastModifiedTime(source, FileTime.from(Instant.now().plusSeconds(5)));
            machine.forgetCalls();
            machine.launch("play");
            assertThat(machine.calls()).contains("-f playground/pom.xml");
            Files.delete(source);
            machine.launch("play");
        }
    }

    @Test
    void testFailsIfATestOfThePlaygroundFails() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        machine.set("PLAYGROUND_STATUS", "6");
        assertThat(machine.launch("test").status).isEqualTo(6);
        assertThat(machine.calls()).contains("-f playground/pom.xml");
    }

    @Test
    void nativeAccessIsGrantedWhereJavaAsksForIt() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 25);
        machine.launch("doctor");
        assertThat(machine.calls()).contains("--enable-native-access=ALL-UNNAMED");
        machine.addJdk(17);
        machine.forgetCalls();
        machine.launch("doctor");
        assertThat(machine.calls()).contains("Doctor").doesNotContain("--enable-native-access");
    }

    @Test
    void whatIsMissingIsInstalledWithSudoAndNamedWithItsReason() throws Exception {
        FakeMachine machine = new FakeMachine(folder);
        machine.addJdk(17);
        machine.addApt("echo '#!/bin/sh' >" + machine.bin() + "/mvn; env chmod +x " + machine.bin() + "/mvn; "
                + "mkdir -p " + machine.root + "/lib; : >" + machine.root + "/lib/libOpenCL.so.1");
        Files.createSymbolicLink(machine.bin().resolve("chmod"), Path.of("/bin/chmod"));
        FakeMachine.Result demo = machine.launch("demo");
        assertThat(demo.status).as(demo.output).isZero();
        assertThat(demo.output)
                .contains("this machine lacks Maven (mvn), an OpenCL driver")
                .contains("maven: builds the library")
                .contains("pocl-opencl-icd: an OpenCL driver that runs on the CPU");
        assertThat(machine.calls())
                .contains("sudo apt-get -q update")
                .containsPattern("sudo env DEBIAN_FRONTEND=noninteractive apt-get .*install --no-install-recommends"
                        + " maven ocl-icd-libopencl1 pocl-opencl-icd\n")
                .contains("CirclesTest");
        machine.forgetCalls();
        assertThat(machine.launch("demo").status).isZero();
        assertThat(machine.calls()).doesNotContain("apt-get").contains("CirclesTest");
    }

    @Test
    void rootInstallsWithoutSudo() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        machine.remove("mvn");
        machine.fake("id", "echo 0");
        FakeMachine.Result demo = machine.launch("demo");
        assertThat(machine.calls()).contains("apt-get -q update", " maven\n").doesNotContain("sudo");
        assertThat(demo.output).as("the fake apt-get installs nothing").contains("this machine lacks Maven (mvn)");
        assertThat(demo.status).isEqualTo(3);
    }

    @Test
    void anInstallationThatFailsIsReportedWithWhatAptGetSaid() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        machine.remove("mvn");
        machine.addApt("echo E: no space left; exit 100");
        FakeMachine.Result demo = machine.launch("demo");
        assertThat(demo.output).contains("E: no space left", "apt-get could not install: maven");
        assertThat(demo.status).isEqualTo(3);
        assertThat(machine.calls()).doesNotContain("CirclesTest");
    }

    @Test
    void withoutAptGetItSaysWhatIsMissing() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        machine.remove("mvn");
        machine.remove("apt-get");
        FakeMachine.Result demo = machine.launch("demo");
        assertThat(demo.output).contains("this machine lacks Maven (mvn)");
        assertThat(demo.status).isEqualTo(3);
        assertThat(machine.calls()).doesNotContain("CirclesTest");
    }

    @Test
    void nothingIsInstalledForAUserWhoForbidsIt() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        machine.remove("mvn");
        machine.set("CIRCLES2D_INSTALL", "no");
        FakeMachine.Result demo = machine.launch("demo");
        assertThat(demo.output).contains("this machine lacks Maven (mvn)");
        assertThat(demo.status).isEqualTo(3);
        assertThat(machine.calls()).doesNotContain("apt-get");
    }

    @Test
    void theDoctorRunsWithoutADriverBecauseThatIsWhatItExplains() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        machine.fake("ldconfig", "");
        machine.remove("apt-get");
        machine.launch("doctor");
        assertThat(machine.calls()).contains("tools.Doctor");
        machine.forgetCalls();
        assertThat(machine.launch("demo").status).isEqualTo(3);
        assertThat(machine.calls()).doesNotContain("CirclesTest");
    }

    @Test
    void testWithoutAProfileLeavesOutWhatTakesLong() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        FakeMachine.Result test = machine.launch("test");
        assertThat(test.status).as(test.output).isZero();
        assertThat(machine.calls())
                .contains("-f bench/pom.xml", "-f playground/pom.xml", "swarm.Main --frames 300 --backend JVM\n")
                .doesNotContain("-Plong", "smoke", "OPENCL_CPU");
    }

    @Test
    void testRunsTheSuiteThenTheBenchmarksAndTheGamesBesideTheConsumerAndThePlaygroundOnTheInstalledArtifact()
            throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        FakeMachine.Result test = machine.launch("test", "-Plong", "-Dtest=Some");
        assertThat(test.status).as(test.output).isZero();
        String repository = machine.clone + "/target/consumer/repository";
        String suite = "mvn -B --no-transfer-progress -Dcircles2d.device.required=true -Dcircles2d.oclgrind="
                + machine.oclgrind() + " -Plong -Dtest=Some install\n";
        assertThat(machine.calls())
                .containsSubsequence(
                        suite,
                        "-f bench/pom.xml",
                        "-Plong package",
                        "benchmarks.jar smoke\n",
                        "-f samples/swarm/pom.xml -Dmaven.repo.local=" + machine.clone + "/samples/target/repository",
                        "com.example.swarm.Main --frames 300 --backend JVM\n",
                        "com.example.swarm.Main --frames 300 --backend OPENCL_CPU\n")
                .containsSubsequence(
                        suite,
                        "install:install-file -Dfile=" + machine.clone + "/target/circles2d-9.jar",
                        "-DlocalRepositoryPath=" + repository,
                        "-Dmaven.repo.local=" + repository,
                        "FreeFall\n",
                        "Game\n",
                        "-P without-opencl compile",
                        "WithoutOpenCl\n",
                        "-f playground/pom.xml -Dmaven.repo.local=" + machine.clone + "/samples/target/repository",
                        "-Plong -Dcircles2d.device.required=true test ")
                .doesNotContain("apt-get -q -y");
        machine.set("JAVA_STATUS", "5");
        assertThat(machine.launch("test").status).as("a program that fails").isEqualTo(5);
    }

    @Test
    void testFailsIfTheBenchmarksFailOrAProgramBesideThemAndShowsWhatBothSaid() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        machine.set("BENCH_STATUS", "3");
        FakeMachine.Result benchmarks = machine.launch("test", "-Plong");
        assertThat(benchmarks.status).as(benchmarks.output).isEqualTo(3);
        assertThat(benchmarks.output).contains("building the benchmarks", "testing the playground");
        machine.set("BENCH_STATUS", "0");
        machine.set("PLAYGROUND_STATUS", "4");
        FakeMachine.Result programs = machine.launch("test", "-Plong");
        assertThat(programs.status).as(programs.output).isEqualTo(4);
        assertThat(programs.output).contains("executing every benchmark once", "testing the playground");
    }

    @Test
    void testOnASecondJdkLeavesOutTheBenchmarksAndTheGames() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 25);
        pretendToBuild(machine);
        machine.set("CIRCLES2D_SECOND_JDK", "yes");
        FakeMachine.Result test = machine.launch("test");
        assertThat(test.status).as(test.output).isZero();
        assertThat(machine.calls())
                .contains("WithoutOpenCl\n", "-f playground/pom.xml")
                .doesNotContain("-f bench/pom.xml", "benchmarks.jar", "-f samples/swarm/pom.xml");
    }

    @Test
    void testComparesWorldInWebAssemblyWithTheJvmIfThereIsNpm() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        Path job = Files.createDirectories(machine.clone.resolve("web")).resolve("run");
        Files.writeString(job, "#!/bin/sh\necho web/run \"$*\"\nexit 6\n");
        assertThat(job.toFile().setExecutable(true)).isTrue();
        FakeMachine.Result test = machine.launch("test", "-Plong");
        assertThat(test.status).as(test.output).isEqualTo(6);
        assertThat(test.output).contains("web/run check");
        FakeMachine.Result quick = machine.launch("test");
        assertThat(quick.status).as(quick.output).isZero();
        assertThat(quick.output).doesNotContain("web/run check", "npm");
        Files.delete(machine.bin().resolve("npm"));
        FakeMachine.Result without = machine.launch("test", "-Plong");
        assertThat(without.status).as(without.output).isZero();
        assertThat(without.output).contains("going on without npm", "WARNING: there is no npm");
    }

    @Test
    void benchWebPutsEnginesInPlaceAndSaysWhereTheyAre() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        machine.fake("chromium", "");
        Path job = Files.createDirectories(machine.clone.resolve("web")).resolve("run");
        Files.writeString(job, "#!/bin/sh\necho web/run \"$*\"\nexit ${WEB_STATUS:-0}\n");
        assertThat(job.toFile().setExecutable(true)).isTrue();
        FakeMachine.Result bench = machine.launch("bench", "web", "--quick");
        assertThat(bench.status).as(bench.output).isZero();
        assertThat(bench.output).contains("web/run bench");
        assertThat(machine.calls())
                .contains("benchmarks.jar web --node " + machine.clone + "/web/target/node/node_modules/node/bin/node")
                .contains(" --chromium " + machine.bin().resolve("chromium"))
                .contains(" --programs " + machine.clone + "/bench/web --quick\n");
        machine.forgetCalls();
        machine.set("WEB_STATUS", "6");
        assertThat(machine.launch("bench", "web").status).isEqualTo(6);
        assertThat(machine.calls()).doesNotContain("benchmarks.jar web");
    }

    /** As on a release without a package of it, or where nothing may be installed. */
    @Test
    void withoutOclgrindTestWarnsAndTellsTheTestsThatItIsAbsent() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        Files.delete(machine.oclgrind());
        FakeMachine.Result test = machine.launch("test");
        assertThat(test.status).as(test.output).isZero();
        assertThat(test.output).contains("going on without Oclgrind", "WARNING: there is no Oclgrind");
        assertThat(machine.calls())
                .contains(" -Dcircles2d.device.required=true -Dcircles2d.oclgrind=absent install\n")
                .doesNotContain("install oclgrind");
    }

    @Test
    void testFailsWhenTheConsumerGotAnotherArtifactThanTheOneJustBuilt() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        machine.set("STALE", "yes");
        assertThat(machine.launch("test").status).isEqualTo(1);
        assertThat(machine.calls()).doesNotContain("FreeFall");
    }

    @Test
    void testFailsWhenAGameEndsInAnotherWorldThanTheOneThatIsKept() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        Files.writeString(machine.clone.resolve("samples/swarm/expected.txt"), "another hash\n");
        FakeMachine.Result test = machine.launch("test");
        assertThat(test.output)
                .contains("swarm on JVM gives another world than samples/swarm/expected.txt says", "another hash");
        assertThat(test.status).isEqualTo(1);
    }

    @Test
    void playBuildsTheGameWhereASourceIsNewerAndRunsIt() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        FakeMachine.Result game = machine.launch("play", "swarm", "--picture", "a file.png");
        assertThat(game.status).as(game.output).isZero();
        assertThat(game.output).contains("java runs in " + machine.elsewhere);
        String repository = machine.clone + "/samples/target/repository";
        assertThat(machine.calls())
                .containsSubsequence(
                        " package\n",
                        "install:install-file -Dfile=" + machine.clone + "/target/circles2d-9.jar",
                        "-DlocalRepositoryPath=" + repository,
                        "-f samples/swarm/pom.xml -Dmaven.repo.local=" + repository,
                        "com.example.swarm.Main --picture a file.png\n");
        machine.forgetCalls();
        machine.launch("play", "swarm");
        assertThat(machine.calls()).doesNotContain("mvn").contains("com.example.swarm.Main\n");
        Path source = Files.createFile(machine.clone.resolve("samples/swarm/src/main/New.java"));
        Files.setLastModifiedTime(source, FileTime.from(Instant.now().plusSeconds(5)));
        machine.set("JAVA_STATUS", "42");
        assertThat(machine.launch("play", "swarm").status).isEqualTo(42);
        assertThat(machine.calls()).contains("-f samples/swarm/pom.xml");
    }

    @Test
    void playNamesTheGamesToWhoeverNamesNone() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        for (String name : new String[] {"tetris", "", ".*", "../samples/swarm"}) {
            FakeMachine.Result refused = machine.launch("play", name);
            assertThat(refused.output).contains("the games are: swarm");
            assertThat(refused.status).isEqualTo(2);
        }
        assertThat(machine.calls()).isEmpty();
    }

    @Test
    void aGameGetsItsArgumentsAndTellsItselfWhatToDoWithoutADisplay() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        pretendToBuild(machine);
        machine.set("DISPLAY", "");
        for (int status = 1; status <= 2; status++) {
            machine.set("JAVA_STATUS", String.valueOf(status));
            machine.forgetCalls();
            assertThat(machine.launch("play", "swarm").status).isEqualTo(status);
            assertThat(machine.calls()).contains("com.example.swarm.Main\n").doesNotContain("apt-get");
        }
        machine.set("JAVA_STATUS", "0");
        assertThat(machine.launch("play", "swarm", "--frames", "300").status).isZero();
        assertThat(machine.calls()).contains("com.example.swarm.Main --frames 300\n");
    }

    /** Makes the fake Maven leave behind what the launcher expects of the real one. */
    private static void pretendToBuild(FakeMachine machine) throws IOException {
        Files.createDirectories(machine.clone.resolve("bench"));
        Files.createFile(machine.clone.resolve("bench/pom.xml"));
        Files.createDirectories(machine.clone.resolve("src/test/resources/consumer"));
        Files.createDirectories(machine.clone.resolve("playground/src/main"));
        Files.createFile(machine.clone.resolve("playground/pom.xml"));
        Files.createDirectories(machine.clone.resolve("samples/swarm/src/main"));
        Files.createFile(machine.clone.resolve("samples/swarm/pom.xml"));
        Files.writeString(
                machine.clone.resolve("samples/swarm/expected.txt"), "java runs in " + machine.elsewhere + "\n");
        machine.fake("Xvfb", "");
        machine.fake(
                "mvn",
                FakeMachine.logged("mvn")
                        + "case \"$*\" in\n"
                        + "*install-file*) ;;\n"
                        + "*'-f bench'*) exit ${BENCH_STATUS:-0};;\n"
                        + "*'-f playground'*) mkdir -p playground/target/lib\n"
                        + "  cp target/circles2d-9.jar playground/target/lib; exit ${PLAYGROUND_STATUS:-0};;\n"
                        + "*samples*) mkdir -p samples/swarm/target/lib\n"
                        + "  cp target/circles2d-9.jar samples/swarm/target/lib;;\n"
                        + "*copy-dependencies*) mkdir -p target/consumer/lib\n"
                        + "  cp target/circles2d-9.jar target/consumer/lib\n"
                        + "  [ -z \"$STALE\" ] || echo stale >target/consumer/lib/circles2d-9.jar;;\n"
                        + "*) mkdir -p target/maven-archiver\n"
                        + "  echo version=9 >target/maven-archiver/pom.properties\n"
                        + "  echo jar >target/circles2d-9.jar;;\n"
                        + "esac");
    }

    @Test
    void onMacOsItNamesHomebrewAndNeverApt() throws Exception {
        FakeMachine machine = FakeMachine.withEverything(folder, 17);
        machine.fake("uname", "echo Darwin");
        machine.remove("mvn");
        FakeMachine.Result demo = machine.launch("demo");
        assertThat(demo.output).contains("brew install");
        assertThat(demo.status).isEqualTo(3);
        assertThat(machine.calls()).doesNotContain("apt-get");
    }
}
