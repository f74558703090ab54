package my.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A user's variants in a jar of their own, run by the toolkit's command line as a process of its own. */
class LabJarTest {
    private static final Path CLASSES = Path.of("target/test-classes");

    @TempDir
    Path folder;

    /** Only the user's classes go into the jar, nothing else of the tests onto the class path. */
    @BeforeEach
    void packJar() throws IOException {
        try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(folder.resolve("lab.jar")));
                Stream<Path> files = Files.walk(CLASSES.resolve("my/lab"))) {
            for (Path file : files.filter(f -> f.getFileName().toString().matches("(Quiet|Fickle|HoldUp)Domain.*\\.class")).toList()) {
                jar.putNextEntry(new JarEntry(CLASSES.relativize(file).toString().replace(File.separatorChar, '/')));
                Files.copy(file, jar);
            }
        }
    }

    @Test
    void simulatesPlansAndInfersWithAUsersVariant() throws Exception {
        String domain = Path.of("src/test/resources/my/lab/hold-up.json").toAbsolutePath().toString();
        assertEquals(0, handover(null, "simulate", "--domain", domain, "--solver", "poss:H=1,C=1", "--episodes", "20"), err());
        assertTrue(out().contains("hold-up"), out());
        assertEquals(0, handover(null, "plan", "--domain", domain, "--solver", "poss:H=2,C=4", "--all"), err());
        assertTrue(out().contains("HOLD_UP(red_cup,red_ball)"), out());
        String messages = """
                {"v":1,"type":"acted","act":"HOLD_UP","objects":["red_ball","red_cup"],"status":"started"}
                {"v":1,"type":"speech","text":"no"}
                """;
        assertEquals(0, handover(messages, "infer", domain), err());
        String last = out().lines().reduce((a, b) -> b).orElseThrow();
        assertTrue(last.contains("\"blue_cup\":0.98"), "the third object is wanted: " + last);
    }

    @Test
    void saysWhichClassIsMissing() throws Exception {
        Path domain = folder.resolve("nowhere.json");
        Files.writeString(domain, Files.readString(Path.of("src/test/resources/my/lab/quiet.json")).replace("QuietDomain", "LoudDomain"));
        assertEquals(2, handover(null, "plan", "--domain", domain.toString()));
        assertTrue(err().contains("variant: expected base, communicated, incremental, incremental_communicated, nested or the name of a "
                + "class, got \"my.lab.LoudDomain\"; no such class is on the class path"), err());
    }

    private int handover(String in, String... args) throws IOException, InterruptedException {
        List<String> path = new ArrayList<>(List.of(folder.resolve("lab.jar").toString()));
        for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
            path.add(entry.endsWith("test-classes") ? null : entry);
        }
        path.removeIf(p -> p == null);
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp", String.join(File.pathSeparator, path), "handover.cli.Main"));
        command.addAll(List.of(args));
        Files.writeString(folder.resolve("in"), in == null ? "" : in);
        Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectInput(folder.resolve("in").toFile())
                .redirectOutput(folder.resolve("out").toFile()).redirectError(folder.resolve("err").toFile()).start();
        assertTrue(process.waitFor(2, TimeUnit.MINUTES), "still running");
        return process.exitValue();
    }

    private String out() throws IOException {
        return Files.readString(folder.resolve("out"));
    }

    private String err() throws IOException {
        return Files.readString(folder.resolve("err"));
    }
}
