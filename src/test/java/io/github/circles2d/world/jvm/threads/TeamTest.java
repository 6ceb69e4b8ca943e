package io.github.circles2d.world.jvm.threads;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
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
    void whatAWorkerDidBeforeABarrierAllSeeAfterIt(int workers) {
        int rounds = 2000;
        int[] marks = new int[16 * workers];
        int[] wrong = new int[16 * workers];
        try (Team team = new Team(workers)) {
            team.run(workers, worker -> {
                for (int round = 1; round <= rounds; round++) {
                    marks[16 * worker] = round;
                    team.sync(worker);
                    for (int other = 0; other < workers; other++) {
                        wrong[16 * worker] += marks[16 * other] == round ? 0 : 1;
                    }
                    team.sync(worker);
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
                team.run(workers, worker -> {
                    sum.addAndGet(1 << worker);
                    team.sync(worker);
                });
                assertThat(sum.get()).isEqualTo((1 << workers) - 1);
            }
        }
    }

    @Test
    void sharesAreDisjointAndCoverAll() {
        try (Team team = new Team(3)) {
            team.run(3, worker -> {});
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
            team.run(workers, worker -> {});
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
            team.run(workers, worker -> {});
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
            assertThatThrownBy(() -> team.run(4, worker -> {
                        for (int round = 0; ; round++) {
                            if (worker == failing && round == 100) {
                                throw thrown;
                            }
                            team.sync(worker);
                        }
                    }))
                    .isSameAs(thrown);
            assertThatThrownBy(() -> team.run(4, worker -> {}))
                    .isInstanceOf(IllegalStateException.class)
                    .hasCause(thrown);
        }
        assertNoThreads();
    }

    @Test
    void anErrorReachesTheCallerToo() {
        StackOverflowError thrown = new StackOverflowError();
        try (Team team = new Team(2)) {
            assertThatThrownBy(() -> team.run(2, worker -> {
                        if (worker == 1) {
                            throw thrown;
                        }
                        team.sync(worker);
                    }))
                    .isSameAs(thrown);
        }
    }

    @Test
    void anInterruptedCallerStaysInterruptedAndGetsItsResults() {
        try (Team team = new Team(3)) {
            Thread.currentThread().interrupt();
            AtomicInteger sum = new AtomicInteger();
            team.run(3, worker -> {
                team.sync(worker);
                sum.incrementAndGet();
            });
            assertThat(sum.get()).isEqualTo(3);
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
    }

    @Test
    void aTeamOfOneStartsNoThread() {
        try (Team team = new Team(1)) {
            team.run(1, worker -> assertThat(Thread.currentThread().getName()).doesNotContain("circles2d"));
            assertThat(threads()).isEmpty();
        }
    }

    @Test
    void threadsAreDaemonsAndEndWithClose() {
        List<Thread> seen = new ArrayList<>();
        try (Team team = new Team(4)) {
            team.run(4, worker -> team.sync(worker));
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
        team.run(3, worker -> team.sync(worker));
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
