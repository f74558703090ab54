package handover.cli;

import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.io.EpisodeLogWriter;
import handover.io.RunHeader;
import handover.simulation.Episode;
import handover.simulation.EpisodeRunner;
import handover.simulation.Episodes;
import handover.simulation.Measures;
import handover.solver.Solver;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Plays the episodes of a run in a fixed order: block by block, in a block solver by solver. Keeps of each episode what the
 * tables need. Used by one thread.
 */
final class Run {
    private static final int BLOCK = 50;

    private final RunHeader header;
    private final Map<String, List<Episode>> finished = new LinkedHashMap<>();

    Run(RunHeader header) {
        this.header = header;
        header.solvers().forEach(s -> finished.put(s, new ArrayList<>()));
    }

    /** Episodes of all solvers, in the order in which they were played. */
    Map<String, List<Episode>> finished() {
        return finished;
    }

    long done() {
        return finished.values().stream().mapToLong(List::size).sum();
    }

    long total() {
        return header.total();
    }

    /** Whether the next episode to be played is this one. */
    boolean expects(String solver, int index) {
        String next = next();
        return solver.equals(next) && finished.get(next).size() == index;
    }

    /** An episode that need not be played because its measures are known. */
    void skip(String solver, int index, String wanted, Measures measures) {
        finished.get(solver).add(new Episode(index, solver, wanted, null, List.of(), measures, new long[0]));
    }

    /**
     * What plays the episodes of each solver, by its name. Solves, and so may find that a solver does not suit the domain: to be
     * called before a log is replaced.
     *
     * @param solvers with the names of the header
     */
    Map<String, EpisodeRunner> runners(List<Solver> solvers, Console console) {
        HandoverDomain domain = DomainFiles.domain(header.domain());
        HandoverDomain people = header.asModelled() ? domain : DomainFiles.domain(header.people());
        Map<String, EpisodeRunner> runners = new LinkedHashMap<>();
        solvers.forEach(s -> runners.put(s.name(), new EpisodeRunner(domain, people, s, header.seed(), header.maxSteps(),
                Deadlines.after(header.deadlineMs(), console.nanoClock()), console.nanoClock())));
        return runners;
    }

    /**
     * Plays what is not finished.
     *
     * @param log receives each episode as soon as all before it are there; null for none
     */
    void play(Map<String, EpisodeRunner> runners, int threads, EpisodeLogWriter log, Progress progress) throws InterruptedException {
        for (String solver = next(); solver != null; solver = next()) {
            List<Episode> list = finished.get(solver);
            int from = list.size();
            Episodes.play(runners.get(solver), from, blockEnd(from), threads, e -> {
                if (log != null) {
                    log.write(e);
                }
                list.add(new Episode(e.index(), e.solver(), e.wanted(), null, List.of(), e.measures(), e.decisionNanos()));
                progress.step();
            });
        }
    }

    /** The first solver in the earliest block that is not finished; null at the end. */
    private String next() {
        int earliest = finished.values().stream().mapToInt(List::size).min().orElse(0);
        int end = blockEnd(earliest);
        return header.solvers().stream().filter(s -> finished.get(s).size() < end).findFirst().orElse(null);
    }

    private int blockEnd(int index) {
        return (int) Math.min(header.episodes(), (index / BLOCK + 1L) * BLOCK);
    }
}
