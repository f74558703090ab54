package handover.cli;

import handover.domain.CommunicatedParameters;
import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.PickType;
import handover.domain.Rewards;
import handover.domain.WaitType;
import handover.io.DomainFiles;
import handover.io.NamedOutput;
import handover.math.MatchScore;
import handover.math.Simplex;
import handover.simulation.BestExpectation;
import handover.simulation.Episode;
import handover.simulation.EpisodeRunner;
import handover.simulation.Episodes;
import handover.simulation.Estimate;
import handover.simulation.Summary;
import handover.solver.Deadline;
import handover.solver.Solver;
import handover.solver.Solvers;
import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** The argument of the report's section 2.3, in numbers. */
@Command(name = "reward", description = {"What each match reward wants the human to believe, and how much it makes the robot communicate.",
    "Writes for a grid of beliefs b the h that maximises each score (CSV), then plays episodes under each reward."})
final class AnalyzeReward implements Callable<Integer> {
    private static final int MOST_BELIEFS = 100_000;

    @Option(names = "--domain", paramLabel = "NAME|FILE", defaultValue = "bowls-and-spoons",
            description = "What is on the table (default: ${DEFAULT-VALUE}).")
    private String domain;

    @Option(names = "--solver", paramLabel = "SPEC", defaultValue = "poss:H=2,C=10",
            description = "Who decides (default: ${DEFAULT-VALUE}).")
    private String solver;

    @Option(names = "--episodes", defaultValue = "1000", description = "Episodes for each reward, on the same seeds (default: ${DEFAULT-VALUE}).")
    private int episodes;

    @Option(names = "--objects", defaultValue = "3", description = "Objects of the grid of beliefs (default: ${DEFAULT-VALUE}).")
    private int objects;

    @Option(names = "--grid", defaultValue = "10", description = "The grid's beliefs are multiples of 1/GRID (default: ${DEFAULT-VALUE}).")
    private int grid;

