package io.github.circles2d;

import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import org.assertj.core.api.ThrowableAssert.ThrowingCallable;

/** Requires of calls that they are refused, with a text in the message. */
public final class Refusals {
    private Refusals() {}

    public static void assertIllegalArgument(String message, ThrowingCallable call) {
        assertThatIllegalArgumentException().isThrownBy(call).withMessageContaining(message);
    }

    public static void assertIllegalState(String message, ThrowingCallable call) {
        assertThatIllegalStateException().isThrownBy(call).withMessageContaining(message);
    }
}
