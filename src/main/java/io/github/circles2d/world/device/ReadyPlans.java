package io.github.circles2d.world.device;

import io.github.circles2d.opencl.RunningBuilds;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.plan.Plan;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Stages;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.List;

/**
 * The plans whose kernels have been compiled. The last plan makes any step, and the kernels that all its steps need are compiled first; those
 * of some steps and of the faster plans are compiled on a thread beside the steps, since a driver may take tens of seconds. So the first step does
 * not wait for them. A plan is ready if those behind it are.
 */
final class ReadyPlans {
    private static final System.Logger LOG = System.getLogger(ReadyPlans.class.getName());

    private final List<Plan> plans;
    private final boolean waits;
    private final List<Plan> ready = new ArrayList<>();
    private Stages stages;

    /** The kernels of the steps to come. The thread beside stops if they are others. */
    private volatile StageKernels kernels;

    ReadyPlans(List<Plan> plans, boolean waits) {
        this.plans = plans;
        this.waits = waits;
    }

    /** Why kernels of some steps have been refused. */
    private record Refusal(StageKernels of, Throwable cause) {}

    /** Null if none have. */
    private volatile Refusal refusal;

    /** Those that are ready, in the order in which a step looks at them. The list changes. No view of it, whose iterators would be garbage of steps. */
    List<Plan> list() {
        return ready;
    }

    /** Lets plans use other kernels. Waits for those that all steps of the last plan need. */
    void use(Stages newStages, StageKernels newKernels) {
        stages = newStages;
        kernels = newKernels;
        ready.clear();
        newKernels.compile(Plans.STEPS);
        takeReady();
        compileBeside(newKernels);
    }

    /** Whether {@link #takeNews} would find a plan that has become ready. */
    boolean haveNews() {
        return ready.size() < plans.size() && kernels != null && kernels.has(Plans.partOf(next()));
    }

    /** Takes the plans that have become ready since. No steps are pending. */
    void takeNews() {
        takeReady();
    }

    /** The slowest of the plans that are not ready. */
    private Plan next() {
        return plans.get(plans.size() - 1 - ready.size());
    }

    /** The thread beside compiles nothing more. */
    void close() {
        kernels = null;
    }

    private void takeReady() {
        while (ready.size() < plans.size()) {
            Plan next = next();
            String part = Plans.partOf(next);
            if (part != null && !waits && !kernels.has(part)) {
                return;
            }
            next.load(stages);
            ready.add(0, next);
        }
    }

    /** First what a step may ask for soon, then the plans from the slowest on. */
    private void compileBeside(StageKernels of) {
        List<String> ofSomeSteps = stages.ofSomeSteps();
        List<String> missing = new ArrayList<>(ofSomeSteps);
        for (int p = plans.size() - 1 - ready.size(); p >= 0; p--) {
            missing.add(Plans.partOf(plans.get(p)));
        }
        missing.removeIf(of::has);
        if (!missing.isEmpty()) {
            Thread thread = new Thread(() -> compile(of, ofSomeSteps, missing), "circles2d compiler");
            thread.setDaemon(true);
            thread.start();
        }
    }

    private void compile(StageKernels of, List<String> ofSomeSteps, List<String> missing) {
        for (String part : missing) {
            if (kernels != of || RunningBuilds.isExiting()) {
                return;
            }
            try {
                of.compile(part);
            } catch (RuntimeException | Error e) {
                if (kernels != of || RunningBuilds.isExiting()) {
                    return;
                }
                if (ofSomeSteps.contains(part)) {
                    refusal = new Refusal(of, e);
                } else {
                    LOG.log(Level.WARNING, "World goes on without plan " + part + ": it could not be compiled", e);
                }
                return;
            }
        }
    }

    /** A compiler that refuses what a step may need is told of before the step changes anything. */
    void requireKernels() {
        Refusal refused = refusal;
        if (refused != null && refused.of == kernels) {
            if (refused.cause instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) refused.cause;
        }
    }
}
