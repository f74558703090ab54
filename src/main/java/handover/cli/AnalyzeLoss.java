package handover.cli;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.math.Streams;
import handover.simulation.Estimate;
import handover.simulation.EpisodeRunner;
import handover.solver.Deadline;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Solver;
import handover.solver.Solvers;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** What single decisions lose, by the values of a slow reference: tells solvers apart with far fewer samples than returns do. */
@Command(name = "loss", description = {"What single decisions of solvers lose, by the values of a slow reference, and what they cost.",
    "At beliefs before the decisions of episodes that POSS plays."})
final class AnalyzeLoss implements Callable<Integer> {
    private static final String PLAYER = "poss:H=2,C=10";

    @Option(names = "--domain", paramLabel = "NAME|FILE", defaultValue = "bowls-and-spoons",
            description = "What is on the table (default: ${DEFAULT-VALUE}).")
    private String domain;

    @Option(names = "--solver", paramLabel = "SPEC[@MS]", description = "Who decides, with a limit in milliseconds on a processor or several "
            + "(as @5/20/50); repeatable, the first is compared with the others (default: poss:H=1,C=1; poss:H=2,C=10; poss:H=2,C=100; "
            + "poss:H=3,C=5; poss:H=3,C=10; anytime:H=2,C=256; anytime).")
    private List<String> solvers = List.of("poss:H=1,C=1", PLAYER, "poss:H=2,C=100", "poss:H=3,C=5", "poss:H=3,C=10",
            "anytime:H=2,C=256", "anytime");

    @Option(names = "--reference", paramLabel = "SPEC", defaultValue = "poss:H=3,C=30",
            description = "Whose values count; must value every act (default: ${DEFAULT-VALUE}).")
    private String reference;

    @Option(names = "--runs", defaultValue = "2", description = "Runs of the reference that are averaged (default: ${DEFAULT-VALUE}).")
    private int runs;

    @Option(names = "--beliefs", defaultValue = "300", description = "How many beliefs (default: ${DEFAULT-VALUE}).")
    private int beliefs;

    @Option(names = "--warm-up", paramLabel = "SECONDS", defaultValue = "3",
            description = "How long each decides before it is measured: until then Java compiles (default: ${DEFAULT-VALUE}).")
    private double warmUp;

    @Option(names = "--seed", defaultValue = "1", description = "Which beliefs, and which luck (default: ${DEFAULT-VALUE}).")
    private long seed;

    private final Console console;

    AnalyzeLoss(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        UsageException.checkAtLeast("--beliefs", beliefs, 2);
        UsageException.checkAtLeast("--runs", runs, 1);
        HandoverDomain on = DomainFiles.load(domain);
        if (!(warmUp >= 0 && warmUp < Double.POSITIVE_INFINITY)) {
            throw new UsageException("--warm-up: expected seconds of at least 0, got " + warmUp);
        }
        List<Contender> chosen = Contender.parse("--solver", solvers);
        List<HandoverBelief> at = met(on);
        double[][] values = values(on, at);
        TextTable table = new TextTable(40, List.of("solver", "loss [95%]", "more than the first", "ms on a processor", "beliefs/decision"));
        List<Double> first = null;
        for (Contender contender : chosen) {
            Run run = decide(contender, on, at, values);
            table.add(run.cells(first));
            first = first == null ? run.losses : first;
        }
        console.out().printf(Locale.ROOT, "%s, %d beliefs, seed %d; values of %s, mean of %d%n%n%s%nloss: how much less the act is worth "
                + "than the best one, in reward, on average over the beliefs; ms: the middle decision.%n", on.spec().name(), beliefs, seed,
                reference, runs, table.text());
        return Main.FINE;
    }

