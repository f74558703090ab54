package handover.io;

import java.util.Collection;
import java.util.Comparator;

/** What somebody who mistyped a key may have meant. */
final class NearestKey {
    private NearestKey() {}

    /** {@code  (did you mean "tau"?)} with a space before it, or nothing if no known key is close. */
    static String suggestion(String key, Collection<String> known) {
        return known.stream().min(Comparator.comparingInt(k -> distance(key, k)))
                .filter(k -> distance(key, k) <= Math.max(2, k.length() / 3))
                .map(k -> " (did you mean \"" + k + "\"?)").orElse("");
    }

    /** Levenshtein's distance: how many characters to insert, delete or replace. */
    static int distance(String a, String b) {
        int[] row = new int[b.length() + 1];
        for (int j = 0; j < row.length; j++) {
            row[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j < row.length; j++) {
                int replaced = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(replaced, 1 + Math.min(row[j], row[j - 1]));
            }
        }
        return row[b.length()];
    }
}
