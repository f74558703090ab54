package handover.cli;

import handover.bridge.CurveKeys;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Makes the keys of a bridge or of a client. */
@Command(name = "keygen", description = "Make a key pair: NAME.key to give away, NAME.key_secret to keep (mode 600).")
final class BridgeKeygen implements Callable<Integer> {
    @Parameters(paramLabel = "NAME", description = "Path of the two files without their endings.")
    private Path name;

    private final Console console;

    BridgeKeygen(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        CurveKeys keys = CurveKeys.generate(name);
        console.out().println(name + ".key: " + keys.publicKey());
        return Main.FINE;
    }
}
