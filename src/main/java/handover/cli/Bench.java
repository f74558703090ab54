package handover.cli;

import handover.io.BenchFile;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.function.LongSupplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Measures how fast decisions are, what they are worth, what they allocate and how they grow, in one run on the same beliefs. */
@Command(name = "bench", sortOptions = false, description = {
    "Measure decisions: times, returns with equal time, BURLAP's BeliefSparseSampling beside POSS, allocation, growth.",
    "All on one thread; all solvers decide at the same beliefs, in turns. What is finished is kept when a run is stopped."})
final class Bench implements Callable<Integer> {
    private static final String WALL = "wall";
    private static final String CPU = "cpu";

    @Option(names = "--parts", split = ",", paramLabel = "PART", defaultValue = "time,return,allocation,growth",
            description = "Of time, return, burlap, allocation, growth (default: ${DEFAULT-VALUE}; burlap takes minutes).")
    private List<String> names;

    @Option(names = "--out", paramLabel = "FILE", description = "Where all numbers go as JSON (default: nowhere).")
    private Path out;

    @Option(names = "--seconds", defaultValue = "0.4",
            description = "For each solver in each place, after half of that to warm up (default: ${DEFAULT-VALUE}).")
    private double seconds;

    @Option(names = "--decisions", defaultValue = "500", description = "Of each solver in each place, at most (default: ${DEFAULT-VALUE}).")
    private int decisions;

    @Option(names = "--clock", defaultValue = "wall", description = "What times and limits are measured by: wall, or cpu for the time that the "
            + "deciding thread is on a processor, which a busy machine does not change (default: ${DEFAULT-VALUE}).")
    private String clock;

    @Option(names = "--seed", defaultValue = "1", description = "Which beliefs, and which luck (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(names = "--commit", paramLabel = "TEXT", defaultValue = "unknown", description = "Of which sources, for the file (default: ${DEFAULT-VALUE}).")
    private String commit;

    @Mixin
    private final BenchTime time = new BenchTime();

    @Mixin
    private final BenchReturn returns = new BenchReturn();

    @Mixin
    private final BenchBurlap burlap = new BenchBurlap();

    @Mixin
    private final BenchAllocation allocation = new BenchAllocation();

    @Mixin
    private final BenchGrowth growth = new BenchGrowth();

    private final Console console;

    Bench(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException, InterruptedException {
        if (!(seconds > 0 && seconds <= 3600)) {
            throw new UsageException("--seconds: expected seconds above 0, at most 3600, got " + seconds);
        }
        UsageException.checkAtLeast("--decisions", decisions, 1);
        if (!clock.equals(WALL) && !clock.equals(CPU) || clock.equals(CPU) && ThreadMeter.nanos(-1) < 0) {
            throw new UsageException("--clock: expected wall or cpu (if this Java can tell), got \"" + clock + "\"");
        }
        List<BenchPart> parts = names.stream().map(this::part).toList();
        parts.forEach(BenchPart::check);
        Map<String, Object> head = head();
        console.out().print(introduction(head));
        BenchReport report = new BenchReport(out == null ? null : new BenchFile(out), head);
        LongSupplier nanos = clock.equals(CPU) ? () -> ThreadMeter.nanos(0) : console.nanoClock();
        BenchRun run = new BenchRun(console, report, nanos, seconds, decisions, seed);
        for (BenchPart part : parts) {
            console.out().print("## " + part.name() + "\n\n" + part.run(run) + "\n");
            console.out().flush();
            report.finish(part.name());
        }
        return Main.FINE;
    }

    private String introduction(Map<String, Object> head) {
        Map<?, ?> machine = (Map<?, ?>) head.get("machine");
        return head.get("date") + ", " + machine.get("processor") + ", " + machine.get("cores") + " cores, " + machine.get("java")
                + (clock.equals(CPU) ? "; all times on the processor" : "") + "\n\n";
    }

    private BenchPart part(String name) {
        List<BenchPart> all = List.of(time, returns, burlap, allocation, growth);
        return all.stream().filter(p -> p.name().equals(name)).findFirst().orElseThrow(() -> new UsageException("--parts: expected some of "
                + String.join(", ", all.stream().map(BenchPart::name).toList()) + ", got \"" + name + "\""));
    }

    private Map<String, Object> head() {
        Map<String, Object> head = new LinkedHashMap<>();
        head.put("format", "handover-bench");
        head.put("version", 1);
        head.put("date", Instant.now().truncatedTo(ChronoUnit.SECONDS).toString());
        head.put("commit", commit);
        head.put("machine", Machine.describe());
        head.put("clock", clock);
        head.put("seconds", seconds);
        head.put("decisions", decisions);
        head.put("seed", seed);
        return head;
    }
}
