package io.github.circles2d.opencl;

/** The device's compiler refused a kernel source. The message names device and files and ends with the build log. */
public final class KernelBuildException extends OpenClException {
    private static final long serialVersionUID = 1L;

    /**
     * Creates the exception.
     *
     * @param message device, files and build log
     * @param cause the failure below, may be null
     */
    public KernelBuildException(String message, Throwable cause) {
        super(message, cause);
    }
}