    @Option(names = "--seed", defaultValue = "1", description = "Seed of the episodes (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(names = "--csv", paramLabel = "FILE", defaultValue = "reward-analysis.csv", description = "Where the grid goes (default: ${DEFAULT-VALUE}).")
    private Path csv;

    private final Console console;

    AnalyzeReward(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException, InterruptedException {
        UsageException.checkAtLeast("--episodes", episodes, 2);
        UsageException.checkAtLeast("--objects", objects, 2);
        UsageException.checkAtLeast("--grid", grid, 1);
        checkGrid();
        DomainSpec spec = DomainFiles.read(domain);
        Solver chosen = Solvers.parse(solver);
        console.out().print(bestExpectations());
        console.out().println("\nThe grid is in " + csv + ".\n");
        console.out().print(communication(spec, chosen));
        return Main.FINE;
    }

    /** There are (grid + objects - 1) over (objects - 1) ways to share out the parts of the grid. */
    private void checkGrid() {
        double beliefs = 1;
        for (int k = 1; k < objects && beliefs <= MOST_BELIEFS; k++) {
            beliefs *= (double) (grid + k) / k;
        }
        if (beliefs > MOST_BELIEFS) {
            throw new UsageException("--objects, --grid: expected at most " + MOST_BELIEFS + " beliefs in the grid, got more with "
                    + objects + " objects and multiples of 1/" + grid);
        }
    }

    /** Writes the grid; gives a table of how far the best h is from b and from a vertex. */
    private String bestExpectations() throws IOException {
        TextTable table = new TextTable(40, List.of("score", "mean |h* - b|", "mean largest h*"));
        try (BufferedWriter out = NamedOutput.text(csv)) {
            out.write("score," + header("b") + "," + header("h") + ",value,distance\n");
            for (MatchScore score : MatchScore.values()) {
                List<double[]> beliefs = score == MatchScore.NONE ? List.of() : simplex(objects, grid);
                double distance = 0;
                double largest = 0;
                for (double[] b : beliefs) {
                    double[] h = BestExpectation.of(score, b);
                    double off = Simplex.l1(b, h);
                    out.write(name(score) + "," + row(b) + "," + row(h) + "," + show("%.6f", score.of(b, h, b.length)) + "," + show("%.6f", off) + "\n");
                    distance += off / beliefs.size();
                    largest += h[Simplex.argmax(h, h.length)] / beliefs.size();
                }
                if (!beliefs.isEmpty()) {
                    table.add(List.of(name(score), show("%.4f", distance), show("%.4f", largest)));
                }
            }
        }
        return "What each score wants the human to believe (h*), over a grid of beliefs b of " + objects + " objects:\n\n" + table.text();
    }

    /** All multiples of 1/grid that sum to one, but for ties at the top, where the linear score has no single best h. */
    private static List<double[]> simplex(int n, int grid) {
        List<double[]> all = new ArrayList<>();
        fill(new int[n], 0, grid, grid, all);
        return all;
    }

    private static void fill(int[] parts, int k, int left, int grid, List<double[]> all) {
        if (k == parts.length - 1) {
            parts[k] = left;
            double[] b = Arrays.stream(parts).mapToDouble(p -> (double) p / grid).toArray();
            int best = Simplex.argmax(b, b.length);
            if (DoubleStream.of(b).filter(p -> p == b[best]).count() == 1) {
                all.add(b);
            }
            return;
        }
        for (int p = 0; p <= left; p++) {
            parts[k] = p;
            fill(parts, k + 1, left - p, grid, all);
        }
    }

    private String communication(DomainSpec spec, Solver chosen) throws InterruptedException {
        TextTable table = new TextTable(40, List.of("reward", "communicative acts", "more than base", "asks", "points", "looks", "success %", "seconds"));
        List<Episode> base = null;
        for (Map.Entry<String, DomainSpec> reward : rewards(spec).entrySet()) {
            HandoverDomain on = DomainFiles.domain(reward.getValue());
            List<Episode> played = new ArrayList<>();
            Episodes.play(new EpisodeRunner(on, on, chosen, seed, EpisodeRunner.STEP_LIMIT, () -> Deadline.NONE, console.nanoClock()),
                    0, episodes, Runtime.getRuntime().availableProcessors(), played::add);
            base = base == null ? played : base;
            List<Double> difference = new ArrayList<>();
            for (int k = 0; k < episodes; k++) {
                difference.add(communicative(played.get(k)) - communicative(base.get(k)));
            }
            Summary summary = Summary.of(played);
            table.add(List.of(reward.getKey(), show(Estimate.mean(played.stream().map(AnalyzeReward::communicative).toList()), 2),
                    played == base ? "" : show(Estimate.mean(difference), 2), perEpisode(played, "ASK"), perEpisode(played, "POINT"),
                    perEpisode(played, "LOOK"), show("%.1f", 100 * summary.success().value()), show(summary.seconds(), 1)));
        }
        return "Communicative acts per episode under each reward, " + chosen.name() + ", " + episodes + " episodes each on the same seeds:\n\n" + table.text();
    }

    /** Name of a reward to the domain that pays it; the first is the base domain's. */
    private static Map<String, DomainSpec> rewards(DomainSpec spec) {
        Map<String, DomainSpec> all = new LinkedHashMap<>();
        all.put("base, brier", scored(spec, MatchScore.BRIER));
        for (MatchScore score : List.of(MatchScore.NONE, MatchScore.LOG, MatchScore.LINEAR, MatchScore.KL)) {
            all.put("base, " + name(score), scored(spec, score));
        }
        for (MatchScore score : List.of(MatchScore.LINEAR, MatchScore.BRIER, MatchScore.LOG)) {
            all.put("communicated, 3 x " + name(score), spec.with(s -> {
                s.variant = "communicated";
                s.communicated = new CommunicatedParameters(3, score);
            }));
        }
        return all;
    }

    private static DomainSpec scored(DomainSpec spec, MatchScore score) {
        return spec.with(s -> {
            s.variant = DomainSpec.BASE;
            s.rewards = new Rewards(spec.rewards().right(), spec.rewards().wrong(), spec.rewards().annoyance(), 1, score,
                    spec.rewards().discount());
        });
    }

    private static double communicative(Episode e) {
        return e.steps().stream().filter(s -> !s.act().verb().equals(WaitType.VERB) && !s.act().verb().equals(PickType.VERB)).count();
    }

    private static String perEpisode(List<Episode> played, String verb) {
        long count = played.stream().flatMap(e -> e.steps().stream()).filter(s -> s.act().verb().equals(verb)).count();
        return show("%.2f", (double) count / played.size());
    }

    private static String name(MatchScore score) {
        return score.name().toLowerCase(Locale.ROOT);
    }

    private String header(String letter) {
        return IntStream.rangeClosed(1, objects).mapToObj(i -> letter + i).collect(Collectors.joining(","));
    }

    private static String row(double[] p) {
        return DoubleStream.of(p).mapToObj(x -> show("%.6f", x)).collect(Collectors.joining(","));
    }

    private static String show(Estimate e, int digits) {
        return show("%." + digits + "f+-%." + digits + "f", e.value(), e.half());
    }

    private static String show(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
