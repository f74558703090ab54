package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The command as a process of its own, with what is packaged and nothing of the tests on its class path. */
class ProcessTest {
    private static final String[] LIBRARIES = {"burlap", "commons-lang", "hipparchus", "jackson", "jeromq", "jnacl", "logback",
        "picocli", "slf4j"};

    @TempDir
    Path folder;

    private List<String> javaOptions = List.of();

    @Test
    void simulatesWithoutAnyArgument() throws Exception {
        assertEquals(Main.FINE, start("check", "kitchen-20"), err());
        assertTrue(out().startsWith("ok: kitchen-20: kitchen-20, 20 objects, "), out());
        assertEquals("", err());
        assertEquals(Main.FINE, start(), err());
        assertTrue(out().contains("\nposs:H=2,C=10 "), out());
        assertTrue(out().contains("than poss:H=2,C=10"), out());
        assertEquals(2501, Files.readAllLines(folder.resolve("episodes.jsonl")).size());
    }

    /** A legal act for a table of a hundred objects, with the memory of a small computer. */
    @Test
    void decidesAmongAHundredObjects() throws Exception {
        javaOptions = List.of("-Xmx512m");
        assertEquals(Main.FINE, start("plan", "--domain", "generated-100", "--solver", "anytime", "--deadline-ms", "250", "--json"), err());
        Act act = decided(out());
        HandoverDomain domain = DomainFiles.load("generated-100");
        assertNotNull(domain.start().model(act), out());
        assertTrue(Pattern.compile("\"depth\":[1-9]").matcher(out()).find(), out());
    }

    private static Act decided(String json) {
        Matcher m = Pattern.compile("\"act\":\"(\\w+)\",\"objects\":\\[(.*?)\\]").matcher(json);
        assertTrue(m.find(), json);
        return m.group(2).isEmpty() ? Act.of(m.group(1)) : Act.of(m.group(1), m.group(2).replace("\"", "").split(","));
    }

    @Test
    void exitCodesComeThrough() throws Exception {
        assertEquals(Main.BAD_INPUT, start("check", "nothing"));
        assertTrue(err().startsWith("handover: nothing: there is no such file"), err());
        assertEquals("", out());
    }

    private int start(String... args) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        command.addAll(javaOptions);
        command.addAll(List.of("-cp", classPath(), "handover.cli.Main"));
        command.addAll(List.of(args));
        Process process = new ProcessBuilder(command).directory(folder.toFile())
                .redirectOutput(folder.resolve("out").toFile()).redirectError(folder.resolve("err").toFile()).start();
        try {
            assertTrue(process.waitFor(2, TimeUnit.MINUTES), "still running");
            return process.exitValue();
        } finally {
            process.destroyForcibly();
        }
    }

    /** The classes of the toolkit and the libraries that it is packaged with. */
    private static String classPath() {
        List<String> path = new ArrayList<>();
        for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
            String name = Path.of(entry).getFileName().toString();
            if (name.equals("classes") || List.of(LIBRARIES).stream().anyMatch(name::startsWith)) {
                path.add(entry);
            }
        }
        return String.join(File.pathSeparator, path);
    }

    private String out() throws IOException {
        return Files.readString(folder.resolve("out"), StandardCharsets.UTF_8);
    }

    private String err() throws IOException {
        return Files.readString(folder.resolve("err"), StandardCharsets.UTF_8);
    }
}
