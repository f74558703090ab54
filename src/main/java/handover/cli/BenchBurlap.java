package handover.cli;

import handover.belief.HandoverBelief;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.math.Streams;
import handover.solver.BurlapSparseSampling;
import handover.solver.Deadline;
import handover.solver.Policy;
import handover.solver.Poss;
import handover.solver.Solver;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Option;

/**
 * How many times longer BURLAP's own BeliefSparseSampling takes than POSS with the same tree at the same beliefs: a ratio for each
 * belief, of times on the processor, so that other programs do not count.
 */
final class BenchBurlap implements BenchPart {
    private static final double WARM_UP_NANOS = 1e9;
    private static final double MS = 1e6;

    @Option(names = "--burlap-domain", paramLabel = "NAME|FILE", defaultValue = "table-line-6",
            description = "burlap: domain (default: ${DEFAULT-VALUE}).")
    private String domain;

    @Option(names = "--trees", split = ",", paramLabel = "HxC", defaultValue = "2x5,3x5",
            description = "burlap: acts ahead and observations for each act (default: ${DEFAULT-VALUE}).")
    private List<String> trees;

    @Option(names = "--burlap-decisions", defaultValue = "1", description = "burlap: decisions for each tree (default: ${DEFAULT-VALUE}).")
    private int decisions;

    @Option(names = "--burlap-seconds", defaultValue = "120",
            description = "burlap: a decision that takes longer is given up (default: ${DEFAULT-VALUE}).")
    private int seconds;

    private record Tree(int horizon, int width) {
        static Tree parse(String text) {
            if (!text.matches("[1-9][0-9]?x[1-9][0-9]{0,3}")) {
                throw new UsageException("--trees: expected acts ahead x observations as 3x5, got \"" + text + "\"");
            }
            String[] parts = text.split("x");
            return new Tree(Integer.parseInt(parts[0]), Integer.parseInt(parts[1]));
        }
    }

    /** How long a decision took, and whether that is all that it would have taken. */
    private record Took(double ms, double cpuMs, boolean whole) {}

    @Override
    public String name() {
        return "burlap";
    }

    @Override
    public void check() {
        UsageException.checkAtLeast("--burlap-decisions", decisions, 1);
        UsageException.checkAtLeast("--burlap-seconds", seconds, 1);
        trees.forEach(Tree::parse);
        DomainFiles.read(domain);
    }

    @Override
    public String run(BenchRun run) throws IOException {
        HandoverDomain on = DomainFiles.load(domain);
        MarkdownTable table = new MarkdownTable("tree", "decisions", "BURLAP ms", "POSS ms", "POSS, leaves 0, ms", "BURLAP / POSS", "smallest", "largest");
        Progress progress = new Progress(run.console(), "decisions of BURLAP", 0, (long) trees.size() * decisions);
        for (String text : trees) {
            Tree tree = Tree.parse(text);
            List<HandoverBelief> beliefs = BenchBeliefs.of(on, decisions, run.seed());
            warmUp(on, tree, beliefs.get(0), run);
            List<Map<String, Object>> rows = new ArrayList<>();
            for (int k = 0; k < decisions; k++) {
                rows.add(row(on, tree, beliefs.get(k), k, run));
                progress.step();
            }
            run.report().add(name(), rows);
            boolean whole = rows.stream().allMatch(r -> (boolean) r.get("burlap_finished"));
            Spread ratio = spread(rows, "ratio");
            String more = whole ? "" : "> ";
            table.add("H=" + tree.horizon + ", C=" + tree.width, decisions, more + BenchTime.show(spread(rows, "burlap_cpu_ms").median()),
                    BenchTime.show(spread(rows, "poss_cpu_ms").median()), BenchTime.show(spread(rows, "poss_leaf_zero_cpu_ms").median()),
                    more + Math.round(ratio.median()), Math.round(ratio.at(0)), Math.round(ratio.max()));
        }
        progress.end();
        return "BURLAP's BeliefSparseSampling and POSS with the same tree at the same beliefs, " + on.spec().name()
                + ", one thread; medians of times on the processor (without those of Java's own threads, which favours BURLAP)\n\n" + table.text();
    }

    private static Spread spread(List<Map<String, Object>> rows, String key) {
        return new Spread(rows.stream().map(r -> (Double) r.get(key)).toList());
    }

    private Map<String, Object> row(HandoverDomain on, Tree tree, HandoverBelief belief, int k, BenchRun run) {
        List<DecisionTimes> poss = List.of(times(new Poss(tree.horizon, tree.width, true), on, belief, run),
                times(new Poss(tree.horizon, tree.width, false), on, belief, run));
        DecisionTimes.measure(poss, run.decisions(), run.seconds(), () -> {});
        Took burlap = burlap(on, tree, belief, k, seconds, run);
        double fast = poss.get(0).work().median();
        Map<String, Object> row = new LinkedHashMap<>();
        row.put("domain", on.spec().name());
        row.put("H", tree.horizon);
        row.put("C", tree.width);
        row.put("burlap_ms", burlap.ms);
        row.put("burlap_cpu_ms", burlap.cpuMs);
        row.put("burlap_finished", burlap.whole);
        row.put("poss_ms", poss.get(0).ms().median());
        row.put("poss_cpu_ms", fast);
        row.put("poss_leaf_zero_cpu_ms", poss.get(1).work().median());
        row.put("ratio", burlap.cpuMs / fast);
        return row;
    }

    private static DecisionTimes times(Solver solver, HandoverDomain on, HandoverBelief belief, BenchRun run) {
        return new DecisionTimes(new Contender(solver, 0), on, List.of(belief), run.seed(), run.clock());
    }

    /** Small trees, until Java has compiled what they need. */
    private static void warmUp(HandoverDomain on, Tree tree, HandoverBelief belief, BenchRun run) {
        long start = run.console().nanoClock().getAsLong();
        Tree small = new Tree(Math.max(1, tree.horizon - 1), tree.width);
        for (int k = 0; run.console().nanoClock().getAsLong() - start < WARM_UP_NANOS; k++) {
            burlap(on, small, belief, k, 1, run);
        }
    }

    private static Took burlap(HandoverDomain on, Tree tree, HandoverBelief belief, int k, int seconds, BenchRun run) {
        Policy policy = new BurlapSparseSampling(tree.horizon, tree.width).solve(on, Streams.of(run.seed(), "solve", 0));
        Deadline limit = Deadlines.after(1000 * seconds, run.console().nanoClock()).get();
        long start = run.console().nanoClock().getAsLong();
        long worked = ThreadMeter.nanos(0);
        boolean whole = true;
        try {
            policy.decide(belief, Deadline.NONE, new LimitedChance(Streams.of(run.seed(), "planner", k), limit));
        } catch (LimitedChance.TimeIsUpException e) {
            whole = false;
        }
        long nanos = run.console().nanoClock().getAsLong() - start;
        return new Took(nanos / MS, Math.min(nanos, ThreadMeter.nanos(nanos) - worked) / MS, whole);
    }
}
