package handover.io;

/** A field of a JSON object that is missing or cannot be meant; whoever reads the object says whose object it was. */
final class FieldException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final boolean missing;
    private final String path;

    FieldException(boolean missing, String path, String problem) {
        super(problem);
        this.missing = missing;
        this.path = path;
    }

    boolean missing() {
        return missing;
    }

    /** Where in the object, for instance {@code hand[1]}. */
    String path() {
        return path;
    }
}
