package io.github.circles2d.teavm;

import org.teavm.backend.javascript.rendering.Precedence;
import org.teavm.backend.javascript.spi.Injector;
import org.teavm.backend.javascript.spi.InjectorContext;
import org.teavm.model.MethodReference;

/** Writes {@code Math.fround(...)} for {@link Floats#round}. */
public final class Rounding implements Injector {
    /** TeaVM makes it. */
    public Rounding() {}

    @Override
    public void generate(InjectorContext context, MethodReference method) {
        context.getWriter().appendGlobal("Math").append(".fround(");
        context.writeExpr(context.getArgument(0), Precedence.min());
        context.getWriter().append(")");
    }
}
