package handover.cli;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.function.LongSupplier;

/**
 * What a command reads, writes and measures time with.
 *
 * @param live whether {@code err} is a terminal, on which a line can be written over
 * @param nanoClock as {@link System#nanoTime}
 */
record Console(InputStream in, PrintStream out, PrintStream err, boolean live, LongSupplier nanoClock) {
    private static final Path STANDARD_ERROR = Path.of("/dev/fd/2");

    /** Whether the standard error of this process is a terminal. */
    static boolean errorIsTerminal() {
        if (!Files.exists(STANDARD_ERROR.getParent())) {
            return System.console() != null;
        }
        try {
            String real = STANDARD_ERROR.toRealPath().toString();
            return real.startsWith("/dev/pts/") || real.startsWith("/dev/tty");
        } catch (NoSuchFileException e) {
            return false; // a pipe has no name
        } catch (IOException e) {
            return System.console() != null;
        }
    }
}
