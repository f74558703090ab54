package handover.cli;

import handover.domain.DomainSpec;
import handover.domain.TableObject;
import handover.io.DomainFiles;
import handover.io.EpisodeLogWriter;
import handover.io.RunHeader;
import handover.simulation.EpisodeRunner;
import handover.simulation.Summary;
import handover.solver.Clairvoyant;
import handover.solver.RandomActs;
import handover.solver.Solver;
import handover.solver.Solvers;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Plays episodes with simulated people and says what each solver was worth. */
@Command(name = "simulate", description = "Play episodes with simulated people; compare solvers in a table; log every step.")
final class Simulate implements Callable<Integer> {
    private static final int MOST_NAMED = 6;
    private static final String NO_LOG = "-";

    @Option(names = "--domain", paramLabel = "NAME|FILE", defaultValue = "bowls-and-spoons",
            description = "What is on the table (default: ${DEFAULT-VALUE}).")
    private String domain;

    @Option(names = "--solver", paramLabel = "SPEC", description = "A solver, several times for several: @|bold NAME|@, "
            + "@|bold NAME:key=value,key=value|@ or a class; see handover plan --help "
            + "(default: clairvoyant, poss:H=2,C=10, confirm, threshold:p=0.9, random).")
    private List<String> solvers = List.of("clairvoyant", "poss:H=2,C=10", "confirm", "threshold:p=0.9", "random");

    @Option(names = "--episodes", defaultValue = "500", description = "Episodes for each solver (default: ${DEFAULT-VALUE}).")
    private int episodes;

    @Option(names = "--seed", defaultValue = "1", description = "The same seed, the same episodes (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(names = "--human", paramLabel = "FILE", description = "People who are not as the robot believes.")
    private Path human;

    @Option(names = "--out", paramLabel = "FILE", defaultValue = "episodes.jsonl",
            description = "Log, - for none (default: ${DEFAULT-VALUE}; with --timed: none).")
    private String out;

    @Option(names = "--resume", description = "Go on with the log of the same run.")
    private boolean resume;

    @Option(names = "--threads", description = "Threads (default: one per processor).")
    private int threads = Runtime.getRuntime().availableProcessors();

    @Option(names = "--deadline-ms", paramLabel = "D", defaultValue = "0",
            description = "Milliseconds for each decision, 0 for no limit (default: ${DEFAULT-VALUE}).")
    private int deadlineMs;

    @Option(names = "--max-steps", paramLabel = "M", defaultValue = "100",
            description = "Acts at which an episode is cut off (default: ${DEFAULT-VALUE}).")
    private int maxSteps;

    @Mixin
    private TimedOptions time;

    private final Console console;

    Simulate(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException, InterruptedException {
        UsageException.checkAtLeast("--episodes", episodes, 1);
        UsageException.checkThreads(threads);
        UsageException.checkAtLeast("--deadline-ms", deadlineMs, 0);
        UsageException.checkAtLeast("--max-steps", maxSteps, 1);
        List<Solver> players = players();
        DomainSpec spec = DomainFiles.read(domain);
        DomainSpec people = human == null ? spec : DomainFiles.readHuman(spec, human);
        RunHeader header = new RunHeader(spec, people, seed, players.stream().map(Solver::name).toList(), episodes, maxSteps,
                deadlineMs, time.timed() ? time.header() : null);
        if (header.time() != null) {
            return playTimed(header, players);
        }
        Run run = new Run(header);
        Map<String, EpisodeRunner> runners = run.runners(players, console);
        try (EpisodeLogWriter log = log(header, run)) {
            console.out().print(introduction(header));
            Progress progress = new Progress(console, "episodes", run.done(), run.total());
            try {
                run.play(runners, threads, log, progress);
            } finally {
                progress.end();
            }
        }
        report(players, run);
        return Main.FINE;
    }

    private int playTimed(RunHeader header, List<Solver> players) throws IOException, InterruptedException {
        out = time.logged() ? out : NO_LOG;
        TimedSimulation simulation = new TimedSimulation(header, players, time.agents(), time.timing(), console);
        try (EpisodeLogWriter log = out.equals(NO_LOG) ? null : new LogFile(Path.of(out), console).create(header)) {
            console.out().print(introduction(header) + time.introduction() + "\n");
            simulation.play(threads, log);
        }
        console.out().print(simulation.report() + whereTheLogIs());
        return Main.FINE;
    }

    private List<Solver> players() {
        List<Solver> players = solvers.stream().map(Solvers::parse).toList();
        Set<String> names = new HashSet<>();
        for (Solver s : players) {
            if (!names.add(s.name())) {
                throw new UsageException("--solver: expected each solver once, got " + s.name() + " twice");
            }
        }
        return players;
    }

    private EpisodeLogWriter log(RunHeader header, Run run) throws IOException {
        if (out.equals(NO_LOG)) {
            if (resume) {
                throw new UsageException("--resume: expected a log to resume, got --out -");
            }
            return null;
        }
        LogFile file = new LogFile(Path.of(out), console);
        return resume ? file.resume(header, run) : file.create(header);
    }

    private static String count(int n, String what) {
        return n + " " + what + (n == 1 ? "" : "s");
    }

    private String introduction(RunHeader header) {
        List<String> names = header.domain().objects().stream().map(TableObject::name).toList();
        String more = names.size() > MOST_NAMED ? " and " + (names.size() - MOST_NAMED) + " more" : "";
        int acts = DomainFiles.domain(header.domain()).start().acts().size();
        return "A robot is to hand a person the object that they want; it does not know which, but sees and hears them.\n"
                + "On the table (domain " + header.domain().name() + "): "
                + names.stream().limit(MOST_NAMED).collect(Collectors.joining(", ")) + more + ".\n"
                + "The robot can do " + acts + " things. " + count(header.solvers().size(), "solver")
                + (header.solvers().size() == 1 ? " plays " : " play ") + count(header.episodes(), "episode")
                + (header.solvers().size() == 1 ? "" : " each, with the same people and the same luck") + ": seed " + header.seed() + ".\n"
                + (header.asModelled() ? "People speak, point and answer as the robot believes that they do.\n"
                        : "People are not as the robot believes, but as in " + human + ".\n")
                + (deadlineMs == 0 ? "" : "A decision takes at most " + deadlineMs
                        + " ms, so that the same seed may give other episodes on another computer.\n") + "\n";
    }

    private void report(List<Solver> players, Run run) {
        console.out().print(ResultTables.summaries(players.stream().map(s -> new ResultTables.Row(
                Summary.of(run.finished().get(s.name())), mark(s))).toList()));
        List<Solver> compared = players.stream().filter(s -> !s.clairvoyant()).toList();
        if (compared.size() > 1) {
            String reference = compared.get(0).name();
            console.out().print("\n" + ResultTables.differences(reference, compared.stream().skip(1)
                    .map(s -> new ResultTables.Difference(s.name(), Summary.returnDifference(
                            run.finished().get(s.name()), run.finished().get(reference)))).toList()));
        }
        console.out().print("\n" + ResultTables.legend());
        if (players.stream().anyMatch(s -> !mark(s).isEmpty())) {
            console.out().print("ceiling     is told what the person wants; floor acts at random\n");
        }
        console.out().print(whereTheLogIs());
    }

    private String whereTheLogIs() {
        return out.equals(NO_LOG) ? "" : "\nEvery step is in " + out + "; handover replay " + out + " checks its beliefs.\n";
    }

    private static String mark(Solver solver) {
        return solver instanceof Clairvoyant ? "ceiling" : solver instanceof RandomActs ? "floor" : "";
    }
}
