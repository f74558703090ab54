package handover.cli;

import handover.bridge.Session;
import handover.bridge.Snapshot;
import handover.io.DomainFiles;
import handover.io.LineReader;
import handover.io.Messages;
import handover.io.Replies;
import handover.io.WireCode;
import handover.io.WireException;
import handover.io.WireMessage;
import java.io.IOException;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Answers each message on standard input with what the robot should believe. */
@Command(name = "infer", description = "Read messages (docs/bridge.md: begin, acted, speech, gesture, scene, state, end; one JSON "
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
        Session session = Session.begun(DomainFiles.load(domain));
        LineReader lines = new LineReader(console.in(), Messages.LARGEST);
        for (LineReader.Line line = lines.next(); line != null; line = lines.next()) {
            if (!line.isBlank()) {
                console.out().print(answer(session, line.content()) + "\n");
                console.out().flush();
            }
        }
        return Main.FINE;
    }

    private static String answer(Session session, byte[] line) {
        String re = null;
        try {
            WireMessage message = Messages.decode(line);
            re = message.envelope().id();
            Session.Outcome outcome = session.apply(message, Session.TIMELESS, Session.Journal.NONE);
            Snapshot after = outcome.after();
            if (message instanceof WireMessage.State) {
                return Replies.state(re, after.belief());
            }
            return message instanceof WireMessage.End && outcome.applied() ? Replies.summary(re, after.belief(), after.acts())
                    : Replies.belief(re, after.belief(), outcome.remarks());
        } catch (WireException e) {
            return Replies.error(re == null ? e : e.about(re));
        } catch (RuntimeException e) {
            return Replies.error(new WireException(WireCode.INTERNAL, "", e.toString()).about(re));
        }
    }
}
