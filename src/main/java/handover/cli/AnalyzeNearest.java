package handover.cli;

import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.io.NamedOutput;
import handover.io.Nearest;
import handover.io.PolicyFile;
import handover.solver.Solver;
import handover.solver.Solvers;
import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** The learning curve of a precomputed policy. */
@Command(name = "nearest", description = {"What a precomputed policy is worth with more and more stored beliefs, against its teacher.",
    "Uses the first N beliefs of a file; writes a CSV and prints a table."})
final class AnalyzeNearest implements Callable<Integer> {
    @Option(names = "--domain", paramLabel = "NAME|FILE", defaultValue = "bowls-and-spoons",
            description = "What is on the table (default: ${DEFAULT-VALUE}).")
    private String domain;

    @Option(names = "--policy", paramLabel = "FILE", required = true, description = "Made by handover precompute.")
    private Path policy;

    @Option(names = "--sizes", paramLabel = "N,N", split = ",", description = "How many beliefs (default: 100, 1000, 10000, ... and all).")
    private List<Integer> sizes = List.of();

    @Option(names = "--neighbours", paramLabel = "K", description = "How many vote (default: ${DEFAULT-VALUE}).")
    private int neighbours = Nearest.NEIGHBOURS;

    @Option(names = "--radius", paramLabel = "R", description = "Beyond which the teacher decides (default: ${DEFAULT-VALUE}).")
    private double radius = Nearest.RADIUS;

    @Option(names = "--episodes", defaultValue = "1000", description = "Paired episodes for each point (default: ${DEFAULT-VALUE}).")
    private int episodes;

    @Option(names = "--seed", defaultValue = "1", description = "Seed of the episodes (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(names = "--csv", paramLabel = "FILE", defaultValue = "nearest-curve.csv", description = "Where the numbers go (default: ${DEFAULT-VALUE}).")
    private Path csv;

    private final Console console;

    AnalyzeNearest(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException, InterruptedException {
        UsageException.checkAtLeast("--episodes", episodes, 2);
        UsageException.checkAtLeast("--neighbours", neighbours, 1);
        if (!(radius >= 0)) {
            throw new UsageException("--radius: expected a distance of at least 0, got " + radius);
        }
        HandoverDomain on = DomainFiles.load(domain);
        PolicyFile file = PolicyFile.read(policy, on.spec());
        Iterable<Integer> chosen = sizes(file.table().size());
        Solver teacher = Solvers.parse(file.run().teacher());
        try (BufferedWriter out = NamedOutput.text(csv)) {
            out.write(LearningCurve.Point.CSV_HEADER + "\n");
            out.flush(); // whether it can be written shows before the long work
            LearningCurve curve = new LearningCurve(on, file.table(), teacher, neighbours, radius, episodes, seed, console.nanoClock());
            console.out().printf(Locale.ROOT, "%s, teacher %s: return %s, agrees with itself at %.1f%% of %d beliefs; %d paired episodes%n%n",
                    on.spec().name(), teacher.name(), LearningCurve.show(curve.teacherReturn()), 100 * curve.teacherAgreement(),
                    curve.beliefs(), episodes);
            console.out().print(points(curve, chosen, out));
        }
        console.out().print("\nreturn: nothing but the table, however far the nearest belief (where its part is empty the teacher decides);"
                + "\nwith fallback: the teacher decides where no stored belief is within " + radius + "; fallback %: how often, at the"
                + "\nbeliefs of the teacher's episodes. +-: half of a 95% interval. The numbers are in " + csv + ".\n");
        return Main.FINE;
    }

    /** Writes the points of the curve; gives them as a table. */
    private static String points(LearningCurve curve, Iterable<Integer> sizes, BufferedWriter out) throws IOException, InterruptedException {
        TextTable table = new TextTable(10, List.of("beliefs", "return", "less than teacher", "% of it", "agrees %", "with fallback",
                "less than teacher", "% of it", "fallback %", "lookup us p50", "p99"));
        for (int size : sizes) {
            LearningCurve.Point point = curve.at(size);
            out.write(point.csv() + "\n");
            table.add(point.cells());
        }
        return table.text();
    }

    private Iterable<Integer> sizes(int all) {
        TreeSet<Integer> chosen = new TreeSet<>(sizes);
        if (sizes.isEmpty()) {
            Stream.iterate(100, n -> n < all, n -> n * 10).forEach(chosen::add);
            chosen.add(all);
        } else if (chosen.first() < 1 || chosen.last() > all) {
            throw new UsageException("--sizes: expected numbers from 1 to " + all + ", which the file has, got " + sizes);
        }
        return chosen;
    }
}
