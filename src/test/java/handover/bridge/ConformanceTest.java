package handover.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * Whole conversations with a real bridge, compared with those on file. {@code $} starts a bridge, {@code >} is a request,
 * {@code >>} is pushed, {@code >~} is a request whose answer comes later; {@code <} is an answer, {@code *} an event.
 * {@code scripts/golden} plays them again and writes what comes of it.
 */
class ConformanceTest {
    private static final Path FILES = Path.of("src/test/resources/golden/bridge").toAbsolutePath();
    private static final boolean WRITE = Boolean.getBoolean("golden.write");

    @TempDir
    Path folder;

    @TestFactory
    Stream<DynamicTest> isAsOnFile() throws IOException {
        return conversations().stream().map(file -> DynamicTest.dynamicTest(file.getFileName().toString(), () -> {
            List<String> lines = Files.readAllLines(file);
            String now = new Conversation(folder, FILES).play(lines);
            if (WRITE) {
                Files.writeString(file, now);
            }
            assertEquals(String.join("\n", Files.readAllLines(file)) + "\n", now, file + " goes another way; see scripts/golden");
        }));
    }

    /** Nothing of the protocol is left out. */
    @Test
    void everyTypeAndEveryCodeIsThere() throws IOException {
        StringBuilder all = new StringBuilder();
        for (Path file : conversations()) {
            all.append(Files.readString(file));
        }
        assertEquals(Set.of("hello", "begin", "decide", "acted", "state", "end", "speech", "gesture", "scene"),
                found("(?m)^>[>~]? .*?\"type\":\"((?!sing)\\w+)\"", all));
        assertEquals(Set.of("welcome", "ok", "decision", "superseded", "state", "summary", "error"),
                found("(?m)^< .*?\"type\":\"(\\w+)\"", all));
        assertEquals(Set.of("belief", "decision", "act", "error", "scene", "episode", "heartbeat"), found("(?m)^\\* (\\w+)", all));
        Set<String> codes = new TreeSet<>(Set.of("not_json", "too_large", "bad_version", "bad_type", "missing_field", "bad_field",
                "unknown_object", "unknown_frame", "stale", "no_episode", "illegal_act", "busy", "internal"));
        assertEquals(codes, found("(?m)^< .*?\"code\":\"(\\w+)\"", all));
        assertTrue(found("\"status\":\"(\\w+)\"", all).containsAll(Set.of("started", "completed", "failed", "cancelled")));
        assertTrue(found("\"pick\":\"(\\w+)\"", all).containsAll(Set.of("moving", "accepted", "rejected")));
    }

    private static Set<String> found(String pattern, CharSequence text) {
        Set<String> found = new TreeSet<>();
        for (Matcher m = Pattern.compile(pattern).matcher(text); m.find();) {
            found.add(m.group(1));
        }
        return found;
    }

    private static List<Path> conversations() throws IOException {
        try (Stream<Path> files = Files.list(FILES)) {
            return files.filter(f -> f.toString().endsWith(".txt")).sorted().toList();
        }
    }
}
