package handover.cli;

import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.io.PointJournal;
import handover.io.PolicyFile;
import handover.io.PolicyRun;
import handover.simulation.OrderedUnits;
import handover.solver.BeliefMetric;
import handover.solver.PolicyTable;
import handover.solver.Solver;
import handover.solver.Solvers;
import handover.solver.StoredBelief;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Decides ahead of time at beliefs that will be met, for {@code --solver nearest:FILE}. */
@Command(name = "precompute", description = {"Decide ahead of time at beliefs that will be met, for --solver nearest:FILE.",
    "May be stopped at any time, also by force: the same command goes on where it was (FILE.partial), and the result is the same.",
    "nearest:FILE[,k=8][,radius=0.1|inf][,fallback=SOLVER]: up to k stored beliefs within the radius vote; else the fallback "
            + "decides, which is the teacher unless another one is named."})
final class Precompute implements Callable<Integer> {
    @Parameters(paramLabel = "DOMAIN", description = "Name or file of the domain.")
    private String domain;

    @Option(names = "--teacher", paramLabel = "SPEC", defaultValue = "poss:H=2,C=10",
            description = "Whose decisions are stored (default: ${DEFAULT-VALUE}).")
    private String teacher;

    @Option(names = "--beliefs", paramLabel = "N", defaultValue = "100000", description = "How many (default: ${DEFAULT-VALUE}).")
    private int beliefs;

    @Option(names = "--out", paramLabel = "FILE", description = "Where they go (default: DOMAIN.policy).")
    private Path out;

    @Option(names = "--seed", defaultValue = "1", description = "The same seed, the same policy (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(names = "--point-ms", paramLabel = "D", defaultValue = "0", description = "Milliseconds for each belief, 0 for no limit; "
            + "with a limit the result depends on the computer (default: ${DEFAULT-VALUE}).")
    private int pointMs;

    @Option(names = "--human", paramLabel = "FILE", description = "Other people to meet; repeatable (default: quiet ones, sloppy "
            + "pointers and contrary ones).")
    private List<Path> humans = List.of();

    @Option(names = "--threads", description = "Threads (default: one per processor).")
    private int threads = Runtime.getRuntime().availableProcessors();

    private final Console console;

    Precompute(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException, InterruptedException {
        UsageException.checkAtLeast("--beliefs", beliefs, 1);
        UsageException.checkAtLeast("--point-ms", pointMs, 0);
        UsageException.checkThreads(threads);
        Solver solver = Solvers.parse(teacher);
        if (solver.clairvoyant()) {
            throw new UsageException("--teacher: " + solver.name() + " is told what the person wants, which nobody knows later");
        }
        DomainSpec spec = DomainFiles.read(domain);
        List<DomainSpec> people = humans.isEmpty() ? OtherPeople.of(spec)
                : humans.stream().map(h -> DomainFiles.readHuman(spec, h)).toList();
        Path file = out == null ? Path.of(spec.name() + ".policy") : out;
        PolicyRun run = PolicyRun.of(spec, solver.name(), pointMs, beliefs, seed, people);
        Path partial = file.resolveSibling(file.getFileName() + ".partial");
        if (!finished(file, run)) {
            make(file, partial, run, new BeliefSampling(DomainFiles.domain(spec), domains(people), solver, seed,
                    Deadlines.after(pointMs, console.nanoClock()), console.nanoClock()));
        }
        Files.deleteIfExists(partial);
        return Main.FINE;
    }

    private static List<HandoverDomain> domains(List<DomainSpec> people) {
        return people.stream().map(DomainFiles::domain).toList();
    }

    /** Whether the file is this run's; throws rather than replace anything else. */
    private boolean finished(Path file, PolicyRun run) throws IOException {
        if (!Files.exists(file)) {
            return false;
        }
        if (!PolicyFile.looksLikePolicy(file)) {
            throw new UsageException(file + ": is not a policy file and will not be overwritten; choose another --out");
        }
        String different = PolicyFile.read(file).run().differences(run);
        if (!different.isEmpty()) {
            throw new UsageException(file + ": is the policy of another run (" + different
                    + ") and will not be overwritten; delete it or choose another --out");
        }
        console.out().println(file + " is finished already; nothing to do.");
        return true;
    }

    private void make(Path file, Path partial, PolicyRun run, BeliefSampling sampling) throws IOException, InterruptedException {
        PolicyTable.Builder builder = new PolicyTable.Builder(BeliefMetric.DEFAULT, beliefs);
        try (PointJournal journal = PointJournal.open(partial, run, unit -> unit.forEach(builder::add))) {
            if (journal.units() > 0) {
                console.err().println("going on with " + partial + ": " + builder.size() + " of " + beliefs + " beliefs are solved");
            }
            if (builder.size() < beliefs) {
                solve(sampling, journal, builder);
            }
            PolicyFile policy = new PolicyFile(run, builder.build());
            policy.write(file);
            report(file, policy, journal.units(), sampling.symmetries());
        }
    }

    private void solve(BeliefSampling sampling, PointJournal journal, PolicyTable.Builder builder) throws InterruptedException {
        Progress progress = new Progress(console, "beliefs", builder.size(), beliefs);
        try {
            OrderedUnits.<List<StoredBelief>>until(journal.units(), Integer.MAX_VALUE, threads, sampling::unit, unit -> {
                journal.add(unit);
                unit.forEach(builder::add);
                progress.at(builder.size());
                return builder.size() == beliefs;
            });
        } finally {
            progress.end();
        }
    }

    private void report(Path file, PolicyFile policy, int units, int symmetries) throws IOException {
        List<String> lines = new ArrayList<>();
        lines.add(String.format(Locale.ROOT, "%s: %d beliefs from %d episodes, decided by %s, in %d parts; %.1f MB", file,
                policy.table().size(), units - 1, policy.run().teacher(), policy.table().parts().size(), Files.size(file) / 1e6));
        lines.add(symmetries == 1 ? "No two objects can be swapped: positions or words tell them apart."
                : "Objects can be swapped: each belief serves " + symmetries + " permutations.");
        lines.add("Use it with: handover simulate --domain " + domain + " --solver nearest:" + file);
        lines.forEach(console.out()::println);
    }
}
