package handover.io;

import java.nio.file.Path;

/** A policy file, or one under way, that cannot be used: names the file and what is wrong. */
public final class PolicyFileException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /**
     * @param file as it was asked for
     * @param problem in plain words
     */
    PolicyFileException(Path file, String problem) {
        super(file + ": " + problem);
    }

    /** As above, with what reported it. */
    PolicyFileException(Path file, String problem, Throwable cause) {
        super(file + ": " + problem, cause);
    }
}
