package handover.cli;

import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.simulation.Episode;
import handover.simulation.EpisodeRunner;
import handover.simulation.Estimate;
import handover.simulation.Summary;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import picocli.CommandLine.Option;

/**
 * What solvers earn with equal time for each decision: episodes with the same people and the same luck for all, on one thread,
 * played in turns.
 */
final class BenchReturn implements BenchPart {
    private static final int SAVED_EVERY = 25;

    @Option(names = "--domains", split = ",", paramLabel = "NAME|FILE", defaultValue = "bowls-and-spoons,table-line-6-incremental",
            description = "return: domains (default: ${DEFAULT-VALUE}).")
    private List<String> domains;

    @Option(names = "--return-solver", paramLabel = "SPEC[@MS]", description = "return: a solver, with a limit or several; the first "
            + "is compared with the others (default: anytime@20; poss:H=10,C=10@20; the baselines).")
    private List<String> solvers = List.of("anytime@20", "poss:H=10,C=10@20", "qmdp", "confirm", "heuristic", "greedy", "threshold:p=0.9");

    @Option(names = "--episodes", defaultValue = "100", description = "return: episodes of each solver (default: ${DEFAULT-VALUE}).")
    private int episodes;

    @Override
    public String name() {
        return "return";
    }

    @Override
    public void check() {
        UsageException.checkAtLeast("--episodes", episodes, 2);
        Contender.parse("--return-solver", solvers);
        domains.forEach(DomainFiles::read);
    }

    @Override
    public String run(BenchRun run) throws IOException {
        List<Contender> contenders = Contender.parse("--return-solver", solvers);
        MarkdownTable table = new MarkdownTable("domain", "solver", "return", "95%", "first less this", "95%", "right %", "median ms", "p99 ms");
        Progress progress = new Progress(run.console(), "episodes", 0, (long) domains.size() * contenders.size() * episodes);
        for (String name : domains) {
            List<List<Episode>> played = play(name, contenders, run, progress);
            run.report().add(name(), rows(name, contenders, played));
            for (int c = 0; c < played.size(); c++) {
                Summary summary = Summary.of(played.get(c));
                Estimate earned = summary.discountedReturn();
                Estimate less = c == 0 ? null : Summary.returnDifference(played.get(0), played.get(c));
                table.add(name, contenders.get(c).name(), show("%.2f", earned.value()), interval(earned), less == null ? "" : show("%+.2f", less.value()),
                        less == null ? "" : interval(less), show("%.1f", 100 * summary.success().value()), BenchTime.show(1e3 * summary.p50()),
                        BenchTime.show(1e3 * summary.p99()));
            }
        }
        progress.end();
        return "Return over " + episodes + " paired episodes, one thread; the limit of a decision in milliseconds after @\n\n" + table.text();
    }

    /** The episodes of each contender. */
    private List<List<Episode>> play(String name, List<Contender> contenders, BenchRun run, Progress progress) throws IOException {
        HandoverDomain domain = DomainFiles.load(name);
        List<EpisodeRunner> runners = contenders.stream().map(c -> new EpisodeRunner(domain, domain, c.solver(), run.seed(),
                EpisodeRunner.STEP_LIMIT, Deadlines.after(c.ms(), run.clock()), run.clock())).toList();
        List<List<Episode>> played = new ArrayList<>();
        contenders.forEach(c -> played.add(new ArrayList<>()));
        for (int k = 0; k < episodes; k++) {
            for (int c = 0; c < contenders.size(); c++) {
                int turn = (c + k) % contenders.size();
                played.get(turn).add(runners.get(turn).play(k));
                progress.step();
            }
            if ((k + 1) % SAVED_EVERY == 0) {
                run.report().addForNow(name(), rows(name, contenders, played));
            }
        }
        return played;
    }

    private static List<Map<String, Object>> rows(String domain, List<Contender> contenders, List<List<Episode>> played) {
        List<Map<String, Object>> rows = new ArrayList<>();
        for (int c = 0; c < played.size(); c++) {
            Estimate less = c == 0 ? null : Summary.returnDifference(played.get(0), played.get(c));
            rows.add(row(domain, contenders.get(c), Summary.of(played.get(c)), contenders.get(0), less));
        }
        return rows;
    }

    private static Map<String, Object> row(String domain, Contender contender, Summary summary, Contender first, Estimate less) {
        Map<String, Object> row = new LinkedHashMap<>();
        row.put("domain", domain);
        row.put("solver", contender.solver().name());
        row.put("limit_ms", contender.ms() == 0 ? null : contender.ms());
        row.put("episodes", summary.episodes());
        row.put("return", numbers(summary.discountedReturn()));
        if (less != null) {
            row.put("compared_with", first.name());
            row.put("it_earns_more", numbers(less));
        }
        row.put("right_share", numbers(summary.success()));
        row.put("median_ms", 1e3 * summary.p50());
        row.put("p99_ms", 1e3 * summary.p99());
        return row;
    }

    /** Estimate, and the ends of its interval. */
    static List<Double> numbers(Estimate e) {
        return List.of(e.value(), e.low(), e.high());
    }

    static String interval(Estimate e) {
        return show("%.2f", e.low()) + " to " + show("%.2f", e.high());
    }

    static String show(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
