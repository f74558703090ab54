package handover.cli;

import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.io.EpisodeLogWriter;
import handover.io.RunHeader;
import handover.simulation.Agent;
import handover.simulation.Estimate;
import handover.simulation.Measures;
import handover.simulation.OrderedUnits;
import handover.simulation.TimedMeasures;
import handover.simulation.TimedRunner;
import handover.simulation.TimedSummary;
import handover.simulation.Timing;
import handover.solver.Solver;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/** {@code simulate --timed}: plays the episodes and prints the tables. Used by one thread. */
final class TimedSimulation {
    private static final String LEGEND = """
            seconds     time until the object was handed over: acts, thinking and waiting
            idle        seconds of it without an act
            return      sum of rewards, those of each later act counting a little less; it does not pay for time
            plannings   how often the robot began to think, for each act
            stale %     acts that were decided before something else was heard or seen, of all acts
            differing % acts that would have been others with what was known when they started, of all acts
            """;
    private static final String CANCELS = """
            Cancels and objections are per 1,000 episodes. Cancels: reaches that were called off. Objections: reaches for something else
            to which the person said no; heeded: called off after that "no". From the act to which they said no to another act: 1 is the next
            one; from the end of the "no" to the start of the other act: in seconds.
            """;

    private final RunHeader header;
    private final List<Agent> agents;
    private final Console console;
    private final HandoverDomain domain;
    private final Map<String, TimedRunner> runners = new LinkedHashMap<>();
    private final Map<String, Map<Agent, List<TimedMeasures>>> played = new LinkedHashMap<>();

    /** Solves, and so may find that a solver does not suit the domain: to be called before a log is replaced. */
    TimedSimulation(RunHeader header, List<Solver> solvers, List<Agent> agents, Timing timing, Console console) {
        this.header = header;
        this.agents = agents;
        this.console = console;
        this.domain = DomainFiles.domain(header.domain());
        HandoverDomain people = header.asModelled() ? domain : DomainFiles.domain(header.people());
        solvers.forEach(s -> runners.put(s.name(), new TimedRunner(domain, people, s, header.seed(), header.maxSteps(), timing)));
    }

    /** @param log receives each episode as soon as all before it are there; null for none */
    void play(int threads, EpisodeLogWriter log) throws InterruptedException {
        Progress progress = new Progress(console, "episodes", 0, (long) header.episodes() * runners.size());
        try {
            for (Map.Entry<String, TimedRunner> runner : runners.entrySet()) {
                Map<Agent, List<TimedMeasures>> lists = new LinkedHashMap<>();
                agents.forEach(a -> lists.put(a, new ArrayList<>()));
                OrderedUnits.until(0, header.episodes(), threads, k -> agents.stream().map(a -> runner.getValue().play(k, a)).toList(), pair -> {
                    for (int a = 0; a < agents.size(); a++) {
                        if (log != null) {
                            log.write(pair.get(a), name(agents.get(a)));
                        }
                        lists.get(agents.get(a)).add(pair.get(a).measures());
                    }
                    progress.step();
                    return false;
                });
                played.put(runner.getKey(), lists);
            }
        } finally {
            progress.end();
        }
    }

    /** The tables and what their columns mean. */
    String report() {
        TextTable table = new TextTable(30, List.of("solver", "agent", "success %", "seconds", "idle", "acts", "return", "plannings",
                "stale %", "differing %"));
        TextTable cancels = new TextTable(30, List.of("solver", "agent", "correct cancels", "false cancels", "objections", "heeded %",
                "acts to cancel", "seconds to cancel"));
        TextTable differences = new TextTable(30, List.of("solver", "concurrent less sequential", "return", "95%", "seconds", "95%"));
        played.forEach((solver, lists) -> {
            lists.forEach((agent, episodes) -> {
                TimedSummary s = TimedSummary.of(episodes);
                addSummary(table, solver, agent, s);
                addCancels(cancels, solver, agent, s);
            });
            if (lists.size() > 1) {
                addDifference(differences, solver, lists);
            }
        });
        boolean incremental = domain.pickRule().increments() > 1 && header.domain().handovers() == 1 && header.domain().tau() == 1;
        return table.text() + (agents.size() > 1 ? "\n" + differences.text() : "") + (incremental ? "\n" + cancels.text() : "") + "\n"
                + LEGEND + (incremental ? CANCELS : "");
    }

    private static void addSummary(TextTable table, String solver, Agent agent, TimedSummary s) {
        table.add(List.of(solver, name(agent), format("%.1f", 100 * s.success().value()), mean(s.seconds(), 2), mean(s.idle(), 2),
                mean(s.steps(), 2), mean(s.discountedReturn(), 1), format("%.2f", s.plannings()), format("%.1f", 100 * s.stale()),
                format("%.1f", 100 * s.differing())));
    }

    private static void addCancels(TextTable table, String solver, Agent agent, TimedSummary s) {
        table.add(List.of(solver, name(agent), format("%.0f", 1000 * s.correctCancels()), format("%.0f", 1000 * s.falseCancels()),
                format("%.0f", 1000 * s.objections()), s.objections() == 0 ? "-" : format("%.0f", 100 * s.heeded()),
                known(s.actsToCancel()), known(s.secondsToCancel())));
    }

    private static void addDifference(TextTable table, String solver, Map<Agent, List<TimedMeasures>> lists) {
        Estimate worth = difference(lists, Measures::discountedReturn);
        Estimate time = difference(lists, Measures::seconds);
        table.add(List.of(solver, "", format("%+.2f", worth.value()), interval(worth), format("%+.2f", time.value()), interval(time)));
    }

    private static Estimate difference(Map<Agent, List<TimedMeasures>> lists, ToDoubleFunction<Measures> of) {
        return TimedSummary.difference(lists.get(Agent.CONCURRENT), lists.get(Agent.SEQUENTIAL), of);
    }

    static String name(Agent agent) {
        return agent.name().toLowerCase(Locale.ROOT);
    }

    private static String known(Estimate e) {
        return Double.isNaN(e.value()) ? "-" : mean(e, 2);
    }

    private static String mean(Estimate e, int decimals) {
        return ResultTables.cell(e, decimals);
    }

    private static String interval(Estimate e) {
        return Double.isInfinite(e.half()) ? "unknown" : format("%+.2f to %+.2f", e.low(), e.high());
    }

    private static String format(String format, Object... values) {
        return ResultTables.format(format, values);
    }
}
