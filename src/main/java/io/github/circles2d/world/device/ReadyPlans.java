package io.github.circles2d.world.device;

import io.github.circles2d.opencl.RunningBuilds;
import io.github.circles2d.world.device.memory.StageKernels;
import io.github.circles2d.world.device.plan.Plan;
import io.github.circles2d.world.device.plan.Plans;
import io.github.circles2d.world.device.plan.Stages;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * The plans whose kernels have been compiled. The last plan makes any step, and its kernels are compiled first; those of the faster plans
 * are compiled on a thread beside the steps, since a driver may take tens of seconds. So the first step does not wait for them. A plan is
 * ready if those behind it are.
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

    /** Those that are ready, in the order in which a step looks at them. The list changes. No view of it, whose iterators would be garbage of steps. */
    List<Plan> list() {
        return ready;
    }

    /** Lets plans use other kernels. Waits for those of the last plan. */
    void use(Stages newStages, StageKernels newKernels) {
        stages = newStages;
        kernels = newKernels;
        ready.clear();
        newKernels.compile(Plans.STEPS);
        takeReady();
        if (ready.size() < plans.size()) {
            compileBeside(newKernels);
        }
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

    private void compileBeside(StageKernels of) {
        List<Plan> missing = new ArrayList<>(plans.subList(0, plans.size() - ready.size()));
        Collections.reverse(missing);
        Thread thread = new Thread(() -> compile(of, missing), "circles2d compiler");
        thread.setDaemon(true);
        thread.start();
    }

    private void compile(StageKernels of, List<Plan> missing) {
        for (Plan plan : missing) {
            if (kernels != of || RunningBuilds.isExiting()) {
                return;
            }
            try {
                of.compile(Plans.partOf(plan));
            } catch (RuntimeException | Error e) {
                if (kernels == of && !RunningBuilds.isExiting()) {
                    LOG.log(
                            Level.WARNING,
                            "World goes on without plan " + Plans.partOf(plan) + ": it could not be compiled",
                            e);
                }
                return;
            }
        }
    }
}
