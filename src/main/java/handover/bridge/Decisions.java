package handover.bridge;

import handover.domain.Act;
import handover.io.Replies;
import handover.io.WireCode;
import handover.io.WireException;
import handover.io.WireMessage;
import handover.solver.Decision;
import java.util.Map;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The decision that is asked for: at most one at a time, and always answered by its deadline. Used by one thread. */
final class Decisions {
    private static final Logger LOG = LoggerFactory.getLogger(Decisions.class);
    private static final double NANOS_PER_MS = 1e6;
    /** So long after the deadline the reply goes out, with what there is. */
    private static final long GRACE_NANOS = 5_000_000;

    private final Planner planner;
    private final Supplier<Snapshot> newest;
    private final double defaultMs;
    private final Answers answers;
    private final Vitals vitals;
    private Pending pending;
    /** How many were answered in this episode. */
    private long answered;

    private record Pending(Client client, WireMessage.Envelope envelope, Planner.Job job) {}

    /**
     * @param newest what is believed now
     * @param defaultMs milliseconds for a decision that names no deadline
     */
    Decisions(Planner planner, Supplier<Snapshot> newest, double defaultMs, Answers answers, Vitals vitals) {
        this.planner = planner;
        this.newest = newest;
        this.defaultMs = defaultMs;
        this.answers = answers;
        this.vitals = vitals;
    }

    /** In this episode so many decisions were answered before. */
    void restore(long before) {
        answered = before;
    }

    /** An episode begins; a decision that was asked for in the last one is made in this one, or is WAIT. */
    void begin() {
        answered = 0;
    }

    /** The episode ends. */
    void end() {
        abandon(new WireException(WireCode.NO_EPISODE, "", "the episode ended before the decision was made"));
    }

    /** No decision can be made any more. */
    void abandon(WireException why) {
        if (pending != null) {
            Pending asked = drop();
            answers.refuse(asked.client, asked.envelope, why);
        }
    }

    /** A client asks; who asks again with the same id waits for the same decision. */
    void decide(Client client, WireMessage.Decide message) {
        WireMessage.Envelope envelope = message.envelope();
        if (pending != null && envelope.id() != null && envelope.id().equals(pending.envelope.id())
                && envelope.source().equals(pending.envelope.source())) {
            pending = new Pending(client, envelope, pending.job);
            return;
        } else if (pending != null) {
            vitals.count("superseded");
            Pending before = drop();
            answers.reply(before.client, Replies.superseded(before.envelope.id()));
        }
        Planner.Job job = planner.job(answered, (long) (NANOS_PER_MS * (message.deadlineMs() == null ? defaultMs : message.deadlineMs())));
        pending = new Pending(client, envelope, job);
        start(job);
    }

    private void start(Planner.Job job) {
        Snapshot now = newest.get();
        if (now.over()) {
            answer(now, Decision.of(Act.WAIT).noted("the episode is over"), false);
        } else if (!planner.start(job)) {
            fallBack("the solver does not return from earlier decisions");
        }
    }

    /** A plan is there. */
    void planned(Planner.Plan plan) {
        if (pending == null || pending.job != plan.job()) {
            return;
        }
        Snapshot now = newest.get();
        if (plan.failure() != null) {
            LOG.warn("the solver failed", plan.failure());
            fallBack("the solver failed: " + plan.failure());
        } else if (now.over() || !plan.at().stillMeant(now) && !plan.job().over()) {
            start(plan.job());
        } else {
            String why = unusable(plan, now);
            if (why == null) {
                answer(plan.at(), plan.decision(), false);
            } else {
                fallBack(why);
            }
        }
    }

    /** Why a plan is no answer now, null if it is one. */
    private static String unusable(Planner.Plan plan, Snapshot now) {
        Decision decision = plan.decision();
        if (!plan.at().stillMeant(now)) {
            return "what was planned for is not so any more, and no time is left";
        } else if (decision == null || decision.act() == null) {
            return "the solver gave no decision";
        } else if (now.belief().scene().model(decision.act()) == null) {
            return decision.act() + " is not possible any more";
        }
        return decision.values().values().stream().allMatch(Double::isFinite) ? null : "the solver finds an act worth what is no number";
    }

    /** Answers what is overdue: with what was planned for an earlier belief, if the solver is still at a later one. */
    void tick() {
        if (pending != null && pending.job.left() <= -GRACE_NANOS) {
            Planner.Plan plan = pending.job.latest();
            if (plan != null && unusable(plan, newest.get()) == null) {
                answer(plan.at(), plan.decision(), false);
            } else {
                fallBack("the deadline passed before the solver had a decision");
            }
        }
    }

    /** Nanoseconds until {@link #tick} has something to do. */
    long untilDue() {
        return pending == null ? Long.MAX_VALUE : pending.job.left() + GRACE_NANOS;
    }

    private void fallBack(String why) {
        vitals.count("fallbacks");
        answer(newest.get(), new Decision(Act.WAIT, Map.of(), 0, 0, false, why), true);
    }

    private void answer(Snapshot at, Decision decision, boolean fallback) {
        Pending asked = drop();
        long nanos = asked.job.elapsed();
        answered++;
        vitals.count("decisions");
        vitals.decided(nanos, nanos + asked.job.left());
        answers.decision(asked.client, Replies.decision(asked.envelope.id(), at.belief(), newest.get().belief().scene(), decision,
                nanos / NANOS_PER_MS, at.version(), fallback));
    }

    private Pending drop() {
        Pending asked = pending;
        pending = null;
        asked.job.cancel();
        return asked;
    }
}
