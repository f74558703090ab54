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

    /** @param longestName characters of the first column; longer cells lose their middle */
    TextTable(int longestName, List<String> header) {
        this.longestName = longestName;
        rows.add(header);
    }

    void add(List<String> cells) {
        List<String> row = new ArrayList<>(cells);
        row.set(0, shortened(cells.get(0)));
        rows.add(row);
    }

    /** The lines, each with its line end. */
    String text() {
        int columns = rows.get(0).size();
        int[] width = new int[columns];
        for (List<String> row : rows) {
            for (int c = 0; c < columns; c++) {
                width[c] = Math.max(width[c], row.get(c).length());
            }
        }
        boolean wide = Arrays.stream(width).sum() + (columns - 1) * GAP.length() > WIDEST;
        String gap = wide ? " " : GAP;
        StringBuilder text = new StringBuilder();
        for (List<String> row : rows) {
            StringBuilder line = new StringBuilder(row.get(0)).append(" ".repeat(width[0] - row.get(0).length()));
            for (int c = 1; c < columns; c++) {
                line.append(gap).append(" ".repeat(width[c] - row.get(c).length())).append(row.get(c));
            }
            text.append(line.toString().stripTrailing()).append('\n');
        }
        return text.toString();
    }

    private String shortened(String cell) {
        if (cell.length() <= longestName) {
            return cell;
        }
        int head = (longestName - 2) / 2;
        return cell.substring(0, head) + ".." + cell.substring(cell.length() - (longestName - 2 - head));
    }
}
