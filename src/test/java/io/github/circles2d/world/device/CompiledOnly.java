package io.github.circles2d.world.device;

import io.github.circles2d.opencl.KernelSource;
import io.github.circles2d.world.device.plan.Plan;
import io.github.circles2d.world.device.plan.Stages;
import io.github.circles2d.world.device.plan.Steps;
import java.util.List;

/** A plan whose kernels are in the program, which is then that of pipelines that follow it, but which no step follows. */
final class CompiledOnly implements Plan {
    private final Plan plan;

    CompiledOnly(Plan plan) {
        this.plan = plan;
    }

    @Override
    public List<String> files() {
        return plan.files();
    }

    @Override
    public KernelSource define(KernelSource source) {
        return plan.define(source);
    }

    @Override
    public void load(Stages stages) {}

    @Override
    public boolean suits(Steps steps) {
        return false;
    }

    @Override
    public void enqueue(Steps steps) {
        throw notFollowed();
    }

    @Override
    public void tell(int circles) {
        throw notFollowed();
    }

    @Override
    public void countDegrees(int contacts) {
        throw notFollowed();
    }

    private static IllegalStateException notFollowed() {
        return new IllegalStateException("no step follows this plan");
    }
}
