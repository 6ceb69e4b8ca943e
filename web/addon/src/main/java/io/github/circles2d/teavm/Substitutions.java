package io.github.circles2d.teavm;

import org.teavm.extension.spi.substitution.SimpleSubstitutionPolicy;
import org.teavm.extension.spi.substitution.SubstitutionSink;

/** Names the classes of the library that a class whose name begins with "Browser" stands for. TeaVM finds it as a service. */
public final class Substitutions extends SimpleSubstitutionPolicy {
    /** TeaVM makes it. */
    public Substitutions() {}

    @Override
    public void contribute(SubstitutionSink sink) {
        sink.selectClasses(named("io.github.circles2d.Notice")
                        .or(named("io.github.circles2d.OpenClChoice"))
                        .or(named("io.github.circles2d.world.jvm.threads.Crew"))
                        .or(named("io.github.circles2d.world.jvm.threads.SharedInts")))
                .simpleNamePrefix("Browser");
    }
}
