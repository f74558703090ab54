package handover.io;

/** A .POMDP file that cannot be meant, with the line and column where that shows: {@code tiger.POMDP:12:7: expected ...}. */
public final class PomdpFileException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    PomdpFileException(String file, int line, int column, String problem) {
        super(file + ":" + line + ":" + column + ": " + problem);
    }
}
