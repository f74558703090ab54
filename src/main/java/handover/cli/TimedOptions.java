package handover.cli;

import handover.io.RunTime;
import handover.simulation.Agent;
import handover.simulation.Delay;
import handover.simulation.PlanningLatency;
import handover.simulation.ResponseTimes;
import handover.simulation.Timing;
import handover.solver.Replan;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The options of {@code simulate --timed}. */
final class TimedOptions {
    private static final Map<String, List<Agent>> AGENTS = Map.of("sequential", List.of(Agent.SEQUENTIAL),
            "concurrent", List.of(Agent.CONCURRENT), "both", List.of(Agent.SEQUENTIAL, Agent.CONCURRENT));
    private static final List<String> ONLY_TIMED = List.of("--planning-latency", "--agent", "--reaction", "--replan", "--patience");
    private static final String UNLIMITED = "unlimited";
    private static final List<String> NEVER_TIMED = List.of("--resume", "--deadline-ms");

    @Option(names = "--timed", description = {"On a virtual clock: acts take time, what people say and show comes when it comes, and "
            + "thinking costs time. Logged only with --out."})
    private boolean timed;

    @Option(names = "--planning-latency", paramLabel = "MODEL", defaultValue = "2s", description = "With --timed: how long a decision "
            + "takes: @|bold 2s|@, @|bold 10ms|@, @|bold lognormal:median=2s,sigma=0.3|@, or @|bold nodes:200000/s|@, beliefs that the "
            + "solver visits in a second (default: ${DEFAULT-VALUE}).")
    private String latency;

    @Option(names = "--agent", paramLabel = "WHICH", defaultValue = "both", description = "With --timed: @|bold sequential|@ observes, "
            + "thinks, acts; @|bold concurrent|@ observes and thinks all the time; or @|bold both|@ (default: ${DEFAULT-VALUE}).")
    private String agent;

    @Option(names = "--reaction", paramLabel = "MODEL", defaultValue = "lognormal:median=0.5s,sigma=0.4", description = "With --timed: "
            + "how long people take to react, as a time or lognormal; @|bold none|@ if all they do is sensed at once, without the time for words "
            + "and for sensing (default: ${DEFAULT-VALUE}).")
    private String reaction;

    @Option(names = "--replan", paramLabel = "D", defaultValue = "0.1", description = "With --timed: by how much the belief must move, in total "
            + "variation, for the concurrent robot to think again (default: ${DEFAULT-VALUE}).")
    private double replan;

    @Option(names = "--patience", paramLabel = "TIME", defaultValue = UNLIMITED, description = "With --timed: how long after the end of an act "
            + "the concurrent robot may still begin to think again; @|bold 0s|@ and it does what it planned, even if it knows better by then "
            + "(default: ${DEFAULT-VALUE}).")
    private String patience;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    /** Whether time is to pass. Throws {@link UsageException} if the other options do not fit that. */
    boolean timed() {
        String why = timed ? "expected no --timed with it" : "expected --timed with it";
        for (String option : timed ? NEVER_TIMED : ONLY_TIMED) {
            if (given(option)) {
                throw new UsageException(option + ": " + why);
            }
        }
        return timed;
    }

    private boolean given(String option) {
        return command.commandLine().getParseResult().hasMatchedOption(option);
    }

    /** Whether a log was asked for. */
    boolean logged() {
        return given("--out");
    }

    /** What the first line of a log says of time. */
    RunTime header() {
        return new RunTime(agents().stream().map(TimedSimulation::name).toList(), latency, reaction, replan, patience);
    }

    List<Agent> agents() {
        List<Agent> agents = AGENTS.get(agent);
        if (agents == null) {
            throw new UsageException("--agent: expected sequential, concurrent or both, got " + agent);
        }
        return agents;
    }

    /** What is assumed of time, in one line. */
    String introduction() {
        return "Thinking takes " + latency + " a decision; people react after " + reaction + ".\n";
    }

    Timing timing() {
        ResponseTimes responses = reaction.equals("none") ? ResponseTimes.NONE
                : ResponseTimes.DEFAULT.with(parse("--reaction", reaction, text -> Delay.parse(text, ", or none")));
        double wait = patience.equals(UNLIMITED) ? Double.POSITIVE_INFINITY
                : parse("--patience", patience, text -> Delay.Fixed.parse(text, ", or " + UNLIMITED)).span();
        return new Timing(parse("--planning-latency", latency, PlanningLatency::parse), responses,
                parse("--replan", replan, Replan::new), wait);
    }

    private static <A, B> B parse(String option, A text, Function<A, B> parser) {
        try {
            return parser.apply(text);
        } catch (IllegalArgumentException e) {
            throw new UsageException(option + ": " + e.getMessage());
        }
    }
}
