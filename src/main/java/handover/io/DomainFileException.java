package handover.io;

/** A domain or human file that cannot be used: names the file, the place in it and what is wrong there. */
public final class DomainFileException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final String file;
    private final String path;
    private final String problem;

    /**
     * @param file the file as it was asked for
     * @param path where in it, for instance {@code objects[2].position[0]}; empty if it is the file as a whole
     * @param problem what was expected and what was there, in plain words
     * @param cause what reported it, null if nothing else did
     */
    DomainFileException(String file, String path, String problem, Throwable cause) {
        super(file + ": " + (path.isEmpty() ? "" : path + ": ") + problem, cause);
        this.file = file;
        this.path = path;
        this.problem = problem;
    }

    public String file() {
        return file;
    }

    /** Where in the file, for instance {@code objects[2].position[0]}; empty if it is the file as a whole. */
    public String path() {
        return path;
    }

    /** What is wrong, without file and path. */
    public String problem() {
        return problem;
    }
}
