package io.github.circles2d.opencl;

/** An OpenCL call failed. The message says which call, on which device, and the name of the OpenCL error code. */
public class OpenClException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /**
     * Creates the exception.
     *
     * @param message what was tried and why it failed
     */
    public OpenClException(String message) {
        super(message);
    }

    /**
     * Creates the exception with the failure that it reports.
     *
     * @param message what was tried and why it failed
     * @param cause the failure below, may be null
     */
    public OpenClException(String message, Throwable cause) {
        super(message, cause);
    }
}
