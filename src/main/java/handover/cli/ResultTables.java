package handover.cli;

import handover.simulation.Estimate;
import handover.simulation.Summary;
import java.util.List;
import java.util.Locale;

/** What a run found, as text for people who see it for the first time. */
final class ResultTables {
    private static final int LONGEST_NAME = 22;
    private static final List<String> HEADER = List.of("solver", "success %", "seconds", "steps", "return", "questions",
            "log score", "Brier", "h to b", "ms p50/p99");
    private static final String LEGEND = """
            success %   episodes whose first finished pick was of the object that the person wanted
            seconds     time until the object was handed over, by how long each act takes
            steps       acts of the robot
            return      sum of rewards, those of each later step counting a little less; higher is better
            questions   how often the robot asked about objects
            log score   how surely the robot's belief was in the right object: mean log probability, 0 is best
            Brier       the same as a squared error, from -2 to 0, 0 is best
            h to b      how far what the person expects is from what the robot believes, from 0 (the same) to 2
            ms p50/p99  milliseconds that a decision took: half took at most the first, 99 of 100 at most the second
            +-          the longer arm of a 95% interval: how far the mean may be off because there were only so many episodes
            """;

    /**
     * One row.
     *
     * @param mark what the solver is for, empty if it is one of those that are compared
     */
    record Row(Summary summary, String mark) {}

    /** The return of a solver less that of another one, on the same episodes. */
    record Difference(String solver, Estimate estimate) {}

    private ResultTables() {}

    /** A row for each solver. */
    static String summaries(List<Row> rows) {
        TextTable table = new TextTable(LONGEST_NAME, HEADER);
        for (Row row : rows) {
            Summary s = row.summary;
            Estimate percent = new Estimate(100 * s.success().value(), 100 * s.success().low(), 100 * s.success().high());
            String name = row.mark.isEmpty() ? s.solver() : s.solver() + " (" + row.mark + ")";
            table.add(List.of(name, cell(percent, 1), cell(s.seconds(), 1), cell(s.steps(), 1),
                    cell(s.discountedReturn(), 1), cell(s.questions(), 1), cell(s.logScore(), 2), cell(s.brierScore(), 2),
                    cell(s.distance(), 2), milliseconds(s.p50()) + "/" + milliseconds(s.p99())));
        }
        return table.text();
    }

    /** Who earned more than {@code reference}. */
    static String differences(String reference, List<Difference> differences) {
        TextTable table = new TextTable(LONGEST_NAME, List.of("solver", "return more", "95% interval", "than " + reference));
        for (Difference d : differences) {
            Estimate e = d.estimate;
            String word = e.low() > 0 ? "better" : e.high() < 0 ? "worse" : "no difference shown";
            String interval = Double.isInfinite(e.half()) ? "unknown" : format("%+.1f to %+.1f", e.low(), e.high());
            table.add(List.of(d.solver, format("%+.1f", e.value()), interval, word));
        }
        return table.text();
    }

    /** What the columns mean. */
    static String legend() {
        return LEGEND;
    }

    /** An estimate and the longer arm of its interval. */
    static String cell(Estimate e, int decimals) {
        double longerArm = Math.max(e.value() - e.low(), e.high() - e.value());
        String half = Double.isInfinite(longerArm) ? "?" : format("%." + decimals + "f", longerArm);
        return format("%." + decimals + "f", e.value()) + "+-" + half;
    }

    private static String milliseconds(double seconds) {
        double ms = 1e3 * seconds;
        return Double.isNaN(ms) ? "-" : format(ms < 10 ? "%.2f" : ms < 100 ? "%.1f" : "%.0f", ms);
    }

    /** Without a sign before what rounds to zero. */
    static String format(String format, Object... values) {
        return String.format(Locale.ROOT, format, values).replaceAll("[-+](0\\.0+)(?![0-9])", "$1");
    }
}
