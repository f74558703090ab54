package handover.cli;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** A table as GitHub shows it, with columns that also line up as plain text: the first aligned left, the others right. Used by one thread. */
final class MarkdownTable {
    private final List<List<String>> rows = new ArrayList<>();

    MarkdownTable(String... header) {
        rows.add(List.of(header));
    }

    /** A row of as many cells as the header has. */
    void add(Object... cells) {
        rows.add(Arrays.stream(cells).map(String::valueOf).toList());
    }

    /** The lines, each with its line end. */
    String text() {
        int[] width = IntStream.range(0, rows.get(0).size())
                .map(c -> rows.stream().mapToInt(r -> r.get(c).length()).max().orElseThrow()).toArray();
        StringBuilder text = new StringBuilder(line(rows.get(0), width));
        text.append(IntStream.range(0, width.length)
                .mapToObj(c -> c == 0 ? "-".repeat(width[c] + 2) : "-".repeat(width[c] + 1) + ":")
                .collect(Collectors.joining("|", "|", "|\n")));
        rows.stream().skip(1).forEach(row -> text.append(line(row, width)));
        return text.toString();
    }

    private static String line(List<String> cells, int[] width) {
        return IntStream.range(0, width.length).mapToObj(c -> {
            String space = " ".repeat(width[c] - cells.get(c).length());
            return c == 0 ? cells.get(c) + space : space + cells.get(c);
        }).collect(Collectors.joining(" | ", "| ", " |\n"));
    }
}
