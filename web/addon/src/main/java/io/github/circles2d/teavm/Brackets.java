package io.github.circles2d.teavm;

import org.teavm.backend.javascript.rendering.Precedence;
import org.teavm.backend.javascript.spi.Injector;
import org.teavm.backend.javascript.spi.InjectorContext;
import org.teavm.model.MethodReference;

/** Writes {@code (...)} for {@link Floats#inBrackets}. */
public final class Brackets implements Injector {
    /** TeaVM makes it. */
    public Brackets() {}

    @Override
    public void generate(InjectorContext context, MethodReference method) {
        context.getWriter().append("(");
        context.writeExpr(context.getArgument(0), Precedence.min());
        context.getWriter().append(")");
    }
}