    private List<HandoverBelief> met(HandoverDomain on) {
        List<HandoverBelief> all = new ArrayList<>();
        Policy player = Solvers.parse(PLAYER).solve(on, Streams.of(seed, "solve", -1));
        Solver noting = new Noting(player, all);
        EpisodeRunner runner = new EpisodeRunner(on, on, noting, seed, EpisodeRunner.STEP_LIMIT, () -> Deadline.NONE, () -> 0);
        for (int k = 0; all.size() < beliefs; k++) {
            runner.play(k);
        }
        return all.subList(0, beliefs);
    }

    /** Writes down at which beliefs it decides. */
    private record Noting(Policy player, List<HandoverBelief> met) implements Solver {
        @Override
        public String name() {
            return "noting";
        }

        @Override
        public Policy solve(HandoverDomain on, RandomGenerator random) {
            return (belief, deadline, chance) -> {
                met.add(belief);
                return player.decide(belief, deadline, chance);
            };
        }
    }

    /** By belief, then act as on the table. */
    private double[][] values(HandoverDomain on, List<HandoverBelief> at) {
        Policy policy = Solvers.parse(reference).solve(on, Streams.of(seed, "solve", 0));
        double[][] values = new double[at.size()][];
        Progress progress = new Progress(console, "beliefs", 0, at.size());
        for (int i = 0; i < values.length; i++) {
            values[i] = new double[at.get(i).scene().acts().size()];
            for (int run = 0; run < runs; run++) {
                Decision decision = policy.decide(at.get(i), Deadline.NONE, Streams.of(seed, "reference " + run, i));
                if (decision.values().size() != values[i].length) {
                    throw new UsageException("--reference: expected a solver that values every act, got " + reference);
                }
                int a = 0;
                for (double value : decision.values().values()) {
                    values[i][a++] += value / runs;
                }
            }
            progress.step();
        }
        progress.end();
        return values;
    }

    /** What one contender did at each belief. */
    private record Run(Contender contender, List<Double> losses, List<Double> ms, long nodes) {
        List<String> cells(List<Double> first) {
            List<Double> sorted = ms.stream().sorted().toList();
            return List.of(contender.name(), interval(losses), first == null ? "" : interval(differences(first)),
                    String.format(Locale.ROOT, "%.2f", sorted.get(sorted.size() / 2)), String.valueOf(nodes / losses.size()));
        }

        private List<Double> differences(List<Double> first) {
            return IntStream.range(0, losses.size()).mapToObj(i -> losses.get(i) - first.get(i)).toList();
        }

        private static String interval(List<Double> values) {
            Estimate mean = Estimate.mean(values);
            return String.format(Locale.ROOT, "%.3f [%.3f, %.3f]", mean.value(), mean.low(), mean.high());
        }
    }

    private Run decide(Contender contender, HandoverDomain on, List<HandoverBelief> at, double[][] values) {
        Policy policy = contender.solver().solve(on, Streams.of(seed, "solve", 0));
        for (long k = 0, start = nanos(); nanos() - start < warmUp * 1e9; k++) {
            decide(policy, contender, at.get((int) (k % at.size())), k);
        }
        List<Double> losses = new ArrayList<>();
        List<Double> ms = new ArrayList<>();
        long nodes = 0;
        for (int i = 0; i < at.size(); i++) {
            HandoverBelief belief = at.get(i);
            long before = nanos();
            Decision decision = decide(policy, contender, belief, i);
            ms.add((nanos() - before) / 1e6);
            nodes += decision.nodes();
            losses.add(max(values[i]) - values[i][index(belief, decision.act())]);
        }
        return new Run(contender, losses, ms, nodes);
    }

    private Decision decide(Policy policy, Contender contender, HandoverBelief belief, long k) {
        return policy.decide(belief, Deadlines.after(contender.ms(), this::nanos).get(), Streams.of(seed, "planner", k));
    }

    private long nanos() {
        return ThreadMeter.nanos(console.nanoClock().getAsLong());
    }

    private static int index(HandoverBelief belief, Act act) {
        return belief.scene().model(act).index();
    }

    private static double max(double[] x) {
        double most = x[0];
        for (double v : x) {
            most = Math.max(most, v);
        }
        return most;
    }
}
