package handover.cli;

import handover.domain.HandoverDomain;
import handover.io.DomainFiles;
import handover.io.LineReader;
import handover.io.Messages;
import java.io.IOException;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Answers each message on standard input with what the robot should believe. */
@Command(name = "infer", description = "Read messages (PROTOCOL.md: begin, acted, speech, gesture, state, end; one JSON "
        + "object a line), answer each with the belief.")
final class Infer implements Callable<Integer> {
    @Parameters(paramLabel = "DOMAIN", description = "Name or file of the domain.")
    private String domain;

    private final Console console;

    Infer(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        Session session = new Session(DomainFiles.load(domain));
        LineReader lines = new LineReader(console.in(), Messages.LARGEST);
        for (LineReader.Line line = lines.next(); line != null; line = lines.next()) {
            if (!line.isBlank()) {
                console.out().print(session.answer(line.content()) + "\n");
                console.out().flush();
            }
        }
        return Main.FINE;
    }
}
