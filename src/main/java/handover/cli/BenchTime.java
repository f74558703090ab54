package handover.cli;

import handover.belief.HandoverBelief;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import picocli.CommandLine.Option;

/** Decision times by variant, number of objects and budget, on generated tables. */
final class BenchTime implements BenchPart {
    private static final int ENOUGH_FOR_P99 = 100;

    @Option(names = "--variants", split = ",", paramLabel = "V", defaultValue = "base,incremental,communicated",
            description = "time: variants (default: ${DEFAULT-VALUE}).")
    private List<String> variants;

    @Option(names = "--objects", split = ",", paramLabel = "N", defaultValue = "4,6,20",
            description = "time: objects on generated tables (default: ${DEFAULT-VALUE}).")
    private List<Integer> objects;

    @Option(names = "--time-solver", paramLabel = "SPEC[@MS]", description = "time: a solver, with a limit in milliseconds or several "
            + "(as @5/20/50); several times for several (default: poss:H=1,C=10; poss:H=2,C=5; poss:H=2,C=10; anytime@5/20/50; qmdp).")
    private List<String> solvers = List.of("poss:H=1,C=10", "poss:H=2,C=5", "poss:H=2,C=10", "anytime@5/20/50", "qmdp");

    @Override
    public String name() {
        return "time";
    }

    @Override
    public void check() {
        Contender.parse("--time-solver", solvers);
        variants.forEach(v -> objects.forEach(n -> DomainFiles.read(domain(n, v))));
    }

    private static String domain(int n, String variant) {
        return "generated-" + n + "-" + variant;
    }

    @Override
    public String run(BenchRun run) throws IOException {
        MarkdownTable table = new MarkdownTable("variant", "objects", "acts", "solver", "decisions", "median ms", "p90 ms", "p99 ms", "max ms",
                "CPU median", "late p99", "late max", "CPU late max", "beliefs", "depth");
        Progress progress = run.progress("rounds of decisions", variants.size() * objects.size());
        for (String variant : variants) {
            for (int n : objects) {
                HandoverDomain domain = DomainFiles.load(domain(n, variant));
                List<HandoverBelief> beliefs = BenchBeliefs.of(domain, run.beliefs(), run.seed());
                List<DecisionTimes> all = Contender.parse("--time-solver", solvers).stream()
                        .map(c -> new DecisionTimes(c, domain, beliefs, run.seed(), run.clock())).toList();
                DecisionTimes.measure(all, run.decisions(), run.seconds(), progress::step);
                List<Map<String, Object>> rows = new ArrayList<>();
                int acts = domain.start().acts().size();
                for (DecisionTimes t : all) {
                    Map<String, Object> row = new LinkedHashMap<>(Map.of("variant", variant, "objects", n, "acts", acts));
                    row.putAll(t.row());
                    rows.add(row);
                    add(table, variant, n, acts, t);
                }
                run.report().add(name(), rows);
            }
        }
        progress.end();
        return "Decision times in milliseconds, one thread, the same beliefs for all and in turns; late: beyond the limit after @; "
                + "CPU: without the time in which the thread had no processor; beliefs visited and acts ahead are medians\n\n" + table.text();
    }

    /** A 99th percentile of fewer numbers would be their largest. */
    private static String p99(Spread spread) {
        return spread.count() < ENOUGH_FOR_P99 ? "" : show(spread.p99());
    }

    private static void add(MarkdownTable table, String variant, int n, int acts, DecisionTimes t) {
        String solver = t.contender().name();
        if (!t.measured()) {
            table.add(variant, n, acts, solver, 0, "> " + DecisionTimes.PATIENCE_MS, "", "", "", "", "", "", "", "", "");
            return;
        }
        boolean limited = t.contender().ms() > 0;
        table.add(variant, n, acts, solver, t.decisions(), show(t.ms().median()), show(t.ms().p90()), p99(t.ms()),
                show(t.ms().max()), show(t.work().median()), limited ? p99(t.late()) : "", limited ? show(t.late().max()) : "",
                limited ? show(t.lateAtWork().max()) : "", Math.round(t.nodes().median()),
                Math.round(t.depth().median()));
    }

    /** A time in milliseconds with three digits. */
    static String show(double ms) {
        return String.format(Locale.ROOT, ms < 1 ? "%.3f" : ms < 10 ? "%.2f" : ms < 100 ? "%.1f" : "%.0f", ms);
    }
}
