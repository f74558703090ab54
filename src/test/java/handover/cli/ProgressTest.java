package handover.cli;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How far a run is that has more episodes than an int can count. */
class ProgressTest {
    private static final long TEN_SECONDS = 10_000_000_000L;

    /** Stops the run at its first line. */
    private static final class Interrupting extends PrintStream {
        private final Thread caller;
        private boolean first = true;

        Interrupting(OutputStream out, Thread caller) {
            super(out, true, StandardCharsets.UTF_8);
            this.caller = caller;
        }

        @Override
        public void println(String line) {
            super.println(line);
            if (first) {
                first = false;
                caller.interrupt();
            }
        }
    }

    @AfterEach
    void clear() {
        Thread.interrupted();
    }

    @ParameterizedTest
    @Timeout(120)
    @ValueSource(strings = {
        "simulate --solver confirm --solver random --out -",
        "simulate --timed --agent sequential --solver confirm --solver random",
        "solve src/test/resources/pomdp/tiger.POMDP --solver qmdp --solver random"})
    void fourBillionEpisodesAreCounted(String command) {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        AtomicLong clock = new AtomicLong();
        Main.run((command + " --episodes 2000000000 --threads 1").split(" "), new Console(InputStream.nullInputStream(),
                new PrintStream(OutputStream.nullOutputStream()), new Interrupting(text, Thread.currentThread()), false,
                () -> clock.addAndGet(TEN_SECONDS)));
        String shown = text.toString(StandardCharsets.UTF_8);
        assertTrue(shown.startsWith("[....................] 1 of 4000000000 episodes, "), shown);
    }
}
