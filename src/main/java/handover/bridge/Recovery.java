package handover.bridge;

import handover.domain.HandoverDomain;
import handover.domain.Scene;
import handover.io.SessionLogReader;
import handover.io.WireException;
import handover.io.WireMessage;
import java.io.IOException;

/**
 * A session computed again from its log.
 *
 * @param session as it was at the end of the log
 * @param messages that were applied
 * @param answered decisions in the last episode
 * @param closed how the last episode was closed; null if none was
 * @param difference where the log says something else than what was computed, null if nowhere
 * @param end bytes of the log up to the end of its last whole line
 */
public record Recovery(Session session, long messages, long answered, Closed closed, String difference, long end) {

    /**
     * How an episode was closed, for a client that did not get the summary and asks again.
     *
     * @param asked the envelope of {@code end}
     * @param after what was believed then
     */
    record Closed(WireMessage.Envelope asked, Snapshot after) {
        boolean by(WireMessage.Envelope again) {
            return asked.id() != null && asked.id().equals(again.id()) && asked.source().equals(again.source());
        }
    }

    /** The beginning of a session that has no log yet. */
    public static Recovery none(HandoverDomain domain, long seed, double maxAge) {
        return new Recovery(Session.of(domain, seed, maxAge), 0, 0, null, null, 0);
    }

    /**
     * Reads a log to its end, or to the first difference.
     *
     * @throws handover.io.EpisodeLogException if it cannot be read, or names a message that cannot be applied
     */
    public static Recovery of(SessionLogReader log) throws IOException {
        Session session = Session.of(log.domain(), log.header().seed(), log.header().maxAge());
        long messages = 0;
        long answered = 0;
        Closed closed = null;
        long end = log.end();
        for (SessionLogReader.Entry e = log.next(); e != null; e = log.next()) {
            end = log.end();
            answered += e.decision() ? 1 : 0;
            if (e.message() != null) {
                messages++;
                answered = e.message() instanceof WireMessage.Begin ? 0 : answered;
                Snapshot after = apply(e, session, log);
                closed = e.message() instanceof WireMessage.End ? new Closed(e.message().envelope(), after) : closed;
                String difference = difference(e, after);
                if (difference != null) {
                    return new Recovery(session, messages, answered, closed, "message " + messages + ": " + difference, end);
                }
            }
        }
        return new Recovery(session, messages, answered, closed, null, end);
    }

    private static Snapshot apply(SessionLogReader.Entry entry, Session session, SessionLogReader log) {
        try {
            return session.apply(entry.message(), entry.received(), entry.at(), Session.Journal.NONE).after();
        } catch (WireException e) {
            throw log.wrong("this message cannot be applied: " + e.path() + ": " + e.getMessage());
        }
    }

    private static String difference(SessionLogReader.Entry logged, Snapshot computed) {
        if (logged.version() != computed.version()) {
            return "logged version " + logged.version() + ", computed " + computed.version();
        }
        String b = difference("belief", computed.belief().scene(), logged.belief(), computed.belief().probabilities());
        return b != null ? b : difference("human_belief", computed.belief().scene(), logged.human(), computed.belief().human());
    }

    private static String difference(String what, Scene scene, double[] logged, double[] computed) {
        if (logged.length != computed.length) {
            return what + ": logged " + logged.length + " objects, computed " + computed.length;
        }
        for (int i = 0; i < logged.length; i++) {
            if (Double.doubleToLongBits(logged[i]) != Double.doubleToLongBits(computed[i])) {
                return what + " of " + scene.objects().get(i).name() + ": logged " + logged[i] + ", computed " + computed[i];
            }
        }
        return null;
    }
}
