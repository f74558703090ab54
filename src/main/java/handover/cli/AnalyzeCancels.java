package handover.cli;

import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.simulation.Episode;
import handover.simulation.EpisodeRunner;
import handover.simulation.Episodes;
import handover.simulation.Estimate;
import handover.simulation.Reaches;
import handover.simulation.Summary;
import handover.solver.Deadline;
import handover.solver.Solver;
import handover.solver.Solvers;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.function.ToIntFunction;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** What increments are good for: the same people, with and without them. */
@Command(name = "cancels", description = {"What it is worth that a pick takes several increments and can be called off.",
    "Plays the same episodes with the incremental variant and with the base variant at the same parameters."})
final class AnalyzeCancels implements Callable<Integer> {
    @Option(names = "--domain", paramLabel = "NAME|FILE", defaultValue = "bowls-incremental",
            description = "A domain with incremental picks (default: ${DEFAULT-VALUE}).")
    private String domain;

    @Option(names = "--solver", paramLabel = "SPEC", description = "Who decides; repeatable (default: threshold:p=0.9 and poss:H=2,C=10).")
    private List<String> solvers = List.of("threshold:p=0.9", "poss:H=2,C=10");

    @Option(names = "--episodes", defaultValue = "1000", description = "Paired episodes (default: ${DEFAULT-VALUE}).")
    private int episodes;

    @Option(names = "--seed", defaultValue = "1", description = "Seed of the episodes (default: ${DEFAULT-VALUE}).")
    private long seed;

    private final Console console;

    AnalyzeCancels(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws InterruptedException {
        UsageException.checkAtLeast("--episodes", episodes, 2);
        DomainSpec spec = DomainFiles.read(domain);
        HandoverDomain with = DomainFiles.domain(spec);
        if (with.pickRule().increments() < 2) {
            throw new UsageException("--domain: " + spec.name() + " completes a pick at once; expected a domain with increments");
        }
        if (spec.handovers() != 1 || spec.tau() != 1) {
            throw new UsageException("--domain: expected one handover of an object that stays the same (handovers 1, tau 1)");
        }
        List<Solver> chosen = solvers.stream().map(Solvers::parse).toList();
        HandoverDomain without = DomainFiles.domain(spec.with(s -> s.variant = withoutIncrements(spec)));
        TextTable table = new TextTable(40, List.of("solver", "increments", "wrong picks % [95%]", "correct cancels", "false cancels",
                "objections", "heeded", "acts to cancel", "return", "seconds"));
        for (Solver solver : chosen) {
            add(table, solver, with.pickRule().increments(), with);
            add(table, solver, 1, without);
        }
        console.out().print(spec.name() + ", " + episodes + " paired episodes, seed " + seed + "\n\n" + table.text());
        console.out().print("\nwrong picks: share of episodes whose first completed pick was wrong. Cancels: reaches that were called off,"
                + "\nper 1,000 episodes. Objections: reaches for something else during which the person said no, per 1,000 episodes;"
                + "\nheeded: how many of them were called off; acts to cancel: from the no to another act, 1 is at once.\n");
        return Main.FINE;
    }

    /** The shipped variant that differs in nothing but the increments. */
    private static String withoutIncrements(DomainSpec spec) {
        return switch (spec.variant()) {
            case "incremental" -> DomainSpec.BASE;
            case "incremental_communicated" -> "communicated";
            default -> throw new UsageException("--domain: expected the variant incremental or incremental_communicated, got "
                    + spec.variant());
        };
    }

    private void add(TextTable table, Solver solver, int increments, HandoverDomain on) throws InterruptedException {
        List<Episode> played = new ArrayList<>();
        Episodes.play(new EpisodeRunner(on, on, solver, seed, EpisodeRunner.STEP_LIMIT, () -> Deadline.NONE, console.nanoClock()),
                0, episodes, Runtime.getRuntime().availableProcessors(), played::add);
        List<Reaches> reaches = played.stream().map(Reaches::of).toList();
        Estimate wrong = Estimate.share((int) reaches.stream().filter(Reaches::wrong).count(), episodes);
        List<Double> delays = reaches.stream().flatMap(r -> r.stepsToCancel().stream()).map(Integer::doubleValue).toList();
        int objections = reaches.stream().mapToInt(Reaches::objections).sum();
        Summary summary = Summary.of(played);
        table.add(List.of(solver.name(), String.valueOf(increments),
                show("%.1f [%.1f, %.1f]", 100 * wrong.value(), 100 * wrong.low(), 100 * wrong.high()),
                perThousand(reaches, Reaches::correctCancels), perThousand(reaches, Reaches::falseCancels),
                perThousand(reaches, Reaches::objections), objections == 0 ? "-" : show("%.0f%%", 100.0 * delays.size() / objections),
                delays.isEmpty() ? "-" : show("%.2f", delays.stream().mapToDouble(d -> d).average().orElseThrow()),
                show("%.1f+-%.1f", summary.discountedReturn().value(), summary.discountedReturn().half()),
                show("%.1f", summary.seconds().value())));
    }

    private String perThousand(List<Reaches> reaches, ToIntFunction<Reaches> of) {
        return show("%.0f", 1000.0 * reaches.stream().mapToInt(of).sum() / reaches.size());
    }

    private static String show(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
