package handover.cli;

import handover.io.BenchFile;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What was measured so far, by part. It is saved at every row, so that nothing is lost if a long run is stopped. Used by one
 * thread.
 */
final class BenchReport {
    private final Map<String, Object> content = new LinkedHashMap<>();
    private final Map<String, List<Map<String, Object>>> parts = new LinkedHashMap<>();
    /** By part: how many rows are there to stay. */
    private final Map<String, Integer> lasting = new HashMap<>();
    private final List<String> finished = new ArrayList<>();
    private final BenchFile file;

    /**
     * @param file null for none
     * @param head what is known before anything is measured; not modified
     */
    BenchReport(BenchFile file, Map<String, Object> head) throws IOException {
        this.file = file;
        content.putAll(head);
        content.put("finished", finished);
        content.put("parts", parts);
        save();
    }

    /** Adds what was measured in one go. */
    void add(String part, List<Map<String, Object>> rows) throws IOException {
        addForNow(part, rows);
        lasting.put(part, parts.get(part).size());
    }

    /** Adds what is known so far; the next rows of this part take its place. */
    void addForNow(String part, List<Map<String, Object>> rows) throws IOException {
        List<Map<String, Object>> all = parts.computeIfAbsent(part, p -> new ArrayList<>());
        all.subList(lasting.getOrDefault(part, 0), all.size()).clear();
        all.addAll(rows);
        save();
    }

    /** No more rows come in this part. */
    void finish(String part) throws IOException {
        finished.add(part);
        save();
    }

    private void save() throws IOException {
        if (file != null) {
            file.write(content);
        }
    }
}
