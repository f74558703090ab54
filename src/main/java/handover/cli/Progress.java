package handover.cli;

import java.util.Locale;

/** How far a long run is, on standard error: a line that is written over on a terminal, else a line now and then. */
final class Progress {
    private static final double LIVE_SECONDS = 0.2;
    private static final double FIRST_LINE_SECONDS = 1;
    private static final double LINE_SECONDS = 4;

    private final Console console;
    private final int total;
    private final int before;
    private final long start;
    private double shown;
    private int done;
    private int width;

    /**
     * @param done how much was done before the start
     * @param total how much there is to do
     */
    Progress(Console console, int done, int total) {
        this.console = console;
        this.before = done;
        this.done = done;
        this.total = total;
        this.start = console.nanoClock().getAsLong();
    }

    /** One more is done. */
    void step() {
        done++;
        double now = (console.nanoClock().getAsLong() - start) / 1e9;
        double pause = console.live() ? LIVE_SECONDS : shown == 0 ? FIRST_LINE_SECONDS : LINE_SECONDS;
        if (now - shown >= pause) {
            shown = now;
            show(line(done, total, (done - before) / now));
        }
    }

    /** Clears the live line. */
    void end() {
        if (width > 0) {
            console.err().print("\r" + " ".repeat(width) + "\r");
            console.err().flush();
            width = 0;
        }
    }

    static String line(int done, int total, double perSecond) {
        double left = (total - done) / perSecond;
        return String.format(Locale.ROOT, "%d of %d episodes, %.0f a second, about %s left", done, total, perSecond,
                left < 90 ? Math.round(left) + " s" : Math.round(left / 60) + " min");
    }

    private void show(String line) {
        if (console.live()) {
            console.err().print("\r" + line + " ".repeat(Math.max(0, width - line.length())));
            console.err().flush();
            width = line.length();
        } else {
            console.err().println(line);
        }
    }
}
