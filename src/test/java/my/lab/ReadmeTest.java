package my.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import handover.cli.Main;
import handover.io.DomainFiles;
import handover.solver.Solvers;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What the README shows is what is compiled and run. */
class ReadmeTest {
    private static String readme() {
        try {
            return Files.readString(Path.of("README.md"));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
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
    void itsMessagesAreUnderstood() {
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
    void itsRepliesAreReal() {
        assertTrue(readme().contains("{\"v\":1,\"type\":\"belief\",\"belief\":{\"blue_cylinder\":0.16666666666666666,"));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Main.run(new String[] {"infer", "table-line-6"}, new ByteArrayInputStream(("{\"v\":1,\"type\":\"acted\",\"act\":\"ASK\","
                + "\"objects\":[\"red_ball\"],\"status\":\"started\"}\n").getBytes(StandardCharsets.UTF_8)), new PrintStream(out), System.err);
        String reply = out.toString(StandardCharsets.UTF_8);
        assertTrue(reply.startsWith("{\"v\":1,\"type\":\"belief\",\"belief\":{\"blue_cylinder\":0.16666666666666666,"), reply);
        assertTrue(reply.contains("\"red_ball\":0.7906229322242181"), reply);
    }

    /** The frames and adapters that the pages show can stand in a domain file. */
    @ParameterizedTest
    @ValueSource(strings = {"README.md", "docs/bridge.md"})
    void itsFramesAreValid(String page) throws IOException {
        Matcher whole = Pattern.compile("```json\n(\\{.*?)```", Pattern.DOTALL).matcher(readme());
        assertTrue(whole.find());
        Matcher part = Pattern.compile("```json\n(\"frames\".*?)```", Pattern.DOTALL).matcher(Files.readString(Path.of(page)));
        assertTrue(part.find());
        String domain = whole.group(1).strip().replaceFirst("^\\{", Matcher.quoteReplacement("{" + part.group(1) + ","));
        assertTrue(DomainFiles.fromJson(new ObjectMapper().readTree(domain), page).frames().containsKey("camera"));
    }

    /** The table that it shows is the one that is printed, but for the times. */
    @Test
    void itsTableIsReal() {
        String table = printed("simulate", "--out", "-");
        List<String> shown = readme().lines().dropWhile(l -> !l.startsWith("solver  ")).takeWhile(l -> !l.startsWith("```"))
                .map(ReadmeTest::withoutTimes).toList();
        assertEquals(6, shown.size());
        List<String> rows = table.lines().map(ReadmeTest::withoutTimes).toList();
        assertTrue(rows.containsAll(shown), table);
    }

    private static String withoutTimes(String row) {
        return row.strip().replaceAll(" +\\S+$", "").replaceAll(" +", " ");
    }

    /** What can be named on the command line is named in it, and so is each package. */
    @Test
    void isComplete() throws IOException {
        List<String> names = new ArrayList<>(Solvers.names());
        try (Stream<Path> files = Files.list(Path.of("domains"))) {
            files.map(f -> f.getFileName().toString()).filter(f -> f.endsWith(".json")).map(f -> f.replace(".json", "")).forEach(names::add);
        }
        try (Stream<Path> packages = Files.list(Path.of("src/main/java/handover"))) {
            packages.map(p -> "handover." + p.getFileName()).forEach(names::add);
        }
        Matcher command = Pattern.compile("(?m)^  ([a-z]+) ").matcher(printed("--help").replaceFirst("(?s).*Commands:", ""));
        while (command.find()) {
            names.add(command.group(1));
        }
        List<String> missing = names.stream().filter(n -> !Pattern.compile("`" + Pattern.quote(n) + "[`: ]").matcher(readme()).find()).toList();
        assertEquals(List.of(), missing);
    }

    /** Each command, each script and each option that the pages name is there. */
    @ParameterizedTest
    @ValueSource(strings = {"README.md", "docs/bridge.md", "docs/results.md"})
    void itsCommandsExist(String page) throws IOException {
        String text = Files.readString(Path.of(page));
        Matcher named = Pattern.compile("scripts/handover ([a-z]+)( [a-z]+)?([^#|`\n]*)").matcher(text);
        while (named.find()) {
            boolean sub = named.group(2) != null && printed(named.group(1), "--help").contains("\n  " + named.group(2).strip() + " ");
            String help = sub ? printed(named.group(1), named.group(2).strip(), "--help") : printed(named.group(1), "--help");
            assertTrue(help.startsWith("Usage: handover " + named.group(1)), "no command " + named.group());
            Matcher option = Pattern.compile("--[a-z-]+").matcher(named.group(3));
            while (option.find()) {
                assertTrue(help.contains(option.group()), "no option " + option.group() + " in:\n" + help);
            }
        }
        Matcher script = Pattern.compile("(scripts/[a-z_./-]*[a-z])([^#|`\n]*)").matcher(text);
        while (script.find()) {
            Path file = Path.of(script.group(1));
            boolean run = Files.isExecutable(file) && !Files.isDirectory(file);
            assertTrue(run || file.toString().matches(".*\\.(txt|ndjson)") && Files.exists(file), script.group(1));
            if (script.group(1).endsWith(".py")) {
                String source = Files.readString(file) + Files.readString(Path.of("scripts/client.py"));
                Matcher option = Pattern.compile("--[a-z-]+").matcher(script.group(2));
                while (option.find()) {
                    assertTrue(source.contains("\"" + option.group() + "\""), "no option " + option.group() + " of " + file);
                }
            }
        }
    }

    /** Links lead to pages and headings that exist. */
    @ParameterizedTest
    @ValueSource(strings = {"README.md", "docs/bridge.md", "docs/results.md"})
    void itsLinksLeadSomewhere(String page) throws IOException {
        Matcher link = Pattern.compile("\\]\\((?!http)([^)#]*)#?([^)]*)\\)").matcher(Files.readString(Path.of(page)));
        int links = 0;
        for (; link.find(); links++) {
            Path target = Path.of(page).resolveSibling(link.group(1));
            assertTrue(Files.exists(target), link.group());
            String anchor = link.group(2);
            assertTrue(anchor.isEmpty() || Files.readString(target).lines().filter(l -> l.startsWith("#"))
                    .anyMatch(l -> l.replaceFirst("^#+ ", "").toLowerCase(Locale.ROOT).replace(' ', '-').equals(anchor)), link.group());
        }
        assertTrue(links > 0);
    }

    private static String printed(String... arguments) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Main.run(arguments, new ByteArrayInputStream(new byte[0]), new PrintStream(out), System.err);
        return out.toString(StandardCharsets.UTF_8);
    }
}
