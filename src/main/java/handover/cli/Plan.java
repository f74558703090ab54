package handover.cli;

import handover.belief.HandoverBelief;
import handover.domain.Act;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.Scene;
import handover.io.DomainFiles;
import handover.io.ObjectProbabilities;
import handover.io.Replies;
import handover.math.Simplex;
import handover.math.Streams;
import handover.solver.Decision;
import handover.solver.Policy;
import handover.solver.Solver;
import handover.solver.Solvers;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Makes one decision and says why. */
@Command(name = "plan", description = "Make one decision and show what each act is worth.")
final class Plan implements Callable<Integer> {
    private static final int SHOWN = 10;

    @Option(names = "--domain", paramLabel = "NAME|FILE", defaultValue = "bowls-and-spoons",
            description = "What is on the table (default: ${DEFAULT-VALUE}).")
    private String domain;

    @Option(names = "--solver", paramLabel = "SPEC", defaultValue = "poss",
            description = "NAME, NAME:key=value,key=value or a class, see below (default: ${DEFAULT-VALUE}).")
    private String solver;

    @Option(names = "--belief", paramLabel = "B", description = "What the robot believes: red_ball=0.7,blue_ball=0.3 or a "
            + "JSON file (default: as at the start of an episode).")
    private String belief;

    @Option(names = "--human-belief", paramLabel = "H",
            description = "What the person believes that they will get (default: anything, each as likely).")
    private String humanBelief;

    @Option(names = "--deadline-ms", paramLabel = "D", defaultValue = "0",
            description = "Milliseconds for the decision, 0 for no limit (default: ${DEFAULT-VALUE}).")
    private int deadlineMs;

    @Option(names = "--seed", defaultValue = "1", description = "The same seed, the same decision (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(names = "--all", description = "Show all acts, not only the best " + SHOWN + ".")
    private boolean all;

    @Option(names = "--json", description = "One line of JSON.")
    private boolean json;

    private final Console console;

    Plan(Console console) {
        this.console = console;
    }

    /** Help ends with the solvers that there are. */
    @Spec
    void describe(CommandSpec spec) {
        SolverList.append(spec, Solvers.names(), Solvers::description);
    }

    @Override
    public Integer call() {
        UsageException.checkAtLeast("--deadline-ms", deadlineMs, 0);
        Solver chosen = Solvers.parse(solver);
        if (chosen.clairvoyant()) {
            throw new UsageException("--solver: " + chosen.name() + " is told what the person wants, which nobody knows here");
        }
        HandoverDomain on = DomainFiles.load(domain);
        Scene scene = on.start();
        HandoverBelief at = HandoverBelief.of(on.task(scene),
                belief == null ? on.prior(scene) : ObjectProbabilities.read(belief, scene, "--belief"),
                humanBelief == null ? Simplex.uniform(scene.size())
                        : ObjectProbabilities.read(humanBelief, scene, "--human-belief"));
        Policy policy = chosen.solve(on, Streams.of(seed, "solve", 0));
        long before = console.nanoClock().getAsLong();
        Decision decision = policy.decide(at, Deadlines.after(deadlineMs, console.nanoClock()).get(),
                Streams.of(seed, "planner", 0));
        double milliseconds = (console.nanoClock().getAsLong() - before) / 1e6;
        refuseNonsense(chosen, at, decision);
        console.out().print(json ? Replies.decision(at, decision, milliseconds) + "\n"
                : text(on.spec().name(), chosen.name(), at, decision, milliseconds));
        return Main.FINE;
    }

    /** What a user's own solver or variant may come up with. */
    private static void refuseNonsense(Solver solver, HandoverBelief at, Decision decision) {
        if (at.scene().model(decision.act()) == null) {
            throw new IllegalStateException(solver.name() + " chose " + decision.act() + ", which is not legal with " + at.scene()
                    + " on the table");
        }
        decision.values().forEach((act, value) -> {
            if (!Double.isFinite(value)) {
                throw new IllegalStateException(solver.name() + " finds " + act + " worth " + value
                        + "; a reward of the domain is no number, or the solver is at fault");
            }
        });
    }

    private String text(String name, String solverName, HandoverBelief at, Decision decision, double milliseconds) {
        StringBuilder text = new StringBuilder(name + ", " + solverName + "\n");
        TextTable beliefs = new TextTable(40, List.of("object", "robot believes", "person expects"));
        for (int i = 0; i < at.human().length; i++) {
            beliefs.add(List.of(at.scene().objects().get(i).name(), number("%.4f", at.probabilities()[i]),
                    number("%.4f", at.human()[i])));
        }
        ActModel model = at.scene().model(decision.act());
        text.append('\n').append(beliefs.text()).append("\nbest: ").append(decision.act());
        text.append(model == null || model.say().isEmpty() ? "" : ", saying \"" + model.say() + "\"").append('\n');
        text.append(number("looked %d acts ahead at %d beliefs in %.1f ms, ", decision.depth(), decision.nodes(), milliseconds))
                .append(decision.finished() ? "finished" : "stopped by the deadline").append('\n')
                .append(decision.bounds() == null ? "" : number("the value lies between about %.2f and %.2f%n",
                        decision.bounds().lower(), decision.bounds().upper()))
                .append(decision.note().isEmpty() ? "" : decision.note() + "\n");
        List<Map.Entry<Act, Double>> values = decision.values().entrySet().stream()
                .sorted(Map.Entry.comparingByValue(Comparator.reverseOrder())).toList();
        if (!values.isEmpty()) {
            TextTable table = new TextTable(60, List.of("act", "worth"));
            values.stream().limit(all ? values.size() : SHOWN)
                    .forEach(v -> table.add(List.of(v.getKey().toString(), number("%.3f", v.getValue()))));
            text.append('\n').append(table.text());
            int left = all ? 0 : Math.max(0, values.size() - SHOWN);
            text.append(left == 0 ? "" : "and " + left + " more (--all)\n");
        }
        return text.toString();
    }

    private static String number(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
