package handover.bridge;

import handover.domain.TableObject;
import handover.io.Events;
import handover.io.Messages;
import handover.io.Replies;
import handover.io.SessionLogWriter;
import handover.io.Welcome;
import handover.io.WireCode;
import handover.io.WireException;
import handover.io.WireMessage;
import handover.solver.Policy;
import handover.solver.Replan;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** What a bridge answers to which message, without the sockets. Used by one thread. */
final class Service implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Service.class);
    private static final WireMessage.Envelope NOBODY = new WireMessage.Envelope(null, "", null);
    private static final long HEARTBEAT_NANOS = 1_000_000_000;
    /** So many messages of the stream are read before the others' turn. */
    private static final int READ = 200;

    private final Session session;
    private final Welcome welcome;
    private final Outbox outbox;
    private final SessionLogWriter log;
    private final DoubleSupplier clock;
    private final LongSupplier nanoClock;
    private final double sourceTimeout;
    private final Planner planner;
    private final Decisions decisions;
    private final Vitals vitals;
    private final Inbox inbox = new Inbox();
    private final StreamQueue queue;
    private volatile Snapshot published;
    /** The envelope of the message that is being handled, as far as it could be read. */
    private WireMessage.Envelope about = NOBODY;
    private long lastBeat;
    /** What the last episode was closed with, for a client that did not get it and asks again; null if none was. */
    private Recovery.Closed closed;

    /**
     * @param log receives what is applied and answered; null for none
     * @param clock Unix seconds
     * @param nanoClock as {@link System#nanoTime}
     * @param planned receives plans on the planner's thread; they are to be handed to {@link #planned}
     */
    Service(Session session, Policy policy, Welcome welcome, BridgeSettings settings, Outbox outbox, SessionLogWriter log,
            DoubleSupplier clock, LongSupplier nanoClock, Consumer<Planner.Plan> planned) {
        this.session = session;
        this.welcome = welcome;
        this.outbox = outbox;
        this.log = log;
        this.clock = clock;
        this.nanoClock = nanoClock;
        this.sourceTimeout = settings.limits().sourceTimeout();
        this.published = session.now();
        this.vitals = new Vitals(clock.getAsDouble());
        this.queue = new StreamQueue(settings.limits().queue());
        this.planner = new Planner(policy, new Replan(settings.replanThreshold()), () -> published, nanoClock, planned);
        this.decisions = new Decisions(planner, () -> published, settings.deadlineMs(), new Desk(), vitals);
        this.lastBeat = nanoClock.getAsLong();
    }

    /** In the episode that is under way so many decisions were answered before; {@code last} is how the last one was closed. */
    void restore(long answered, Recovery.Closed last) {
        decisions.restore(answered);
        closed = last;
    }

    // ---- messages ------------------------------------------------------------------------------------------------

    /** A request, which is answered. */
    void command(Client client, byte[] body) {
        Inbox.Received received = received(body);
        vitals.count("requests");
        guarded(client, () -> {
            WireMessage message = decode(received);
            if (message instanceof WireMessage.Hello) {
                answer(client, welcome.reply(message.envelope().id(), session.table()));
            } else if (message instanceof WireMessage.Decide decide) {
                session.episode();
                decisions.decide(client, decide);
            } else {
                apply(message, received, client);
            }
        });
    }

    /** Whether more of the stream should be taken. */
    boolean hasRoom() {
        return inbox.hasRoom();
    }

    /** A message that is not answered; it waits until {@link #work}. */
    void stream(byte[] body) {
        vitals.count("streamed");
        inbox.add(received(body));
    }

    private Inbox.Received received(byte[] body) {
        return new Inbox.Received(body, nanoClock.getAsLong(), clock.getAsDouble());
    }

    private void read(Inbox.Received received) {
        guarded(null, () -> {
            WireMessage message = decode(received);
            if (message instanceof WireMessage.Hello || message instanceof WireMessage.Decide
                    || message instanceof WireMessage.State) {
                throw new WireException(WireCode.BAD_TYPE, "type", "a question cannot be answered here; expected it on the "
                        + "command socket");
            } else if (!queue.add(message, received)) {
                throw new WireException(WireCode.BUSY, "", "too many messages are waiting");
            }
            vitals.shed(queue.shed());
        });
    }

    /** Reads some messages of the stream, and applies what was read for at most so long; whether any is left. */
    boolean work(long nanos) {
        for (int left = Math.min(READ, inbox.size()); left > 0; left--) {
            read(inbox.poll());
        }
        long start = nanoClock.getAsLong();
        while (queue.size() > 0 && nanoClock.getAsLong() - start < nanos) {
            StreamQueue.Waiting waiting = queue.poll();
            guarded(null, () -> {
                about = waiting.message().envelope();
                apply(waiting.message(), waiting.received(), null);
            });
        }
        return queue.size() > 0 || inbox.size() > 0;
    }

    private WireMessage decode(Inbox.Received received) {
        WireMessage message = Messages.decode(received.body());
        about = message.envelope();
        if (message instanceof WireMessage.Heard || message instanceof WireMessage.Pointed || message instanceof WireMessage.SceneChange) {
            vitals.sources().seen(about.source(), received.at());
        }
        return message;
    }

    /** What goes wrong with a message is told to its sender, if they wait for an answer, and to who listens to errors. */
    private void guarded(Client client, Runnable handling) {
        about = NOBODY;
        try {
            handling.run();
        } catch (WireException e) {
            refuse(client, about, e);
        } catch (RuntimeException e) {
            LOG.error("a message could not be handled", e);
            refuse(client, about, new WireException(WireCode.INTERNAL, "", e.toString()));
        }
    }

    /** Frames that are no message; {@code client} is null if nobody waits for an answer. */
    void malformed(Client client, String problem) {
        vitals.count(client == null ? "streamed" : "requests");
        refuse(client, NOBODY, new WireException(WireCode.NOT_JSON, "", problem));
    }

    /** Something of a feed that cannot be read as a message. */
    void unusable(String topic, WireException e) {
        vitals.count("streamed");
        refuse(null, new WireMessage.Envelope(null, topic, null), e);
    }

    private void apply(WireMessage message, Inbox.Received received, Client client) {
        double at = clock.getAsDouble();
        Session.Outcome outcome = session.apply(message, received.at(), at, after -> {
            if (log != null) {
                Snapshot s = after.after();
                log.applied(at, received.at(), received.body(), s.version(), s.belief(), client == null ? null : reply(message, after));
            }
        });
        if (outcome.applied()) {
            published = outcome.after();
            vitals.count("applied");
        } else {
            vitals.count(message instanceof WireMessage.State ? "questions" : outcome.remarks().complete() ? "repeated" : "unfinal");
        }
        if (client != null && outcome.applied()) {
            outbox.reply(client, reply(message, outcome));
        } else if (client != null) {
            answer(client, reply(message, outcome));
        }
        publish(message, outcome, at);
        vitals.applied(nanoClock.getAsLong() - received.nanos());
        if (message instanceof WireMessage.End && outcome.applied()) {
            decisions.end();
        } else if (message instanceof WireMessage.Begin && outcome.applied()) {
            decisions.begin();
        }
    }

    private String reply(WireMessage message, Session.Outcome outcome) {
        String re = message.envelope().id();
        Snapshot now = outcome.after();
        if (message instanceof WireMessage.State) {
            return Replies.state(re, now.belief(), now.version(), now.episode(), vitals.counters());
        } else if (message instanceof WireMessage.End && outcome.applied()) {
            closed = new Recovery.Closed(message.envelope(), now);
            return summary(closed);
        } else if (message instanceof WireMessage.End && closed != null && closed.by(message.envelope())) {
            return summary(closed);
        }
        return Replies.ok(re, now.version(), outcome.remarks());
    }

    private static String summary(Recovery.Closed closed) {
        Snapshot then = closed.after();
        return Replies.summary(closed.asked().id(), then.belief(), then.acts(), then.version(), then.episode());
    }

    private void publish(WireMessage message, Session.Outcome outcome, double at) {
        if (!outcome.applied() && outcome.remarks().complete()) {
            return;
        }
        Snapshot after = outcome.after();
        Events.Context context = new Events.Context(message.envelope(), at, after.version(), after.episode());
        outbox.publish(Topics.BELIEF, () -> Events.belief(context, after.belief(), message, outcome.remarks()));
        if (message instanceof WireMessage.Acted acted) {
            outbox.publish(Topics.ACT, () -> Events.act(context, acted));
        } else if (message instanceof WireMessage.SceneChange) {
            outbox.publish(Topics.SCENE, () -> Events.scene(context, session.table()));
        } else if (message instanceof WireMessage.Begin || message instanceof WireMessage.End) {
            outbox.publish(Topics.EPISODE, () -> Events.episode(context, message instanceof WireMessage.Begin,
                    after.belief().scene().objects().stream().map(TableObject::name).toList()));
        }
    }

    private void answer(Client client, String json) {
        log(() -> log.replied(clock.getAsDouble(), json));
        outbox.reply(client, json);
    }

    private void refuse(Client client, WireMessage.Envelope envelope, WireException e) {
        WireException told = e.re() == null && envelope.id() != null ? e.about(envelope.id()) : e;
        vitals.count("errors");
        vitals.count("errors_" + e.code().key());
        if (client != null) {
            answer(client, Replies.error(told));
        }
        outbox.publish(Topics.ERROR, () -> Events.error(told, envelope.source(), clock.getAsDouble()));
    }

    /** What cannot be written must not keep an answer back that changes nothing. */
    private void log(Runnable line) {
        if (log != null) {
            try {
                line.run();
            } catch (RuntimeException e) {
                LOG.error("the log cannot be written", e);
            }
        }
    }

    private final class Desk implements Answers {
        @Override
        public void reply(Client client, String json) {
            answer(client, json);
        }

        @Override
        public void decision(Client client, String json) {
            log(() -> log.decided(clock.getAsDouble(), json));
            outbox.reply(client, json);
            outbox.publish(Topics.DECISION, () -> json);
        }

        @Override
        public void refuse(Client client, WireMessage.Envelope envelope, WireException why) {
            Service.this.refuse(client, envelope, why);
        }
    }

    // ---- time ----------------------------------------------------------------------------------------------------

    /** A plan is there. */
    void planned(Planner.Plan plan) {
        decisions.planned(plan);
    }

    /** Does what is due; to be called when {@link #untilDue} says, and after each message. */
    void tick() {
        decisions.tick();
        long now = nanoClock.getAsLong();
        if (now - lastBeat >= HEARTBEAT_NANOS) {
            lastBeat = now;
            beat(clock.getAsDouble());
        }
    }

    private void beat(double now) {
        outbox.publish(Topics.HEARTBEAT, () -> vitals.heartbeat(now, published, inbox.size() + queue.size(),
                inbox.bytes() + queue.bytes()));
        for (String source : vitals.sources().silent(now, sourceTimeout)) {
            LOG.warn("source {} has been silent for {} s", source, sourceTimeout);
            outbox.publish(Topics.ERROR, () -> Events.silent(source, vitals.sources().lastSeen().get(source), now));
        }
    }

    /** Nanoseconds until {@link #tick} has something to do; not positive if it has already. */
    long untilDue() {
        return Math.min(decisions.untilDue(), HEARTBEAT_NANOS - (nanoClock.getAsLong() - lastBeat));
    }

    @Override
    public void close() {
        int left = queue.owed() + inbox.size();
        if (left > 0) {
            LOG.warn("{} messages of the stream were not applied", left);
            WireException lost = new WireException(WireCode.BUSY, "", left + " messages of the stream were not applied before the "
                    + "bridge shut down");
            log(() -> log.replied(clock.getAsDouble(), Replies.error(lost)));
            refuse(null, NOBODY, lost);
        }
        decisions.abandon(new WireException(WireCode.BUSY, "", "the bridge is shutting down"));
        planner.close();
    }
}
