package io.github.circles2d.world.jvm.threads;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(60)
@Tag("each-jdk")
class TeamTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7})
    void whatAWorkerDidInAStageAllSeeInTheNext(int workers) {
        int rounds = 2000;
        int[] marks = new int[16 * workers];
        int[] wrong = new int[16 * workers];
        try (Team team = new Team(workers)) {
            team.run(workers, () -> {
                for (int k = 1; k <= rounds; k++) {
                    int round = k;
                    team.all(worker -> marks[16 * worker] = round);
                    team.all(worker -> {
                        for (int other = 0; other < workers; other++) {
                            wrong[16 * worker] += marks[16 * other] == round ? 0 : 1;
                        }
                    });
                }
            });
        }
        assertThat(wrong).containsOnly(0);
    }

    @Test
    void runsOfAnyNumberOfWorkersFollowEachOther() {
        try (Team team = new Team(5)) {
            for (int round = 0; round < 500; round++) {
                int workers = 1 + round % 5;
                AtomicInteger sum = new AtomicInteger();
                team.run(workers, () -> team.all(worker -> sum.addAndGet(1 << worker)));
                assertThat(sum.get()).isEqualTo((1 << team.size()) - 1);
                assertThat(team.size()).isIn(1, workers);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7})
    void theCallerAloneDoesAStageOfFew(int workers) {
        Thread caller = Thread.currentThread();
        List<Integer> done = new ArrayList<>();
        AtomicInteger together = new AtomicInteger();
        try (Team team = new Team(workers)) {
            team.setFew(true);
            team.run(workers, () -> {
                team.all(worker -> {
                    assertThat(Thread.currentThread()).isSameAs(caller);
                    done.add(worker);
                });
                team.together(worker -> together.addAndGet(1 << worker));
            });
            for (int worker = 0; worker < team.size(); worker++) {
                assertThat(done.get(worker)).isEqualTo(worker);
            }
            assertThat(done).hasSize(team.size());
            assertThat(together.get()).isEqualTo((1 << team.size()) - 1);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7})
    void piecesFollowEachOther(int workers) {
        try (Team team = new Team(workers)) {
            team.run(workers, () -> {
                int items = 1000;
                int[] ends = new int[team.pieces()];
                for (int worker = 0; worker < team.size(); worker++) {
                    for (int round = 0; round < team.rounds(); round++) {
                        int piece = team.piece(worker, round);
                        assertThat(team.worker(piece)).isEqualTo(worker);
                        ends[piece] = team.to(items, worker, round);
                    }
                }
                for (int piece = 0; piece < ends.length; piece++) {
                    int round = piece / team.size();
                    assertThat(team.from(items, team.worker(piece), round)).isEqualTo(piece == 0 ? 0 : ends[piece - 1]);
                }
                assertThat(ends[ends.length - 1]).isEqualTo(items);
            });
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7})
    void eachWorkerDoesAStageOnce(int workers) {
        int stages = 5000;
        AtomicIntegerArray done = new AtomicIntegerArray(workers);
        try (Team team = new Team(workers)) {
            team.run(workers, () -> {
                for (int stage = 0; stage < stages; stage++) {
                    team.all(done::incrementAndGet);
                }
            });
        }
        for (int worker = 0; worker < workers; worker++) {
            assertThat(done.get(worker)).isEqualTo(stages);
        }
    }

    /** Other threads take long for their parts, as if other programs had taken their processors. */
    @Test
    void aCallerThatWaitsForLongGoesOnAloneAndTriesAgain() {
        Thread caller = Thread.currentThread();
        AtomicInteger byOthers = new AtomicInteger();
        Team.Work slow = worker -> {
            boolean isCaller = Thread.currentThread() == caller;
            byOthers.addAndGet(isCaller ? 0 : 1);
            sleep(isCaller ? 0 : 20);
        };
        try (Team team = new Team(2)) {
            for (int run = 0; run < 3; run++) {
                team.run(2, () -> team.all(worker -> {}));
            }
            team.run(2, () -> {
                while (byOthers.get() == 0) {
                    team.all(slow);
                }
                for (int stage = 0; stage < 500; stage++) {
                    team.all(slow);
                }
            });
            assertThat(byOthers.get()).isLessThan(250);
            team.run(2, () -> {});
            for (int k = 0; k < 2000 && team.size() == 1; k++) {
                sleep(1);
                team.run(2, () -> {});
            }
            assertThat(team.size()).as("workers after the pause").isEqualTo(2);
        }
    }

    private static void sleep(long millis) {
        try {
            Thread.sleep(millis);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void sharesAreDisjointAndCoverAll() {
        try (Team team = new Team(3)) {
            team.run(3, () -> {});
            for (int n : new int[] {0, 1, 2, 3, 100, Integer.MAX_VALUE}) {
                assertThat(team.part(n, 0)).isZero();
                assertThat(team.part(n, 3)).isEqualTo(n);
                assertThat(team.part(n, 1)).isBetween(0, team.part(n, 2));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7})
    void everyItemIsDealtOutOnce(int workers) {
        try (Team team = new Team(workers)) {
            team.run(workers, () -> {});
            for (int n : new int[] {0, 1, 5, 100, 1001}) {
                int[] dealt = new int[n];
                for (int worker = 0; worker < workers; worker++) {
                    for (int round = 0; round < team.rounds(); round++) {
                        for (int k = team.from(n, worker, round); k < team.to(n, worker, round); k++) {
                            dealt[k]++;
                        }
                    }
                }
                assertThat(dealt).containsOnly(n == 0 ? new int[0] : new int[] {1});
            }
            assertThat(team.from(Integer.MAX_VALUE, 0, 0)).isZero();
            int end = 0;
            for (int worker = 0; worker < workers; worker++) {
                end = Math.max(end, team.to(Integer.MAX_VALUE, worker, team.rounds() - 1));
            }
            assertThat(end).isEqualTo(Integer.MAX_VALUE);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 16})
    void workersGetEqualWorkWhereItGrowsFromItemToItem(int workers) {
        int n = 10_000;
        long fair = (long) n * (n - 1) / 2 / workers;
        try (Team team = new Team(workers)) {
            team.run(workers, () -> {});
            for (int worker = 0; worker < workers; worker++) {
                long work = 0;
                for (int round = 0; round < team.rounds(); round++) {
                    for (int k = team.from(n, worker, round); k < team.to(n, worker, round); k++) {
                        work += k;
                    }
                }
                assertThat(work).isBetween(fair * 99 / 100, fair * 101 / 100);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 3})
    void whatAWorkerThrowsReachesTheCallerAndTheOthersStop(int failing) {
        IllegalStateException thrown = new IllegalStateException("worker " + failing);
        try (Team team = new Team(4)) {
            assertThatThrownBy(() -> team.run(4, () -> {
                        for (int k = 0; ; k++) {
                            int round = k;
                            team.all(worker -> {
                                if (worker == failing && round == 100) {
                                    throw thrown;
                                }
                            });
                        }
                    }))
                    .isSameAs(thrown);
            assertThatThrownBy(() -> team.run(4, () -> {}))
                    .isInstanceOf(IllegalStateException.class)
                    .hasCause(thrown);
        }
        assertNoThreads();
    }

    @Test
    void anErrorReachesTheCallerToo() {
        StackOverflowError thrown = new StackOverflowError();
        try (Team team = new Team(2)) {
            assertThatThrownBy(() -> team.run(
                            2,
                            () -> team.all(worker -> {
                                if (worker == 1) {
                                    throw thrown;
                                }
                            })))
                    .isSameAs(thrown);
        }
    }

    @Test
    void anInterruptedCallerStaysInterruptedAndGetsItsResults() {
        try (Team team = new Team(3)) {
            Thread.currentThread().interrupt();
            AtomicInteger sum = new AtomicInteger();
            team.run(3, () -> team.all(worker -> sum.incrementAndGet()));
            assertThat(sum.get()).isEqualTo(3);
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
    }

    @Test
    void aTeamOfOneStartsNoThread() {
        try (Team team = new Team(1)) {
            team.run(
                    1,
                    () -> team.all(worker ->
                            assertThat(Thread.currentThread().getName()).doesNotContain("circles2d")));
            assertThat(threads()).isEmpty();
        }
    }

    @Test
    void threadsAreDaemonsAndEndWithClose() {
        List<Thread> seen = new ArrayList<>();
        try (Team team = new Team(4)) {
            team.run(4, () -> {});
            seen.addAll(threads());
            assertThat(seen).hasSize(3).allMatch(Thread::isDaemon);
        }
        assertThat(seen).noneMatch(Thread::isAlive);
    }

    @Test
    void threadsOfAForgottenTeamEnd() throws InterruptedException {
        forget();
        for (int k = 0; k < 400 && !threads().isEmpty(); k++) {
            System.gc();
            Thread.sleep(20);
        }
        assertThat(threads()).isEmpty();
    }

    private static void forget() {
        Team team = new Team(3);
        team.run(3, () -> {});
        assertThat(threads()).hasSize(2);
    }

    private static void assertNoThreads() {
        assertThat(threads()).isEmpty();
    }

    private static List<Thread> threads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().startsWith("circles2d-World-"))
                .toList();
    }
}
