package handover.io;

/** An episode log that cannot be used: names the file, the line and what is wrong there. */
public final class EpisodeLogException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /**
     * @param file as it was asked for
     * @param line from 1; 0 if it is the file as a whole
     * @param problem in plain words
     * @param cause what reported it, null if nothing else did
     */
    EpisodeLogException(String file, int line, String problem, Throwable cause) {
        super(file + ": " + (line == 0 ? "" : "line " + line + ": ") + problem, cause);
    }
}
