package my.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import handover.cli.Main;
import handover.io.DomainFiles;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What the README shows is what is compiled and run. */
class ReadmeTest {
    private static String readme() throws IOException {
        return Files.readString(Path.of("README.md"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"QuietDomain", "FickleDomain", "HoldUpDomain", "AskOnce"})
    void showsTheCodeThatIsTested(String name) throws IOException {
        String code = Files.readString(Path.of("src/test/java/my/lab", name + ".java"));
        assertTrue(readme().contains("```java\n" + code + "```"), "README and " + name + ".java differ");
    }

    @Test
    void itsDomainFileIsValid() throws IOException {
        Matcher json = Pattern.compile("```json\n(.*?)```", Pattern.DOTALL).matcher(readme());
        assertTrue(json.find());
        assertEquals("my-table", DomainFiles.fromJson(new ObjectMapper().readTree(json.group(1)), "README").name());
    }

    /** The messages that it feeds to infer are understood. */
    @Test
    void itsMessagesAreUnderstood() throws IOException {
        Matcher session = Pattern.compile("infer table-line-6 <<'END'\n(.*?)\n\\s*END", Pattern.DOTALL).matcher(readme());
        assertTrue(session.find());
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        int code = Main.run(new String[] {"infer", "table-line-6"},
                new ByteArrayInputStream(session.group(1).getBytes(StandardCharsets.UTF_8)), new PrintStream(out), System.err);
        String replies = out.toString(StandardCharsets.UTF_8);
        assertEquals(0, code);
        assertEquals(3, replies.lines().filter(l -> l.contains("\"type\":\"belief\"")).count(), replies);
    }

    /** The replies that it shows are the first ones of those that are made, shortened. */
    @Test
    void itsRepliesAreReal() throws IOException {
        assertTrue(readme().contains("{\"v\":1,\"type\":\"belief\",\"belief\":{\"blue_cylinder\":0.16666666666666666,"));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Main.run(new String[] {"infer", "table-line-6"}, new ByteArrayInputStream(("{\"v\":1,\"type\":\"acted\",\"act\":\"ASK\","
                + "\"objects\":[\"red_ball\"],\"status\":\"started\"}\n").getBytes(StandardCharsets.UTF_8)), new PrintStream(out), System.err);
        String reply = out.toString(StandardCharsets.UTF_8);
        assertTrue(reply.startsWith("{\"v\":1,\"type\":\"belief\",\"belief\":{\"blue_cylinder\":0.16666666666666666,"), reply);
        assertTrue(reply.contains("\"red_ball\":0.7906229322242181"), reply);
    }

    /** Each command and each script that it names is there. */
    @Test
    void itsCommandsExist() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Main.run(new String[] {"--help"}, new ByteArrayInputStream(new byte[0]), new PrintStream(out), System.err);
        String help = out.toString(StandardCharsets.UTF_8);
        Matcher named = Pattern.compile("scripts/handover ([a-z]+)").matcher(readme());
        while (named.find()) {
            assertTrue(help.contains("  " + named.group(1)), "no command " + named.group(1) + " in:\n" + help);
        }
        Matcher script = Pattern.compile("(scripts/[a-z_.-]+)").matcher(readme());
        while (script.find()) {
            Path file = Path.of(script.group(1));
            assertTrue(file.toString().endsWith(".txt") ? Files.exists(file) : Files.isExecutable(file), script.group(1));
        }
    }
}
