package handover.io;

/** A message that cannot be used: what docs/bridge.md's error reply says. */
public final class WireException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final WireCode code;
    private final String path;
    private final String re;

    /**
     * @param code what kind of problem
     * @param path of the field, for instance {@code hand[1]}; empty if it is the message as a whole
     * @param problem in plain words: what was expected and what was there
     */
    public WireException(WireCode code, String path, String problem) {
        this(code, path, problem, null);
    }

    private WireException(WireCode code, String path, String problem, String re) {
        super(problem);
        this.code = code;
        this.path = path;
        this.re = re;
    }

    /** The same, said of the message with this id. */
    public WireException about(String id) {
        WireException e = new WireException(code, path, getMessage(), id);
        e.initCause(this);
        return e;
    }

    public WireCode code() {
        return code;
    }

    public String path() {
        return path;
    }

    /** The id of the message; null if it has none or none could be read. */
    public String re() {
        return re;
    }
}
