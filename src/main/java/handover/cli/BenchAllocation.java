package handover.cli;

import handover.belief.HandoverBelief;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Option;

/**
 * How much a decision allocates, and how much more for each further belief that it visits: from two budgets of the same solver, so
 * that what every decision allocates once does not count.
 */
final class BenchAllocation implements BenchPart {
    @Option(names = "--allocation-domain", paramLabel = "NAME|FILE", defaultValue = "table-line-6",
            description = "allocation: domain (default: ${DEFAULT-VALUE}).")
    private String domain;

    @Option(names = "--allocation-solver", paramLabel = "SPEC[@MS]", description = "allocation: a solver; give each with a small and a "
            + "large budget (default: poss:H=2,C=5; poss:H=2,C=20; anytime@5/20; qmdp; confirm).")
    private List<String> solvers = List.of("poss:H=2,C=5", "poss:H=2,C=20", "anytime@5/20", "qmdp", "confirm");

    @Override
    public String name() {
        return "allocation";
    }

    @Override
    public void check() {
        Contender.parse("--allocation-solver", solvers);
        DomainFiles.read(domain);
    }

    @Override
    public String run(BenchRun run) throws IOException {
        if (ThreadMeter.bytes() < 0) {
            return "Allocation: this Java does not count what threads allocate.\n";
        }
        HandoverDomain on = DomainFiles.load(domain);
        List<HandoverBelief> beliefs = BenchBeliefs.of(on, run.beliefs(), run.seed());
        List<DecisionTimes> all = Contender.parse("--allocation-solver", solvers).stream()
                .map(c -> new DecisionTimes(c, on, beliefs, run.seed(), run.clock())).toList();
        Progress progress = run.progress("rounds of decisions", 1);
        DecisionTimes.measure(all, run.decisions(), run.seconds(), progress::step);
        progress.end();
        List<DecisionTimes> measured = all.stream().filter(DecisionTimes::measured).toList();
        MarkdownTable table = new MarkdownTable("solver", "decisions", "bytes", "beliefs", "bytes for each further belief");
        List<Map<String, Object>> rows = new ArrayList<>();
        for (DecisionTimes t : measured) {
            Double more = perBelief(t, measured);
            Map<String, Object> row = new LinkedHashMap<>(Map.of("domain", on.spec().name()));
            row.putAll(t.row());
            row.put("bytes_per_further_node", more);
            rows.add(row);
            table.add(t.contender().name(), t.decisions(), Math.round(t.bytes().median()), Math.round(t.nodes().median()),
                    more == null ? "" : BenchReturn.show("%.3f", more));
        }
        run.report().add(name(), rows);
        return "Bytes that a decision allocates on its thread, " + on.spec().name() + "; medians\n\n" + table.text();
    }

    /** Against the smallest budget of the same kind of solver; null for that itself. */
    private static Double perBelief(DecisionTimes t, List<DecisionTimes> all) {
        DecisionTimes least = all.stream().filter(o -> kind(o).equals(kind(t)))
                .min((a, b) -> Double.compare(a.nodes().median(), b.nodes().median())).orElseThrow();
        double nodes = t.nodes().median() - least.nodes().median();
        return nodes > 0 ? (t.bytes().median() - least.bytes().median()) / nodes : null;
    }

    private static String kind(DecisionTimes t) {
        return t.contender().solver().name().split(":", 2)[0];
    }
}
