package io.github.circles2d;

import io.github.circles2d.opencl.OpenClUnavailableException;

/** Takes the place of {@link OpenClChoice} in browsers, which have no OpenCL. */
final class BrowserOpenClChoice {
    private BrowserOpenClChoice() {}

    static BackendChoice askedFor(BackendWish wish) {
        throw new OpenClUnavailableException("there is no OpenCL in a browser: take Backend.JVM or Backend.AUTO");
    }

    static BackendChoice moving(BackendWish wish) {
        return fastest(wish);
    }

    static BackendChoice fastest(BackendWish wish) {
        return BackendChoice.jvm(wish, "there is no OpenCL in a browser");
    }
}
