package handover.cli;

import picocli.CommandLine.Command;

/** Experiments on the model itself. */
@Command(name = "analyze", description = "Experiments: what the match rewards want (reward), what increments are good for (cancels), "
    + "what a stored policy is worth (nearest), how well and what for the robot can follow what people believe of it (nested), "
    + "what single decisions lose (loss).")
final class Analyze implements Runnable {
    @Override
    public void run() {
        throw new UsageException("expected an experiment: analyze reward, analyze cancels, analyze nearest, analyze nested, analyze loss; see handover analyze --help");
    }
}
