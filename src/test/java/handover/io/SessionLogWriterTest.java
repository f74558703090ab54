package handover.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A log has one writer, who goes on only where it really ends. */
class SessionLogWriterTest {
    @TempDir
    Path folder;

    @Test
    void aLogHasOneWriter() throws IOException {
        Path log = folder.resolve("log.jsonl");
        SessionHeader header = new SessionHeader(DomainFiles.read("bowls-and-spoons"), "confirm", 1, 2);
        SessionLogWriter first = SessionLogWriter.create(log, header);
        first.replied(1, "{}");
        long end = Files.size(log);
        assertEquals("another bridge writes to this log",
                assertThrows(FileSystemException.class, () -> SessionLogWriter.append(log, end)).getReason());
        first.replied(2, "{\"note\":1}");
        first.close();
        assertEquals("another bridge wrote to this log after it was read",
                assertThrows(FileSystemException.class, () -> SessionLogWriter.append(log, end)).getReason());
        Files.writeString(log, Files.readString(log) + "{\"at\":3,\"repl");
        long whole = Files.size(log) - "{\"at\":3,\"repl".length();
        try (SessionLogWriter second = SessionLogWriter.append(log, whole)) {
            second.replied(4, "{}");
        }
        assertEquals("{\"at\":4.0,\"reply\":{}}", Files.readAllLines(log).get(3));
        assertEquals(4, Files.readAllLines(log).size());
    }
}
