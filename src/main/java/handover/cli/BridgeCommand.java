package handover.cli;

import handover.bridge.Bridge;
import handover.bridge.BridgeSettings;
import handover.bridge.CurveKeys;
import handover.bridge.Recovery;
import handover.bridge.Security;
import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.io.SessionHeader;
import handover.io.SessionLogReader;
import handover.io.SessionLogWriter;
import handover.solver.Solver;
import handover.solver.Solvers;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Serves decisions to a robot and its sensors until it is told to stop. */
@Command(name = "bridge", description = "Serve decisions to a robot and its sensors over ZeroMQ (docs/bridge.md).")
final class BridgeCommand implements Callable<Integer> {
    private static final String SOLVER = "poss";
    private static final long SEED = 1;
    private static final double MAX_AGE = 2;
    private static final long SHUTDOWN_MS = 1800;
    private static final double LONGEST = 3600;
    private static final String NO_LOG = "none";
    private static final DateTimeFormatter STAMP = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss").withZone(ZoneOffset.UTC);

    @Parameters(paramLabel = "DOMAIN", arity = "0..1", description = "Name or file of the domain.")
    private String domain;

    @Option(names = "--solver", paramLabel = "SPEC",
            description = "NAME, NAME:key=value,key=value or a class (default: " + SOLVER + "; with --resume that of the log).")
    private String solver;

    @Option(names = "--command", paramLabel = "ADDRESS", defaultValue = "tcp://127.0.0.1:5701",
            description = "Where requests are answered; port * for any that is free (default: ${DEFAULT-VALUE}).")
    private String command;

    @Option(names = "--stream", paramLabel = "ADDRESS", defaultValue = "tcp://127.0.0.1:5702",
            description = "Where sensors push (default: ${DEFAULT-VALUE}).")
    private String stream;

    @Option(names = "--events", paramLabel = "ADDRESS", defaultValue = "tcp://127.0.0.1:5703",
            description = "Where events are published (default: ${DEFAULT-VALUE}).")
    private String events;

    @Option(names = "--subscribe", paramLabel = "ADDRESS[,TOPIC]", description = "Also listen to a publisher; the domain file's "
            + "adapters say how its topics are read. May be repeated.")
    private List<String> subscribe = List.of();

    @Option(names = "--curve", paramLabel = "FILE", description = "Encrypt with the secret key of this file (see bridge keygen).")
    private Path curve;

    @Option(names = "--authorized", paramLabel = "FOLDER", description = "Let clients in whose public keys are in this folder.")
    private Path authorized;

    @Option(names = "--insecure", description = "Let other machines in without encryption.")
    private boolean insecure;

    @Option(names = "--seed", description = "Of the chance that decisions use (default: " + SEED + "; with --resume that of the log).")
    private Long seed;

    @Option(names = "--deadline-ms", paramLabel = "D", defaultValue = "1000",
            description = "Milliseconds for a decision whose request gives no deadline (default: ${DEFAULT-VALUE}).")
    private int deadlineMs;

    @Option(names = "--replan", paramLabel = "TV", defaultValue = "0.1",
            description = "Plan anew when the belief moved by more while planning: total variation (default: ${DEFAULT-VALUE}).")
    private double replan;

    @Option(names = "--max-age", paramLabel = "SECONDS",
            description = "What was sensed longer ago is not used (default: " + MAX_AGE + "; with --resume that of the log).")
    private Double maxAge;

    @Option(names = "--source-timeout", paramLabel = "SECONDS", defaultValue = "10",
            description = "A source that is silent for longer is reported once (default: ${DEFAULT-VALUE}).")
    private double sourceTimeout;

    @Option(names = "--queue", paramLabel = "N", defaultValue = "5000", description = "So many messages of the stream may wait; "
            + "then the oldest gestures and unfinal speech are dropped and counted (default: ${DEFAULT-VALUE}).")
    private int queue;

    @Option(names = "--log", paramLabel = "FILE", defaultValue = "", description = "New file for all that is applied and "
            + "answered, or none (default: session-TIME.jsonl).")
    private String log;

    @Option(names = "--resume", paramLabel = "LOG", description = "Go on with the session of this log, where it ends.")
    private Path resume;

    private final Console console;

    BridgeCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        if (domain == null && resume == null) {
            throw new UsageException("expected the name or file of a domain; see handover bridge --help");
        }
        if (resume != null && !log.isEmpty()) {
            throw new UsageException("--log and --resume: expected one of them; a session that goes on is logged where it was");
        }
        settle();
        check();
        Solver chosen = Solvers.parse(solver);
        if (chosen.clairvoyant()) {
            throw new UsageException("--solver: " + chosen.name() + " is told what the person wants, which nobody knows here");
        }
        HandoverDomain on = domain == null ? logged() : DomainFiles.load(domain);
        Recovery start = resume == null ? Recovery.none(on, seed, maxAge) : recovery(on);
        Path file = resume != null ? resume : log.equals(NO_LOG) ? null
                : Path.of(log.isEmpty() ? "session-" + STAMP.format(Instant.now()) + ".jsonl" : log);
        if (resume == null && file != null && Files.exists(file)) {
            throw new UsageException(file + ": there is such a file already; go on with it by --resume, or choose another --log");
        }
        try (Bridge bridge = new Bridge(on, chosen, new BridgeSettings(command, stream, events, subscribe, security(), seed,
                deadlineMs, replan, new BridgeSettings.Limits(maxAge, sourceTimeout, queue)));
                SessionLogWriter writer = file == null ? null : resume != null ? SessionLogWriter.append(file, start.end())
                        : SessionLogWriter.create(file, new SessionHeader(on.spec(), chosen.name(), seed, maxAge))) {
            Runtime.getRuntime().addShutdownHook(new Thread(() -> stop(bridge), "handover-shutdown"));
            console.out().print(bridge.welcome().ready(file == null ? null : file.toString(), start.session().now().version(),
                    start.session().table()) + "\n");
            console.out().flush();
            bridge.run(start, writer);
        }
        return Main.FINE;
    }

    /** A session goes on with the seed and the age that it began with, and with its solver unless another one is asked for. */
    private void settle() throws IOException {
        if (resume == null) {
            solver = solver == null ? SOLVER : solver;
            seed = seed == null ? SEED : seed;
            maxAge = maxAge == null ? MAX_AGE : maxAge;
            return;
        }
        try (SessionLogReader reader = SessionLogReader.open(resume)) {
            SessionHeader begun = reader.header();
            if (seed != null && seed != begun.seed()) {
                throw new UsageException("--seed: " + resume + " began with " + begun.seed() + ", got " + seed);
            } else if (maxAge != null && maxAge != begun.maxAge()) {
                throw new UsageException("--max-age: " + resume + " began with " + begun.maxAge() + ", got " + maxAge);
            }
            solver = solver == null ? begun.solver() : solver;
            seed = begun.seed();
            maxAge = begun.maxAge();
        }
    }

    private HandoverDomain logged() throws IOException {
        try (SessionLogReader reader = SessionLogReader.open(resume)) {
            return reader.domain();
        }
    }

    private Recovery recovery(HandoverDomain on) throws IOException {
        try (SessionLogReader reader = SessionLogReader.open(resume)) {
            if (!reader.header().domain().equals(on.spec())) {
                throw new UsageException(resume + ": is the log of another domain than " + domain);
            }
            Recovery recovery = Recovery.of(reader);
            if (recovery.difference() != null) {
                throw new UsageException(resume + ": " + recovery.difference());
            }
            console.err().println("resuming " + resume + " at belief " + recovery.session().now().version()
                    + (reader.torn() ? "; its last line was torn and is left out" : ""));
            return recovery;
        }
    }

    private void check() {
        UsageException.checkAtLeast("--deadline-ms", deadlineMs, 1);
        UsageException.checkAtLeast("--queue", queue, 1);
        checkPositive("--max-age", maxAge);
        checkPositive("--source-timeout", sourceTimeout);
        if (!(replan >= 0 && replan <= 1)) {
            throw new UsageException("--replan: expected a total variation distance in [0, 1], got " + replan);
        }
    }

    private static void checkPositive(String option, double seconds) {
        if (!(seconds > 0 && seconds <= LONGEST)) {
            throw new UsageException(option + ": expected seconds in (0, " + (int) LONGEST + "], got " + seconds);
        }
    }

    private Security security() throws IOException {
        if ((curve == null) != (authorized == null)) {
            throw new UsageException("--curve and --authorized: expected both or neither");
        }
        return curve == null ? new Security(null, Set.of(), insecure)
                : new Security(CurveKeys.server(curve), CurveKeys.authorized(authorized), insecure);
    }

    private void stop(Bridge bridge) {
        try {
            if (!bridge.stop(SHUTDOWN_MS)) {
                console.err().println("handover: the bridge did not stop in time");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
