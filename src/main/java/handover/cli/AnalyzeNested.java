package handover.cli;

import handover.domain.DomainSpec;
import handover.domain.HandoverDomain;
import handover.domain.InvalidParameterException;
import handover.domain.PerceptionParameters;
import handover.io.DomainFiles;
import handover.simulation.Episode;
import handover.simulation.EpisodeRunner;
import handover.simulation.Episodes;
import handover.simulation.Estimate;
import handover.simulation.Summary;
import handover.solver.Deadline;
import handover.solver.Solver;
import handover.solver.Solvers;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** What is lost by approximating the belief over the human's belief, and what it is worth to have one. */
@Command(name = "nested", description = {"How well the belief over the human's belief can be represented, and what it is worth.",
    "Compares representations with particles over random dialogues, the robot's filter with more minds, and a planner that knows "
    + "that it may be misperceived with one that takes itself to be understood."})
final class AnalyzeNested implements Callable<Integer> {
    @Option(names = "--domain", paramLabel = "NAME|FILE", defaultValue = "bowls-nested",
            description = "A domain in which acts may be misperceived (default: ${DEFAULT-VALUE}).")
    private String domain;

    @Option(names = "--objects", paramLabel = "N,N", split = ",", description = "Objects of the dialogues (default: as in the domain).")
    private List<Integer> objects = List.of();

    @Option(names = "--dialogues", defaultValue = "100", description = "Dialogues for each line (default: ${DEFAULT-VALUE}).")
    private int dialogues;

    @Option(names = "--particles", defaultValue = "4000", description = "Particles of the reference (default: ${DEFAULT-VALUE}).")
    private int particles;

    @Option(names = "--solver", paramLabel = "SPEC", defaultValue = "poss:H=2,C=10",
            description = "Who decides (default: ${DEFAULT-VALUE}).")
    private String solver;

    @Option(names = "--episodes", defaultValue = "2000", description = "Paired episodes (default: ${DEFAULT-VALUE}).")
    private int episodes;

    @Option(names = "--people", paramLabel = "MISSED/MISREAD,...", split = ",",
            description = "Probabilities of the people that are played with (default: those of the domain, 0.2/0, 0/0.2 and 0.2/0.2).")
    private List<String> people = List.of();

    @Option(names = "--seed", defaultValue = "1", description = "Seed of dialogues and episodes (default: ${DEFAULT-VALUE}).")
    private long seed;

    private final Console console;

    AnalyzeNested(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws InterruptedException {
        UsageException.checkAtLeast("--dialogues", dialogues, 1);
        UsageException.checkAtLeast("--particles", particles, 1);
        UsageException.checkAtLeast("--episodes", episodes, 2);
        for (int n : objects) {
            UsageException.checkAtLeast("--objects", n, 2);
        }
        DomainSpec spec = DomainFiles.read(domain);
        Solver chosen = Solvers.parse(solver);
        if (spec.perception().exact()) {
            throw new UsageException("--domain: in " + spec.name() + " every act is perceived as it is meant; expected perception.missed "
                    + "or perception.misread above 0");
        }
        Set<PerceptionParameters> kinds = kinds(spec.perception());
        List<Integer> sizes = objects.isEmpty() ? List.of(spec.objects().size()) : objects;
        ProjectionTables tables = new ProjectionTables(spec, dialogues, particles, seed, console.nanoClock());
        console.out().print(tables.errors(sizes) + "\n" + tables.counting() + "\n" + tables.costs(sizes) + "\n");
        console.out().print(new FilterTable(spec, dialogues, seed, console.nanoClock()).text() + "\n");
        console.out().print(worth(spec, chosen, kinds));
        return Main.FINE;
    }

    private String worth(DomainSpec spec, Solver chosen, Set<PerceptionParameters> kinds) throws InterruptedException {
        TextTable table = new TextTable(40, List.of("missed", "misread", "modelled", "right %", "questions", "assumed", "right %", "questions",
                "modelled - assumed [95%]"));
        for (PerceptionParameters kind : kinds) {
            HandoverDomain actual = DomainFiles.domain(spec.with(s -> s.perception = kind));
            HandoverDomain assumed = DomainFiles.domain(spec.with(s -> s.perception = spec.perception().with(0, 0)));
            List<Episode> knowing = play(actual, actual, chosen);
            List<Episode> assuming = play(assumed, actual, chosen);
            Summary first = Summary.of(knowing);
            Summary second = Summary.of(assuming);
            Estimate difference = Summary.returnDifference(knowing, assuming);
            table.add(List.of(show("%.2f", kind.missed()), show("%.2f", kind.misread()), show(first.discountedReturn()),
                    show("%.1f", 100 * first.success().value()), show("%.2f", first.questions().value()), show(second.discountedReturn()),
                    show("%.1f", 100 * second.success().value()), show("%.2f", second.questions().value()),
                    show("%+.2f [%.2f, %.2f]", difference.value(), difference.low(), difference.high())));
        }
        return "What it is worth to know: the return of " + chosen.name() + " on " + spec.name() + ", " + episodes + " paired episodes, seed "
                + seed + ".\nmodelled: the robot knows how often its acts are missed and misread; assumed: it takes itself to be understood.\n\n"
                + table.text();
    }

    /** The kinds of people, each once. */
    private Set<PerceptionParameters> kinds(PerceptionParameters own) {
        if (people.isEmpty()) {
            return new LinkedHashSet<>(List.of(own, own.with(0.2, 0), own.with(0, 0.2), own.with(0.2, 0.2)));
        }
        Set<PerceptionParameters> all = new LinkedHashSet<>();
        for (String text : people) {
            int slash = text.indexOf('/');
            try {
                all.add(own.with(Double.parseDouble(text.substring(0, Math.max(0, slash))), Double.parseDouble(text.substring(slash + 1))));
            } catch (NumberFormatException e) {
                throw new UsageException("--people: expected two probabilities, such as 0.1/0.2, got \"" + text + "\"");
            } catch (InvalidParameterException e) {
                throw new UsageException("--people: " + text + ": " + e.getMessage());
            }
        }
        return all;
    }

    private List<Episode> play(HandoverDomain planner, HandoverDomain actual, Solver chosen) throws InterruptedException {
        List<Episode> played = new ArrayList<>();
        Episodes.play(new EpisodeRunner(planner, actual, chosen, seed, EpisodeRunner.STEP_LIMIT, () -> Deadline.NONE, console.nanoClock()),
                0, episodes, Runtime.getRuntime().availableProcessors(), played::add);
        return played;
    }

    private static String show(Estimate e) {
        return show("%.1f+-%.1f", e.value(), e.half());
    }

    private static String show(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
