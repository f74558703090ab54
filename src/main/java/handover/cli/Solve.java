package handover.cli;

import handover.io.PomdpFiles;
import handover.math.Streams;
import handover.simulation.Estimate;
import handover.simulation.OrderedUnits;
import handover.solver.Deadline;
import handover.tabular.TabularDecision;
import handover.tabular.TabularEpisodes;
import handover.tabular.TabularPolicy;
import handover.tabular.TabularPomdp;
import handover.tabular.TabularSolver;
import handover.tabular.TabularSolvers;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Solves any POMDP of a standard file and says what each solver was worth. */
@Command(name = "solve", description = "Solve a .POMDP file: bounds on its value, and what solvers earn in episodes.")
final class Solve implements Callable<Integer> {
    private static final int LONGEST_NAME = 40;
    /** What comes after an episode is cut off is worth less than this share. */
    private static final double TAIL = 1e-4;

    @Parameters(paramLabel = "FILE", description = "A .POMDP file, in Cassandra's format.")
    private Path file;

    @Option(names = "--solver", paramLabel = "SPEC", description = "A solver, several times for several, see below (default: anytime, qmdp, random).")
    private List<String> solvers = List.of("anytime", "qmdp", "random");

    @Option(names = "--episodes", defaultValue = "1000", description = "Episodes for each solver (default: ${DEFAULT-VALUE}).")
    private int episodes;

    @Option(names = "--seed", defaultValue = "1", description = "The same seed, the same episodes (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(names = "--threads", description = "Threads (default: one per processor).")
    private int threads = Runtime.getRuntime().availableProcessors();

    @Option(names = "--deadline-ms", paramLabel = "D", defaultValue = "0",
            description = "Milliseconds for each decision, 0 for no limit (default: ${DEFAULT-VALUE}).")
    private int deadlineMs;

    @Option(names = "--max-steps", paramLabel = "M", defaultValue = "0", description = "Acts at which an episode is cut off "
            + "(default: so many that the discount leaves 0.0001 of what comes later).")
    private int maxSteps;

    private final Console console;

    Solve(Console console) {
        this.console = console;
    }

    /** Help ends with the solvers that there are. */
    @Spec
    void describe(CommandSpec spec) {
        SolverList.append(spec, TabularSolvers.names(), TabularSolvers::description);
    }

    @Override
    public Integer call() throws InterruptedException {
        UsageException.checkAtLeast("--episodes", episodes, 1);
        UsageException.checkThreads(threads);
        UsageException.checkAtLeast("--deadline-ms", deadlineMs, 0);
        UsageException.checkAtLeast("--max-steps", maxSteps, 0);
        List<TabularSolver> players = players();
        TabularPomdp pomdp = PomdpFiles.read(file);
        int steps = maxSteps == 0 ? TabularEpisodes.horizon(pomdp.discount(), TAIL) : maxSteps;
        console.out().printf(Locale.ROOT, "%s: %d states, %d acts, %d observations, discount %s%n%d episodes of at most %d acts, seed %d%n%n",
                file, pomdp.states().size(), pomdp.acts().size(), pomdp.observations().size(), pomdp.discount(), episodes, steps, seed);
        TextTable table = table(players, pomdp);
        console.out().print(table.text());
        long unforeseen = 0;
        Progress progress = new Progress(console, "episodes", 0, (long) episodes * players.size());
        try {
            for (TabularSolver player : players) {
                unforeseen += play(player, pomdp, steps, table, progress);
            }
        } finally {
            progress.end();
        }
        console.out().print("""

                return        sum of rewards, those of each later step counting less: the mean over the episodes
                worth         what the solver can promise at the start: the value of the best policy lies in between
                """);
        console.out().print(unforeseen == 0 ? "" : unforeseen + " observations were of probability 0 and only moved the belief on\n");
        return Main.FINE;
    }

    /** Only its header; wide enough for most rows, because each is printed when it is known. */
    private static TextTable table(List<TabularSolver> players, TabularPomdp pomdp) {
        return new TextTable(LONGEST_NAME, List.of("solver", "return", "95% interval", "worth at least", "at most", "steps", "offline s",
                "ms p50/p99", "first act"), new int[] {longest(players.stream().map(TabularSolver::name)), 8, 20, 0, 8, 6, 0, 13,
                    longest(pomdp.acts().stream())});
    }

    private static int longest(Stream<String> texts) {
        return texts.mapToInt(String::length).max().orElse(0);
    }

    private List<TabularSolver> players() {
        List<TabularSolver> players = solvers.stream().map(TabularSolvers::parse).toList();
        Set<String> names = new HashSet<>();
        for (TabularSolver s : players) {
            if (!names.add(s.name())) {
                throw new UsageException("--solver: expected each solver once, got " + s.name() + " twice");
            }
        }
        return players;
    }

    /** Adds and prints a row, and gives the number of unforeseen observations. */
    private long play(TabularSolver player, TabularPomdp pomdp, int steps, TextTable table, Progress progress)
            throws InterruptedException {
        long before = console.nanoClock().getAsLong();
        progress.note(player.name() + " is solving the model");
        TabularPolicy policy = solved(player, pomdp);
        double offline = (console.nanoClock().getAsLong() - before) / 1e9;
        Supplier<Deadline> deadlines = Deadlines.after(deadlineMs, console.nanoClock());
        TabularDecision first = policy.decide(pomdp.start(), deadlines.get(), Streams.of(seed, "planner", 0));
        TabularEpisodes game = new TabularEpisodes(pomdp, policy, seed, steps, deadlines, console.nanoClock());
        List<TabularEpisodes.Outcome> played = new ArrayList<>();
        OrderedUnits.until(0, episodes, threads, game::play, e -> {
            played.add(e);
            progress.step();
            return false;
        });
        Estimate mean = Estimate.mean(played.stream().map(TabularEpisodes.Outcome::discountedReturn).toList());
        double acts = played.stream().mapToInt(TabularEpisodes.Outcome::steps).average().orElse(0);
        long[] nanos = played.stream().flatMapToLong(e -> Arrays.stream(e.decisionNanos())).sorted().toArray();
        table.add(List.of(player.name(), number(mean.value()), Double.isInfinite(mean.half()) ? "unknown"
                : number(mean.low()) + " to " + number(mean.high()), number(first.lower()), number(first.upper()),
                String.format(Locale.ROOT, "%.1f", acts), String.format(Locale.ROOT, "%.1f", offline),
                milliseconds(nanos, 0.5) + "/" + milliseconds(nanos, 0.99), pomdp.acts().get(first.act())));
        progress.end();
        console.out().print(table.lastLine());
        return played.stream().mapToLong(TabularEpisodes.Outcome::unforeseen).sum();
    }

    private TabularPolicy solved(TabularSolver player, TabularPomdp pomdp) {
        try {
            return player.solve(pomdp, Streams.of(seed, "solve", 0));
        } catch (IllegalArgumentException e) {
            throw new UsageException("--solver: " + player.name() + ": " + e.getMessage());
        }
    }

    private static String number(double x) {
        return Double.isNaN(x) ? "-" : String.format(Locale.ROOT, "%.3f", x);
    }

    private static String milliseconds(long[] sorted, double p) {
        return sorted.length == 0 ? "-" : String.format(Locale.ROOT, "%.3f", sorted[(int) Math.max(0, Math.ceil(p * sorted.length) - 1)] / 1e6);
    }
}
