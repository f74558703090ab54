package handover.domain;

/** A parameter of a domain that cannot be meant: names the field, the value and what was expected. */
public final class InvalidParameterException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    private final String field;
    private final String problem;

    /**
     * @param field path of the field inside the record that was being made, for instance {@code position[0]}
     * @param value the offending value
     * @param expected what would have been right, for instance "metres within 100 of the table's origin"
     */
    public InvalidParameterException(String field, Object value, String expected) {
        this(field, "expected " + expected + ", got " + show(value));
    }

    /** As above, for a problem that is not about one value. */
    public InvalidParameterException(String field, String problem) {
        super(field.isEmpty() ? problem : field + ": " + problem);
        this.field = field;
        this.problem = problem;
    }

    /** Path of the offending field inside its record; empty if it is the record as a whole. */
    public String field() {
        return field;
    }

    /** What is wrong, without the field. */
    public String problem() {
        return problem;
    }

    private static String show(Object value) {
        return value instanceof CharSequence ? "\"" + value + "\"" : String.valueOf(value);
    }
}
