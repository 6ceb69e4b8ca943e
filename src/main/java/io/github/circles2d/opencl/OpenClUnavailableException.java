package io.github.circles2d.opencl;

/**
 * There is no usable OpenCL device: no driver, no native library for this processor, no device of the kind asked for,
 * or a home directory that kernels cannot be compiled through. The message says what is missing and what to install.
 */
public final class OpenClUnavailableException extends OpenClException {
    private static final long serialVersionUID = 1L;

    /**
     * Creates the exception.
     *
     * @param message what is missing and what to install
     */
    public OpenClUnavailableException(String message) {
        super(message);
    }

    /**
     * Creates the exception with the failure that it reports.
     *
     * @param message what is missing and what to install
     * @param cause the failure below, may be null
     */
    public OpenClUnavailableException(String message, Throwable cause) {
        super(message, cause);
    }
}
