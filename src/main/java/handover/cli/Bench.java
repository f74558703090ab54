package handover.cli;

import handover.belief.HandoverBelief;
import handover.domain.ActModel;
import handover.domain.HandoverDomain;
import handover.domain.HandoverModel;
import handover.domain.HandoverObservationFunction;
import handover.domain.HandoverState;
import handover.io.DomainFiles;
import handover.math.Simplex;
import handover.math.Streams;
import handover.solver.BurlapSparseSampling;
import handover.solver.Deadline;
import handover.solver.Policy;
import handover.solver.Poss;
import handover.solver.Solver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.random.RandomGenerator;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Measures how long decisions take, against BURLAP's own sparse sampling on the same beliefs and with the same tree. */
@Command(name = "bench", description = "Measure decision times: POSS against BURLAP's BeliefSparseSampling, one thread, same beliefs.")
final class Bench implements Callable<Integer> {
    @Option(names = "--domain", paramLabel = "NAME|FILE", defaultValue = "table-line-6",
            description = "What is on the table (default: ${DEFAULT-VALUE}).")
    private String domain;

    @Option(names = {"--horizon", "-H"}, defaultValue = "3", description = "Acts to look ahead (default: ${DEFAULT-VALUE}).")
    private int horizon;

    @Option(names = {"--width", "-C"}, defaultValue = "5",
            description = "Observations sampled for each act (default: ${DEFAULT-VALUE}).")
    private int width;

    @Option(names = "--decisions", defaultValue = "200", description = "Measured decisions of POSS (default: ${DEFAULT-VALUE}).")
    private int decisions;

    @Option(names = "--burlap-decisions", defaultValue = "1",
            description = "Measured decisions of BURLAP, 0 to leave it out (default: ${DEFAULT-VALUE}).")
    private int burlapDecisions;

    @Option(names = "--seed", defaultValue = "1", description = "Which beliefs, and which luck (default: ${DEFAULT-VALUE}).")
    private long seed;

    private final Console console;

    Bench(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        UsageException.checkAtLeast("--horizon", horizon, 1);
        UsageException.checkAtLeast("--width", width, 1);
        UsageException.checkAtLeast("--decisions", decisions, 1);
        UsageException.checkAtLeast("--burlap-decisions", burlapDecisions, 0);
        HandoverDomain on = DomainFiles.load(domain);
        List<HandoverBelief> beliefs = beliefs(on);
        console.out().printf(Locale.ROOT, "%s: %d objects, %d acts, H=%d, C=%d; beliefs from random episodes, one thread%n%n",
                on.spec().name(), on.start().size(), on.start().acts().size(), horizon, width);
        TextTable table = new TextTable(40, List.of("solver", "decisions", "median ms", "p90 ms", "p99 ms", "beliefs/decision"));
        double[] fast = measure(table, new Poss(horizon, width, true), on, beliefs, decisions, decisions);
        measure(table, new Poss(horizon, width, false), on, beliefs, decisions, decisions);
        double[] slow = burlapDecisions == 0 ? null
                : measure(table, new BurlapSparseSampling(horizon, width), on, beliefs, 0, burlapDecisions);
        console.out().print(table.text());
        if (slow != null) {
            console.out().printf(Locale.ROOT, "%nBURLAP's median is %.0f times that of POSS.%n", slow[0] / fast[0]);
        }
        return Main.FINE;
    }

    /** Beliefs before the decisions of random episodes. */
    private List<HandoverBelief> beliefs(HandoverDomain on) {
        RandomGenerator random = Streams.of(seed, "bench", 0);
        HandoverModel model = new HandoverModel(on, random);
        HandoverObservationFunction senses = new HandoverObservationFunction(on, random);
        List<HandoverBelief> all = new ArrayList<>();
        while (all.size() < decisions) {
            double[] prior = on.prior(on.start());
            String wanted = on.start().objects().get(Simplex.sample(prior, prior.length, random)).name();
            HandoverState state = on.initialState(wanted);
            HandoverBelief belief = HandoverBelief.initial(on);
            while (!belief.task().done() && all.size() < decisions) {
                all.add(belief);
                List<ActModel> quiet = belief.task().legalActs().stream().filter(m -> !m.isPick()).toList();
                ActModel act = quiet.get(random.nextInt(quiet.size()));
                state = (HandoverState) model.sample(state, act.act()).op;
                belief = belief.after(act.act()).given(senses.sample(state, act.act()));
                if (belief.probabilities()[state.wanted()] > 0.95) {
                    break;
                }
            }
        }
        return all;
    }

    /** Adds a row and gives median, p90 and p99 in milliseconds, after {@code warmUp} decisions that are not counted. */
    private double[] measure(TextTable table, Solver solver, HandoverDomain on, List<HandoverBelief> beliefs, int warmUp,
            int counted) {
        Policy policy = solver.solve(on, Streams.of(seed, "solve", 0));
        double[] ms = new double[counted];
        long nodes = 0;
        for (int k = -warmUp; k < counted; k++) {
            HandoverBelief belief = beliefs.get(Math.floorMod(k, beliefs.size()));
            long before = console.nanoClock().getAsLong();
            long visited = policy.decide(belief, Deadline.NONE, Streams.of(seed, "planner", k)).nodes();
            if (k >= 0) {
                ms[k] = (console.nanoClock().getAsLong() - before) / 1e6;
                nodes += visited;
            }
        }
        Arrays.sort(ms);
        double[] p = {rank(ms, 0.5), rank(ms, 0.9), rank(ms, 0.99)};
        table.add(List.of(solver.name(), String.valueOf(counted), show(p[0]), show(p[1]), show(p[2]), String.valueOf(nodes / counted)));
        return p;
    }

    private static double rank(double[] sorted, double p) {
        return sorted[(int) Math.max(0, Math.ceil(p * sorted.length) - 1)];
    }

    private static String show(double ms) {
        return String.format(Locale.ROOT, "%.2f", ms);
    }
}
