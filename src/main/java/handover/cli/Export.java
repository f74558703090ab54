package handover.cli;

import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.io.NamedOutput;
import handover.io.PomdpFiles;
import handover.tabular.FlatHandover;
import handover.tabular.TabularPomdp;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Writes a handover domain, cut into pieces, for other people's solvers. */
@Command(name = "export", description = "Write a handover domain as a standard .POMDP file, with everything continuous cut into pieces.")
final class Export implements Callable<Integer> {
    @Parameters(paramLabel = "DOMAIN", description = "A domain file, or the name of a domain that comes along.")
    private String domain;

    @Option(names = "--format", paramLabel = "F", defaultValue = "pomdp", description = "pomdp (default).")
    private String format;

    @Option(names = "--out", paramLabel = "FILE", description = "Where to (default: standard output).")
    private Path out;

    @Option(names = "--keep", paramLabel = "K", defaultValue = "reference", description = "What states tell apart: @|bold wish|@, what is "
            + "wanted; @|bold reference|@, also the open question (default); @|bold expectation|@, also what the person expects.")
    private String keep;

    @Option(names = "--tolerance", paramLabel = "T", defaultValue = "0.5",
            description = "With expectation: L1 distance up to which expectations are one (default: ${DEFAULT-VALUE}).")
    private double tolerance;

    private final Console console;

    Export(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        if (!format.equals("pomdp")) {
            throw new UsageException("--format: expected pomdp, got " + format);
        } else if (!keep.matches("wish|reference|expectation")) {
            throw new UsageException("--keep: expected wish, reference or expectation, got " + keep);
        } else if (!(tolerance >= 0 && tolerance <= 2)) {
            throw new UsageException("--tolerance: expected an L1 distance in [0, 2], got " + tolerance);
        }
        FlatHandover flat = flatten(DomainFiles.load(domain));
        if (out == null) {
            Writer writer = new OutputStreamWriter(console.out(), StandardCharsets.UTF_8);
            PomdpFiles.write(flat.pomdp(), flat.notes(), writer);
            writer.flush();
        } else {
            try (Writer writer = NamedOutput.text(out)) {
                PomdpFiles.write(flat.pomdp(), flat.notes(), writer);
            }
            TabularPomdp m = flat.pomdp();
            console.out().printf(Locale.ROOT, "%s: %d states, %d acts, %d observations, %d kB%n", out, m.states().size(), m.acts().size(),
                    m.observations().size(), Files.size(out) / 1000);
        }
        return Main.FINE;
    }

    private FlatHandover flatten(HandoverDomain on) {
        try {
            return new FlatHandover(on, FlatHandover.Detail.valueOf(keep.toUpperCase(Locale.ROOT)), tolerance);
        } catch (IllegalArgumentException e) {
            throw new UsageException(domain + ": " + e.getMessage() + "; try --keep wish" + (keep.equals("expectation")
                    ? " or reference, or a larger --tolerance" : ""));
        }
    }
}
