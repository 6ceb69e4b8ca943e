package io.github.circles2d.opencl;

/**
 * What was asked for does not fit the device's memory. It is thrown before anything is allocated; the message says how
 * many bytes are needed and how many the device has.
 */
public final class DeviceMemoryException extends OpenClException {
    private static final long serialVersionUID = 1L;

    /** Bytes that were asked for in all. */
    private final long neededBytes;

    /** Bytes that the device could still give. */
    private final long availableBytes;

    /**
     * Creates the exception.
     *
     * @param message what was asked for, bytes needed, bytes there
     * @param neededBytes bytes that were asked for in all
     * @param availableBytes bytes that the device could still give
     */
    public DeviceMemoryException(String message, long neededBytes, long availableBytes) {
        super(message);
        this.neededBytes = neededBytes;
        this.availableBytes = availableBytes;
    }

    /** {@return the bytes that were asked for in all} */
    public long neededBytes() {
        return neededBytes;
    }

    /**
     * {@return the bytes that the device could still give: the tighter of its free memory and its largest single
     * buffer}
     */
    public long availableBytes() {
        return availableBytes;
    }
}
