package handover.cli;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Columns of text: the first aligned left, the others right. Used by one thread. */
final class TextTable {
    private static final String GAP = "  ";
    /** Wider tables have narrower gaps. */
    private static final int WIDEST = 130;

    private final List<List<String>> rows = new ArrayList<>();
    private final int longestName;
    private final int[] width;

    /** @param longestName characters of the first column; longer cells lose their middle */
    TextTable(int longestName, List<String> header) {
        this(longestName, header, new int[header.size()]);
    }

    /** @param least characters of each column, so that lines can be printed before all rows are known */
    TextTable(int longestName, List<String> header, int[] least) {
        this.longestName = longestName;
        width = least.clone();
        width[0] = Math.min(longestName, width[0]);
        append(header);
    }

    void add(List<String> cells) {
        List<String> row = new ArrayList<>(cells);
        row.set(0, shortened(cells.get(0)));
        append(row);
    }

    private void append(List<String> row) {
        rows.add(row);
        for (int c = 0; c < width.length; c++) {
            width[c] = Math.max(width[c], row.get(c).length());
        }
    }

    /** The lines, each with its line end. */
    String text() {
        StringBuilder text = new StringBuilder();
        rows.forEach(row -> text.append(line(row)));
        return text.toString();
    }

    /** The line of the row that was added last, as wide as the rows so far. */
    String lastLine() {
        return line(rows.get(rows.size() - 1));
    }

    private String line(List<String> row) {
        boolean wide = Arrays.stream(width).sum() + (width.length - 1) * GAP.length() > WIDEST;
        String gap = wide ? " " : GAP;
        StringBuilder line = new StringBuilder(row.get(0)).append(" ".repeat(width[0] - row.get(0).length()));
        for (int c = 1; c < width.length; c++) {
            line.append(gap).append(" ".repeat(width[c] - row.get(c).length())).append(row.get(c));
        }
        return line.toString().stripTrailing() + '\n';
    }

    private String shortened(String cell) {
        if (cell.length() <= longestName) {
            return cell;
        }
        int head = (longestName - 2) / 2;
        return cell.substring(0, head) + ".." + cell.substring(cell.length() - (longestName - 2 - head));
    }
}
