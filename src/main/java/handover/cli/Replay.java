package handover.cli;

import handover.belief.HandoverBelief;
import handover.bridge.Recovery;
import handover.domain.TableObject;
import handover.io.EpisodeLogReader;
import handover.io.LoggedEpisode;
import handover.io.SessionLogReader;
import handover.simulation.TimedReplay;
import handover.simulation.TimedStep;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Computes the beliefs of a log again from its acts and observations, and compares them bit for bit. */
@Command(name = "replay", description = "Compute the beliefs of a log again from what was done and sensed, and compare.")
final class Replay implements Callable<Integer> {
    @Parameters(paramLabel = "LOG", description = "A log of handover simulate or bridge.")
    private Path file;

    private final Console console;

    Replay(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        return SessionLogReader.looksLikeLog(file) ? session() : simulation();
    }

    /** Of a bridge. */
    private Integer session() throws IOException {
        try (SessionLogReader log = SessionLogReader.open(file)) {
            Recovery recovery = Recovery.of(log);
            if (recovery.difference() != null) {
                console.err().println("handover: " + file + ": " + recovery.difference());
                return Main.DIFFERENT;
            }
            if (log.torn()) {
                console.err().println("handover: " + file + ": the last line is torn and was skipped");
            }
            console.out().println(recovery.session().now().episode() + " episodes with " + recovery.messages()
                    + " messages agree");
        }
        return Main.FINE;
    }

    private Integer simulation() throws IOException {
        int episodes = 0;
        long steps = 0;
        try (EpisodeLogReader log = EpisodeLogReader.open(file)) {
            HandoverBelief start = HandoverBelief.initial(log.domain());
            for (LoggedEpisode e = log.next(); e != null; e = log.next()) {
                String difference = difference(e, start, log);
                if (difference != null) {
                    console.err().println("handover: " + file + ": episode " + e.index() + " of " + e.solver()
                            + (e.agent() == null ? "" : ", " + e.agent()) + ": " + difference);
                    return Main.DIFFERENT;
                }
                episodes++;
                steps += e.steps().size();
            }
            if (log.torn()) {
                console.err().println("handover: " + file + ": the last line is torn and was skipped");
            }
            long all = log.header().total();
            console.out().println(episodes + " episodes with " + steps + " steps agree"
                    + (episodes < all ? "; the run was to have " + all + " episodes" : ""));
        }
        return Main.FINE;
    }

    /** Where an episode differs from what its acts and observations lead to; null if nowhere. */
    private static String difference(LoggedEpisode episode, HandoverBelief start, EpisodeLogReader log) {
        HandoverBelief belief = start;
        TimedReplay timed = new TimedReplay(start);
        for (int k = 0; k < episode.steps().size(); k++) {
            LoggedEpisode.Step step = episode.steps().get(k);
            try {
                belief = episode.times().isEmpty() ? belief.after(step.act()).given(step.observation()) : after(k, episode, timed);
            } catch (IllegalArgumentException e) {
                throw log.wrong("steps[" + k + "]: " + e.getMessage());
            }
            String difference = difference(step, belief);
            if (difference != null) {
                return "step " + k + ": " + difference;
            }
        }
        return null;
    }

    /** The belief at the end of a timed step: when the next one starts, or when the last act is over. */
    private static HandoverBelief after(int k, LoggedEpisode episode, TimedReplay timed) {
        LoggedEpisode.Step step = episode.steps().get(k);
        TimedStep time = episode.times().get(k);
        timed.started(step.act(), step.observation().signal(), time);
        return timed.settled(k + 1 < episode.times().size() ? episode.times().get(k + 1).start() : time.end());
    }

    private static String difference(LoggedEpisode.Step step, HandoverBelief belief) {
        List<String> onTable = belief.scene().objects().stream().map(TableObject::name).toList();
        if (!onTable.equals(step.onTable())) {
            return "on the table are logged " + step.onTable() + ", computed " + onTable;
        }
        String difference = difference("belief", onTable, step.belief(), belief.probabilities());
        return difference != null ? difference : difference("human_belief", onTable, step.human(), belief.human());
    }

    private static String difference(String what, List<String> names, double[] logged, double[] computed) {
        for (int i = 0; i < logged.length; i++) {
            if (Double.doubleToLongBits(logged[i]) != Double.doubleToLongBits(computed[i])) {
                return what + " of " + names.get(i) + ": logged " + logged[i] + ", computed " + computed[i];
            }
        }
        return null;
    }
}
