package handover.bridge;

/** A bridge that cannot be started as it was asked for. */
public final class BridgeException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    BridgeException(String problem, Throwable cause) {
        super(problem, cause);
    }
}
