package io.github.circles2d.opencl;

import static io.github.circles2d.Refusals.assertIllegalArgument;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("each-jdk")
class ReachableNamesTest {
    private static Set<String> reached(String text, String kernel, String... hidden) {
        return ReachableNames.of(KernelSource.ofText("test", text), Set.of(hidden))
                .from(kernel);
    }

    @Test
    void aKernelReachesWhatItsFunctionsName() {
        String text = """
                float inner(global float *deep) { return deep[0]; }
                float outer(global float *p) { if (p) { return inner(p); } return 0; }
                float other(global float *q) { return q[0]; }
                kernel void run(global float *p) { p[0] = outer(p); }
                """;
        assertThat(reached(text, "run"))
                .contains("run", "outer", "inner", "deep")
                .doesNotContain("other", "q");
    }

    @Test
    void macrosVariablesAndAllBranchesCount() {
        String text = """
                #define FIRST(a) (a \\
                    + SECOND)
                #define SECOND hidden
                #ifdef HOT
                #define SECOND shown
                #endif
                constant float TABLE[2] = {A, B};
                kernel __attribute__((reqd_work_group_size(GROUP, 1, 1))) void run(int n) {
                #ifdef HOT
                    call(FIRST(n));
                #else
                    use(TABLE[n]);
                #endif
                }
                """;
        assertThat(reached(text, "run")).contains("shown", "hidden", "call", "use", "A", "B", "GROUP");
        assertThat(reached(text, "run", "SECOND")).contains("SECOND").doesNotContain("shown", "hidden");
    }

    @Test
    void typesCommentsAndOtherFunctionsOfTheSameTypeDoNot() {
        String text = """
                typedef struct {
                    union { int member; } of;
                } World; // comment
                /* remark */
                World one(World w) { return w; }
                World two(World w) { return gone(w); }
                TILE_KERNEL run(World w) { one(w); }
                """;
        assertThat(reached(text, "run"))
                .contains("one", "World")
                .doesNotContain("member", "comment", "remark", "gone", "two");
    }

    @Test
    void whatCannotBeReadIsRefused() {
        assertIllegalArgument("no function other", () -> reached("kernel void run() {}\n", "other"));
        String branches =
                "#ifdef A\nint f(int a) {\n#else\nint f(float a) {\n#endif\nreturn 0; }\nkernel void run() {}\n";
        assertIllegalArgument("'f' has no end", () -> reached(branches, "run"));
        assertThat(reached("kernel void run() { f(); }\n#define LAST \\", "run"))
                .contains("f");
    }

    @Test
    void anEndlessCommentEnds() {
        assertThat(reached("kernel void run() { f(); } /* on and on", "run")).contains("f");
    }

    @Test
    void aProgramOfSomeKernelsHasWhatTheyReachAndKnowsItsLines() {
        String text = """
                #define GROUP_KERNEL kernel __attribute__((reqd_work_group_size(8, 1, 1))) void
                constant int TABLE[2] = {1, 2};
                int shared(int n) { return TABLE[n]; }
                int alone(int n) {
                    return n;
                }
                kernel void first(global int *p) { p[0] = shared(1); }
                GROUP_KERNEL second(global int *p) { p[0] = alone(shared(1)); }
                """;
        ReachableNames names =
                ReachableNames.of(KernelSource.ofText("test", text).define("N", 3), Set.of());
        assertThat(names.kernels()).containsExactlyInAnyOrder("first", "second");
        KernelSource first = names.sourceOf(Set.of("first"));
        assertThat(first.text())
                .contains("TABLE[2]", "int shared(", "void first(")
                .doesNotContain("alone", "second");
        assertThat(first.text())
                .contains("#line 6\n\nkernel void first(")
                .endsWith("p[0] = shared(1); }\n\n#line 8\n\n");
        assertThat(first.buildOptions()).containsExactly("-DN=3");
        assertThat(names.sourceOf(Set.of("second")).text())
                .contains("int alone(")
                .doesNotContain("void first(");
    }
}
