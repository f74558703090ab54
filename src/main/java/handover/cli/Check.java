package handover.cli;

import handover.domain.DomainSpec;
import handover.domain.InvalidParameterException;
import handover.io.DomainFileException;
import handover.io.DomainFiles;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Says of each domain file whether it can be used. */
@Command(name = "check", description = "Say of each domain file whether it can be used.")
final class Check implements Callable<Integer> {
    @Parameters(arity = "1..*", paramLabel = "FILE", description = "Domain files, or names of domains that come along.")
    private List<String> files;

    @Option(names = "--human", paramLabel = "DOMAIN", description = "The files are human files for this domain.")
    private String planner;

    private final Console console;

    Check(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        DomainSpec domain = planner == null ? null : DomainFiles.read(planner);
        int bad = 0;
        for (String file : files) {
            try {
                console.out().println("ok: " + file + ": " + line(domain == null ? DomainFiles.read(file)
                        : DomainFiles.readHuman(domain, Path.of(file))));
            } catch (DomainFileException e) {
                console.err().println("handover: " + e.getMessage());
                bad++;
            } catch (InvalidParameterException e) {
                console.err().println("handover: " + file + ": " + e.getMessage());
                bad++;
            }
        }
        return bad == 0 ? Main.FINE : Main.BAD_INPUT;
    }

    private static String line(DomainSpec spec) {
        return spec.name() + ", " + spec.objects().size() + " objects, " + DomainFiles.domain(spec).start().acts().size()
                + " acts, " + DomainFiles.hash(spec);
    }
}
